// The scenes that are shipped: an exact value or a conserved quantity of each.

#include "io/scene_file.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/observables.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

RunDescription shipped(const std::string& name) { return describe(find_scene(name)); }

Diagnostics diagnostics_after(const RunDescription& run, std::uint64_t steps) {
    Simulation simulation(run);
    simulation.advance(steps);
    return simulation.diagnostics();
}

Frame frame_at(const RunDescription& run, double time) {
    return frame_after(run, static_cast<std::uint64_t>(std::lround(time / run.dt)));
}

TEST(ShippedScenes, are_at_least_sixteen_with_a_title_and_what_they_teach) {
    const std::vector<std::string> names = shipped_scenes();
    EXPECT_GE(names.size(), 16U);
    for (const std::string& name : names) {
        const auto scene = find_scene(name);
        EXPECT_FALSE(scene->model->info.name.empty()) << name;
        EXPECT_TRUE(scene->model->info.what.ends_with('.')) << name;
    }
}

// What a person first sees of a scene of one's own is chosen for it; models choose their camera themselves.
TEST(ShippedScenes, open_with_a_camera_and_colours) {
    for (const std::string& name : shipped_scenes()) {
        const bool is_model =
            std::any_of(models().begin(), models().end(), [&](const Model& model) { return model.info.id == name; });
        EXPECT_NE(find_scene(name)->defaults.camera.empty(), !is_model) << name;
        EXPECT_NE(find_scene(name)->defaults.colour.empty(), !is_model) << name;
    }
}

// A teacher writes them within a lesson.
TEST(ShippedScenes, that_need_no_programming_are_files_of_under_40_lines) {
    for (const char* const name :
         {"three-pendulums", "newtons-cradle", "two-planets", "cloth", "fermi-pasta-ulam", "kepler-ellipse"}) {
        const std::string text = find_scene(name)->parts.front().content;
        EXPECT_LT(std::count(text.begin(), text.end(), '\n'), 40) << name;
    }
}

// Symplectic methods at the steps the scenes open with: the energy wobbles by a few per cent of what moves at most.
// Where drag acts it is that and what drag took.
TEST(ShippedScenes, keep_their_energy) {
    for (const std::string& name : shipped_scenes()) {
        const RunDescription run = shipped(name);
        check(run);
        Simulation simulation(run);
        const bool counted = simulation.count_drag_work();
        EXPECT_EQ(counted, has_drag(run)) << name;
        const double start = simulation.diagnostics().energy;
        double error = 0, moving = 0;
        for (int part = 0; part < 20; ++part) {
            simulation.advance(25);
            const Diagnostics now = simulation.diagnostics();
            error = std::max(error, std::abs(now.energy + simulation.drag_work().value_or(0) - start));
            moving = std::max(moving, now.kinetic);
        }
        EXPECT_FALSE(simulation.divergence()) << name;
        EXPECT_LE(error, 0.05 * moving) << name;
        if (counted) {
            EXPECT_GT(*simulation.drag_work(), 3 * error) << name << ": drag takes more than the error";
        }
    }
}

/// Where the particles of a chain of equal links hang that is held at both ends, at one height: the tension has the
/// same part across in all links, and up in each what hangs below it (Irvine, Cable Structures, 1981, 1.1).
std::vector<Vec3> hanging(std::size_t links, double span, double length, double k, double weight) {
    const auto link = [&](double across, std::size_t i) {
        const double up = weight * (static_cast<double>(i) - 0.5 * static_cast<double>(links - 1));
        const double tension = std::hypot(across, up), stretched = (length + tension / k) / tension;
        return Vec3{stretched * across, stretched * up, 0};
    };
    const auto reach = [&](double across) {
        double sum = 0;
        for (std::size_t i = 0; i < links; ++i) sum += link(across, i).x;
        return sum;
    };
    double low = 0, high = k * span;
    for (int halved = 0; halved < 200; ++halved) (reach((low + high) / 2) < span ? low : high) = (low + high) / 2;
    std::vector<Vec3> places{{}};
    for (std::size_t i = 0; i < links; ++i) places.push_back(places.back() + link(low, i));
    return places;
}

// After 200 s of strong drag the slowest swing, of about 4 rad/s, is damped by e^-100 and more.
TEST(ShippedScenes, chain_comes_to_rest_as_an_elastic_catenary) {
    RunDescription run = shipped("catenary");
    run.scene.set("c", 0.1);
    const auto right = hanging(30, 3, 0.12, run.scene["k"], 0.02 * 9.81);
    const Frame rest = frame_at(run, 200);
    ASSERT_EQ(rest.positions.size(), right.size());
    for (std::size_t i = 0; i < right.size(); ++i) EXPECT_LT(length(rest.positions[i] - right[i]), 1e-10) << i;
    EXPECT_GT(length(hanging(30, 3, 0.12, 1.01 * run.scene["k"], 0.02 * 9.81)[15] - right[15]), 1e-6)
        << "the links' elasticity is seen";
}

// `free` within rounding: its accelerations become fields.
TEST(ShippedScenes, every_model_is_one_with_its_hash) {
    for (const Model& model : models()) {
        const RunDescription file = shipped(std::string(model.info.id));
        RunDescription direct = describe(model.info.id, file.method);
        direct.dt = file.dt;
        Simulation a(direct), b(file);
        a.advance(50);
        b.advance(50);
        if (model.info.id == "free") {
            EXPECT_LT(distance(a.frame(), b.frame()), 1e-12);
        } else {
            EXPECT_EQ(a.hash(), b.hash()) << model.info.id;
        }
    }
}

// Small swings: the period is longer by angle^2 / 16 = 4e-5; the rod is stretched by m g / S = 1e-3 of its length,
// which makes it longer by half of that; at a quarter of a period the angle passes 0.
TEST(ShippedScenes, pendulum_has_the_period_of_a_pendulum) {
    RunDescription run = shipped("pendulum");
    run.scene.set("angle", 0.025);
    const double period = 2 * std::numbers::pi * std::sqrt(1 / 9.81);
    for (const double quarter : {0.25, 0.75, 1.25})
        EXPECT_NEAR(frame_at(run, quarter * period).positions[1].x, 0, 0.025 * 0.015) << quarter;
    EXPECT_NEAR(frame_at(run, period).positions[1].x, 0.025, 0.025 * 0.01);
}

// V'' = 8 h in the wells.
TEST(ShippedScenes, double_well_swings_with_the_frequency_of_its_wells) {
    RunDescription run = shipped("double-well");
    const Frame start = frame_after(run, 0);
    EXPECT_NEAR(start.positions[3].x, 0.95, 1e-12);
    const double omega = std::sqrt(8 * 0.25), half = std::numbers::pi / omega;
    EXPECT_NEAR(frame_at(run, half).positions[3].x, 1.05, 0.01);  // the next term of V is a tenth of the first
    EXPECT_NEAR(frame_at(run, 2 * half).positions[3].x, 0.95, 0.005);
}

// The last ball rises as high as the first came from, L (1 - cos 0.6); what the others keep of it is a few per cent.
TEST(ShippedScenes, cradle_hands_its_swing_to_the_last_ball) {
    const RunDescription run = shipped("newtons-cradle");
    Simulation simulation(run);
    const double height = 1 - std::cos(0.6);
    EXPECT_NEAR(simulation.frame().positions[5].y, height, 1e-12);
    double highest = 0, middle = 0;
    for (int part = 0; part < 120; ++part) {
        simulation.advance(20);
        const Frame frame = simulation.frame();
        highest = std::max(highest, frame.positions[9].y);
        middle = std::max(middle, frame.positions[7].y);
    }
    EXPECT_NEAR(highest, height, 0.15 * height);
    EXPECT_LT(middle, 0.1 * height);
}

// Perihelion and aphelion of Jupiter, 4.95 and 5.46 astronomical units; its year of 4333 days.
TEST(ShippedScenes, jupiter_keeps_to_its_orbit) {
    const RunDescription run = shipped("outer-solar-system");
    const auto from_sun = [](const Frame& frame) { return frame.positions[1] - frame.positions[0]; };
    Simulation simulation(run);
    const Vec3 start = from_sun(simulation.frame());
    for (int part = 0; part < 100; ++part) {
        simulation.advance(5);
        const double distance = length(from_sun(simulation.frame()));
        EXPECT_GT(distance, 4.9);
        EXPECT_LT(distance, 5.5);
    }
    RunDescription year = run;
    year.dt = 4332.6 / 365.25 / 108;
    EXPECT_LT(length(from_sun(frame_after(year, 108)) - start), 0.06);  // what Saturn does in a year, 1 % of the orbit
}

TEST(ShippedScenes, network_and_crystal_keep_their_momentum) {
    for (const char* const name : {"spring-network", "fcc-crystal"}) {
        const RunDescription run = shipped(name);
        const Vec3 start = diagnostics_after(run, 0).momentum, end = diagnostics_after(run, 200).momentum;
        EXPECT_LT(length(end - start), 1e-10) << name;  // rounding of some thousand forces a step
    }
}

// sum m v^2 = (3 n - 3) kT.
TEST(ShippedScenes, crystal_has_its_temperature) {
    EXPECT_NEAR(2 * diagnostics_after(shipped("fcc-crystal"), 0).kinetic, (3.0 * 256 - 3) * 0.3, 1e-9);
}

/// Of a start at this temperature: root of the mean squared displacement after a time, by the distance of neighbours.
double lindemann_ratio(RunDescription run, double neighbours, double kT, double time) {
    run.scene.set("kT", kT);
    Observables observables(model_of(run).plan(run.scene), {Observable::msd});
    Simulation simulation(run);
    observables.of(simulation.state());
    simulation.advance(static_cast<std::uint64_t>(std::lround(time / run.dt)));
    return std::sqrt(observables.of(simulation.state())[0].value()) / neighbours;
}

// Crystals hold where it is below some 0.15 (Lindemann 1910); in a melt it grows with time.
TEST(ShippedScenes, crystal_melts_above_a_temperature) {
    const RunDescription run = shipped("fcc-crystal");
    const double neighbours = 1.64 / std::numbers::sqrt2;
    EXPECT_LT(lindemann_ratio(run, neighbours, 0.3, 8), 0.1);
    EXPECT_LT(lindemann_ratio(run, neighbours, 1, 8), 0.15);
    EXPECT_GT(lindemann_ratio(run, neighbours, 2, 8), 0.5);
    EXPECT_GT(lindemann_ratio(run, neighbours, 3, 8), 1);
}

TEST(ShippedScenes, cubic_crystal_gives_way_even_if_cold) {
    RunDescription run = shipped("crystal");
    run.dt = 0.05;
    EXPECT_GT(lindemann_ratio(run, 1, 0, 160), 1);
}

}  // namespace
}  // namespace steplab::test
