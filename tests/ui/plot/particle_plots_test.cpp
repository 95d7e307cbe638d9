#include "core/number_text.hpp"
#include "sim/run/pair_law.hpp"
#include "support/scene_texts.hpp"
#include "ui/plot/recorded.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// The rows of a table of numbers below its header; a cell without one is not a number.
std::vector<std::vector<double>> rows_of(const std::string& csv) {
    std::vector<std::vector<double>> rows;
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
        rows.emplace_back();
        std::istringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');)
            rows.back().push_back(cell.empty() ? NAN : std::stod(cell));
    }
    return rows;
}

struct Peak {
    double frequency = 0, amplitude = 0, step = 0;
};

/// The highest of a spectrum that is shown.
Peak peak_of(Desk& desk) {
    choose(desk, 1, "spectrum");
    const auto rows = rows_of(saved_csv(desk, "spectrum"));
    Peak peak{.step = rows.at(1).at(0) - rows.at(0).at(0)};
    for (const auto& row : rows) {
        if (row.at(1) > peak.amplitude) peak = {row[0], row[1], peak.step};
    }
    return peak;
}

TEST(particle_plots, the_spectrum_of_an_oscillator_peaks_at_the_root_of_k_over_m) {
    const OwnFolder folder;
    RunDescription description = describe("oscillator");
    description.scene.set("k", 2.5);
    description.dt = 0.05;
    Recorded recorded(description, 1500);
    const Peak peak = peak_of(recorded.desk);
    const double omega = std::sqrt(2.5 / description.scene["m"]);
    EXPECT_NEAR(peak.frequency, omega, 0.51 * peak.step);
    // as high as the amplitude, but for the frequencies not fitting the length: 5 %
    EXPECT_NEAR(peak.amplitude, description.scene["v0"] / omega, 0.05 * description.scene["v0"] / omega);
}

/// Seven particles on springs, fixed at one end, that vibrate in a normal mode.
RunDescription row_in(int mode) {
    RunDescription description = describe(test::read_scene(R"(steplab = 1
[[particles]]
group = "row"
line = { count = 8, step = [1, 0, 0] }
[[fix]]
particles = ["row[0]"]
fixed = true
[[springs]]
between = "row"
k = 4
[run]
method = "rk4"
dt = 0.05
[start]
amplitude = 0.01
mode = )" + std::to_string(mode) + "\n"));
    return description;
}

TEST(particle_plots, the_spectrum_of_a_chain_in_a_normal_mode_peaks_at_its_frequency) {
    for (const int mode : {1, 3, 6}) {
        const OwnFolder folder;
        Recorded recorded(row_in(mode), 3000);
        const double omega = 2 * 2 * std::sin((2 * mode - 1) * std::numbers::pi / (2 * 15));
        const Peak peak = peak_of(recorded.desk);
        EXPECT_NEAR(peak.frequency, omega, 0.51 * peak.step) << mode;
        recorded.desk.click("spectrum.save");
        recorded.desk.click("spectrum.svg");
        EXPECT_THAT(text_of_file("steplab-spectrum-1.svg"), HasSubstr("mode " + std::to_string(mode)));
    }
}

TEST(particle_plots, a_spectrum_is_the_same_however_often_the_run_was_shown) {
    const OwnFolder folder;
    Recorded recorded(describe("chain"), 400);
    choose(recorded.desk, 1, "spectrum");
    const std::string often = saved_csv(recorded.desk, "spectrum");
    std::filesystem::remove("steplab-spectrum-1.csv");
    Desk desk(describe("chain"));
    desk.show(recorded.desk.view);
    desk.frame();
    choose(desk, 1, "spectrum");
    EXPECT_EQ(saved_csv(desk, "spectrum"), often);
    EXPECT_THAT(often, StartsWith("angular frequency,run\n"));
}

TEST(particle_plots, a_spectrum_is_of_the_newest_samples_at_equal_distances) {
    const OwnFolder folder;
    Recorded recorded(describe("oscillator"), 10);
    std::vector<Sample>& samples = recorded.desk.view.series.samples;
    samples.clear();
    double time = 0;
    for (int i = 0; i < 1200; ++i) {
        time += i < 700 ? 0.17 : 0.04;  // as where dt is changed
        Sample sample;
        sample.step = static_cast<std::uint64_t>(i);
        sample.time = time;
        sample.particles = {Sample::Particle{{std::sin((i < 700 ? 9 : 5) * time), 0, 0}, {}}};
        samples.push_back(sample);
    }
    recorded.desk.frame();
    const Peak peak = peak_of(recorded.desk);
    EXPECT_NEAR(peak.frequency, 5, 0.51 * peak.step);
}

TEST(particle_plots, too_few_samples_have_no_spectrum) {
    const OwnFolder folder;
    Recorded recorded(describe("chain"), 60);
    choose(recorded.desk, 1, "spectrum");
    EXPECT_EQ(saved_csv(recorded.desk, "spectrum"), "angular frequency\n");
}

TEST(particle_plots, an_ensemble_is_a_band_around_the_displacement) {
    const OwnFolder folder;
    Recorded recorded("oscillator");
    Desk& desk = recorded.desk;
    const Vec3 u = desk.view.tracked->displacement;
    SpreadSample sample{.step = desk.view.frame.step, .time = desk.view.frame.time, .largest = 0.5};
    sample.reach = {u - Vec3{0.25, 0, 0}, u + Vec3{0.5, 0, 0}};
    desk.view.spread.samples = {sample};
    desk.interface.record(desk.view);
    desk.frame();
    const std::string text = saved_csv(desk, "displacement");
    EXPECT_THAT(text, StartsWith("time,run,exact,ensemble low,ensemble high\n"));
    const std::vector<double> last = rows_of(text).back();
    EXPECT_NEAR(last.at(3), u.x - 0.25, 1e-12);
    EXPECT_NEAR(last.at(4), u.x + 0.5, 1e-12);
}

/// The position errors of a run of five steps of this error, as a table.
std::string errors_against_reference(double error) {
    Desk desk(describe("morse"));
    desk.view.series.samples = {Sample{}};
    desk.view.has_exact = false;
    ErrorSeries errors;
    for (std::uint64_t step = 0; step < 5; ++step)
        errors.samples.push_back({step, 0.25 * static_cast<double>(step), error, 1e-9});
    desk.session.error_series = {errors};
    desk.interface.record(desk.view);
    desk.frame();
    choose(desk, 1, "position error");
    return saved_csv(desk, "position error");
}

TEST(particle_plots, the_error_of_the_reference_is_a_band_below_which_no_error_is_known) {
    const OwnFolder folder;
    EXPECT_THAT(errors_against_reference(1e-3),
                HasSubstr("time,run,error of the reference low,error of the reference high\n0,0.001,0,1e-09\n"));
}

TEST(particle_plots, there_is_no_band_of_the_reference_while_no_error_is_known) {
    const OwnFolder folder;
    EXPECT_THAT(errors_against_reference(0), Not(HasSubstr("error of the reference")));
}

TEST(particle_plots, the_pair_potential_is_that_of_the_scene_with_the_pairs_on_it) {
    const OwnFolder folder;
    Recorded recorded("morse");
    choose(recorded.desk, 1, "pair potential");
    const std::string text = saved_csv(recorded.desk, "pair potential");
    EXPECT_THAT(text, StartsWith("distance of two particles,V,F,pairs now\n"));
    const PairLaw law = pair_laws(describe("morse")).front();
    std::size_t pairs = 0;
    for (const auto& row : rows_of(text)) {
        if (std::isfinite(row.at(1))) {
            EXPECT_EQ(row[1], law.energy(row[0]));
            EXPECT_EQ(row.at(2), law.force(row[0]));
        }
        if (!std::isfinite(row.at(3))) continue;
        EXPECT_EQ(row[3], law.energy(row[0]));
        ++pairs;
    }
    EXPECT_GT(pairs, 10u);
}

TEST(particle_plots, a_scene_without_pair_forces_has_no_pair_potential) {
    const OwnFolder folder;
    Recorded recorded("chain");
    choose(recorded.desk, 1, "pair potential");
    EXPECT_EQ(saved_csv(recorded.desk, "pair potential"), "distance of two particles\n");
}

/// True if a plot of this kind has points, of a file that is played.
bool is_known(PlotKind kind, const PlaybackView& playback) {
    const OwnFolder folder;
    Recorded recorded("chain");
    recorded.desk.session.playback = playback;
    const std::string name(info_of(kind).id);
    choose(recorded.desk, 1, name);
    const std::string table = saved_csv(recorded.desk, name);
    return std::count(table.begin(), table.end(), '\n') > 1;
}

TEST(particle_plots, are_known_of_files_without_their_scene_as_far_as_they_have_it) {
    using enum PlotKind;
    const PlaybackView whole{.file = "a.trajectory"}, rows{.file = "a.xyz", .measured = false},
        positions{.file = "a.xyz", .measured = false, .has_velocities = false};
    for (const PlotKind kind : {energies, momentum, displacement, position, velocity, phase, speeds}) {
        EXPECT_TRUE(is_known(kind, whole)) << info_of(kind).id;
        EXPECT_EQ(is_known(kind, rows), kind != energies && kind != momentum) << info_of(kind).id;
        EXPECT_EQ(is_known(kind, positions), kind == displacement || kind == position) << info_of(kind).id;
    }
}

}  // namespace
}  // namespace steplab::ui
