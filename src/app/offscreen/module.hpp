#pragma once

#include "core/error.hpp"
#include "render/camera.hpp"
#include "render/style.hpp"
#include "session/session_view.hpp"
#include "ui/caption_text.hpp"
#include "ui/plot/choice.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// What plots show of runs at an earlier time of the leading one.
struct PastMoment {
    RunView leading;                           ///< without its particles
    Sample sample = {};                        ///< of it
    std::vector<Sample> followers = {};        ///< of the runs beside it
    std::optional<SessionErrors> errors = {};  ///< of all of them
};

/// A request for a picture of a run.
struct PictureRequest {
    RunView view;
    render::Style style;
    std::string camera = "default";  ///< see render::camera_of()
    render::PictureSize size;
    bool panel = false;                                ///< with the panels of the window
    std::optional<ui::Caption> caption = {};           ///< at the foot of the picture
    std::vector<ui::PlotKind> plots = {};              ///< with the panels; empty: the usual ones
    std::vector<PastMoment> past = {};                 ///< earlier ones, for the plots
    std::vector<RunView> followers = {};               ///< the runs beside it, at the same time
    std::optional<SessionErrors> errors = {};          ///< of all of them, for the panel
    std::shared_ptr<const CostsView> costs = {};       ///< what accuracy costs, for the plots of that
    std::shared_ptr<const PresentLimit> present = {};  ///< of the leading run, for the panel
    std::shared_ptr<const BlowUp> blow_up = {};        ///< if that diverged
    std::optional<PlaybackView> playback = {};         ///< if it is a frame of a file
    TimeLineView line = {};                            ///< of that file
};

/// A picture: rows from the top, 4 bytes per pixel (red, green, blue, alpha).
struct Picture {
    render::PictureSize size;
    std::vector<std::uint8_t> rgba;
    std::string camera = {};  ///< as text that reads back exactly, for another picture with it
};

/// The result of a call into a module; exceptions do not cross its border.
struct ModuleAnswer {
    ExitCode code = ExitCode::done;
    std::string message = {};
};

/// Off-screen drawing in a module, with plain data as input and output. It is built together with the program, so that
/// both agree on the layout of the data.
class OffscreenModule {
public:
    virtual ~OffscreenModule() = default;
    virtual ModuleAnswer draw(const PictureRequest& request, Picture& picture) noexcept = 0;
};

/// The only exported function of a module: creates its OpenGL context. Null if that failed, with the reason in
/// `answer`. The caller owns the result.
using OpenOffscreenModule = OffscreenModule*(ModuleAnswer& answer);
inline constexpr const char* open_offscreen_module_name = "steplab_open_offscreen_module";

}  // namespace steplab
