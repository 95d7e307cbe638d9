#include "render/shader_files.hpp"

#include "core/error.hpp"
#include "core/installed_folders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

namespace steplab::render {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> text_of(const fs::path& path) {
    constexpr std::uintmax_t largest = 1 << 20;  // of a text that people write
    std::error_code none;
    std::ifstream file(path, std::ios::binary);
    if (!file || fs::file_size(path, none) > largest) return std::nullopt;
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
        fmt::format("shader {} not found in {}. Reinstall steplab, or set STEPLAB_SHADERS "
                    "to the folder that contains the shaders",
                    name, fmt::join(looked_in, ", ")));
}

/// The name in a line `#include "name"`.
std::optional<std::string> included_name(std::string_view line) {
    constexpr std::string_view directive = "#include \"";
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (!line.starts_with(directive)) return std::nullopt;
    line.remove_prefix(directive.size());
    return std::string(line.substr(0, line.find('"')));
}

/// Removes an integer from the front of `text`.
std::optional<std::size_t> take_number(std::string_view& text) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

/// One line of a log. Mesa writes "0:12(5): error: ...", others "0(12) : error ..." or "ERROR: 0:12: ...".
std::string named_line(std::string_view line, const std::vector<std::string>& files) {
    std::string_view rest = line;
    std::string_view kind;
    for (const std::string_view each : {"ERROR: ", "WARNING: "}) {
        if (rest.starts_with(each)) kind = each;
    }
    rest.remove_prefix(kind.size());
    const auto source = take_number(rest);
    if (!source || *source >= files.size() || rest.empty() || (rest[0] != ':' && rest[0] != '(')) {
        return std::string(line);
    }
    const bool bracket = rest[0] == '(';
    rest.remove_prefix(1);
    const auto number = take_number(rest);
    if (!number) return std::string(line);
    if (bracket && rest.starts_with(')')) rest.remove_prefix(1);
    return fmt::format("{}{}:{}{}", kind, files[*source], *number, rest);
}

/// `within`: the files whose includes led here, outermost first.
void append(ShaderSource& source, const std::string& name, const std::vector<fs::path>& folders,
            std::vector<std::string> within) {
    const fs::path path = find(name, folders);
    constexpr std::size_t most_files = 256;
    const bool circular = std::find(within.begin(), within.end(), name) != within.end();
    within.push_back(name);
    if (circular) {
        throw GraphicsError(fmt::format("the shader {} includes itself: {}", path.string(), fmt::join(within, " > ")));
    }
    if (source.files.size() == most_files)
        throw GraphicsError(fmt::format("the shader {} includes more than {} files", within.front(), most_files));
    const auto text = text_of(path);
    if (!text) throw GraphicsError(fmt::format("cannot read the shader {}", path.string()));
    const std::size_t number = source.files.size();
    source.files.push_back(path.string());
    // Only comments may precede #version, so the outermost file has no #line.
    if (number > 0) source.text += fmt::format("#line 1 {}\n", number);
    std::istringstream lines(*text);
    std::size_t line_number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++line_number;
        if (const auto included = included_name(line)) {
            append(source, *included, folders, within);
            source.text += fmt::format("#line {} {}\n", line_number + 1, number);
        } else {
            source.text += line + '\n';
        }
    }
}

}  // namespace

std::vector<fs::path> shader_folders() {
    if (const char* chosen = std::getenv("STEPLAB_SHADERS")) return {chosen};
    std::vector<fs::path> folders = installed_folders("shaders");
    folders.emplace_back(STEPLAB_SHADERS_IN_SOURCE);
    return folders;
}

ShaderSource read_shader(const std::string& name, const std::vector<fs::path>& folders) {
    ShaderSource source;
    append(source, name, folders, {});
    return source;
}

std::string named_log(const std::string& log, const std::vector<std::string>& files) {
    std::istringstream lines(log);
    std::string named;
    for (std::string line; std::getline(lines, line);) named += named_line(line, files) + '\n';
    return named;
}

}  // namespace steplab::render
