#include "core/installed_folders.hpp"

#include <dlfcn.h>
#include <system_error>

namespace steplab {

namespace fs = std::filesystem;

namespace {

fs::path running_program() {
    std::error_code none;
    return fs::read_symlink("/proc/self/exe", none);
}

/// The file that contains this code: the module, the library or the program. Of the program dladdr gives the path on
/// its command line, which is invalid after a change of folder.
fs::path own_file() {
    Dl_info info{};
    const bool known = dladdr(reinterpret_cast<const void*>(&installed_folders), &info) != 0 && info.dli_fname;
    return known && fs::path(info.dli_fname).is_absolute() ? fs::path(info.dli_fname) : running_program();
}

}  // namespace

std::vector<fs::path> installed_folders(const std::string& name) {
    const fs::path below = fs::path("share/steplab") / name, folder = own_file().parent_path();
    return {(folder / ".." / below).lexically_normal(), (folder / "../.." / below).lexically_normal(),
            (running_program().parent_path() / ".." / below).lexically_normal()};
}

}  // namespace steplab
