#include "render/font_files.hpp"

#include "core/installed_folders.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

namespace steplab::render {

FontFiles find_font_files() {
    std::vector<FontFiles> known;
    const auto add = [&known](const std::filesystem::path& inter, const std::filesystem::path& dejavu) {
        known.push_back({inter / "Inter-Regular.otf", inter / "Inter-SemiBold.otf", 1});
        known.push_back({dejavu / "DejaVuSans.ttf", dejavu / "DejaVuSans-Bold.ttf", 0.88F});
    };
    for (const std::filesystem::path& own : installed_folders("fonts")) add(own, own);
    add("/usr/share/fonts/opentype/inter", "/usr/share/fonts/truetype/dejavu");
    const auto readable = [](const FontFiles& files) {
        std::error_code ignored;
        return std::filesystem::is_regular_file(files.regular, ignored) &&
               std::filesystem::is_regular_file(files.strong, ignored);
    };
    const auto found = std::find_if(known.begin(), known.end(), readable);
    return found == known.end() ? FontFiles{} : *found;
}

}  // namespace steplab::render
