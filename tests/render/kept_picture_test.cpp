// Drawing only what has changed of a scene with panels over it: the same picture as one drawn from scratch.
#include "render/kept_picture.hpp"

#include "render/panel_studio.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <set>

namespace steplab::render {
namespace {

using namespace steplab::test;

const PictureArea place{60, 20, {120, 64}};

/// A picture of this size; no two numbers give the same.
PictureTexture scene_picture(int number, PictureSize of) {
    std::vector<std::uint8_t> rgba;
    for (int i = 0; i < of.width * of.height; ++i) {
        for (const int byte : {37 * number, 3 * i, 5 * (i / of.width), 255})
            rgba.push_back(static_cast<std::uint8_t>(byte));
    }
    PictureTexture picture;
    picture.upload(of, rgba);
    return picture;
}

/// What the window shows.
struct Shown {
    int scene = 0;  ///< number of its picture
    PictureArea area = place;
    Paint panels;
    PictureSize scene_size = place.size;
};

class KeptPictureTest : public PanelStudio {
protected:
    int draw(const Shown& shown) {
        if (scene_ != shown.scene) {
            scene_ = shown.scene;
            kept_.forget_scene();
        }
        return draw_in(kept_, shown);
    }
    void expect_same_as_from_scratch(const std::vector<Shown>& steps) {
        for (std::size_t i = 0; i < steps.size(); ++i) {
            draw(steps[i]);
            KeptPicture other;
            draw_in(other, steps[i]);
            ASSERT_EQ(pixels(kept_), pixels(other)) << "step " << i;
        }
    }

    std::size_t colours_in_place() const {
        const std::vector<std::uint8_t> rgba = pixels(kept_);
        std::set<std::vector<std::uint8_t>> colours;
        for (int y = 0; y < place.size.height; ++y) {
            for (int x = 0; x < place.size.width; ++x) {
                const auto at = rgba.begin() +
                                4 * ((panel_picture.height - 1 - place.top - y) * panel_picture.width + place.left + x);
                colours.emplace(at, at + 4);
            }
        }
        return colours.size();
    }

private:
    int draw_in(KeptPicture& picture, const Shown& shown) {
        return picture.draw(scene_picture(shown.scene, shown.scene_size), shown.area, data_of(shown.panels),
                            renderer());
    }
    static std::vector<std::uint8_t> pixels(const KeptPicture& picture) {
        const auto [width, height] = picture.size();
        std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width * height));
        glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return rgba;
    }

    KeptPicture kept_;
    std::optional<int> scene_;
};

const Paint nothing = [](ImDrawList&) {};

TEST_F(KeptPictureTest, looks_as_if_it_were_drawn_from_scratch) {
    PictureArea moved = place;
    moved.left -= 20;
    expect_same_as_from_scratch({{1, place, panel("step 1")},
                                 {1, place, panel("step 2")},
                                 {1, place, panel("step 2", 50)},
                                 {2, place, panel("step 2", 50)},
                                 {3, place, panel("step 3", 50)},
                                 {3, place, panel("step 3", 51)},
                                 {3, moved, panel("step 3", 51)},
                                 {3, moved, nothing},
                                 {3, moved, panel("step 1")}});
}

TEST_F(KeptPictureTest, stretches_a_coarse_scene_the_same_way_in_each_part) {
    expect_same_as_from_scratch(
        {{1, place, panel("step 1"), {30, 16}}, {1, place, panel("step 2"), {30, 16}}, {1, place, nothing, {30, 16}}});
}

TEST_F(KeptPictureTest, draws_nothing_where_nothing_changes) {
    const int all = panel_picture.width * panel_picture.height, scene = place.size.width * place.size.height;
    EXPECT_EQ(draw({1, place, panel("step 1")}), all);
    EXPECT_EQ(draw({1, place, panel("step 1")}), 0);
    EXPECT_EQ(draw({2, place, panel("step 1")}), scene) << "another picture of the scene";
    const int of_panels = draw({2, place, panel("step 2")});
    EXPECT_GT(of_panels, 0);
    EXPECT_LT(of_panels, scene / 2) << "a text that covers a part of the scene";
}

TEST_F(KeptPictureTest, draws_what_changes_alone_while_there_is_no_scene) {
    const auto without = [&](const Paint& panels) { return draw({0, place, panels, {0, 0}}); };
    EXPECT_EQ(without(panel("step 1")), panel_picture.width * panel_picture.height);
    EXPECT_EQ(without(panel("step 1")), 0);
    EXPECT_LT(without(panel("step 2")), panel_picture.width * panel_picture.height / 4);
    EXPECT_EQ(draw({0, {10, 10, {50, 50}}, panel("step 2"), {0, 0}}), 0) << "where it will be is of no account";
    expect_same_as_from_scratch({{0, place, panel("step 3"), {0, 0}}, {1, place, panel("step 3")}});
}

TEST_F(KeptPictureTest, smooths_a_scene_that_it_enlarges) {
    const auto colours = [&](PictureSize of) {
        draw({of.width, place, nothing, of});
        return colours_in_place();
    };
    const std::size_t own = colours(place.size);
    EXPECT_EQ(own, static_cast<std::size_t>(place.size.width * place.size.height)) << "all differ";
    EXPECT_GT(colours({30, 16}), 2 * 30 * 16) << "some in between";
}

}  // namespace
}  // namespace steplab::render
