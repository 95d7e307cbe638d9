#include "session/playback.hpp"
#include "support/runs.hpp"
#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace steplab::ui {
namespace {

/// A window that plays a trajectory of a mesh.
struct PlayedBack : testing::Test {
    PlayedBack() {
        desk.session.playback = PlaybackView{.file = "/data/mesh.trajectory", .frame = 3, .frames = 12};
        desk.frame();
        desk.frame();
        desk.calls();
    }
    Desk desk;
};

TEST_F(PlayedBack, offers_nothing_that_changes_a_run) {
    for (const std::string_view widget :
         {"method", "dt", "precision/float", "scene.dim", "ensemble/16", "add run", "twin", "turn round"})
        EXPECT_FALSE(desk.has(widget)) << widget;
    for (const std::string_view widget : {"model", "play", "step", "time", "springs", "continue", "forces"})
        EXPECT_TRUE(desk.has(widget)) << widget;
    desk.session.playback.reset();
    desk.frame();
    desk.frame();
    for (const std::string_view widget : {"method", "dt", "scene.dim", "ensemble/16", "add run", "twin"})
        EXPECT_TRUE(desk.has(widget)) << widget;
    EXPECT_FALSE(desk.has("continue"));
}

TEST_F(PlayedBack, is_continued_by_a_run_from_its_frame) {
    desk.click("continue");
    EXPECT_EQ(desk.calls(), std::vector<std::string>{"begin"});
    const auto& from = desk.wanted().start.from;
    ASSERT_TRUE(from);
    EXPECT_EQ(from->positions, desk.view.frame.positions);
    EXPECT_EQ(from->velocities, desk.view.frame.velocities);
    EXPECT_EQ(from->given, "/data/mesh.trajectory:0");
}

TEST_F(PlayedBack, gives_way_to_the_scene_that_is_chosen_also_to_its_own) {
    desk.click("model");
    desk.frame();
    desk.click("model/mesh");
    EXPECT_EQ(desk.calls(), std::vector<std::string>{"begin"});
    EXPECT_EQ(desk.wanted().model, "mesh");
    EXPECT_FALSE(desk.wanted().start.from);
}

// What reads m and s elsewhere is that of the file.
TEST_F(PlayedBack, in_other_units_names_them) {
    const int before = desk.interface.draw_data().TotalVtxCount;
    desk.session.playback->units = "metal";
    desk.frame();
    desk.frame();
    EXPECT_GT(desk.interface.draw_data().TotalVtxCount, before);
}

TEST_F(PlayedBack, of_some_particles_says_nothing_of_energies) {
    desk.session.playback->measured = false;
    desk.frame();
    desk.frame();
    EXPECT_FALSE(desk.has("continue"));
    EXPECT_FALSE(desk.has("forces"));
}

// "not known: the file does not have a whole scene" takes several lines there.
TEST(played_back_in_a_small_window, plots_say_why_they_are_empty_within_their_frames) {
    Desk desk(describe("mesh"), {900, 600, 1});
    desk.session.playback = PlaybackView{.file = "a.xyz", .frame = 3, .frames = 12, .measured = false};
    for (int i = 0; i < 3; ++i) desk.frame();
    const WidgetRect frame = desk.widget("displacement");
    EXPECT_GT(desk.vertices_within(frame), 0);
    EXPECT_EQ(desk.vertices_within({frame.right + 1, frame.top, 900, frame.bottom}), 0);
}

}  // namespace
}  // namespace steplab::ui
