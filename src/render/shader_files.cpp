#include "render/shader_files.hpp"

#include "core/error.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>
#include <optional>
#include <regex>
#include <sstream>

namespace steplab::render {
namespace {

namespace fs = std::filesystem;

// The file this code is part of: the module, or the program where it is linked into one.
fs::path own_file() {
    Dl_info info{};
    std::error_code none;
    const bool known = dladdr(reinterpret_cast<const void*>(&shader_folders), &info) != 0 && info.dli_fname;
    const fs::path program = fs::read_symlink("/proc/self/exe", none);
    // For the program itself dladdr gives what it was started as, which says nothing after a change of folder.
    const bool is_module = known && fs::path(info.dli_fname).is_absolute() && fs::path(info.dli_fname) != program;
    return is_module ? fs::path(info.dli_fname) : program;
}

std::optional<std::string> text_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

fs::path find(const std::string& name, const std::vector<fs::path>& folders) {
    std::error_code none;
    for (const auto& folder : folders) {
        if (fs::is_regular_file(folder / name, none)) return folder / name;
    }
    std::vector<std::string> looked_in(folders.size());
    std::transform(folders.begin(), folders.end(), looked_in.begin(), [](const fs::path& f) { return f.string(); });
    throw GraphicsError(
        fmt::format("the shader {} was not found; looked in {}. Reinstall steplab, or set "
                    "STEPLAB_SHADERS to the folder that holds the shaders",
                    name, fmt::join(looked_in, ", ")));
}

void append(ShaderSource& source, const std::string& name, const std::vector<fs::path>& folders) {
    const fs::path path = find(name, folders);
    const auto text = text_of(path);
    if (!text) throw GraphicsError(fmt::format("the shader {} cannot be read", path.string()));
    const std::size_t number = source.files.size();
    source.files.push_back(path.string());
    // Nothing but comments may stand before #version, so the outermost file is not announced.
    if (number > 0) source.text += fmt::format("#line 1 {}\n", number);
    static const std::regex include(R"re(\s*#include\s+"([^"]+)"\s*)re");
    std::istringstream lines(*text);
    std::smatch match;
    std::size_t line_number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++line_number;
        if (std::regex_match(line, match, include)) {
            append(source, match[1], folders);
            source.text += fmt::format("#line {} {}\n", line_number + 1, number);
        } else {
            source.text += line + '\n';
        }
    }
}

}  // namespace

std::vector<fs::path> shader_folders() {
    if (const char* chosen = std::getenv("STEPLAB_SHADERS")) return {chosen};
    // Installed, a program is in bin/ and a module in lib/steplab/.
    const fs::path folder = own_file().parent_path();
    return {(folder / "../share/steplab/shaders").lexically_normal(),
            (folder / "../../share/steplab/shaders").lexically_normal(), STEPLAB_SHADERS_IN_SOURCE};
}

ShaderSource read_shader(const std::string& name, const std::vector<fs::path>& folders) {
    ShaderSource source;
    append(source, name, folders);
    return source;
}

std::string named_log(const std::string& log, const std::vector<std::string>& files) {
    // Mesa writes "0:12(5): error: ...", others "0(12) : error ..." or "ERROR: 0:12: ...".
    static const std::regex place(R"(^((?:ERROR|WARNING): )?(\d+)[:(](\d+)\)?)");
    std::istringstream lines(log);
    std::string named;
    std::smatch match;
    for (std::string line; std::getline(lines, line);) {
        const bool found = std::regex_search(line, match, place) && std::stoul(match[2]) < files.size();
        if (found) {
            named += fmt::format("{}{}:{}{}\n", match[1].str(), files[std::stoul(match[2])], match[3].str(),
                                 match.suffix().str());
        } else {
            named += line + '\n';
        }
    }
    return named;
}

}  // namespace steplab::render
