#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steplab::render {

/// The folders to search for shaders, in order: only that of the environment variable STEPLAB_SHADERS if it is set;
/// otherwise those of the installed program or module, then the source tree it was built from. Independent of the
/// working directory.
std::vector<std::filesystem::path> shader_folders();

/// The text of a shader with every `#include "name"` replaced by that file. `#line` precedes each part, so that
/// "source:line" in messages of the compiler can be translated into file names.
struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< files[i] is the path of source number i
};

/// Reads `name` (such as "sphere.vert") and what it includes from the first of `folders` that has it.
/// Throws GraphicsError that names the file and all searched folders.
ShaderSource read_shader(const std::string& name, const std::vector<std::filesystem::path>& folders);

/// The log of a compiler with "number:line" or "number(line)" at the start of a message replaced by "path:line".
std::string named_log(const std::string& log, const std::vector<std::string>& files);

}  // namespace steplab::render
