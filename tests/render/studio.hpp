#pragma once

#include "app/offscreen/context.hpp"
#include "render/framing.hpp"
#include "render/gl.hpp"
#include "render/palette.hpp"
#include "render/scene_renderer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steplab::test {

/// A finished picture: rows from the top, 4 bytes a pixel.
struct Image {
    render::PictureSize size;
    std::vector<std::uint8_t> rgba;

    render::Rgb at(int x, int y) const {
        const std::size_t i =
            4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x));
        return {rgba[i], rgba[i + 1], rgba[i + 2]};
    }
    render::Rgb at(render::PixelPoint p) const { return at(static_cast<int>(p.x), static_cast<int>(p.y)); }
};

/// Largest difference of a channel.
inline int difference(render::Rgb a, render::Rgb b) {
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

/// Number of pixels in which two pictures of one size differ by more than `tolerance` in a channel.
inline int differing_pixels(const Image& a, const Image& b, int tolerance = 0) {
    int count = 0;
    for (int y = 0; y < a.size.height; ++y) {
        for (int x = 0; x < a.size.width; ++x) count += difference(a.at(x, y), b.at(x, y)) > tolerance;
    }
    return count;
}

/// Tests that draw: one context for all of them, as making one takes a while.
class Studio : public testing::Test {
protected:
    static void SetUpTestSuite() {
        context_ = std::make_unique<OffscreenContext>();
        render::load_opengl();
        renderer_ = std::make_unique<render::SceneRenderer>();
    }
    static void TearDownTestSuite() {
        renderer_.reset();
        context_.reset();
    }

    static Image draw(const Frame& frame, const render::Camera& camera, const render::Style& style = {},
                      render::PictureSize size = {320, 180}) {
        const render::RenderTarget target(size);
        renderer_->draw(frame, style, camera, target);
        return {size, target.read()};
    }
    static Image draw(const Frame& frame, const render::Style& style = {}, render::PictureSize size = {320, 180}) {
        return draw(frame, render::default_camera(frame, size), style, size);
    }
    static render::SceneRenderer& renderer() { return *renderer_; }

private:
    inline static std::unique_ptr<OffscreenContext> context_;
    inline static std::unique_ptr<render::SceneRenderer> renderer_;
};

/// Only the particles.
inline render::Style bare() {
    render::Style style;
    style.springs = style.grid = style.legend = false;
    return style;
}

// A small picture, looked at straight on: for what is compared pixel by pixel.

inline const render::PictureSize small_size{320, 180};
inline const render::Camera straight{{0, 0, 0}, 4, 0, 0};
/// A difference that is clearly not of the background.
inline constexpr int something = 20;
/// Where a point of the scene is in that picture.
inline render::PixelPoint place_of(Vec3 point) { return *render::Projection(straight, small_size).pixel(point); }

}  // namespace steplab::test
