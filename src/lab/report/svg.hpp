#pragma once

#include <span>
#include <string>
#include <string_view>

namespace steplab {

// Gnuplot writes colours as numbers and repeats its marks in every picture. Here they are converted for styling by a
// page: a CSS variable for each colour, in light and dark mode, and a class for each curve.

/// Colours of a figure. Gnuplot's colour "#0000kk" represents the page's variable with this number.
enum FigureColour { ink = 1, quiet = 2, grid = 3, background_curve = 4, first_of_palette = 16 };
/// Number of colours in the palette of a page.
inline constexpr int most_colours = 32;

/// "#000010", as input of gnuplot.
std::string placeholder(int colour);

/// The svg element of a picture gnuplot wrote: `names` are those of its curves, in order. Colours are var(--c<number>),
/// a curve is <g class="curve" data-method="first word of its name"> with its name as title. Empty if there is none.
std::string page_svg(std::string_view file, std::span<const std::string> names);

/// The mark of points, to which the elements refer.
extern const char* const svg_mark;
/// The same, to be included once in a page.
std::string svg_marks();

}  // namespace steplab
