#pragma once

#include "io/temporary_folder.hpp"

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

namespace steplab {

/// All bytes of a file.
inline std::string text_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error("no file " + file);
    return {std::istreambuf_iterator<char>(in), {}};
}

inline void put_text(const std::string& file, std::string_view text) { std::ofstream(file, std::ios::binary) << text; }

}  // namespace steplab
