#pragma once

#include "app/offscreen/module.hpp"

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The OpenGL backends without a display, one module each, in the order in which `auto` tries them.
inline constexpr std::array<std::string_view, 2> offscreen_kinds = {"osmesa", "egl"};

/// Draws pictures without a display, in a module loaded at run time: the program itself does not link OpenGL.
///
///     Offscreen offscreen("auto");
///     const Picture picture = offscreen.draw({.view = view_of(simulation)});
class Offscreen {
public:
    /// `kind`: one of offscreen_kinds, or `auto` for the first that works. Throws UsageError for any other word or
    /// where memory is limited to less than drivers need, and GraphicsError if none works, naming what was tried, what
    /// failed and what to install.
    explicit Offscreen(std::string_view kind);
    Offscreen(std::string_view kind, const std::filesystem::path& folder);

    /// Throws UsageError (view; too little memory), GraphicsError.
    Picture draw(const PictureRequest& request);
    /// The module in use: "osmesa" or "egl".
    const std::string& kind() const { return kind_; }

private:
    std::string kind_;
    std::unique_ptr<OffscreenModule> module_;
};

/// The folder of the modules relative to the program, both in the build tree and installed: ../lib/steplab.
std::filesystem::path module_folder();

}  // namespace steplab
