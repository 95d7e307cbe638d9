#include "ui/plot/draw_plot.hpp"
#include "ui/plot/plot_files.hpp"
#include "ui/plot/plots.hpp"
#include "ui/plot/recorded.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace steplab::ui {
namespace {

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

TEST(plot, a_snapshot_is_requested_by_its_name) {
    Recorded recorded("oscillator");
    recorded.desk.click("displacement.save");
    recorded.desk.click("displacement.png");
    const auto requests = recorded.desk.interface.take_requests();
    ASSERT_EQ(requests.size(), 1u);
    EXPECT_EQ(requests[0].kind, Request::Kind::save_snapshot);
    EXPECT_EQ(requests[0].plot, "displacement");
}

TEST(plot, drawing_a_long_run_stays_small) {
    Desk desk(describe("oscillator"));
    for (int i = 0; i < 50000; ++i) {
        desk.view.frame.step = static_cast<std::uint64_t>(i);
        desk.view.frame.time = 0.1 * i;
        desk.view.diagnostics.energy_error = 1e-6 * (1 + std::sin(0.3 * i));
        desk.view.tracked = Tracked{0, {std::sin(0.1 * i), 0, 0}, Vec3{std::cos(0.1 * i), 0, 0}};
        desk.view.series.samples.push_back(sample_of(desk.view));
        if (i % 100 == 0) desk.interface.record(desk.view);
    }
    desk.frame();
    // Each plotted line has at most four points a column of pixels, and a point takes four corners.
    EXPECT_LT(desk.interface.draw_data().TotalVtxCount, 60000);
}

}  // namespace
}  // namespace steplab::ui
