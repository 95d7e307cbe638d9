#include "plot/plot.hpp"

#include "core/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace steplab::plot {
namespace {

/// Smallest and largest value that can be drawn; low > high if there is none.
struct Extent {
    double low = INFINITY;
    double high = -INFINITY;
    double least_size = INFINITY;  ///< the smallest distance from 0 that is not 0

    bool empty() const { return !(low <= high); }
    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
        if (value != 0) least_size = std::min(least_size, std::abs(value));
    }
    void add_all(std::span<const double> values, const Quantity& quantity) {
        const Axis axis{.scale = quantity.scale};
        for (const double value : values) {
            if (axis.can_show(value)) add(value);
        }
    }
    /// Those over a part of the other axis that is shown.
    void add_over(std::span<const double> values, const Quantity& quantity, std::span<const double> x,
                  const std::optional<Range>& shown) {
        const Axis axis{.scale = quantity.scale};
        for (std::size_t i = 0; i < std::min(values.size(), x.size()); ++i) {
            const bool visible = !shown || (x[i] >= shown->low && x[i] <= shown->high);
            if (visible && axis.can_show(values[i])) add(values[i]);
        }
    }
};

Extent extent_across(const Plot& plot) {
    Extent extent;
    for (const Curve& curve : plot.curves) extent.add_all(curve.x, plot.x);
    for (const Band& band : plot.bands) extent.add_all(band.x, plot.x);
    return extent;
}

Extent extent_up(const Plot& plot) {
    Extent extent;
    for (const Curve& curve : plot.curves) extent.add_over(curve.y, plot.y, curve.x, plot.x.range);
    const bool alone = extent.empty();
    for (const Band& band : plot.bands) {
        if (band.is_cut && !alone) continue;
        extent.add_over(band.low, plot.y, band.x, plot.x.range);
        extent.add_over(band.high, plot.y, band.x, plot.x.range);
    }
    return extent;
}

/// A symmetric axis shows so many decades at most on either side: below lies what nobody could see.
constexpr double most_decades = 12;

double threshold_of(const Extent& extent) {
    const double largest = std::max(std::abs(extent.low), std::abs(extent.high));
    if (!(largest > 0)) return 1;
    const double least = std::max(extent.least_size, largest * std::pow(10.0, -most_decades));
    return std::max(std::pow(10.0, std::floor(std::log10(least))), 1e-300);
}

/// A little beyond the powers of ten around.
Range symmetric_range(const Extent& extent) {
    const auto beyond = [&](double value, double sign) {
        const double size = sign * value;
        return size > 0 ? sign * decade_range(size, size).high : 0;
    };
    const Range range{beyond(extent.low, -1), beyond(extent.high, 1)};
    return range.low < range.high ? range : Range{-1, 1};
}

Range range_up(const Extent& extent, const Quantity& quantity, int most) {
    if (quantity.range) return *quantity.range;
    if (extent.empty()) return {};
    switch (quantity.scale) {
        case Scale::logarithmic:
            return decade_range(extent.low, extent.high);
        case Scale::symmetric_logarithmic:
            return symmetric_range(extent);
        default:
            return nice_range(extent.low, extent.high, most);
    }
}

/// As far as the data go: time moves on without jumps.
Range range_across(const Extent& extent, const Quantity& quantity) {
    if (quantity.range) return *quantity.range;
    if (extent.empty()) return {};
    if (extent.high > extent.low) return {extent.low, extent.high};
    if (quantity.scale == Scale::logarithmic) return decade_range(extent.low, extent.high);
    return {extent.low, extent.low + std::max(1.0, 1e-6 * std::abs(extent.low))};
}

/// The points of one column of pixels, in their order.
struct Column {
    Point first, lowest, highest, last;
    std::size_t count = 0;

    void add(Point point) {
        if (count++ == 0) first = lowest = highest = point;
        if (point.y > lowest.y) lowest = point;
        if (point.y < highest.y) highest = point;
        last = point;
    }
    void append_to(std::vector<Point>& points) {
        if (count > 0) points.push_back(first);
        if (count > 2) {
            const bool low_first = lowest.x < highest.x;
            points.push_back(low_first ? lowest : highest);
            points.push_back(low_first ? highest : lowest);
        }
        if (count > 1) points.push_back(last);
        count = 0;
    }
};

/// Points nearer than this to the one before [pixels] are not told apart, and the joints between them would be thick.
constexpr float apart = 0.75f;

/// Without those; the last one stays.
void thin_out(std::vector<Point>& points) {
    if (points.size() < 2) return;
    const auto near_by = [](const Point& a, const Point& b) { return std::hypot(b.x - a.x, b.y - a.y) < apart; };
    std::size_t kept = 1;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        if (!near_by(points[kept - 1], points[i])) points[kept++] = points[i];
    }
    if (kept > 1 && near_by(points[kept - 1], points.back())) --kept;
    points[kept++] = points.back();
    points.resize(kept);
}

/// A name as a cell: in quotes where a comma, quote or line break in it would be read as the end of the cell (RFC
/// 4180).
std::string csv_text(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
    std::string quoted = "\"";
    for (const char c : name) quoted.append(c == '"' ? 2 : 1, c);
    return quoted + "\"";
}

/// A column of a table.
struct Values {
    std::string name;
    std::span<const double> x, y;

    /// The value at one of its own x; empty elsewhere.
    std::string at(double place) const {
        const auto found = std::lower_bound(x.begin(), x.end(), place);
        if (found == x.end() || *found != place) return {};
        const double value = y[static_cast<std::size_t>(found - x.begin())];
        return std::isfinite(value) ? number_text(value) : std::string();
    }
};

std::vector<Values> columns_of(const Plot& plot) {
    std::vector<Values> columns;
    for (const Curve& curve : plot.curves) columns.push_back({curve.name, curve.x, curve.y});
    for (const Band& band : plot.bands) {
        columns.push_back({band.name + " low", band.x, band.low});
        columns.push_back({band.name + " high", band.x, band.high});
    }
    return columns;
}

std::string table_of(const Plot& plot) {
    std::string text = csv_text(plot.x.name);
    std::set<double> all;
    const std::vector<Values> columns = columns_of(plot);
    for (const Values& column : columns) {
        text.append(",").append(csv_text(column.name));
        all.insert(column.x.begin(), column.x.end());
    }
    text.append("\n");
    for (const double x : all) {
        text.append(number_text(x));
        for (const Values& column : columns) text.append(",").append(column.at(x));
        text.append("\n");
    }
    return text;
}

std::string points_of(const Plot& plot) {
    std::string text = "curve," + csv_text(plot.x.name) + "," + csv_text(plot.y.name) + "\n";
    for (const Curve& curve : plot.curves) {
        const std::string name = csv_text(curve.name);
        for (std::size_t i = 0; i < curve.x.size(); ++i)
            text.append(name + "," + number_text(curve.x[i]) + "," + number_text(curve.y[i]) + "\n");
    }
    return text;
}

}  // namespace

std::vector<std::size_t> drawing_order(const Plot& plot) {
    std::vector<std::size_t> order(plot.curves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto is_exact = [&](std::size_t curve) { return plot.curves[curve].colour == Curve::exact; };
    if (std::count_if(order.begin(), order.end(), is_exact) > 1)
        std::stable_partition(order.begin(), order.end(), is_exact);
    return order;
}

Line line_of_run(std::size_t swatch) { return static_cast<Line>(std::min(swatch, lines_of_runs - 1)); }

std::span<const float> dashes_of(Line line) {
    static constexpr std::array dashed{4.0f, 2.5f}, dotted{1.2f, 1.8f};
    static constexpr std::array both{4.5f, 1.8f, 1.2f, 1.8f};
    switch (line) {
        case Line::dashed:
            return dashed;
        case Line::dotted:
            return dotted;
        case Line::dash_dotted:
            return both;
        default:
            return {};
    }
}

void Curve::add(double across, double up) {
    x.push_back(across);
    y.push_back(up);
}

bool Curve::has_marks(bool few) const {
    return marks == Marks::always || (marks == Marks::if_few && few && colour != exact && colour != quiet);
}

std::string text_of(const Quantity& quantity) {
    const std::string name = quantity.part.empty() ? quantity.name : quantity.name + ", " + quantity.part;
    return quantity.unit.empty() ? name : name + " [" + quantity.unit + "]";
}

bool has_values(const Plot& plot) { return !extent_up(plot).empty(); }

Axes axes(const Plot& plot, const Box& frame, int most) {
    const Extent across = extent_across(plot), up = extent_up(plot);
    const Range x = range_across(across, plot.x), y = range_up(up, plot.y, most);
    return {{x.low, x.high, plot.x.scale, frame.x, frame.right(), threshold_of(across), plot.x.numbers},
            {y.low, y.high, plot.y.scale, frame.bottom(), frame.y, threshold_of(up), plot.y.numbers}};
}

std::vector<Point> decimated(std::span<const double> x, std::span<const double> y, const Axes& axes) {
    std::vector<Point> points;
    Column column;
    float pixel = 0;
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        if (!axes.across.can_show(x[i]) || !axes.up.can_show(y[i])) continue;
        const Point point{axes.across.pixel(x[i]), axes.up.pixel(y[i])};
        if (column.count > 0 && std::floor(point.x) != pixel) column.append_to(points);
        pixel = std::floor(point.x);
        column.add(point);
    }
    column.append_to(points);
    thin_out(points);
    return points;
}

bool told_apart(std::span<const Point> points, const Box& frame, float distance) {
    const auto seen = std::count_if(points.begin(), points.end(),
                                    [&](const Point& point) { return point.x >= frame.x && point.x <= frame.right(); });
    return static_cast<float>(seen) * distance < frame.width;
}

std::vector<Strip> strips(const Band& band, const Axes& axes) {
    std::vector<Strip> found;
    for (std::size_t i = 0; i < band.x.size(); ++i) {
        if (!axes.across.can_show(band.x[i]) || !axes.up.can_show(band.high[i]) || std::isnan(band.low[i])) continue;
        const Strip strip{axes.across.pixel(band.x[i]), axes.up.pixel(band.high[i]),
                          axes.up.can_show(band.low[i]) ? axes.up.pixel(band.low[i]) : axes.up.from};
        if (found.empty() || std::floor(strip.x) != std::floor(found.back().x)) {
            found.push_back(strip);
        } else {
            found.back().top = std::min(found.back().top, strip.top);
            found.back().bottom = std::max(found.back().bottom, strip.bottom);
        }
    }
    return found;
}

std::size_t nearest(std::span<const double> x, double value) {
    if (x.empty()) return 0;
    const auto above = std::lower_bound(x.begin(), x.end(), value);
    if (above == x.begin()) return 0;
    if (above == x.end()) return x.size() - 1;
    const auto below = std::prev(above);
    return static_cast<std::size_t>((value - *below <= *above - value ? below : above) - x.begin());
}

std::string csv(const Plot& plot) {
    const bool ascending =
        std::all_of(plot.curves.begin(), plot.curves.end(), [](const Curve& c) { return c.ascending; });
    return ascending ? table_of(plot) : points_of(plot);
}

}  // namespace steplab::plot
