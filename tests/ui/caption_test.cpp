// Captions of pictures.
#include "ui/caption.hpp"

#include "ui/desk.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

RunDescription chain_of(const char* method, double dt) {
    RunDescription run = with_method(describe("chain"), method);
    run.dt = dt;
    return run;
}

TEST(caption, names_scene_method_dt_and_time) {
    Simulation simulation(chain_of("verlet", 0.05));
    simulation.advance(3);
    const SessionView session{.leading = view_of(simulation)};
    const auto lines = caption_lines({}, session);
    ASSERT_EQ(lines.size(), 1u);
    for (const char* part : {"chain", "verlet", "dt 0.05 s", "double", "t = 0.15"})
        EXPECT_NE(lines[0].text.find(part), std::string::npos) << part << " in " << lines[0].text;
}

TEST(caption, has_a_line_for_each_run) {
    SessionView session{.leading = view_of(Simulation(chain_of("rk4", 0.1)))};
    session.followers.push_back(view_of(Simulation(chain_of("euler", 0.02))));
    session.followers.back().swatch = 3;
    const auto lines = caption_lines({}, session);
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].swatch, std::nullopt);
    EXPECT_EQ(lines[1].swatch, 0u);
    EXPECT_NE(lines[1].text.find("rk4, dt 0.1 s"), std::string::npos) << lines[1].text;
    EXPECT_EQ(lines[2].swatch, 3u);
    EXPECT_NE(lines[2].text.find("euler, dt 0.02 s"), std::string::npos) << lines[2].text;
}

TEST(caption, that_is_given_stays_as_it_is) {
    const SessionView session{.leading = view_of(Simulation(describe("chain")))};
    const auto lines = caption_lines({"first\nsecond, 100 %"}, session);
    ASSERT_EQ(lines.size(), 2u);
    EXPECT_EQ(lines[0].text, "first");
    EXPECT_EQ(lines[1].text, "second, 100 %");
}

TEST(caption, takes_the_foot_of_a_still) {
    Desk desk(describe("chain"), {800, 600, 1});
    for (const bool alone : {true, false}) {
        desk.interface.draw_still(desk.session, {desk.camera, desk.style}, alone, Caption{});
        const WidgetRect strip = desk.widget("caption");
        EXPECT_EQ(strip.bottom, 600);
        EXPECT_EQ(strip.bottom - strip.top, static_cast<float>(desk.interface.caption_height(desk.session, {})));
        const PixelRect scene = desk.interface.scene();
        EXPECT_LE(scene.y + scene.height, static_cast<int>(strip.top));
        EXPECT_EQ(desk.has("play"), !alone);
    }
    desk.interface.draw_still(desk.session, {desk.camera, desk.style}, true);
    EXPECT_FALSE(desk.has("caption"));
    EXPECT_EQ(desk.interface.scene(), (PixelRect{0, 0, 800, 600}));
}

TEST(scale, is_that_of_the_display_times_that_of_the_person) {
    Desk desk(describe("chain"), {1600, 1200, 1});
    const Display display{1600, 1200, 1};
    const auto width = [&] {
        const WidgetRect place = desk.widget("snapshot");
        return place.right - place.left;
    };
    const float usual = width();
    for (int i = 0; i < 5; ++i) desk.key(Key::equal, true);
    EXPECT_EQ(desk.interface.choices(desk.style).scale, 2);
    EXPECT_TRUE(desk.recorder.rates.empty()) << "Ctrl+= is not the key of the speed";
    EXPECT_TRUE(desk.interface.resize(display));
    EXPECT_FALSE(desk.interface.resize(display));
    for (int i = 0; i < 2; ++i) desk.frame();
    EXPECT_NEAR(width(), 2 * usual, 3) << "glyphs have whole widths";
    for (int i = 0; i < 20; ++i) desk.key(Key::minus, true);
    EXPECT_EQ(desk.interface.choices(desk.style).scale, 0.75);
    desk.key(Key::zero, true);
    EXPECT_EQ(desk.interface.choices(desk.style).scale, 1);
}

}  // namespace
}  // namespace steplab::ui
