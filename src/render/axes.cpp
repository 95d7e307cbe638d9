#include "render/axes.hpp"

#include "core/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

namespace steplab::render {
namespace {

// In pixels.
constexpr double tick_length = 5;
constexpr double number_distance = 15;
constexpr double title_distance = 46;
constexpr double least_spacing[] = {54, 32, 54};  // of ticks along x, y, z
constexpr double vanished_length = 50;
constexpr double full_length = 120;

/// One axis: an edge of the box and a direction out of the box, to the side where ticks and numbers are.
struct Edge {
    int axis;  // 0 x, 1 y, 2 z
    Vec3 start;
    Vec3 end;
    Vec3 outward;
};

double component(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

Vec3 with_component(Vec3 v, int axis, double value) {
    (axis == 0 ? v.x : axis == 1 ? v.y : v.z) = value;
    return v;
}

/// The upright edge farthest to the left in the picture.
Edge upright_edge(const Bounds& box, const Projection& projection) {
    double leftmost = std::numeric_limits<double>::infinity();
    Edge edge{1, box.low, box.low, -1.0 * projection.right()};
    for (const double x : {box.low.x, box.high.x}) {
        for (const double z : {box.low.z, box.high.z}) {
            const auto pixel = projection.pixel({x, box.low.y, z});
            if (!pixel || pixel->x >= leftmost) continue;
            leftmost = pixel->x;
            edge.start = {x, box.low.y, z};
            edge.end = {x, box.high.y, z};
        }
    }
    return edge;
}

/// The edges of the floor that are lowest in the picture, so that nothing of the box is beyond them: seen from below
/// they are the far ones.
std::array<Edge, 3> outer_edges(const Bounds& box, const Projection& projection) {
    const bool from_above = projection.eye().y >= box.low.y;
    const bool from_right = projection.eye().x >= box.centre().x;
    const bool from_front = projection.eye().z >= box.centre().z;
    const bool to_right = from_right == from_above, to_front = from_front == from_above;
    const double x = to_right ? box.high.x : box.low.x;
    const double z = to_front ? box.high.z : box.low.z;
    const double y = box.low.y;
    constexpr double down = -1e-3;  // so small that it decides only where the floor is seen edge-on
    return {{{0, {box.low.x, y, z}, {box.high.x, y, z}, {0, down, to_front ? 1.0 : -1.0}},
             upright_edge(box, projection),
             {2, {x, y, box.low.z}, {x, y, box.high.z}, {to_right ? 1.0 : -1.0, down, 0}}}};
}

/// The direction of ticks: parallel to the picture and across the edge, so that they are as long in every view.
Vec3 tick_direction(const Edge& edge, const Projection& projection) {
    // Of the plane through the eye and the edge, which divides space into what is seen on either side of the edge.
    const Vec3 normal = cross(edge.start - projection.eye(), edge.end - projection.eye());
    const Vec3 across = normal - dot(normal, projection.forward()) * projection.forward();
    return (dot(normal, edge.outward) > 0 ? 1 : -1) / length(across) * across;
}

/// The point moved in a direction parallel to the picture, by pixels.
Vec3 moved(Vec3 point, Vec3 direction, const Projection& projection, double pixels) {
    return point + pixels / projection.pixels_per_unit(projection.depth(point)) * direction;
}

/// The step of the grid, or a larger nice one that leaves room for the numbers.
double tick_step(double step, double pixels_per_step, double least) {
    while (pixels_per_step < least) {
        const double wider = nice_above(step);
        if (!(wider > step)) break;
        pixels_per_step *= wider / step;
        step = wider;
    }
    return step;
}

void add_ticks(Axes& axes, const Edge& edge, Vec3 direction, double step, double strength, const Projection& projection,
               double pixel_scale) {
    const double low = component(edge.start, edge.axis);
    const double high = component(edge.end, edge.axis);
    for (const double value : linear_ticks(low, high, step)) {
        const Vec3 point = with_component(edge.start, edge.axis, value);
        const auto number = projection.pixel(moved(point, direction, projection, number_distance * pixel_scale));
        if (!number) continue;
        axes.lines.push_back({point, moved(point, direction, projection, tick_length * pixel_scale), strength});
        axes.labels.push_back({tick_text(value, step, std::max(std::abs(low), std::abs(high))), *number, strength});
    }
}

/// Among the numbers of an axis, as near to its middle as none is; nothing if the axis is not in the picture there.
std::optional<PixelPoint> between_numbers(const Edge& edge, Vec3 direction, double step, const Projection& projection,
                                          double pixel_scale) {
    const double low = component(edge.start, edge.axis), high = component(edge.end, edge.axis);
    const std::vector<double> ticks = linear_ticks(low, high, step);
    const auto beyond = std::upper_bound(std::next(ticks.begin()), std::prev(ticks.end()), 0.5 * (low + high));
    const Vec3 point = with_component(edge.start, edge.axis, 0.5 * (*std::prev(beyond) + *beyond));
    const auto pixel = projection.pixel(point);
    const PictureSize size = projection.size();
    if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x > size.width || pixel->y > size.height) return std::nullopt;
    return projection.pixel(moved(point, direction, projection, number_distance * pixel_scale));
}

void add_axis(Axes& axes, const Edge& edge, double grid_step, const Projection& projection, double pixel_scale) {
    constexpr const char* titles[] = {"x [m]", "y [m]", "z [m]"};
    const auto start = projection.pixel(edge.start);
    const auto end = projection.pixel(edge.end);
    if (!start || !end) return;
    const double pixels = std::hypot(end->x - start->x, end->y - start->y);
    const double strength =
        std::clamp((pixels / pixel_scale - vanished_length) / (full_length - vanished_length), 0.0, 1.0);
    if (!(strength > 0)) return;
    const double reach = length(edge.end - edge.start);
    const double step = tick_step(grid_step, pixels * grid_step / reach, least_spacing[edge.axis] * pixel_scale);
    // A single number shows no scale.
    if (linear_ticks(component(edge.start, edge.axis), component(edge.end, edge.axis), step).size() < 2) return;
    axes.lines.push_back({edge.start, edge.end, strength});
    const Vec3 direction = tick_direction(edge, projection);
    add_ticks(axes, edge, direction, step, strength, projection, pixel_scale);
    const Vec3 middle = 0.5 * (edge.start + edge.end);
    const auto title = projection.pixel(moved(middle, direction, projection, title_distance * pixel_scale));
    if (title)
        axes.labels.push_back(
            {titles[edge.axis], *title, strength, between_numbers(edge, direction, step, projection, pixel_scale)});
}

}  // namespace

Axes axes_of(const AxesBox& box, const Projection& projection, double pixel_scale) {
    Axes axes;
    for (const Edge& edge : outer_edges(box.bounds, projection)) {
        add_axis(axes, edge, box.step, projection, pixel_scale);
    }
    return axes;
}

namespace {

constexpr double across_open = 0.4;  // strength of edges across an axis on which the box is open

/// The strength of the edge along `axis` that starts at one of the corners, for each other axis at its high or low end.
double edge_strength(const Shape& shape, int axis, const std::array<bool, 3>& high) {
    for (int other = 0; other < 3; ++other) {
        if (other == axis || component(shape.box, other) > 0) continue;
        if (component(shape.box, axis) == 0) continue;  // both open: nothing is across
        return high[static_cast<std::size_t>(other)] ? 0 : across_open;
    }
    return 1;
}

/// One of the four edges along an axis.
void add_edge(Axes& axes, const Shape& shape, const Bounds& box, int axis, unsigned corner) {
    const bool first = (corner & 1U) != 0, second = (corner & 2U) != 0;
    const std::array<bool, 3> high{axis != 0 && first, axis == 0 ? first : axis == 2 && second, axis != 2 && second};
    const double strength = edge_strength(shape, axis, high);
    if (!(strength > 0)) return;
    const Vec3 start{high[0] ? box.high.x : box.low.x, high[1] ? box.high.y : box.low.y,
                     high[2] ? box.high.z : box.low.z};
    axes.lines.push_back({start, with_component(start, axis, component(box.high, axis)), strength});
}

}  // namespace

void add_box_edges(Axes& axes, const Shape& shape, const Bounds& within) {
    if (!shape.is_periodic()) return;
    Bounds box{shape.corner, shape.corner + shape.box};
    for (int axis = 0; axis < 3; ++axis) {
        if (component(shape.box, axis) > 0) continue;
        box.low = with_component(box.low, axis, component(within.low, axis));
        box.high = with_component(box.high, axis, component(within.high, axis));
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (unsigned corner = 0; corner < 4; ++corner) add_edge(axes, shape, box, axis, corner);
    }
}

void add_cell_edges(Axes& axes, const Cell& cell) {
    const std::array<Vec3, 8> corners = cell.corners();
    for (std::size_t from = 0; from < corners.size(); ++from) {
        for (std::size_t along = 1; along < corners.size(); along *= 2) {
            if ((from & along) == 0) axes.lines.push_back({corners[from], corners[from | along], 1});
        }
    }
}

}  // namespace steplab::render
