#include "repository/arrows.hpp"

#include <fmt/format.h>

#include <map>
#include <regex>
#include <set>

namespace steplab::repository {
namespace {

using Folders = std::set<std::string>;

/// What a folder may include besides itself. `core` is the vocabulary of all.
const std::map<std::string, Folders>& arrows() {
    static const std::map<std::string, Folders> map{
        {"core", {}},
        {"plot", {"core"}},
        {"methods", {"core"}},
        {"models", {"core"}},
        {"sim", {"core", "methods", "models"}},
        {"io", {"core", "models", "sim"}},
        {"lab", {"core", "plot", "methods", "models", "sim", "io"}},
        {"session", {"core", "methods", "models", "sim", "io", "lab"}},
        {"render", {"core"}},
        {"ui", {"core", "plot", "sim", "io", "session", "render"}},
        {"app", {"core", "plot", "methods", "models", "sim", "io", "lab", "session", "render", "ui"}},
    };
    return map;
}

bool knows_drawing(const std::string& folder) { return folder == "render" || folder == "ui" || folder == "app"; }

/// What is wrong with one line of a file in `folder`; empty if nothing is.
std::string complaint(const std::string& folder, const std::string& line) {
    static const std::regex own(R"re(^\s*#\s*include\s*"(?:([^"/]+)/)?([^"]*)")re");
    static const std::regex drawing(R"(^\s*#\s*include\s*[<"](GL|GLES\w*|EGL|GLFW|KHR|glm|imgui)\b.*)");
    static const std::regex linked(R"(^[^#]*\bsteplab_(core|plot|methods|models|sim|io|lab|session|render|ui)\b.*)");
    std::smatch match;
    if (std::regex_match(line, drawing) && !knows_drawing(folder)) return "OpenGL, windows and ImGui are unknown here";
    const bool is_include = std::regex_search(line, match, own);
    if (is_include && !match[1].matched) return fmt::format("\"{}\" is not named from src/", match[2].str());
    if (!is_include && !std::regex_match(line, match, linked)) return {};
    const std::string other = match[1];
    if (other == folder || arrows().at(folder).contains(other)) return {};
    return fmt::format("{} may not know {}", folder, other);
}

/// Programs on the library, which know include/steplab and nothing of src/.
bool is_outside(const std::filesystem::path& path) {
    const std::string first = path.begin()->string();
    return first == "include" || first == "examples" || first == "python" ||
           path.string().starts_with("tests/library/");
}

/// What is wrong with a line of such a program; empty if nothing is.
std::string complaint_outside(const std::string& line) {
    static const std::regex room(R"re(^\s*#\s*include\s*["<]([^"/>]+)/.*)re");
    std::smatch match;
    if (!std::regex_match(line, match, room) || !arrows().contains(match[1])) return {};
    return fmt::format("the library's users may not know {}", match[1].str());
}

bool is_looked_at(const std::filesystem::path& path) {
    const auto extension = path.extension();
    return extension == ".hpp" || extension == ".cpp" || extension == ".in" || path.filename() == "CMakeLists.txt";
}

}  // namespace

std::vector<std::string> forbidden_arrows(const std::vector<TextFile>& files) {
    std::vector<std::string> found;
    for (const TextFile& file : files) {
        const bool outside = is_outside(file.path);
        if ((*file.path.begin() != "src" && !outside) || !is_looked_at(file.path)) continue;
        const std::string folder = std::next(file.path.begin())->string();
        if (folder == "CMakeLists.txt") continue;
        if (!outside && !arrows().contains(folder)) {
            found.push_back(fmt::format("{}: src/{} is not a folder of the plan", file.path.string(), folder));
            continue;
        }
        std::size_t number = 0;
        for (const std::string& line : lines_of(file.text)) {
            ++number;
            const std::string wrong = outside ? complaint_outside(line) : complaint(folder, line);
            if (!wrong.empty()) found.push_back(fmt::format("{}:{}: {}", file.path.string(), number, wrong));
        }
    }
    return found;
}

}  // namespace steplab::repository
