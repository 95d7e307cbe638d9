#pragma once

#include "core/error.hpp"
#include "render/camera.hpp"
#include "render/style.hpp"
#include "sim/run/run_view.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace steplab {

/// A picture of a run as it is asked for.
struct PictureRequest {
    RunView view;
    render::Style style;
    std::string camera = "default";  ///< see render::camera_of()
    render::PictureSize size;
    bool panel = false;              ///< with the panels of the window, as they would look
    std::vector<RunView> past = {};  ///< earlier moments, for the panel's plots
};

/// Rows from the top, 4 bytes a pixel: red, green, blue, alpha.
struct Picture {
    render::PictureSize size;
    std::vector<std::uint8_t> rgba;
};

/// How a call into a module went: exceptions stay on their side.
struct ModuleAnswer {
    ExitCode code = ExitCode::done;
    std::string message = {};
};

/// A module's side of off-screen drawing: plain data go in and out. It is built together with the program, so that both
/// agree on their layout.
class OffscreenModule {
public:
    virtual ~OffscreenModule() = default;
    virtual ModuleAnswer draw(const PictureRequest& request, Picture& picture) noexcept = 0;
};

/// The one function a module offers: makes its OpenGL context. Null if that failed; `answer` tells why. The caller owns
/// what it gets.
using OpenOffscreenModule = OffscreenModule*(ModuleAnswer& answer);
inline constexpr const char* open_offscreen_module_name = "steplab_open_offscreen_module";

}  // namespace steplab
