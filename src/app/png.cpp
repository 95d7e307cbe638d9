#include "app/png.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>
#include <png.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace steplab {
namespace {

/// Owns libpng's two structures.
class PngWriter {
public:
    explicit PngWriter(std::string& out) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, warn);
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_) throw FileError("libpng cannot be used");
        png_set_write_fn(png_, &out, append, nullptr);
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    void write(int width, int height, std::span<const std::uint8_t> rgba) {
        png_set_user_limits(png_, 0x7fffffff, 0x7fffffff);
        // The lowest level takes half the time of the usual one, and flat colours pack well at any.
        png_set_compression_level(png_, 1);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
        png_set_IHDR(png_, info_, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png_, info_);
        png_set_filler(png_, 0, PNG_FILLER_AFTER);
        const std::size_t row = 4 * static_cast<std::size_t>(width);
        for (std::size_t y = 0; y < static_cast<std::size_t>(height); ++y) png_write_row(png_, rgba.data() + y * row);
        png_write_end(png_, info_);
    }

private:
    static void append(png_structp png, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
    }
    [[noreturn]] static void fail(png_structp, png_const_charp message) {
        throw FileError(fmt::format("the picture cannot be encoded: {}", message));
    }
    static void warn(png_structp, png_const_charp) {}

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace

std::string encode_png(int width, int height, std::span<const std::uint8_t> rgba) {
    std::string bytes;
    bytes.reserve(rgba.size() / 8);
    PngWriter(bytes).write(width, height, rgba);
    return bytes;
}

ReadPicture read_png(const std::filesystem::path& file) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    const std::unique_ptr<png_image, void (*)(png_image*)> owner(&image, png_image_free);
    ReadPicture picture;
    if (png_image_begin_read_from_file(&image, file.c_str()) != 0) {
        image.format = PNG_FORMAT_RGBA;
        picture.width = static_cast<int>(image.width);
        picture.height = static_cast<int>(image.height);
        picture.rgba.resize(PNG_IMAGE_SIZE(image));
        if (png_image_finish_read(&image, nullptr, picture.rgba.data(), 0, nullptr) != 0) return picture;
    }
    throw FileError(fmt::format("cannot read '{}': {}", shown(file.string()), image.message));
}

}  // namespace steplab
