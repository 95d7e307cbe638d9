#include "app/offscreen/modules.hpp"
#include "core/error.hpp"
#include "io/files.hpp"
#include "sim/run/simulation.hpp"

#include <gmock/gmock.h>

namespace steplab {
namespace {

using testing::AllOf;
using testing::HasSubstr;

PictureRequest request_of(std::string_view model, bool panel = false) {
    Simulation simulation(describe(model));
    PictureRequest request;
    const RunView start = view_of(simulation, 1);
    request.past.push_back({.leading = start, .sample = sample_of(start)});
    simulation.advance(10);
    request.view = view_of(simulation, 1);
    request.panel = panel;
    request.size = panel ? render::PictureSize{800, 600} : render::PictureSize{320, 180};
    return request;
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(Offscreen, osmesa_and_egl_draw_the_same_pixels) {
    Offscreen osmesa("osmesa");
    Offscreen egl("egl");
    for (const char* model : {"mesh", "morse"}) {
        const PictureRequest request = request_of(model);
        EXPECT_EQ(osmesa.draw(request).rgba, egl.draw(request).rgba);
    }
}

TEST(Offscreen, auto_takes_the_first_that_works) {
    EXPECT_EQ(Offscreen("auto").kind(), "osmesa");
    EXPECT_EQ(Offscreen("egl").kind(), "egl");
}

TEST(Offscreen, picture_has_the_size_asked_for) {
    Offscreen offscreen("auto");
    PictureRequest request = request_of("chain");
    for (const render::PictureSize size : {render::PictureSize{1, 1}, {333, 77}, {2500, 2100}}) {
        request.size = size;
        const Picture picture = offscreen.draw(request);
        EXPECT_EQ(picture.size, size);
        EXPECT_EQ(picture.rgba.size(), 4u * static_cast<unsigned>(size.width * size.height));
    }
}

TEST(Offscreen, panel_gives_the_same_bytes_again) {
    Offscreen offscreen("auto");
    const PictureRequest request = request_of("mesh", true);
    const Picture first = offscreen.draw(request);
    EXPECT_EQ(offscreen.draw(request).rgba, first.rgba);
    EXPECT_EQ(Offscreen("egl").draw(request).rgba, first.rgba);
}

TEST(Offscreen, panel_covers_the_left_and_not_the_scene) {
    Offscreen offscreen("auto");
    PictureRequest request = request_of("mesh", true);
    request.size = {1280, 800};
    const Picture with = offscreen.draw(request);
    request.panel = false;
    const Picture without = offscreen.draw(request);
    const auto differs = [&](std::size_t x, std::size_t y) {
        const std::size_t i = 4 * (y * 1280 + x);
        return !std::equal(with.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                           with.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3),
                           without.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    };
    int panel = 0;
    for (std::size_t y = 100; y < 700; ++y) panel += differs(20, y);
    EXPECT_GT(panel, 500);
}

TEST(Offscreen, panel_is_drawn_in_tiles_without_a_seam) {
    Offscreen offscreen("auto");
    PictureRequest request = request_of("mesh", true);
    request.size = {2304, 600};  // a tile and an eighth
    const Picture picture = offscreen.draw(request);
    EXPECT_EQ(picture.rgba.size(), 4u * 2304 * 600);
    // The bar at the top continues past the seam at 2048.
    const auto pixel = [&](std::size_t x) { return picture.rgba[4 * (2304 * 2 + x)]; };
    EXPECT_EQ(pixel(2047), pixel(2048));
}

TEST(Offscreen, wrong_view_comes_back_as_wrong_usage) {
    Offscreen offscreen("auto");
    PictureRequest request = request_of("chain");
    request.camera = "sideways";
    EXPECT_THROW(offscreen.draw(request), UsageError);
    request.camera = "top";
    EXPECT_NO_THROW(offscreen.draw(request));  // and the module still works
}

TEST(Offscreen, unknown_way_lists_the_known_ones) {
    EXPECT_THROW(Offscreen("glx"), UsageError);
    EXPECT_THAT(message_of([] { Offscreen("glx"); }), AllOf(HasSubstr("auto"), HasSubstr("osmesa"), HasSubstr("egl")));
}

TEST(Offscreen, missing_modules_are_named_with_the_remedy) {
    const TemporaryFolder empty;
    EXPECT_THROW(Offscreen("auto", empty.path()), GraphicsError);
    EXPECT_THAT(message_of([&] { Offscreen("auto", empty.path()); }),
                AllOf(HasSubstr(empty.file("osmesa.so")), HasSubstr(empty.file("egl.so")), HasSubstr("libosmesa6")));
    EXPECT_THAT(message_of([&] { Offscreen("egl", empty.path()); }), testing::Not(HasSubstr("osmesa.so")));
}

TEST(Offscreen, file_that_is_not_a_module_is_reported) {
    const TemporaryFolder folder;
    put_text(folder.file("osmesa.so"), "no module");
    EXPECT_THAT(message_of([&] { Offscreen("osmesa", folder.path()); }), HasSubstr(folder.file("osmesa.so")));
}

/// Limits of scenes with drag are found by stepping, which modules cannot: the view brings the method of its card.
TEST(Offscreen, card_of_a_diverged_scene_with_drag_is_drawn) {
    RunDescription description = describe("rope", "euler");
    description.dt = 0.5;
    Simulation simulation(description);
    simulation.advance(10000);
    PictureRequest request = request_of("rope", true);
    request.view = view_of(simulation);
    ASSERT_TRUE(request.view.divergence);
    ASSERT_GT(description.scene["c"], 0);
    Offscreen offscreen("auto");
    const std::vector<std::uint8_t> with_card = offscreen.draw(request).rgba;
    request.view.divergence.reset();
    EXPECT_NE(with_card, offscreen.draw(request).rgba);
}

/// The program's own are not linked a second and a third time: 2 MB a module, not 15.
TEST(Offscreen, modules_hold_no_integrators) {
    const std::string build = STEPLAB_BINARY_DIR, integrator = "make_Rk4";
    EXPECT_THAT(text_of(build + "/bin/steplab"), HasSubstr(integrator));
    for (const char* module : {"osmesa", "egl"}) {
        EXPECT_THAT(text_of(build + "/lib/steplab/" + module + ".so"), testing::Not(HasSubstr(integrator))) << module;
    }
}

}  // namespace
}  // namespace steplab
