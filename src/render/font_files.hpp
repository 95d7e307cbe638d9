#pragma once

#include <string>

namespace steplab::render {

/// The vector font of all texts: Inter if it is there, otherwise DejaVu Sans; before those of the system one that came
/// with the program.
struct FontFiles {
    std::string regular;  ///< path; empty if no font was found: use the font of Dear ImGui
    std::string strong;
    float size_factor = 1;  ///< fonts of the same nominal size differ in apparent size
};

FontFiles find_font_files();

}  // namespace steplab::render
