#pragma once

#include <string>

namespace steplab::render {

/// The vector font of everything that is written: Inter if it is installed, else DejaVu Sans.
struct FontFiles {
    std::string regular;  ///< path; empty if no font was found, and Dear ImGui's own is to be used
    std::string strong;
    float size_factor = 1;  ///< fonts of one nominal size differ in how large they look
};

FontFiles find_font_files();

}  // namespace steplab::render
