#include "sim/catalogue.hpp"
#include "ui/desk.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string copied(Desk& desk) {
    desk.interface.take_requests();
    desk.click("menu");
    desk.click("menu/copy command");
    const auto requests = desk.interface.take_requests();
    return requests.size() == 1 ? requests[0].text : "nothing";
}

TEST(window_command, of_a_window_as_it_opens_names_scene_method_and_dt_alone) {
    Desk desk(describe("rope", "verlet"), {1280, 800, 1});
    EXPECT_EQ(copied(desk), "steplab view " + command_line(desk.view.description) + " --config none");
}

TEST(window_command, names_all_that_was_chosen) {
    Desk desk(describe("chain"), {1000, 900, 1});
    desk.view.frame.step = 120;
    desk.view.frame.time = 12;
    desk.view.tracked = Tracked{3, {}, {}};
    desk.view.rate = {.as_fast_as_possible = false, .seconds_per_second = 2.5};
    desk.view.playing = true;
    desk.view.ensemble = {.runs = 16, .spread = "k", .width = 1e-3};
    desk.show(desk.view);
    desk.style = {.colouring = render::Colouring::speed,
                  .background = render::Background::light,
                  .springs = false,
                  .grid = false,
                  .velocities = true,
                  .forces = true,
                  .displacements = 250};
    ViewChoices choices;
    choices.trail = true;
    desk.interface.use(choices, choices);
    desk.camera = {{1, 2, -3}, 20, 35, 25.5};
    EXPECT_EQ(copied(desk), "steplab view " + command_line(desk.view.description) +
                                " --steps 120 --play --view 35,25.5,20,1,2,-3 --colour speed --background light"
                                " --springs off --grid off --velocities on --forces on --trail on --displacements 250"
                                " --particle 3 --speed 2.5 --ensemble 16"
                                " --spread k=0.999:1.001 --size 1000x900 --config none");
}

TEST(window_command, names_all_selected_particles) {
    Desk desk(describe("chain"));
    desk.view.tracked = Tracked{3, {}, {}};
    desk.show(desk.view);
    desk.interface.select_too(ParticleList({0, 5, 6, 7, 9}));
    EXPECT_THAT(copied(desk), HasSubstr(" --particle 3,0,5-7,9 "));
}

TEST(window_command, names_what_stands_below_the_scene_and_below_pictures) {
    Desk desk(describe("chain"), {1280, 800, 1});
    ViewChoices choices;
    choices.plots = {{PlotKind::phase}, {PlotKind::error, plot::Scale::logarithmic}};
    choices.picture.caption = true;
    desk.interface.use(choices, choices);
    desk.frame();
    EXPECT_THAT(copied(desk), HasSubstr(" --plots phase-portrait,position-error --caption auto "));
    choices.picture.caption_text = "how it began";
    desk.interface.use(choices, choices);
    EXPECT_THAT(copied(desk), HasSubstr(" --caption 'how it began' "));
}

// On a display of twice the scale, half the scale is not the usual one.
TEST(window_command, names_a_scale_that_was_chosen) {
    Desk desk(describe("chain"), {1280, 800, 2});
    ViewChoices choices;
    EXPECT_THAT(copied(desk), HasSubstr("--scale 2"));
    choices.scale = 0.5;
    desk.interface.use(choices, choices);
    desk.interface.resize({1280, 800, 2});
    desk.frame();
    EXPECT_THAT(copied(desk), HasSubstr("--scale 1 "));
}

TEST(window_command, names_the_runs_and_how_they_are_drawn) {
    Desk desk(describe("rope", "verlet"), {1280, 800, 1});
    RunView other = desk.view;
    other.description.precision = Precision::float_;
    desk.session.followers = {other};
    desk.style.magnify = 1000;
    const std::string runs = " --run method=verlet,dt=0.1,precision=double --run method=verlet,dt=0.1,precision=float";
    EXPECT_THAT(copied(desk), HasSubstr(runs + " --magnify 1000"));
    desk.style.layout = render::RunLayout::split;
    EXPECT_THAT(copied(desk), AllOf(HasSubstr(runs + " --layout split"), Not(HasSubstr("--magnify"))));
}

// Without --view, a window keeps the camera of the first moment.
TEST(window_command, of_a_later_moment_seen_as_usual_says_so) {
    Desk desk(describe("chain"));
    EXPECT_THAT(copied(desk), Not(HasSubstr("--view")));
    desk.view.frame.step = 120;
    desk.show(desk.view);
    desk.key(Key::home);
    EXPECT_THAT(copied(desk), HasSubstr("--steps 120 --view default"));
}

TEST(window_command, of_a_run_that_was_changed_opens_its_start) {
    Desk desk(describe("chain"));
    desk.view.frame.step = 120;
    desk.show(desk.view);
    EXPECT_THAT(copied(desk), HasSubstr("--steps 120"));
    desk.view.segment_start = 3;
    desk.show(desk.view);
    EXPECT_THAT(copied(desk), Not(HasSubstr("--steps")));
}

TEST(window_command, of_an_unlimited_speed_and_a_hidden_panel) {
    Desk desk(describe("chain"));
    desk.view.rate = {.as_fast_as_possible = true};
    desk.show(desk.view);
    desk.key(Key::tab);
    EXPECT_THAT(copied(desk), AllOf(HasSubstr("--speed unlimited"), HasSubstr("--ui off")));
}

}  // namespace
}  // namespace steplab::ui
