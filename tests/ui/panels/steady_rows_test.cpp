// Texts that change while a run goes on leave what is below them where it is.

#include "ui/desk.hpp"
#include "ui/panels/step_verdict.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

/// Where a widget stands after two frames, the second of which knows the sizes of the first.
float top_of(Desk& desk, const char* widget) {
    desk.frame();
    desk.frame();
    return desk.widget(widget).top;
}

TEST(steady_rows, no_verdict_moves_what_is_below_it) {
    for (const int width : {260, 300, 520}) {
        Desk desk(describe("rope", "rk4"));
        ViewChoices choices;
        choices.sizes.panel_width = width;
        desk.interface.use(choices, choices);
        const float known = top_of(desk, "colouring");
        const auto limit = desk.view.limit;
        desk.view.limit.reset();
        EXPECT_EQ(top_of(desk, "colouring"), known) << "unknown, at " << width;
        desk.view.limit = limit;
        for (const double dt : {1e-5, 0.01, 0.05, 0.1, 0.102, 3.0}) {
            desk.view = view_of(Simulation([&] {
                RunDescription description = describe("rope", "rk4");
                description.dt = dt;
                return description;
            }()));
            EXPECT_EQ(top_of(desk, "colouring"), known) << dt << " s, at " << width;
        }
        desk.view.description = with_method(desk.view.description, "dopri5");
        EXPECT_LT(top_of(desk, "colouring"), known + 100) << "the row can move";
        EXPECT_NE(top_of(desk, "colouring"), known) << "a method of steps of its own has other rows";
    }
}

TEST(steady_rows, no_note_moves_what_is_below_it) {
    Desk desk;
    const float without = top_of(desk, "colouring");
    desk.view.notes = {"a displacement of 1e9 m is known to 100 m in float, which is too little for bonds of 2 m"};
    EXPECT_EQ(top_of(desk, "colouring"), without);
}

TEST(steady_rows, no_error_moves_what_is_below_it) {
    for (const std::string model : {"chain", "morse"}) {
        for (const int width : {260, 300, 520}) {
            Desk desk(describe(model, "rk4"));
            ViewChoices choices;
            choices.sizes.panel_width = width;
            desk.interface.use(choices, choices);
            const float alone = top_of(desk, "method");
            desk.session.followers = {desk.view};
            const float none = top_of(desk, "layout/split");
            EXPECT_GT(top_of(desk, "method"), alone) << "runs have rows";
            const bool exact = desk.view.why_not_exact.empty();
            Compared little, much;
            little.energy_error = 0.0;
            little.evaluations = 4;
            much.error = 1.2e-13;
            much.energy_error = -3.4e-13;
            much.reference_error = exact ? 0 : 2.3e-15;
            much.evaluations = 123456789012;
            for (const Compared& compared : {little, much}) {
                for (const double time : {0.0, -12.34}) {
                    desk.session.errors.emplace(
                        SessionErrors{.time = time, .runs = {compared, std::nullopt}, .exact = exact, .how = "how"});
                    if (exact && time < 0) continue;  // a closed form is never late
                    EXPECT_EQ(top_of(desk, "layout/split"), none) << model << ' ' << width;
                }
            }
        }
    }
}

TEST(steady_rows, no_rate_moves_what_is_above_it) {
    Desk desk(describe("chain"), {1280, 640, 1});
    desk.move_to(100, 300);
    desk.wheel(-100);  // to the end, where the height of the panel decides what is shown
    for (int i = 0; i < 30; ++i) desk.frame();
    const float paused = top_of(desk, "selection.box");
    desk.view.steps_per_second = 1.9e6;
    desk.view.evaluations_per_second = 7.6e6;
    EXPECT_EQ(top_of(desk, "selection.box"), paused);
}

// Its text ends where the strip does: what it has more of than usual, the slider leaves to it.
TEST(time_line, leaves_room_for_long_times) {
    Desk desk(describe("chain"));
    const auto right_at = [&](double time, double dt) {
        desk.view.dt = dt;
        desk.session.line.reached_time = time;
        desk.frame();
        desk.frame();
        return desk.widget("time").right;
    };
    const float usual = right_at(10, 0.1), tiny = right_at(0, 1e-16), small = right_at(10, 1e-9),
                long_run = right_at(123456.7, 1e-9);
    EXPECT_EQ(right_at(9, 0.1), usual) << "no digit moves it";
    EXPECT_LT(tiny, usual - 3);
    EXPECT_LT(small, tiny - 3);
    EXPECT_LT(long_run, small - 12) << "four digits more";
}

// "displacements" touched its slider.
TEST(rows, labels_leave_a_gap_before_their_sliders) {
    for (const char* const model : {"chain", "mesh", "rope", "crystal", "morse"}) {
        Desk desk(describe(model));
        for (const auto& [name, place] : desk.interface.widgets()) {
            if (!desk.has(name + ".value")) continue;
            const WidgetRect gap{place.left - 6, place.top, place.left - 2, place.bottom};
            EXPECT_EQ(desk.vertices_within(gap), 0) << name << " of " << model;
        }
    }
}

}  // namespace
}  // namespace steplab::ui
