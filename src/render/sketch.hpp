#pragma once

#include "render/camera.hpp"
#include "render/palette.hpp"

#include <memory>
#include <string>

namespace steplab::render {

struct Tile;

/// Text, lines and boxes over a picture, in pixels from its top left corner. It uses ImGui's draw lists and our font,
/// but no ImGui context, so that it does not interfere with another one.
class Sketch {
public:
    Sketch();
    ~Sketch();
    Sketch(Sketch&&) noexcept;
    Sketch& operator=(Sketch&&) noexcept;

    /// Starts an empty sketch. Text has `pixel_scale` times its usual size.
    void begin(PictureSize size, double pixel_scale);

    PixelPoint text_size(const std::string& text) const;
    void text(PixelPoint top_left, const std::string& text, Rgb colour, double opacity = 1);
    /// The same with a rim of the colour of the ground, so that it is readable over whatever is there.
    void text_over(PixelPoint top_left, const std::string& text, Rgb colour, Rgb ground);
    void line(PixelPoint from, PixelPoint to, Rgb colour, double width, double opacity = 1);
    void disc(PixelPoint centre, double radius, Rgb colour, double opacity = 1);
    /// A circle (0 corners), or a regular polygon whose first corner lies so many turns from the right upward.
    void outline(PixelPoint centre, double radius, int corners, double first, Rgb colour, double width);
    void box(PixelPoint top_left, PixelPoint bottom_right, Rgb colour, double opacity = 1);
    /// A box with a colour gradient from top to bottom.
    void shaded_box(PixelPoint top_left, PixelPoint bottom_right, Rgb top, Rgb bottom);

    /// Draws the sketch, or the part of it in the tile, into the bound framebuffer.
    void finish(const Tile& tile, PictureSize part);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::render
