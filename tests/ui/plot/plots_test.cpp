#include "core/number_text.hpp"
#include "ui/plot/choice.hpp"
#include "ui/plot/recorded.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

std::string saved_svg(Desk& desk, int number, const std::string& kind = "energy error") {
    desk.click(kind + ".save");
    desk.click(kind + ".svg");
    desk.frame();
    std::string words = kind;
    std::replace(words.begin(), words.end(), ' ', '-');
    return text_of_file("steplab-" + words + "-" + std::to_string(number) + ".svg");
}

TEST(plots, of_every_kind_are_chosen_and_drawn_in_every_scale) {
    for (const char* const model : {"chain", "morse", "rope", "free"}) {
        Recorded recorded(model);
        recorded.desk.session.followers = {recorded.desk.view};
        for (const PlotKindInfo& info : plot_kinds) {
            SCOPED_TRACE(std::string(model) + " " + std::string(info.id));
            choose(recorded.desk, 1, info.id);
            for (int scale = 0; scale < 3; ++scale) {
                EXPECT_TRUE(recorded.desk.has(std::string(info.id) + ".scale"));
                recorded.desk.click(std::string(info.id) + ".scale");
                recorded.desk.frame();
                for (int across = 0; across < 3; ++across) {
                    recorded.desk.click(std::string(info.id) + ".across");
                    recorded.desk.frame();
                }
            }
        }
    }
}

TEST(plots, without_samples_say_so) {
    Desk desk(describe("chain"));
    desk.view.series = {};
    for (const PlotKindInfo& info : plot_kinds) {
        choose(desk, 1, info.id);
        EXPECT_TRUE(desk.has(info.id));
    }
}

TEST(plots, of_energy_are_relative_where_the_scene_has_a_scale) {
    const OwnFolder folder;
    Recorded recorded("chain");
    std::string expected = "time,run\n";
    for (const Sample& sample : recorded.desk.view.series.samples) {
        const double start = sample.kinetic + sample.potential - sample.energy_error;
        expected += number_text(sample.time) + "," + number_text(sample.energy_error / std::abs(start)) + "\n";
    }
    EXPECT_EQ(saved_csv(recorded.desk, "energy error"), expected);
}

TEST(plots, of_a_whole_run_begin_at_its_start) {
    const OwnFolder folder;
    Recorded recorded("chain");
    auto& samples = recorded.desk.view.series.samples;
    recorded.desk.frame();
    const std::string whole = saved_svg(recorded.desk, 1);
    samples.erase(samples.begin());
    recorded.desk.frame();
    const std::string from_first_step = saved_svg(recorded.desk, 2);
    EXPECT_NE(whole.find(">0</text>"), std::string::npos);
    EXPECT_NE(from_first_step.find("text-anchor=\"middle\" fill=\"#1b2430\">0</text>"), std::string::npos)
        << "the first value is that after the first step";
    samples.erase(samples.begin(), samples.begin() + 5);
    recorded.desk.frame();
    EXPECT_EQ(saved_svg(recorded.desk, 3).find("text-anchor=\"middle\" fill=\"#1b2430\">0</text>"), std::string::npos)
        << "what was sampled later begins there";
}

// Of what oscillates, all of a long run would be a bar.
TEST(plots, that_show_the_latest_part_of_a_run_say_so) {
    const OwnFolder folder;
    Recorded recorded("chain");
    auto& samples = recorded.desk.view.series.samples;
    for (Sample next = samples.back(); samples.size() < 1000; samples.push_back(next)) next.time += 0.1, ++next.step;
    recorded.desk.frame();
    EXPECT_NE(saved_svg(recorded.desk, 1, "displacement").find("time, latest part [s]"), std::string::npos);
    EXPECT_NE(saved_svg(recorded.desk, 1).find(">time [s]<"), std::string::npos);
    samples.resize(500);
    recorded.desk.frame();
    EXPECT_NE(saved_svg(recorded.desk, 2, "displacement").find(">time [s]<"), std::string::npos);
}

TEST(plots, name_the_runs_in_their_order_within_the_frame) {
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    for (const char* const method : {"velocity-verlet", "euler", "midpoint"}) {
        RunView run = desk.view;
        run.description = with_method(desk.view.description, method);
        desk.session.followers.push_back(run);
    }
    desk.interface.resize({1600, 1200, 1});
    desk.frame();
    desk.frame();
    const WidgetRect frame = desk.widget("energy error");
    WidgetRect before{frame.left, frame.top, frame.left, frame.top};
    for (const char* const method : {"rk4", "velocity-verlet", "euler", "midpoint"}) {
        const WidgetRect name = desk.widget("energy error.legend/" + std::string(method) + ", dt 0.1 s, double");
        EXPECT_TRUE(name.top > before.top || name.left >= before.right) << method;
        EXPECT_GE(name.left, frame.left) << method;
        EXPECT_LE(name.right, frame.right) << method;
        before = name;
    }
}

TEST(plots, of_energies_add_up) {
    const OwnFolder folder;
    Recorded recorded("chain");
    choose(recorded.desk, 1, "energies");
    std::istringstream lines(saved_csv(recorded.desk, "energies"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "time,kinetic,potential,total");
    std::size_t rows = 0;
    for (char comma = 0; std::getline(lines, line); ++rows) {
        double time = 0, kinetic = 0, potential = 0, total = 0;
        std::istringstream(line) >> time >> comma >> kinetic >> comma >> potential >> comma >> total;
        EXPECT_EQ(kinetic + potential, total);
    }
    EXPECT_EQ(rows, 50u);
}

TEST(plots, of_a_path_hold_displacement_and_velocity) {
    const OwnFolder folder;
    Recorded recorded("oscillator");
    choose(recorded.desk, 2, "phase portrait");
    const std::string text = saved_csv(recorded.desk, "phase portrait");
    const Sample& first = recorded.desk.view.series.samples.front();
    EXPECT_NE(text.find("\nrun," + number_text(first.particle()->displacement.x) + "," +
                        number_text(first.particle()->velocity.x) + "\n"),
              std::string::npos)
        << text.substr(0, 200);
}

TEST(plots, are_saved_as_drawings_of_what_run_they_are) {
    const OwnFolder folder;
    Recorded recorded("chain");
    recorded.desk.click("energy error.save");
    recorded.desk.click("energy error.svg");
    const std::string text = text_of_file("steplab-energy-error-1.svg");
    EXPECT_NE(text.find("chain, rk4, dt 0.1 s, double"), std::string::npos) << text.substr(0, 300);
    EXPECT_NE(text.find("<polyline"), std::string::npos);
}

TEST(plots, are_added_and_closed_down_to_one) {
    Desk desk(describe("chain"), {1920, 1080, 1});
    ASSERT_TRUE(desk.has("plots.add"));
    desk.click("plots.add");
    desk.frame();
    EXPECT_TRUE(desk.has("plot 3"));
    desk.click("plots.add");
    desk.frame();
    EXPECT_TRUE(desk.has("plot 4"));
    for (const char* const id : {"energy error", "displacement", "energies"}) {
        desk.click(std::string(id) + ".close");
        desk.frame();
    }
    EXPECT_TRUE(desk.has("plot 1"));
    EXPECT_FALSE(desk.has("plot 2"));
    const float alone = desk.widget("plots.add").right;
    desk.click("plots.add");
    desk.frame();
    EXPECT_NEAR(desk.widget("plots.add").right, alone, 2) << "a second click adds another one, and closes none";
    desk.click("energy error.close");
    desk.frame();
    EXPECT_FALSE(desk.has("position error.close")) << "one stays";
}

TEST(plots, of_a_kind_that_is_shown_elsewhere_change_places) {
    Desk desk(describe("chain"));
    choose(desk, 1, "displacement");
    EXPECT_LT(desk.widget("displacement").left, desk.widget("energy error").left);
}

TEST(plots, show_one_part_of_time_until_a_double_click) {
    const OwnFolder folder;
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    const std::string whole = saved_svg(desk, 1);
    desk.point_at("displacement");  // all plots over time show the same part
    desk.frame();
    desk.wheel(3);
    desk.frame();
    const std::string part = saved_svg(desk, 2);
    EXPECT_NE(part, whole);
    desk.drag("displacement", 0.6f, 0.4f);
    desk.frame();
    EXPECT_NE(saved_svg(desk, 3), part);
    desk.double_click("displacement");
    desk.frame();
    EXPECT_EQ(saved_svg(desk, 4), whole);
}

// From below to above a widget that is higher than wide.
void drag_up(Desk& desk, const std::string& name) {
    const WidgetRect place = desk.widget(name);
    const float x = 0.5f * (place.left + place.right);
    desk.move_to(x, place.bottom - 10);
    desk.frame();
    desk.press();
    desk.frame();
    desk.move_to(x, place.top + 10);
    desk.frame();
    desk.release();
    desk.frame();
}

TEST(plots, show_one_part_of_their_values_until_a_double_click) {
    const OwnFolder folder;
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    choose(desk, 1, "energies");  // above 0, so that every scale shows them
    int number = 0;
    for (const char* const scale : {"linear", "logarithmic", "symmetric"}) {
        const std::string whole = saved_svg(desk, ++number, "energies");
        desk.point_at("energies.axis");
        desk.frame();
        desk.wheel(2);
        desk.frame();
        const std::string nearer = saved_svg(desk, ++number, "energies");
        EXPECT_TRUE(nearer != whole) << scale;
        drag_up(desk, "energies.axis");
        const std::string moved = saved_svg(desk, ++number, "energies");
        EXPECT_TRUE(moved != nearer && moved != whole) << scale;
        desk.double_click("energies.axis");
        desk.frame();
        EXPECT_TRUE(saved_svg(desk, ++number, "energies") == whole) << scale;
        desk.click("energies.scale");
        desk.frame();
    }
}

TEST(plots, over_other_things_than_time_are_moved_alone) {
    const OwnFolder folder;
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    choose(desk, 2, "phase portrait");
    const std::string whole = saved_svg(desk, 1, "phase portrait"), other = saved_svg(desk, 1);
    desk.point_at("phase portrait");
    desk.frame();
    desk.wheel(3);
    desk.frame();
    EXPECT_TRUE(saved_svg(desk, 2, "phase portrait") != whole);
    EXPECT_TRUE(saved_svg(desk, 2) == other);
}

long asked(Desk& desk, const char* what) {
    const auto calls = desk.calls();
    return std::count(calls.begin(), calls.end(), what);
}

// What a run did while its plots were hidden would be missing from them.
TEST(plots, keep_their_samples_while_they_are_hidden) {
    Desk desk(describe("chain"));
    EXPECT_TRUE(desk.calls().empty()) << "asked for in the first frame";
    desk.key(Key::tab);
    desk.frame();
    EXPECT_FALSE(desk.has("plot 1"));
    EXPECT_EQ(asked(desk, "samples off"), 0);
    desk.key(Key::tab);
    EXPECT_TRUE(desk.has("plot 1"));
    EXPECT_EQ(asked(desk, "samples on"), 0) << "they are being taken";
}

TEST(plots, of_costs_are_kept_while_they_are_hidden_but_not_closed) {
    Desk desk(describe("chain"));
    choose(desk, 1, "speed against error");
    EXPECT_EQ(asked(desk, "costs on"), 1);
    desk.key(Key::tab);
    desk.frame();
    desk.key(Key::tab);
    EXPECT_EQ(asked(desk, "costs off"), 0);
    desk.click("speed against error.close");
    EXPECT_EQ(asked(desk, "costs off"), 1);
    EXPECT_EQ(asked(desk, "costs on"), 0);
}

}  // namespace
}  // namespace steplab::ui
