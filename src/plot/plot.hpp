#pragma once

#include "core/ticks.hpp"
#include "plot/scale.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace steplab::plot {

/// How a curve is drawn between its points; none: not at all.
enum class Line { solid, dashed, dotted, dash_dotted, none };
/// How many lines, and colours of the window, there are for runs.
inline constexpr std::size_t lines_of_runs = 4;
/// The line of a run of the session, so that runs are told apart without colours too.
Line line_of_run(std::size_t swatch);
constexpr Line dashed_if(bool dashed) { return dashed ? Line::dashed : Line::solid; }
/// Lengths of dash and gap in turn, in thicknesses of the line; empty: solid.
std::span<const float> dashes_of(Line line);

/// Where a curve has dots at its points.
enum class Marks {
    if_few,  ///< where they are few enough to be told apart; none on quiet and exact curves
    always,
    never,
};

/// A curve of a plot.
struct Curve {
    /// Colours that have a meaning, besides those of runs, which are numbers from 0. Quiet: behind the others.
    static constexpr std::size_t exact = 100, quiet = 101;

    std::string name = {};   ///< in the header of the CSV file, and at the pointer
    std::string label = {};  ///< in the legend; empty: the name
    std::size_t colour = 0;
    Line line = Line::solid;
    Marks marks = Marks::if_few;
    bool large = false;  ///< large dots
    bool in_legend = true;
    bool ascending = true;  ///< x ascends; else the curve may go anywhere, as a path does
    std::vector<double> x = {};
    std::vector<double> y = {};  ///< values that are not finite are gaps

    const std::string& legend() const { return label.empty() ? name : label; }
    void add(double across, double up);
    /// `few`: there are few enough points to be told apart.
    bool has_marks(bool few) const;
};

/// What lies between two curves.
struct Band {
    std::string name = {};  ///< in the legend; with "low" and "high" in the header of the CSV file
    std::size_t colour = 0;
    std::vector<double> x = {};  ///< ascending
    std::vector<double> low = {}, high = {};
    bool is_cut = false;  ///< the axis does not reach to its ends, but to those of the curves
};

/// A vertical line at something that happened.
struct Moment {
    double x = 0;
    std::string text = {};
};

/// What an axis shows.
struct Quantity {
    std::string name = {};
    std::string unit = {};
    std::string part = {};  ///< which part of it is shown, if that is not said by a person
    Scale scale = Scale::linear;
    std::optional<Range> range = {};  ///< none: that of the data
    Numbers numbers = Numbers::typed;
};
/// "position error [m]", "time, latest part [s]".
std::string text_of(const Quantity& quantity);

/// The content of a plot, with everything that its picture says. It is drawn by draw_plot() of the
/// window and written by csv() and svg().
struct Plot {
    std::string name = {};     ///< in the names of its files and widgets: "energy error"
    std::string title = {};    ///< above it; empty: what its axis up shows
    std::string caption = {};  ///< of what run it is
    Quantity x = {.name = "time", .unit = "s"};
    Quantity y = {};
    std::vector<Curve> curves = {};
    std::vector<Band> bands = {};
    std::vector<Moment> moments = {};
    std::optional<double> now = {};  ///< where the run stands, if it is not at the end of its curves
    bool nearest_alone = false;      ///< many curves: the pointer is told of the nearest point, not of all
    std::string empty = {};          ///< shown if there is nothing to draw
};

/// The numbers of the curves of a plot as one lies over the other. One exact curve lies over all; several, which would
/// cover the others, under them.
std::vector<std::size_t> drawing_order(const Plot& plot);

/// A box on a picture, in pixels; y downwards.
struct Box {
    float x = 0, y = 0, width = 0, height = 0;

    float right() const { return x + width; }
    float bottom() const { return y + height; }
    bool empty() const { return width <= 0 || height <= 0; }
    bool contains(float px, float py) const { return px >= x && px < right() && py >= y && py < bottom(); }
    bool meets(const Box& other) const {
        return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
    }
};

/// The axes of a plot in a frame of pixels.
struct Axes {
    Axis across;
    Axis up;
};
/// `most`: number of intervals between the ticks of the vertical axis, at most.
Axes axes(const Plot& plot, const Box& frame, int most = 5);
/// True if there is a value to draw.
bool has_values(const Plot& plot);

/// A point of a plotted line, in pixels.
struct Point {
    float x = 0;
    float y = 0;
};

/// The line through (x, y), reduced to what its pixels can show: the first, lowest, highest and last point of each
/// column of pixels that it passes through, so that no peak is lost by as much as a pixel. Points that an axis cannot
/// show are left out.
std::vector<Point> decimated(std::span<const double> x, std::span<const double> y, const Axes& axes);
/// True if those of them that the frame shows are so far apart [pixels], in the mean.
bool told_apart(std::span<const Point> points, const Box& frame, float distance);

/// A band over a column of pixels.
struct Strip {
    float x = 0;
    float top = 0, bottom = 0;
};
/// The band, reduced to its widest extent in each column of pixels. What lies below a logarithmic axis is cut off
/// there; points without a value are left out.
std::vector<Strip> strips(const Band& band, const Axes& axes);

/// Index of the value in `x` (ascending) nearest to `value`; 0 if `x` is empty.
std::size_t nearest(std::span<const double> x, double value);

/// The data of a plot as CSV (RFC 4180): a column for x, of all curves and bands, one for each curve, and two for each
/// band, empty where it has no value; of curves that do not ascend the name, x and y of each point.
std::string csv(const Plot& plot);

}  // namespace steplab::plot
