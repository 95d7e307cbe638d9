#pragma once

#include <span>
#include <string>
#include <string_view>

namespace steplab {

// Gnuplot writes colours as numbers and repeats its marks in every picture. Here they become what a page can style:
// one of its variables for each colour, in light and dark, and a class for each curve.

/// Colours of a figure. As gnuplot's "#0000kk" they stand for the page's variable --kk of that number.
enum FigureColour { ink = 1, quiet = 2, grid = 3, background_curve = 4, first_of_palette = 16 };
/// Colours of a palette that a page knows.
inline constexpr int most_colours = 32;

/// "#000010", to be given to gnuplot.
std::string placeholder(int colour);

/// The svg element of a picture gnuplot wrote: `names` are those of its curves, in order. Colours are var(--c<number>),
/// a curve is <g class="curve" data-method="first word of its name"> with its name as title. Empty if there is none.
std::string page_svg(std::string_view file, std::span<const std::string> names);

/// What the elements refer to: the mark of their points.
extern const char* const svg_mark;
/// The same, to stand once in a page.
std::string svg_marks();

}  // namespace steplab
