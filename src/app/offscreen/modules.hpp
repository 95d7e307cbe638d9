#pragma once

#include "app/offscreen/module.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The ways to get OpenGL without a display, one module each; in the order in which `auto` tries them.
inline constexpr std::array<std::string_view, 2> offscreen_kinds = {"osmesa", "egl"};

/// Draws pictures without a display, with a module that is loaded for it: this program itself is linked to no OpenGL.
///
///     Offscreen offscreen("auto");
///     const Picture picture = offscreen.draw({.view = view_of(simulation)});
class Offscreen {
public:
    /// `kind` is one of offscreen_kinds, or `auto`: the first that works. Throws UsageError for any other word;
    /// GraphicsError if none works, naming what was tried, what went wrong and how to get it.
    explicit Offscreen(std::string_view kind);
    Offscreen(std::string_view kind, const std::filesystem::path& folder);

    /// Throws what the request deserves: UsageError (view), GraphicsError.
    Picture draw(const PictureRequest& request);
    /// The module in use: "osmesa" or "egl".
    const std::string& kind() const { return kind_; }

private:
    std::string kind_;
    std::unique_ptr<OffscreenModule> module_;
};

/// Where the modules are, seen from the program, in the build tree as when installed: ../lib/steplab.
std::filesystem::path module_folder();

}  // namespace steplab
