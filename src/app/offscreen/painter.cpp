#include "app/offscreen/painter.hpp"

#include "app/shown_runs.hpp"
#include "render/framing.hpp"
#include "render/render_target.hpp"
#include "render/split.hpp"
#include "ui/interface.hpp"

#include <imgui.h>

#include <algorithm>
#include <functional>

namespace steplab {
namespace {

// Longest side of a tile: its multisampled framebuffer takes 128 MiB.
constexpr int tile_side = 2048;

void copy_into(Picture& picture, const OffscreenPainter::Place& place, const std::vector<std::uint8_t>& tile) {
    const std::size_t row = 4 * static_cast<std::size_t>(place.size.width);
    for (int y = 0; y < place.size.height; ++y) {
        const std::size_t to =
            4 * (static_cast<std::size_t>(place.top + y) * static_cast<std::size_t>(picture.size.width) +
                 static_cast<std::size_t>(place.left));
        std::copy_n(tile.data() + static_cast<std::size_t>(y) * row, row, picture.rgba.data() + to);
    }
}

/// The panels as in the window, and the camera and style for the scene.
class Panels {
public:
    /// Of an interface that is as newly made.
    Panels(const PictureRequest& request, ui::Interface& interface, const render::ImguiRenderer& renderer)
        : interface_(interface),
          view_{.leading = request.view,
                .followers = request.followers,
                .line = request.line,
                .errors = request.errors,
                .costs = request.costs,
                .present = request.present,
                .blow_up = request.blow_up,
                .playback = request.playback},
          style_(request.style),
          request_(request),
          renderer_(renderer) {
        if (!request.plots.empty()) interface_.use({.plots = chosen(request.plots)}, {});
        interface_.select_too(request.style.selected_too);
        for (const PastMoment& moment : request.past) record(moment);
        interface_.record(request.view);
        add(view_.leading, sample_of(request.view));
        for (std::size_t i = 0; i < view_.followers.size(); ++i)
            add(view_.followers[i], sample_of(request.followers[i]));
        add_errors(request.view.frame.step, request.errors);
        // The first frame determines the area of the scene; the second is drawn with the camera for it.
        draw();
        if (request.panel && !request.plots.empty() && !interface_.shows_plots())
            throw UsageError("--plots: the caption leaves no room for plots; choose a higher picture (--size)");
        camera_ = render::camera_of(request.camera, view_.leading.frame,
                                    render::leading_size(scene_size(), style_.layout, 1 + view_.followers.size()));
        draw();
    }

    const render::Camera& camera() const { return camera_; }
    render::PictureSize scene_size() const { return {interface_.scene().width, interface_.scene().height}; }

    void paint(render::SceneRenderer& scene, const OffscreenPainter::Place& place,
               const render::RenderTarget& target) const {
        const ui::PixelRect rect = interface_.scene();
        scene.draw(shown_runs(view_.leading, view_.followers), style_, camera_, target,
                   render::Tile{scene_size(), place.left - rect.x, place.top - rect.y});
        ImDrawData data = interface_.draw_data();
        const ImVec2 scale = data.FramebufferScale;
        data.DisplayPos = {static_cast<float>(place.left) / scale.x, static_cast<float>(place.top) / scale.y};
        data.DisplaySize = {static_cast<float>(place.size.width) / scale.x,
                            static_cast<float>(place.size.height) / scale.y};
        renderer_.draw(data);
    }

private:
    void draw() { interface_.draw_still(view_, {camera_, style_}, !request_.panel, request_.caption); }

    static std::vector<ui::PlotChoice> chosen(const std::vector<ui::PlotKind>& kinds) {
        std::vector<ui::PlotChoice> plots;
        plots.reserve(kinds.size());
        for (const ui::PlotKind kind : kinds) plots.push_back(ui::default_choice(kind));
        return plots;
    }

    /// For the plots.
    void record(const PastMoment& moment) {
        interface_.record(moment.leading);
        add_errors(moment.leading.frame.step, moment.errors);
        view_.leading.series.samples.push_back(moment.sample);
        for (std::size_t i = 0; i < moment.followers.size(); ++i) add(view_.followers[i], moment.followers[i]);
    }

    void add_errors(std::uint64_t step, const std::optional<SessionErrors>& errors) {
        if (!errors) return;
        view_.error_series.resize(errors->runs.size());
        for (std::size_t run = 0; run < errors->runs.size(); ++run) {
            if (const auto& known = errors->runs[run])
                view_.error_series[run].samples.push_back({step, known->time, known->error, known->reference_error});
        }
    }

    /// A run beside the leading one has none of its own between two of its steps, and none after it has diverged; a
    /// frame of a file may be among those that are known.
    static void add(RunView& run, const Sample& sample) {
        std::vector<Sample>& samples = run.series.samples;
        if (samples.empty() || samples.back().step < sample.step) samples.push_back(sample);
    }

    ui::Interface& interface_;
    SessionView view_;
    render::Style style_;
    const PictureRequest& request_;
    render::Camera camera_;
    const render::ImguiRenderer& renderer_;
};

}  // namespace

Picture OffscreenPainter::paint(const PictureRequest& request) {
    return request.panel || request.caption ? paint_with_panels(request) : paint_scene(request);
}

Picture OffscreenPainter::paint_scene(const PictureRequest& request) {
    const auto runs = shown_runs(request.view, request.followers);
    const auto size = render::leading_size(request.size, request.style.layout, runs.size());
    const render::Camera camera = render::camera_of(request.camera, request.view.frame, size);
    Picture picture = in_tiles(request.size, [&](const Place& place, const render::RenderTarget& target) {
        scene_.draw(runs, request.style, camera, target, render::Tile{request.size, place.left, place.top});
    });
    picture.camera = render::view_text(camera);
    return picture;
}

Picture OffscreenPainter::paint_with_panels(const PictureRequest& request) {
    const ui::Display display{request.size.width, request.size.height, static_cast<float>(request.style.pixel_scale)};
    if (!panels_) {
        panels_.emplace(display);
    } else if (panels_->interface.resize(display)) {
        panels_->renderer.upload_fonts(panels_->interface.fonts());
    }
    panels_->interface.clear();
    const Panels panels(request, panels_->interface, panels_->renderer);
    Picture picture = in_tiles(request.size, [&](const Place& place, const render::RenderTarget& target) {
        panels.paint(scene_, place, target);
    });
    picture.camera = render::view_text(panels.camera());
    return picture;
}

Picture OffscreenPainter::in_tiles(render::PictureSize size, const PaintTile& paint) {
    Picture picture{size, std::vector<std::uint8_t>(4 * static_cast<std::size_t>(size.width) *
                                                    static_cast<std::size_t>(size.height))};
    for (int top = 0; top < size.height; top += tile_side) {
        for (int left = 0; left < size.width; left += tile_side) {
            const Place place{
                left, top, {std::min(tile_side, size.width - left), std::min(tile_side, size.height - top)}};
            if (!target_ || target_->size() != place.size) {
                target_.reset();  // a large one first makes room for the other
                target_.emplace(place.size);
            }
            paint(place, *target_);
            copy_into(picture, place, target_->read());
        }
    }
    return picture;
}

}  // namespace steplab
