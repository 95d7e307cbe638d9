#include "repository/files.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace steplab::repository {
namespace {

namespace fs = std::filesystem;

/// Hidden folders are tools' own (.git, .cache); build folders hold what is made from the rest.
bool is_kept(const fs::path& folder) {
    const std::string name = folder.filename().string();
    return name == ".ci" || (!name.starts_with('.') && !name.starts_with("build"));
}

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

bool has_run_bit(const fs::path& path) {
    return (fs::status(path).permissions() & fs::perms::owner_exec) != fs::perms::none;
}

}  // namespace

std::vector<TextFile> text_files(const fs::path& root) {
    std::vector<TextFile> files;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
        if (entry->is_directory() && !is_kept(entry->path())) entry.disable_recursion_pending();
        // .git is a file in a further working tree
        if (!entry->is_regular_file() || entry->path().filename() == ".git") continue;
        std::string text = read(entry->path());
        const bool binary = text.find('\0') != std::string::npos;
        if (!binary) files.push_back({entry->path().lexically_relative(root), text, has_run_bit(entry->path())});
    }
    std::ranges::sort(files, {}, &TextFile::path);
    return files;
}

std::vector<TextFile> pages(const fs::path& root) {
    std::vector<TextFile> files = text_files(root);
    std::erase_if(files, [](const TextFile& file) { return file.path.extension() != ".md"; });
    return files;
}

std::string name_in_tests(const std::string& text) {
    std::string name;
    for (const char c : text.substr(0, text.ends_with(".md") ? text.size() - 3 : text.size())) {
        const bool kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (kept || !name.ends_with('_')) name += kept ? c : '_';
    }
    return name;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace steplab::repository
