#include "render/scene_renderer.hpp"

#include "render/ensemble_dots.hpp"
#include "render/ground.hpp"
#include "render/known_shape.hpp"
#include "render/lines.hpp"
#include "render/motion_lines.hpp"
#include "render/overlay.hpp"
#include "render/particle_blocks.hpp"
#include "render/particles.hpp"
#include "render/shot.hpp"
#include "render/springs.hpp"

namespace steplab::render {
namespace {

/// Smaller pictures have no numbers and no legend.
bool has_room(PictureSize size, double pixel_scale) {
    return size.width >= 160 * pixel_scale && size.height >= 120 * pixel_scale;
}

/// The box around everything that is drawn, for the near and far planes.
Bounds drawn_bounds(Bounds positions, const std::optional<Bounds>& ensemble, double margin, const AxesBox& box,
                    bool grid) {
    if (ensemble) positions = joined(positions, *ensemble);
    const Bounds bodies = joined(widened(positions, margin), box.bounds);
    if (!grid) return bodies;
    const double reach = Ground::reach(box);
    const Vec3 middle = box.bounds.centre();
    const Bounds ground{{middle.x - reach, box.bounds.low.y, middle.z - reach},
                        {middle.x + reach, box.bounds.low.y, middle.z + reach}};
    return joined(bodies, ground);
}

}  // namespace

struct SceneRenderer::Body {
    Ground ground;
    Springs springs;
    Particles particles;
    EnsembleDots ensemble;
    Lines lines;
    std::vector<Rod> arrows, trail;
    Sketch sketch;
    ParticleBlocks blocks;
    std::optional<KnownShape> known;  ///< of the last frame

    void draw_space(const Style& style, const AxesBox& box, const Axes& axes, const ViewUniforms& view,
                    const Tile& tile, const RenderTarget& target);
    void draw_grid(const Style& style, const AxesBox& box, const ViewUniforms& view);
    void draw_flat(const Style& style, const Projection& projection, const std::optional<ColourScale>& scale,
                   const Axes& axes, const Occupancy& taken, const Tile& tile, PictureSize part);
};

void SceneRenderer::Body::draw_space(const Style& style, const AxesBox& box, const Axes& axes, const ViewUniforms& view,
                                     const Tile& tile, const RenderTarget& target) {
    const Palette& colours = palette(style.background);
    target.bind();
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
    ground.draw_backdrop(colours, tile, target);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // The grid is below everything: seen from above, it is behind everything.
    const bool from_above = view.projection().eye().y > box.bounds.low.y;
    if (style.grid && from_above) draw_grid(style, box, view);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    if (style.springs) springs.draw(view, style.pixel_scale);
    particles.draw(view, target);
    lines.draw(arrows, view, 1.5 * style.pixel_scale);
    lines.draw(trail, view, 1.5 * style.pixel_scale);
    if (style.grid) ground.draw_axes(axes, view, colours, style.pixel_scale);
    if (style.grid && !from_above) draw_grid(style, box, view);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    ensemble.draw(view, style.pixel_scale);
    particles.draw_rings(view, style.pixel_scale);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    target.resolve();
}

void SceneRenderer::Body::draw_grid(const Style& style, const AxesBox& box, const ViewUniforms& view) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    ground.draw_grid(box, view, palette(style.background), style.pixel_scale);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void SceneRenderer::Body::draw_flat(const Style& style, const Projection& projection,
                                    const std::optional<ColourScale>& scale, const Axes& axes, const Occupancy& taken,
                                    const Tile& tile, PictureSize part) {
    const Palette& colours = palette(style.background);
    if (!has_room(tile.whole, style.pixel_scale)) return;
    sketch.begin(tile.whole, style.pixel_scale);
    if (style.grid) sketch_labels(sketch, axes, taken, colours);
    if (style.grid) sketch_cross(sketch, projection, colours, style.pixel_scale);
    if (style.legend && scale) sketch_legend(sketch, *scale, tile.whole, colours, style.pixel_scale);
    sketch.finish(tile, part);
}

SceneRenderer::SceneRenderer() : body_(std::make_unique<Body>()) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

void SceneRenderer::draw(const Frame& frame, const Style& style, const Camera& camera, const RenderTarget& target,
                         const std::optional<Tile>& part) {
    const Tile tile = part.value_or(Tile{target.size()});
    const Projection projection(camera, tile.whole);
    const auto scale = colour_scale(frame, style);
    auto& [ground, springs, particles, ensemble, lines, arrows, trail, sketch, blocks, known] = *body_;
    if (!known || known->shape != frame.shape) known.emplace(frame.shape);
    blocks.place(frame, projection);
    const AxesBox box = axes_box(known->expected, frame.shape->spacing, blocks.bounds());
    Axes axes = style.grid ? axes_of(box, projection, style.pixel_scale) : Axes{};
    if (style.grid) add_box_edges(axes, *frame.shape, blocks.bounds());
    Occupancy taken(tile.whole);
    mark_cross(taken, tile.whole, style.pixel_scale);
    const Shot shot{frame, *known, style, scale, projection, tile, target.size()};
    if (style.springs) springs.prepare(shot, blocks);
    particles.prepare(shot, blocks, taken);
    ensemble.prepare(shot);
    arrows = motion_arrows(shot);
    trail = trail_lines(shot);
    const double reach = known->largest_radius(Role::bullet) + (arrows.empty() ? 0 : 2 * frame.shape->spacing);
    Bounds bodies = blocks.bounds();
    if (style.trails) {
        for (const std::vector<Vec3>& places : *style.trails) bodies = joined(bodies, bounds_of(places));
    }
    const ViewUniforms view(projection, drawn_bounds(bodies, ensemble.bounds(), reach, box, style.grid), tile,
                            target.size(), palette(style.background));
    body_->draw_space(style, box, axes, view, tile, target);
    body_->draw_flat(style, projection, scale, axes, taken, tile, target.size());
}

}  // namespace steplab::render
