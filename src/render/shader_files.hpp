#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steplab::render {

/// Folders in which the shaders are looked for, first to last: the environment variable STEPLAB_SHADERS alone if it is
/// set; else beside the installed program or module, then the source tree it was built from. Independent of the
/// working directory.
std::vector<std::filesystem::path> shader_folders();

/// The text of one shader with every `#include "name"` of it replaced by that file; each part is announced by `#line`,
/// so that a compiler's messages "source:line" can be told in names.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< files[i] is the path of source number i
};

/// Reads `name` (such as "sphere.vert") and what it includes from the first of `folders` that has it.
/// Throws GraphicsError that names the file and every folder looked in.
ShaderSource read_shader(const std::string& name, const std::vector<std::filesystem::path>& folders);

/// A compiler's log with "number:line" or "number(line)" at the start of a message told as "path:line".
std::string named_log(const std::string& log, const std::vector<std::string>& files);

}  // namespace steplab::render
