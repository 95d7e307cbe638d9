#include "render/scene_renderer.hpp"

#include "render/ensemble_dots.hpp"
#include "render/ghosts.hpp"
#include "render/ground.hpp"
#include "render/known_shape.hpp"
#include "render/lines.hpp"
#include "render/motion_lines.hpp"
#include "render/overlay.hpp"
#include "render/particle_blocks.hpp"
#include "render/particles.hpp"
#include "render/run_labels.hpp"
#include "render/seen_area.hpp"
#include "render/shot.hpp"
#include "render/split.hpp"
#include "render/springs.hpp"
#include "render/underlay.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace steplab::render {
namespace {

/// Smaller pictures have no numbers and no legend.
bool has_room(PictureSize size, double pixel_scale) {
    return size.width >= 160 * pixel_scale && size.height >= 120 * pixel_scale;
}

bool has_room_for_lines(PictureSize size, double pixel_scale) {
    return size.width >= 100 * pixel_scale && size.height >= 50 * pixel_scale;
}

/// The box around everything that is drawn, for the near and far planes.
Bounds drawn_bounds(Bounds positions, const std::optional<Bounds>& ensemble, double margin, const AxesBox& box,
                    bool grid) {
    if (ensemble) positions = joined(positions, *ensemble);
    const Bounds bodies = joined(widened(positions, margin), box.bounds);
    if (!grid) return bodies;
    return joined(bodies, Ground::extent(box));
}

/// Seen from above, the grid is below everything.
bool is_above(const AxesBox& box, const Projection& projection) { return projection.eye().y > box.bounds.low.y; }

/// A run's part of the picture.
struct Place {
    Tile tile;         ///< of the run's own picture
    PictureSize part;  ///< the size of that tile
    PictureArea port;  ///< where in the target it is
};

/// Where the picture of an area of the whole is drawn; none if the target does not contain any of it.
std::optional<Place> place_of(const PictureArea& area, const Tile& tile, PictureSize target) {
    const auto part = shared_part(area, {tile.left, tile.top, target});
    if (!part) return std::nullopt;
    return Place{{area.size, part->left - area.left, part->top - area.top},
                 part->size,
                 {part->left - tile.left, part->top - tile.top, part->size}};
}

/// A part of a run's own picture in the target.
std::optional<PictureArea> in_target(const PictureArea& area, const Place& place) {
    const auto& [tile, part, port] = place;
    const auto shown = shared_part(area, {tile.left, tile.top, part});
    if (!shown) return std::nullopt;
    return PictureArea{shown->left - tile.left + port.left, shown->top - tile.top + port.top, shown->size};
}

/// Limits drawing to a part of the target.
void scissor(const PictureArea& area, const RenderTarget& target) {
    glScissor(area.left, target.size().height - area.top - area.size.height, area.size.width, area.size.height);
    glEnable(GL_SCISSOR_TEST);
}

void set_viewport(const PictureArea& port, const RenderTarget& target) {
    glViewport(port.left, target.size().height - port.top - port.size.height, port.size.width, port.size.height);
}

/// What is drawn over the finished scene of a run.
struct Flat {
    Projection projection;
    std::optional<ColourScale> scale;
    Axes axes;
    Occupancy taken;
    std::vector<RunLine> lines = {};
    RunLayout layout = RunLayout::ghosts;
    Tile tile = {};  ///< of the run's own picture, as if the whole target showed it
    bool legend = true;
    std::size_t one_of = 1;  ///< see Particles::one_of()
};

/// The style with one colour scale for all runs: where none is given, that of the run with the largest value.
Style with_common_scale(Style style, ShownRuns runs) {
    if (style.scale_maximum) return style;
    double largest = 0;
    for (const ShownRun& run : runs) {
        if (const auto scale = colour_scale(*run.frame, style)) largest = std::max(largest, scale->maximum);
    }
    if (largest > 0) style.scale_maximum = largest;
    return style;
}

}  // namespace

struct SceneRenderer::Body {
    Ground ground;
    Underlay underlay;
    Springs springs;
    Particles particles;
    EnsembleDots ensemble;
    Lines lines;
    std::vector<Rod> arrows, trail;
    Sketch sketch;
    ParticleBlocks blocks;
    std::optional<Ghosts> ghosts;                                  ///< made when first needed
    std::array<std::optional<KnownShape>, most_shown_runs> known;  ///< of each run's last frame

    static void begin();
    std::vector<Flat> draw_split(ShownRuns runs, const Style& style, const Camera& camera, const Tile& tile,
                                 const RenderTarget& target);
    Flat draw_run(std::size_t run, const Frame& frame, ShownRuns beside, const Style& style, const Camera& camera,
                  const Place& place, const RenderTarget& target);
    Bounds bodies(const Style& style, bool with_ghosts) const;
    void draw_underlay(std::size_t run, const Style& style, const AxesBox& box, const Projection& projection,
                       const Place& place, const RenderTarget& target);
    std::optional<PictureArea> sampled_area(const Shot& shot, const AxesBox& box, const Axes& axes, const Bounds& all,
                                            bool with_ghosts) const;
    void draw_space(const Style& style, const AxesBox& box, const Axes& axes, const ViewUniforms& view,
                    const RenderTarget& target, bool with_ghosts);
    void draw_grid(const Style& style, const AxesBox& box, const ViewUniforms& view);
    void draw_flat(const Style& style, const Flat& flat, PictureSize part);
    void draw_borders(const Style& style, const Tile& tile, std::size_t runs, PictureSize part);
};

void SceneRenderer::Body::begin() {
    glEnable(GL_MULTISAMPLE);
    glDisable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDepthMask(GL_TRUE);
}

std::vector<Flat> SceneRenderer::Body::draw_split(ShownRuns runs, const Style& given, const Camera& camera,
                                                  const Tile& tile, const RenderTarget& target) {
    const Style style = with_common_scale(given, runs);
    target.bind();
    ground.draw_backdrop(palette(style.background), tile, target.size());
    target.resolve();
    const auto areas = split_areas(tile.whole, runs.size());
    // The legend is that of all runs: it is drawn once, at the upper right.
    const std::size_t in_corner = areas[1].top == 0 ? 1 : 0;
    std::vector<Flat> flats;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const auto place = place_of(areas[i], tile, target.size());
        if (!place) continue;
        flats.push_back(draw_run(i, *runs[i].frame, {}, style, camera, *place, target));
        flats.back().lines = lines_of_tile(runs[i], i);
        flats.back().layout = RunLayout::split;
        flats.back().tile = {areas[i].size, tile.left - areas[i].left, tile.top - areas[i].top};
        flats.back().legend = i == in_corner;
    }
    return flats;
}

/// Draws a run, and those beside it as ghosts.
Flat SceneRenderer::Body::draw_run(std::size_t run, const Frame& frame, ShownRuns beside, const Style& style,
                                   const Camera& camera, const Place& place, const RenderTarget& target) {
    const auto& [tile, part, port] = place;
    Flat flat{Projection(camera, tile.whole), colour_scale(frame, style), {}, Occupancy(tile.whole)};
    const Projection& projection = flat.projection;
    if (!known[run] || known[run]->shape != frame.shape) known[run].emplace(frame.shape);
    blocks.place(frame, projection);
    const AxesBox box = axes_box(known[run]->expected, frame.shape->spacing, with_cell(blocks.bounds(), frame));
    if (style.grid) flat.axes = axes_of(box, projection, style.pixel_scale);
    if (style.grid && frame.cell) add_cell_edges(flat.axes, *frame.cell);
    if (style.grid) add_box_edges(flat.axes, *frame.shape, blocks.bounds());
    mark_cross(flat.taken, tile.whole, style.pixel_scale);
    const Shot shot{frame, *known[run], style, flat.scale, projection, tile, part};
    if (style.springs) springs.prepare(shot, blocks);
    particles.prepare(shot, blocks, flat.taken);
    flat.one_of = particles.one_of();
    ensemble.prepare(shot);
    arrows = motion_arrows(shot);
    trail = trail_lines(shot);
    if (!beside.empty() && !ghosts) ghosts.emplace();
    if (!beside.empty()) ghosts->prepare(shot, beside, flat.taken);
    const double reach = known[run]->largest_radius(Role::bullet) + (arrows.empty() ? 0 : 2 * frame.shape->spacing);
    const Bounds all = bodies(style, !beside.empty());
    const ViewUniforms view(projection, drawn_bounds(all, ensemble.bounds(), reach, box, style.grid), tile, part,
                            palette(style.background));
    draw_underlay(run, style, box, projection, place, target);
    const auto sampled = sampled_area(shot, box, flat.axes, all, !beside.empty());
    if (const auto area = sampled ? in_target(*sampled, place) : std::nullopt) {
        target.bind();
        set_viewport(port, target);
        scissor(*area, target);  // points and lines reach beyond the viewport
        glClear(GL_DEPTH_BUFFER_BIT);
        underlay.draw_into_samples(target);
        draw_space(style, box, flat.axes, view, target, !beside.empty());
        target.resolve(*area);
    }
    return flat;
}

/// The backdrop, and the grid where it is below everything.
void SceneRenderer::Body::draw_underlay(std::size_t run, const Style& style, const AxesBox& box,
                                        const Projection& projection, const Place& place, const RenderTarget& target) {
    const auto& [tile, part, port] = place;
    const bool grid = style.grid && is_above(box, projection);
    const Underlay::Look look{
        projection.camera(), tile, port, style.background, grid ? std::optional(box) : std::nullopt, style.pixel_scale};
    glDisable(GL_SCISSOR_TEST);
    if (underlay.repeat(run, look, target)) return;
    target.bind();
    set_viewport(port, target);
    ground.draw_backdrop(palette(style.background), tile, part);
    if (grid) draw_grid(style, box, {projection, Ground::extent(box), tile, part, palette(style.background)});
    target.resolve(port);
    underlay.keep(run, look, target);
}

/// The part of the run's own picture where pixels may have several colours: around all that is drawn but the underlay.
std::optional<PictureArea> SceneRenderer::Body::sampled_area(const Shot& shot, const AxesBox& box, const Axes& axes,
                                                             const Bounds& all, bool with_ghosts) const {
    const Projection& projection = shot.projection;
    const Shape& shape = *shot.known.shape;
    const PictureArea whole{0, 0, projection.size()};
    const bool grid_above = shot.style.grid && !is_above(box, projection);
    const bool leaves_box = shape.is_periodic() && (shot.style.springs || with_ghosts);  // to the nearest images
    if (grid_above || leaves_box) return whole;
    // rings are the widest around a particle
    const double reach = 2.1 * shot.known.largest_radius(Role::bullet) + (arrows.empty() ? 0 : 2 * shape.spacing);
    Bounds bounds = drawn_bounds(all, ensemble.bounds(), reach, box, false);
    for (const AxisLine& line : axes.lines) bounds = joined(bounds, bounds_of(std::array{line.start, line.end}));
    return seen_area(bounds, projection, 8 + 10 * shot.style.pixel_scale);
}

/// The box around particles, trails and ghosts.
Bounds SceneRenderer::Body::bodies(const Style& style, bool with_ghosts) const {
    Bounds bounds = blocks.bounds();
    if (style.trails) {
        for (const std::vector<Vec3>& places : *style.trails) bounds = joined(bounds, bounds_of(places));
    }
    if (with_ghosts && ghosts->bounds()) bounds = joined(bounds, *ghosts->bounds());
    return bounds;
}

void SceneRenderer::Body::draw_space(const Style& style, const AxesBox& box, const Axes& axes, const ViewUniforms& view,
                                     const RenderTarget& target, bool with_ghosts) {
    const Palette& colours = palette(style.background);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    if (style.springs) springs.draw(view, style.pixel_scale);
    particles.draw(view, target);
    lines.draw(arrows, view, 1.5 * style.pixel_scale);
    lines.draw(trail, view, 1.5 * style.pixel_scale);
    if (with_ghosts) ghosts->draw_lines(view, style);
    if (style.grid) ground.draw_axes(axes, view, colours, style.pixel_scale);
    if (style.grid && !is_above(box, view.projection())) draw_grid(style, box, view);
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    ensemble.draw(view, style.pixel_scale);
    if (with_ghosts) ghosts->draw_particles(view, style.pixel_scale);
    particles.draw_rings(view, style.pixel_scale);
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

void SceneRenderer::Body::draw_grid(const Style& style, const AxesBox& box, const ViewUniforms& view) {
    glEnable(GL_BLEND);
    glDepthMask(GL_FALSE);
    ground.draw_grid(box, view, palette(style.background), style.pixel_scale);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
}

void SceneRenderer::Body::draw_flat(const Style& style, const Flat& flat, PictureSize part) {
    const Palette& colours = palette(style.background);
    const PictureSize size = flat.tile.whole;
    if (!has_room_for_lines(size, style.pixel_scale)) return;
    sketch.begin(size, style.pixel_scale);
    const bool in_full = has_room(size, style.pixel_scale);
    const PictureArea room = run_lines_area(size, flat.layout, flat.lines.size(), style.pixel_scale);
    const PictureArea texts = sketch_run_lines(sketch, flat.lines, room, colours, style.pixel_scale);
    if (in_full && style.grid) sketch_labels(sketch, flat.axes, flat.taken, texts, size, colours);
    const bool over_cross = !flat.lines.empty() && shared_part(room, cross_area(size, style.pixel_scale));
    if (in_full && style.grid && !over_cross) sketch_cross(sketch, flat.projection, colours, style.pixel_scale);
    const bool above = texts.top < size.height / 2;
    if (in_full && style.legend && flat.legend && flat.scale)
        sketch_legend(sketch, *flat.scale, size, colours, style.pixel_scale, above ? texts.size.height : 0);
    if (in_full && flat.one_of > 1) sketch_share(sketch, flat.one_of, size, colours, style.pixel_scale);
    sketch.finish(flat.tile, part);
}

/// Lines between the pictures of the runs.
void SceneRenderer::Body::draw_borders(const Style& style, const Tile& tile, std::size_t runs, PictureSize part) {
    const Palette& colours = palette(style.background);
    sketch.begin(tile.whole, style.pixel_scale);
    const std::size_t places = runs == 3 ? 4 : runs;  // one of them empty
    for (const auto& [left, top, size] : split_areas(tile.whole, places)) {
        const PixelPoint corner{static_cast<double>(left), static_cast<double>(top)};
        const double width = style.pixel_scale;
        if (left > 0) sketch.box(corner, {corner.x + width, corner.y + size.height}, colours.grid, 0.6);
        if (top > 0) sketch.box(corner, {corner.x + size.width, corner.y + width}, colours.grid, 0.6);
    }
    sketch.finish(tile, part);
}

SceneRenderer::SceneRenderer() : body_(std::make_unique<Body>()) {}
SceneRenderer::~SceneRenderer() = default;
SceneRenderer::SceneRenderer(SceneRenderer&&) noexcept = default;
SceneRenderer& SceneRenderer::operator=(SceneRenderer&&) noexcept = default;

void SceneRenderer::draw(const Frame& frame, const Style& style, const Camera& camera, const RenderTarget& target,
                         const std::optional<Tile>& part) {
    const ShownRun alone{&frame};
    draw(ShownRuns(&alone, 1), style, camera, target, part);
}

void SceneRenderer::draw(ShownRuns runs, const Style& style, const Camera& camera, const RenderTarget& target,
                         const std::optional<Tile>& part) {
    runs = runs.first(std::min(runs.size(), most_shown_runs));
    const Tile tile = part.value_or(Tile{target.size()});
    const bool split = style.layout == RunLayout::split && runs.size() > 1;
    SceneRenderer::Body::begin();
    std::vector<Flat> flats;
    if (split) {
        flats = body_->draw_split(runs, style, camera, tile, target);
    } else {
        Style own = style;
        if (runs.size() > 1) own.swatch = runs[0].swatch;
        flats.push_back(body_->draw_run(0, *runs[0].frame, runs.subspan(1), own, camera,
                                        {tile, target.size(), {0, 0, target.size()}}, target));
        flats[0].lines = lines_of_runs(runs, style);
        flats[0].tile = tile;
    }
    glDisable(GL_SCISSOR_TEST);
    target.bind_picture();
    for (const Flat& flat : flats) body_->draw_flat(style, flat, target.size());
    if (split) body_->draw_borders(style, tile, runs.size(), target.size());
}

}  // namespace steplab::render
