#include "render/particle_blocks.hpp"

#include "render/view_uniforms.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace steplab::render {
namespace {

// Up to these radii in pixels, the shading and the depth of a ball are not visible.
constexpr double dot_radius = 1.0;
constexpr double point_radius = 3.5;
// Margin around a drawn particle, in pixels.
constexpr float margin = 2;

/// The view frustum of a tile in units of the vertices: in front of the camera, between four planes through it.
class Pyramid {
public:
    Pyramid(const Projection& p, const Tile& tile, PictureSize part)
        : eye_(vertex(p, p.eye())), forward_(in_float(p.forward())), pixels_(static_cast<float>(p.pixels_per_unit(1))) {
        const auto across = [&](int pixel, int whole, double half) { return half * (2.0 * pixel / whole - 1); };
        const double left = across(tile.left, tile.whole.width, p.half_width());
        const double right = across(tile.left + part.width, tile.whole.width, p.half_width());
        const double top = -across(tile.top, tile.whole.height, p.half_height());
        const double bottom = -across(tile.top + part.height, tile.whole.height, p.half_height());
        // Inwards: a point is inside where its product with all of them is positive.
        inwards_ = {in_float(p.right() - left * p.forward()), in_float(right * p.forward() - p.right()),
                    in_float(p.up() - bottom * p.forward()), in_float(top * p.forward() - p.up())};
    }

    /// The level of detail of balls of a radius in this box; none if all are outside the view.
    std::optional<Detail> detail(glm::vec3 low, glm::vec3 high, float radius) const {
        const glm::vec3 centre = 0.5F * (low + high) - eye_, half = 0.5F * (high - low);
        const float ahead = glm::dot(centre, forward_), reach = glm::dot(half, glm::abs(forward_));
        const float nearest = ahead - reach, farthest = ahead + reach;
        if (farthest <= 0) return std::nullopt;
        const float beyond = 1.5F * radius + margin * farthest / pixels_;
        for (const glm::vec3& inward : inwards_) {
            const float inside = glm::dot(centre, inward) + glm::dot(half, glm::abs(inward));
            if (inside < -beyond * glm::length(inward)) return std::nullopt;
        }
        return nearest > 0 ? detail_of(static_cast<double>(radius * pixels_ / nearest)) : Detail::body;
    }

private:
    glm::vec3 eye_, forward_;
    float pixels_;
    std::array<glm::vec3, 4> inwards_;
};

/// True where particles are drawn at their positions themselves: no box and no magnification moves them.
bool drawn_in_place(const Frame& frame) { return !frame.cell && !frame.shape->is_periodic() && frame.magnified == 1; }

constexpr Bounds nothing{{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}};

/// Adds a position; none that is not a number.
void include(Bounds& bounds, Vec3 at) {
    const auto smaller = [](double a, double b) { return a < b ? a : b; };
    const auto larger = [](double a, double b) { return a > b ? a : b; };
    bounds.low = {smaller(at.x, bounds.low.x), smaller(at.y, bounds.low.y), smaller(at.z, bounds.low.z)};
    bounds.high = {larger(at.x, bounds.high.x), larger(at.y, bounds.high.y), larger(at.z, bounds.high.z)};
}

/// The vertices of positions where they are, and the box around them. None if one of them cannot be drawn.
std::optional<Bounds> place_all(std::span<const Vec3> positions, Vec3 focus, double scale, glm::vec3* vertex) {
    Bounds bounds = nothing;
    double numbers = 0;  // not even 0 once one is no number
    for (const Vec3& position : positions) {
        const Vec3 seen = scale * (position - focus);
        numbers += 0 * (position.x + position.y + position.z);
        include(bounds, position);
        *vertex++ = {static_cast<float>(seen.x), static_cast<float>(seen.y), static_cast<float>(seen.z)};
    }
    if (numbers != 0 || !drawable(bounds.low) || !drawable(bounds.high)) return std::nullopt;
    return bounds;
}

}  // namespace

Detail detail_of(double radius) {
    if (radius <= dot_radius) return Detail::dot;
    return radius <= point_radius ? Detail::point : Detail::body;
}

void ParticleBlocks::place(const Frame& frame, const Projection& projection) {
    const std::size_t count = frame.positions.size();
    vertices_.resize(count);
    boxes_.resize((count + block_size - 1) / block_size);
    unseen_ = vertex(projection, projection.eye() - projection.camera().distance * projection.forward());
    std::optional<Bounds> whole;
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
        const std::size_t first = block * block_size;
        const auto bounds = place_block(frame, projection, first, std::min(block_size, count - first));
        boxes_[block].reset();
        if (!bounds) continue;
        boxes_[block] = Box{vertex(projection, bounds->low), vertex(projection, bounds->high)};
        whole = whole ? joined(*whole, *bounds) : *bounds;
    }
    bounds_ = whole.value_or(Bounds{});
}

std::optional<Bounds> ParticleBlocks::place_block(const Frame& frame, const Projection& projection, std::size_t first,
                                                  std::size_t count) {
    const Vec3 focus = projection.camera().focus;
    const double scale = 1 / projection.camera().distance;
    if (drawn_in_place(frame)) {
        const auto all = place_all(std::span(frame.positions).subspan(first, count), focus, scale, &vertices_[first]);
        if (all) return all;
    }
    Bounds bounds = nothing;
    for (std::size_t i = first; i < first + count; ++i) {
        const Vec3 position = frame.seen(i);
        if (!drawable(position)) {
            vertices_[i] = unseen_;
            continue;
        }
        vertices_[i] = in_float(scale * (position - focus));
        include(bounds, position);
    }
    if (bounds.low.x > bounds.high.x) return std::nullopt;
    return bounds;
}

std::array<std::vector<IndexRange>, details> ParticleBlocks::choose(const Projection& projection, const Tile& tile,
                                                                    PictureSize part, double radius) const {
    const Pyramid pyramid(projection, tile, part);
    const float drawn = vertex_length(projection, radius);
    std::array<std::vector<IndexRange>, details> chosen;
    for (std::size_t block = 0; block < boxes_.size(); ++block) {
        const auto& box = boxes_[block];
        const auto detail = box ? pyramid.detail(box->low, box->high, drawn) : std::nullopt;
        if (!detail) continue;
        const std::size_t first = block * block_size, size = std::min(block_size, vertices_.size() - first);
        std::vector<IndexRange>& ranges = chosen[static_cast<std::size_t>(*detail)];
        if (!ranges.empty() && ranges.back().first + ranges.back().count == first) {
            ranges.back().count += size;
        } else {
            ranges.push_back({first, size});
        }
    }
    return chosen;
}

void ParticleBlocks::mark(const Projection& projection, std::span<const IndexRange> ranges, double radius,
                          Occupancy& taken, std::size_t one_of) const {
    const glm::vec3 eye = vertex(projection, projection.eye()), forward = in_float(projection.forward());
    const glm::vec3 right = in_float(projection.right()), up = in_float(projection.up());
    const auto pixels = static_cast<float>(projection.pixels_per_unit(1));
    const PictureSize size = projection.size();
    const auto drawn = static_cast<double>(vertex_length(projection, radius));
    for (const IndexRange& range : ranges) {
        for (std::size_t i = range.first; i < range.first + range.count; i += one_of) {
            const glm::vec3 seen = vertices_[i] - eye;
            const float scale = pixels / glm::dot(seen, forward);
            if (!(scale > 0)) continue;
            const PixelPoint pixel{0.5 * size.width + static_cast<double>(scale * glm::dot(seen, right)),
                                   0.5 * size.height - static_cast<double>(scale * glm::dot(seen, up))};
            taken.mark(pixel, drawn * static_cast<double>(scale));
        }
    }
}

}  // namespace steplab::render
