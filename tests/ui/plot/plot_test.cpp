#include "ui/plot/plot.hpp"

#include "ui/desk.hpp"
#include "ui/plot/plot_files.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace steplab::ui {
namespace {

/// An empty working directory, removed at the end.
class OwnFolder {
public:
    OwnFolder() : before_(std::filesystem::current_path()) {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("steplab-") + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~OwnFolder() {
        std::filesystem::current_path(before_);
        std::filesystem::remove_all(folder_);
    }

private:
    std::filesystem::path before_;
    std::filesystem::path folder_;
};

Plot two_curves() {
    Plot plot;
    plot.widget = "test";
    Curve run;
    run.name = "run";
    run.x = {0, 0.1, 0.2};
    run.y = {1, 2.5, -3};
    Curve exact = run;
    exact.name = "exact";
    exact.y = {1, NAN, -3.125};
    plot.curves = {run, exact};
    return plot;
}

/// A desk with 50 recorded steps of a run.
struct Recorded {
    explicit Recorded(const std::string& model) : desk(describe(model)) {
        Simulation simulation(describe(model));
        for (int i = 0; i < 50; ++i) {
            desk.view = view_of(simulation, simulation.particles() - 1);
            desk.interface.record(desk.view);
            simulation.advance(1);
        }
        desk.frame();
    }
    Desk desk;
};

TEST(plot, csv_has_a_column_for_each_curve) {
    EXPECT_EQ(plot_csv(two_curves()), "time,run,exact\n0,1,1\n0.1,2.5,\n0.2,-3,-3.125\n");
}

TEST(plot, axes_hold_every_value) {
    const PlotAxes axes = plot_axes(two_curves(), {10, 20, 300, 100});
    EXPECT_FLOAT_EQ(axes.across.pixel(0), 10);
    EXPECT_FLOAT_EQ(axes.across.pixel(0.2), 310);
    EXPECT_LE(axes.up.low, -3.125);
    EXPECT_GE(axes.up.high, 2.5);
}

TEST(plot, only_positive_values_count_on_a_logarithmic_axis) {
    Plot plot = two_curves();
    plot.logarithmic = true;
    EXPECT_TRUE(has_values(plot));
    EXPECT_GT(plot_axes(plot, {0, 0, 100, 100}).up.low, 0);
    for (Curve& curve : plot.curves) curve.y = {0, -1, NAN};
    EXPECT_FALSE(has_values(plot));
}

TEST(plot, names_that_are_taken_are_not_used_again) {
    const OwnFolder folder;
    EXPECT_EQ(free_name({}, "energy error", "csv"), "steplab-energy-error-1.csv");
    std::ofstream("steplab-energy-error-1.csv") << "mine";
    EXPECT_EQ(free_name({}, "energy error", "csv"), "steplab-energy-error-2.csv");
}

TEST(plot, saves_its_numbers_from_button_and_right_click) {
    const OwnFolder folder;
    Recorded recorded("oscillator");
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.csv");
    recorded.desk.point_at("energy error");
    recorded.desk.press(1);
    recorded.desk.release(1);
    recorded.desk.frame();
    recorded.desk.click("energy error.csv");
    std::stringstream text;
    text << std::ifstream("steplab-displacement-1.csv").rdbuf();
    EXPECT_EQ(text.str().substr(0, text.str().find('\n')), "time,run,exact");
    EXPECT_TRUE(std::filesystem::exists("steplab-energy-error-1.csv"));
}

TEST(plot, a_folder_that_cannot_be_written_is_reported) {
    const OwnFolder folder;
    Recorded recorded("oscillator");
    const auto gone = std::filesystem::current_path();
    std::filesystem::remove_all(gone);
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.csv");
    recorded.desk.frame();
    EXPECT_TRUE(recorded.desk.has("refusal"));
    std::filesystem::create_directory(gone);
}

TEST(plot, a_snapshot_is_requested_of_the_place_of_the_plot) {
    Recorded recorded("oscillator");
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.png");
    const auto requests = recorded.desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::save_snapshot);
    const WidgetRect frame = recorded.desk.widget("displacement");
    EXPECT_LE(static_cast<float>(requests[0].part.x), frame.left);
    EXPECT_GE(static_cast<float>(requests[0].part.x + requests[0].part.width), frame.right);
}

TEST(plot, drawing_a_long_run_stays_small) {
    Desk desk(describe("oscillator"));
    for (int i = 0; i < 50000; ++i) {
        desk.view.frame.step = static_cast<std::uint64_t>(i);
        desk.view.frame.time = 0.1 * i;
        desk.view.diagnostics.energy_error = 1e-6 * (1 + std::sin(0.3 * i));
        desk.view.tracked = Tracked{0, {std::sin(0.1 * i), 0, 0}, Vec3{std::cos(0.1 * i), 0, 0}};
        desk.interface.record(desk.view);
    }
    desk.frame();
    // Each plotted line has at most four points a column of pixels, and a point takes four corners.
    EXPECT_LT(desk.interface.draw_data().TotalVtxCount, 60000);
}

}  // namespace
}  // namespace steplab::ui
