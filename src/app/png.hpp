#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace steplab {

/// The bytes of a PNG file: the same picture always gives the same bytes. `rgba` holds the rows from the top, 4 bytes a
/// pixel; the alpha is left out, pictures are opaque. Throws FileError if the picture cannot be encoded.
std::string encode_png(int width, int height, std::span<const std::uint8_t> rgba);

/// A picture that was read: rows from the top, 4 bytes a pixel.
struct ReadPicture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba;
};

/// The picture of a PNG file that comes with the program. Throws FileError if it cannot be read.
ReadPicture read_png(const std::filesystem::path& file);

}  // namespace steplab
