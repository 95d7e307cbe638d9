#include "render/font_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace steplab::render {

FontFiles find_font_files() {
    const FontFiles known[] = {
        {"/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf", 1},
        {"/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
         0.88F},
    };
    const auto readable = [](const FontFiles& files) {
        std::error_code ignored;
        return std::filesystem::is_regular_file(files.regular, ignored) &&
               std::filesystem::is_regular_file(files.strong, ignored);
    };
    const auto* found = std::find_if(std::begin(known), std::end(known), readable);
    return found == std::end(known) ? FontFiles{} : *found;
}

}  // namespace steplab::render
