#include "app/offscreen/modules.hpp"

#include "app/cli/driver_needs.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <dlfcn.h>
#include <system_error>

namespace steplab {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view remedy =
    "Off-screen drawing requires the Debian package libosmesa6, or libegl1 with libgl1-mesa-dri, and a steplab built "
    "with "
    "graphics";

struct Opened {
    std::unique_ptr<OffscreenModule> module;
    std::string trouble;  ///< why there is no module
};

Opened open(std::string_view kind, const fs::path& folder) {
    std::error_code none;
    const fs::path file = folder / (std::string(kind) + ".so");
    if (!fs::is_regular_file(file, none)) return {nullptr, fmt::format("{} not found", file.string())};
    // It stays loaded to the end of the program: OpenGL drivers may crash when unloaded.
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) return {nullptr, dlerror()};
    auto* open_module = reinterpret_cast<OpenOffscreenModule*>(dlsym(library, open_offscreen_module_name));
    if (!open_module) return {nullptr, dlerror()};
    ModuleAnswer answer;
    std::unique_ptr<OffscreenModule> module(open_module(answer));
    return {std::move(module), answer.message};
}

std::vector<std::string_view> wanted_kinds(std::string_view kind) {
    if (kind == "auto") return {offscreen_kinds.begin(), offscreen_kinds.end()};
    if (std::find(offscreen_kinds.begin(), offscreen_kinds.end(), kind) != offscreen_kinds.end()) return {kind};
    constexpr std::array<std::string_view, 3> known{"auto", offscreen_kinds[0], offscreen_kinds[1]};
    throw UsageError(unknown_word("OpenGL backend (--gl)", kind, known));
}

[[noreturn]] void rethrow(const ModuleAnswer& answer) {
    if (answer.code == ExitCode::usage) throw UsageError(answer.message);
    throw GraphicsError(answer.message);
}

}  // namespace

fs::path module_folder() {
    std::error_code none;
    const fs::path programs = fs::read_symlink("/proc/self/exe", none).parent_path();
    return (programs / "../lib/steplab").lexically_normal();
}

Offscreen::Offscreen(std::string_view kind) : Offscreen(kind, module_folder()) {}

Offscreen::Offscreen(std::string_view kind, const fs::path& folder) {
    limit_driver_threads();
    require_space_to_draw(driver_space);
    std::vector<std::string> troubles;
    for (const std::string_view each : wanted_kinds(kind)) {
        Opened opened = open(each, folder);
        if (opened.module) {
            kind_ = each;
            module_ = std::move(opened.module);
            return;
        }
        troubles.push_back(fmt::format("{}: {}", each, opened.trouble));
    }
    throw GraphicsError(fmt::format("cannot draw without a display; tried {}. {}", fmt::join(troubles, "; "), remedy));
}

Picture Offscreen::draw(const PictureRequest& request) {
    constexpr std::size_t bytes_a_pixel = 30;  // measured: of 3840x2160 pixels the picture and its file take half
    const auto pixels = static_cast<std::size_t>(request.size.width) * static_cast<std::size_t>(request.size.height);
    require_space_to_draw(drawing_space + bytes_a_pixel * pixels);
    Picture picture;
    const ModuleAnswer answer = module_->draw(request, picture);
    if (answer.code != ExitCode::done) rethrow(answer);
    return picture;
}

}  // namespace steplab
