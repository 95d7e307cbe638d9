// What plots say of values that their axes cannot show, of particles at rest, and of points that are clicked.
#include "session/session_view.hpp"
#include "ui/plot/choice.hpp"
#include "ui/plot/recorded.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <variant>

namespace steplab::ui {
namespace {

/// Until the scale button says so.
void choose_scale(Desk& desk, const std::string& kind, plot::Scale scale) {
    const int clicks =
        (static_cast<int>(scale) - static_cast<int>(default_choice(PlotKind::energy_error).scale) + 3) % 3;
    for (int i = 0; i < clicks; ++i) {
        desk.click(kind + ".scale");
        desk.frame();
    }
}

TEST(plot_values, of_an_energy_error_below_zero_are_sizes_on_a_logarithmic_axis) {
    const OwnFolder folder;
    Recorded recorded("chain");
    for (Sample& sample : recorded.desk.view.series.samples)
        sample.energy_error = -1e-5 * static_cast<double>(sample.step);
    choose_scale(recorded.desk, "energy error", plot::Scale::logarithmic);
    const std::string table = saved_csv(recorded.desk, "energy error");
    std::size_t rows = 0;
    for (const Sample& sample : recorded.desk.view.series.samples) {
        const double start = sample.kinetic + sample.potential - sample.energy_error;
        const std::string row = number_text(sample.time) + "," + number_text(-sample.energy_error / std::abs(start));
        if (sample.step > 0) rows += table.find(row + "\n") != std::string::npos ? 1 : 0;
    }
    EXPECT_EQ(rows, recorded.desk.view.series.samples.size() - 1) << table;
}

TEST(plot_values, of_speeds_count_particles_at_rest_but_not_fixed_ones) {
    const OwnFolder folder;
    Recorded recorded("mesh");
    choose(recorded.desk, 1, "speeds");
    const auto& roles = recorded.desk.view.frame.shape->roles;
    auto& velocities = recorded.desk.view.frame.velocities;
    std::fill(velocities.begin(), velocities.end(), Vec3{});
    recorded.desk.frame();
    const auto moving = static_cast<std::size_t>(
        std::find_if(roles.begin(), roles.end(), [](Role role) { return role != Role::fixed; }) - roles.begin());
    velocities[moving] = {0, 2, 0};
    recorded.desk.frame();
    const std::string table = saved_csv(recorded.desk, "speeds");
    const auto free = std::count_if(roles.begin(), roles.end(), [](Role role) { return role != Role::fixed; });
    EXPECT_NE(table.find("run,0," + std::to_string(free - 1) + "\n"), std::string::npos) << table;
    EXPECT_NE(table.find("run,2,1\n"), std::string::npos) << table;
}

/// A click on the only point of the diagram, wherever in its frame that is.
RunDescription clicked(Desk& desk, const RunDescription& run, const char* plot = "speed against error") {
    CostsView costs{.time = 60, .done = 1, .complete = true, .how = "exact"};
    costs.points = {{run, 100, 1e-3, 1e-3}};
    costs.runs = {CostPoint{desk.view.description, 200, 1e-5, 2e-3}};
    desk.session.costs = std::make_shared<const CostsView>(costs);
    desk.frame();
    const WidgetRect place = desk.widget(plot);
    for (float y = place.top; y < place.bottom; y += 10) {
        for (float x = place.left; x < place.right; x += 10) {
            desk.move_to(x, y);
            desk.frame();
            desk.press();
            desk.release();
            const auto& events = desk.recorder.events;
            if (const auto* const added = std::get_if<event::AddRun>(&events.back())) return added->description;
        }
    }
    ADD_FAILURE() << "no run was added";
    return {};
}

// Of a method of own steps the scan knows one step over the whole time, at whose end alone such a run would be seen.
TEST(plot_values, a_clicked_point_is_added_with_the_dt_at_which_it_is_seen) {
    for (const char* const method : {"dop853", "rk4"}) {
        Desk desk(describe("chain"));
        choose(desk, 1, "speed against error");
        RunDescription run = with_method(describe("chain"), method);
        run.dt = 60;
        const double dt = clicked(desk, run).dt;
        EXPECT_EQ(dt, std::string(method) == "rk4" ? 60 : desk.view.dt) << method;
    }
}

TEST(plot_values, of_time_against_error_are_what_computing_took) {
    const OwnFolder folder;
    Desk desk(describe("chain"));
    choose(desk, 1, "time against error");
    EXPECT_EQ(clicked(desk, with_method(describe("chain"), "rk4"), "time against error").method, "rk4");
    const std::string table = saved_csv(desk, "time against error");
    EXPECT_NE(table.find("rk4,0.001,0.001\n"), std::string::npos) << table;
    EXPECT_NE(table.find(",0.002,1e-05\n"), std::string::npos) << table;
    EXPECT_EQ(table.substr(0, table.find(',', 6)), "curve,computing time");
}

/// A label below the axis across.
std::string across_label(const std::string& text) {
    return "text-anchor=\"middle\" fill=\"#1b2430\">" + text + "</text>";
}

std::string saved_svg(Desk& desk, const std::string& kind, int number) {
    desk.click(kind + ".save");
    desk.click(kind + ".svg");
    desk.frame();
    return text_of_file("steplab-" + kind + "-" + std::to_string(number) + ".svg");
}

TEST(plot_values, lie_along_a_logarithmic_axis_across_from_the_first_above_zero_on) {
    const OwnFolder folder;
    Recorded recorded("chain");
    choose(recorded.desk, 1, "energies");
    auto& samples = recorded.desk.view.series.samples;
    samples.resize(4);
    for (std::size_t i = 0; i < 4; ++i) samples[i].time = i == 0 ? 0 : std::pow(10, i - 1);
    recorded.desk.frame();
    EXPECT_NE(saved_svg(recorded.desk, "energies", 1).find(across_label("0")), std::string::npos);
    recorded.desk.click("energies.across");
    recorded.desk.frame();
    const std::string text = saved_svg(recorded.desk, "energies", 2);
    for (const char* const label : {"1", "10", "100"})
        EXPECT_NE(text.find(across_label(label)), std::string::npos) << label;
    EXPECT_EQ(text.find(across_label("0")), std::string::npos);
}

// A part of the axis up that was zoomed to is the same part whatever the axis across is.
TEST(plot_values, are_shown_over_the_same_part_when_the_other_axis_has_another_scale) {
    const OwnFolder folder;
    Recorded recorded("chain");
    Desk& desk = recorded.desk;
    choose(desk, 1, "energies");
    desk.point_at("energies.axis");
    desk.frame();
    desk.wheel(2);
    desk.frame();
    const std::string zoomed = saved_svg(desk, "energies", 1);
    for (int click = 0; click < 3; ++click) {
        desk.click("energies.across");
        desk.frame();
    }
    EXPECT_EQ(saved_svg(desk, "energies", 2), zoomed);
    for (int click = 0; click < 3; ++click) {
        desk.click("energies.scale");
        desk.frame();
    }
    EXPECT_NE(saved_svg(desk, "energies", 3), zoomed) << "its own scale shows all of it";
}

}  // namespace
}  // namespace steplab::ui
