#pragma once

#include "render/camera.hpp"
#include "render/palette.hpp"

#include <memory>
#include <string>

namespace steplab::render {

struct Tile;

/// Text, lines and boxes over a picture, in pixels from its top left corner. It draws with ImGui's draw lists and our
/// font, but without an ImGui context, so beside one of somebody else's.
class Sketch {
public:
    Sketch();
    ~Sketch();
    Sketch(Sketch&&) noexcept;
    Sketch& operator=(Sketch&&) noexcept;

    /// Forgets what was drawn. Text is `pixel_scale` times its usual size.
    void begin(PictureSize size, double pixel_scale);

    PixelPoint text_size(const std::string& text) const;
    void text(PixelPoint top_left, const std::string& text, Rgb colour, double opacity = 1);
    void text_centred(PixelPoint centre, const std::string& text, Rgb colour, double opacity = 1);
    void line(PixelPoint from, PixelPoint to, Rgb colour, double width, double opacity = 1);
    void box(PixelPoint top_left, PixelPoint bottom_right, Rgb colour, double opacity = 1);
    /// A box whose colour goes evenly from top to bottom.
    void shaded_box(PixelPoint top_left, PixelPoint bottom_right, Rgb top, Rgb bottom);

    /// Draws it into the framebuffer that is bound; with the part of the picture that the tile is.
    void finish(const Tile& tile, PictureSize part);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::render
