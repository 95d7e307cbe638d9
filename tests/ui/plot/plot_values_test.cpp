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
RunDescription clicked(Desk& desk, const RunDescription& run) {
    CostsView costs{.time = 60, .done = 1, .complete = true, .how = "exact"};
    costs.points = {{run, 100, 1e-3, 1e-3}};
    desk.session.costs = std::make_shared<const CostsView>(costs);
    desk.frame();
    const WidgetRect place = desk.widget("speed against error");
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

}  // namespace
}  // namespace steplab::ui
