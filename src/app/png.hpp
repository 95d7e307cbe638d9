#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace steplab {

/// The bytes of a PNG file: the same picture always gives the same bytes. `rgba` holds the rows from the top, 4 bytes a
/// pixel; the alpha is left out, pictures are opaque. Throws FileError if the picture cannot be encoded.
std::string encode_png(int width, int height, std::span<const std::uint8_t> rgba);

}  // namespace steplab
