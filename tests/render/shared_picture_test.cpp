#include "render/fence.hpp"
#include "render/picture_texture.hpp"
#include "render/scenes.hpp"
#include "render/studio.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace steplab::render {
namespace {

using namespace steplab::test;

std::vector<std::uint8_t> bytes_of(const PictureTexture& texture) {
    const auto [width, height] = texture.size();
    std::vector<std::uint8_t> bytes(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

struct SharedPicture : Studio {
    static void paint(const RenderTarget& target, Vec3 place) {
        renderer().draw(particles_at({place}), bare(), straight, target);
    }
    static void expect_no_error() { EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)); }
};

TEST_F(SharedPicture, is_not_drawn_over_once_it_was_given_away) {
    RenderTarget target({64, 36});
    PictureTexture shown;
    paint(target, {0, 0, 0});
    const auto first = target.read();
    target.exchange(shown);
    const auto given = bytes_of(shown);
    paint(target, {0.5, 0.2, 0});
    EXPECT_EQ(bytes_of(shown), given);
    EXPECT_NE(target.read(), first) << "the other texture has the new picture";
    paint(target, {0, 0, 0});
    EXPECT_EQ(target.read(), first) << "and holds the same pixels";
    expect_no_error();
}

TEST_F(SharedPicture, changes_places_with_textures_of_any_size) {
    PictureTexture shown;
    for (const PictureSize size : {PictureSize{64, 36}, {32, 18}, {200, 100}}) {
        RenderTarget target(size);
        for (int i = 0; i < 3; ++i) {
            paint(target, {0, 0, 0});
            const auto picture = target.read();
            target.exchange(shown);
            EXPECT_EQ(shown.size(), size);
            EXPECT_EQ(bytes_of(shown).size(), picture.size());
        }
    }
    expect_no_error();
}

TEST_F(SharedPicture, can_be_copied_instead_with_the_same_pixels) {
    PictureTexture shown;
    TexturePixels pixels;
    for (const PictureSize size : {PictureSize{64, 36}, {31, 17}, {200, 100}}) {
        RenderTarget target(size);
        renderer().draw(particles_at({{0.3, 0.4, 0}}), {}, straight, target);
        target.copy_into(pixels);
        shown.upload(pixels);
        PictureTexture drawn;
        target.exchange(drawn);
        EXPECT_EQ(shown.size(), size);
        EXPECT_EQ(bytes_of(shown), bytes_of(drawn));
    }
    expect_no_error();
}

TEST_F(SharedPicture, fences_are_waited_for_once_set_and_otherwise_cost_nothing) {
    const RenderTarget target({64, 36});
    Fence fence;
    fence.wait();
    fence.delay_commands();
    paint(target, {0, 0, 0});
    fence = Fence::after_commands();
    fence.delay_commands();
    fence.wait();
    fence.wait();
    expect_no_error();
}

/// A grid of dots that do not touch.
Frame grid_of_dots() {
    std::vector<Vec3> places;
    for (int row = -20; row <= 20; ++row) {
        for (int column = -40; column <= 40; ++column) places.push_back({column * 0.04, row * 0.04, 0});
    }
    return particles_at(places, {}, 0.01);
}

TEST_F(SharedPicture, of_more_dots_than_are_drawn_at_once_has_them_all) {
    std::vector<Vec3> places;
    for (int row = -100; row < 100; ++row) {
        for (int column = -105; column < 105; ++column) places.push_back({column * 0.008, row * 0.008, 0});
    }
    const PictureSize without_texts{150, 100};
    const Image image = draw(particles_at(places, {}, 0.002), straight, bare(), without_texts);
    const Image empty = draw(particles_at({{100, 100, 0}}, {}, 0.002), straight, bare(), without_texts);
    EXPECT_GT(differing_pixels(image, empty), 6500) << "42 000 dots lie closer than pixels, over half of 15 000";
    std::reverse(places.begin(), places.end());
    EXPECT_EQ(differing_pixels(draw(particles_at(places, {}, 0.002), straight, bare(), without_texts), image), 0);
}

TEST_F(SharedPicture, coarse_ones_have_some_of_the_dots_and_the_same_every_time) {
    const Frame frame = grid_of_dots(), nothing = particles_at({{100, 100, 0}}, {}, 0.01);
    const auto drawn = [&](int enlarged) {
        Style style = bare();
        style.enlarged = enlarged;
        return draw(frame, straight, style);
    };
    const Image empty = draw(nothing, straight, bare());
    const int all = differing_pixels(drawn(1), empty), half = differing_pixels(drawn(2), empty),
              quarter = differing_pixels(drawn(4), empty);
    ASSERT_GT(all, 3000);
    EXPECT_NEAR(half, all / 4, all / 20);
    EXPECT_NEAR(quarter, all / 16, all / 40);
    EXPECT_EQ(differing_pixels(drawn(4), drawn(4)), 0);
}

TEST_F(SharedPicture, of_more_dots_than_are_wanted_has_a_fair_sample) {
    const PictureSize without_texts{150, 100};
    const Frame frame = grid_of_dots(), nothing = particles_at({{100, 100, 0}}, {}, 0.01);
    const auto drawn = [&](std::size_t most) {
        Style style = bare();
        style.most_dots = most;
        return draw(frame, straight, style, without_texts);
    };
    const Image empty = draw(nothing, straight, bare(), without_texts);
    const int all = differing_pixels(drawn(0), empty), some = differing_pixels(drawn(400), empty);
    ASSERT_GT(all, 3000);
    EXPECT_EQ(differing_pixels(drawn(0), drawn(3321)), 0) << "as many as there are";
    EXPECT_NEAR(some, all / 9, all / 40);  // one of 9 of 3321
    EXPECT_EQ(differing_pixels(drawn(400), drawn(400)), 0);
}

TEST_F(SharedPicture, that_leaves_out_particles_says_so) {
    const Frame frame = grid_of_dots(), nothing = particles_at({{100, 100, 0}}, {}, 0.01);
    const auto lower_right = [](const Image& image, const Image& empty) {
        int count = 0;
        for (int y = 0; y < image.size.height; ++y) {
            for (int x = 0; x < image.size.width; ++x)
                count += y > image.size.height - 50 && x > image.size.width / 2 && image.at(x, y) != empty.at(x, y);
        }
        return count;
    };
    Style style = bare();
    const Camera above{{0, -10, 0}, 4, 0, 0};  // all dots are out of the picture, and so is what they would cover
    const Image empty = draw(nothing, above, style);
    style.most_dots = 1;
    EXPECT_EQ(lower_right(draw(frame, above, style), empty), 0) << "nothing is left out of what is not seen";
    const Camera far{{0, 0, 0}, 40, 0, 0};  // the dots are in the middle
    EXPECT_GT(lower_right(draw(frame, far, style), empty), 100) << "the letters of a line";
    style.most_dots = 0;
    EXPECT_EQ(lower_right(draw(frame, far, style), empty), 0);
}

TEST_F(SharedPicture, coarse_ones_have_all_that_is_more_than_a_dot) {
    const Frame frame = string_of({{-1, 0, 0}, {0, 0.2, 0}, {1, 0, 0}});
    Style full, coarse;
    coarse.enlarged = 4;
    coarse.most_dots = 1;
    EXPECT_EQ(differing_pixels(draw(frame, straight, full), draw(frame, straight, coarse)), 0);
}

}  // namespace
}  // namespace steplab::render
