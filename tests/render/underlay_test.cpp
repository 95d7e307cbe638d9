// What is kept of a picture for the next one: pictures are the same as those of a renderer that keeps nothing.
#include "render/scenes.hpp"
#include "render/seen_area.hpp"
#include "render/studio.hpp"

#include <vector>

namespace steplab::render {
namespace {

using test::Image;

/// One picture of a sequence.
struct Step {
    Camera camera{{0, 0, 0}, 4, 20, 30};
    Style style = {};
    PictureSize size{320, 180};
    double shift = 0;  ///< of the last particle
    std::size_t runs = 1;
};

class Underlays : public test::Studio {
protected:
    static Image picture(SceneRenderer& renderer, const Step& step) {
        std::vector<Frame> frames(step.runs, test::string_of({{-1, 0, 0}, {0, 0.2, 0}, {1, 0, 0}}));
        for (std::size_t run = 0; run < step.runs; ++run)
            frames[run].positions.back().y += step.shift + 0.3 * static_cast<double>(run);
        std::vector<ShownRun> runs;
        for (const Frame& frame : frames) runs.push_back({&frame, "rk4, dt 0.1 s, double"});
        const RenderTarget target(step.size);
        renderer.draw(runs, step.style, step.camera, target);
        return {step.size, target.read()};
    }
    /// By one renderer for all of them, and by a new one for each: from the third picture of a kind on, the first one
    /// copies what it keeps.
    static void expect_same_as_new(const std::vector<Step>& steps) {
        SceneRenderer keeping;
        for (std::size_t i = 0; i < steps.size(); ++i) {
            for (const double shift : {0.0, 0.05, 0.1}) {
                Step step = steps[i];
                step.shift += shift;
                SceneRenderer fresh;
                ASSERT_EQ(picture(keeping, step).rgba, picture(fresh, step).rgba) << "step " << i << " +" << shift;
            }
        }
    }
    static Style split() {
        Style style;
        style.layout = RunLayout::split;
        return style;
    }
};

TEST_F(Underlays, follow_the_camera) {
    Step turned, above, near, below;
    turned.camera.yaw = 50;
    above.camera.focus.y = 0.1;
    near.camera.distance = 3;
    below.camera.pitch = -20;
    expect_same_as_new({{}, turned, above, {}, near, below, {}});
}

TEST_F(Underlays, follow_the_style_and_the_size) {
    Step light, without_grid, scaled, larger;
    light.style.background = Background::light;
    without_grid.style.grid = false;
    scaled.style.pixel_scale = 2;
    larger.size = {400, 300};
    expect_same_as_new({{}, light, {}, without_grid, scaled, larger, {}});
}

TEST_F(Underlays, follow_the_box_of_the_scene) {
    Step far;
    far.shift = 3;
    expect_same_as_new({{}, far, {}});
}

TEST_F(Underlays, follow_the_layout_of_runs) {
    const Step two{.style = split(), .runs = 2}, three{.style = split(), .runs = 3}, four{.style = split(), .runs = 4};
    expect_same_as_new({two, {}, two, {.runs = 3}, four, three, two, {}});
}

TEST_F(Underlays, pictures_that_differ_are_told_apart) {
    Step turned;
    turned.camera.yaw = 50;
    EXPECT_NE(picture(renderer(), {}).rgba, picture(renderer(), turned).rgba);
}

const PictureSize size{320, 180};
const Projection ahead({{0, 0, 0}, 4, 0, 0}, size);

TEST(SeenArea, holds_the_pixels_of_a_box_and_its_margin) {
    const Bounds box{{-0.5, -0.2, -0.3}, {0.4, 0.3, 0.5}};
    const auto area = seen_area(box, ahead, 3);
    ASSERT_TRUE(area);
    for (const Vec3& corner : box.corners()) {
        const PixelPoint pixel = *ahead.pixel(corner);
        EXPECT_LE(area->left, pixel.x - 3);
        EXPECT_LE(area->top, pixel.y - 3);
        EXPECT_GE(area->left + area->size.width, pixel.x + 3);
        EXPECT_GE(area->top + area->size.height, pixel.y + 3);
    }
    EXPECT_LT(area->size.width, size.width / 2);  // not all of the picture
}

TEST(SeenArea, is_cut_at_the_edges_of_the_picture) {
    const auto area = seen_area({{-100, -0.1, 0}, {0, 0.1, 0}}, ahead, 2);
    ASSERT_TRUE(area);
    EXPECT_EQ(area->left, 0);
    EXPECT_NEAR(area->size.width, size.width / 2, 3);  // the middle and the margin
}

TEST(SeenArea, of_a_box_outside_is_none) {
    EXPECT_FALSE(seen_area({{50, 0, 0}, {51, 1, 0}}, ahead, 2));
    EXPECT_TRUE(seen_area({{-0.1, 0, 0}, {0.1, 1, 0}}, ahead, 2));
}

TEST(SeenArea, is_all_of_the_picture_where_a_box_reaches_behind_the_camera) {
    const PictureArea all{0, 0, size};
    EXPECT_EQ(seen_area({{-0.1, -0.1, -1}, {0.1, 0.1, 9}}, ahead, 2), all);
    EXPECT_EQ(seen_area({{NAN, 0, 0}, {0, 0, 0}}, ahead, 2), all);
}

}  // namespace
}  // namespace steplab::render
