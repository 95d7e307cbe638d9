// The exact motion between the samples of a run, as plots show it.
#include "ui/plot/exact_curve.hpp"

#include "core/number_text.hpp"
#include "ui/plot/recorded.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

/// The samples of a run and the closed form of its last particle.
struct Known {
    SampleSeries series;
    std::optional<ExactMotion> motion;
    std::size_t particles = 0;
};

Known known_of(const std::string& model, double dt, std::uint64_t steps) {
    RunDescription description = describe(model);
    description.dt = dt;
    Simulation run(description);
    RunSamples samples(run.particles());
    samples.follow({run.particles() - 1});
    for (samples.offer(run); run.step() < steps; samples.offer(run)) run.advance(1);
    Known known{{}, run.exact_motion(run.particles() - 1), run.particles()};
    samples.put_into(known.series);
    return known;
}

std::vector<ExactPoint> points_of(const Known& known) {
    ExactCurve curve;
    const auto points = curve.of(known.series, 0, known.motion, known.particles);
    return {points.begin(), points.end()};
}

std::vector<double> times_of(std::span<const ExactPoint> points) {
    std::vector<double> times;
    for (const ExactPoint& point : points) times.push_back(point.time);
    return times;
}

/// Largest distance of the closed form from the straight lines of a curve, as part of the largest displacement.
double corners_of(const std::vector<ExactPoint>& points, const ExactMotion& motion) {
    double off = 0, farthest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 middle = 0.5 * (points[i - 1].displacement + points[i].displacement);
        off = std::max(off, length(*motion.displacement(0.5 * (points[i - 1].time + points[i].time)) - middle));
        farthest = std::max(farthest, length(points[i].displacement));
    }
    return off / farthest;
}

TEST(exact_curve, has_no_corners_however_large_the_steps_are) {
    for (const char* model : {"oscillator", "chain", "free"}) {
        for (const double dt : {1e-3, 0.03, 0.4, 1.2, 2.5, 6.28318530717958648}) {
            const Known known = known_of(model, dt, 20);
            // 16 points to a gap, of a period of 2 or more: at most 6.3 / 16 rad of a wave of angular frequency 2 lie
            // between two, an arc of 0.8 rad, whose height is 0.8^2 / 8 = 8 % of the amplitude of that mode alone; of
            // all gaps but the longest far less
            const double allowed = dt < 3 ? 0.02 : 0.08;
            EXPECT_LE(corners_of(points_of(known), *known.motion), allowed) << model << " dt " << dt;
        }
    }
}

TEST(exact_curve, is_the_closed_form_at_each_of_its_points_and_passes_through_the_samples) {
    const Known known = known_of("chain", 1.2, 40);
    const std::vector<ExactPoint> points = points_of(known);
    EXPECT_GT(points.size(), 4 * known.series.samples.size());
    for (const ExactPoint& point : points) {
        EXPECT_EQ(point.displacement, *known.motion->displacement(point.time)) << point.time;
        EXPECT_EQ(point.velocity, known.motion->velocity(point.time)) << point.time;
    }
    const std::vector<double> times = times_of(points);
    EXPECT_TRUE(std::is_sorted(times.begin(), times.end()));
    for (const Sample& sample : known.series.samples)
        EXPECT_TRUE(std::binary_search(times.begin(), times.end(), sample.time)) << sample.time;
}

TEST(exact_curve, has_the_same_points_however_often_it_was_shown) {
    for (const std::uint64_t steps : {40u, 3000u, 7000u, 9000u}) {
        const Known known = known_of("oscillator", 1.2, steps);
        ExactCurve often;
        Known part = known;
        part.series.samples.clear();
        for (std::size_t i = 0; i < known.series.samples.size(); ++i) {
            part.series.samples.push_back(known.series.samples[i]);
            if (i % 7 == 0) often.of(part.series, 0, part.motion, part.particles);
        }
        EXPECT_EQ(times_of(often.of(part.series, 0, part.motion, part.particles)), times_of(points_of(known))) << steps;
    }
}

TEST(exact_curve, has_no_points_between_those_that_a_line_joins) {
    const Known known = known_of("oscillator", 0.01, 500);
    EXPECT_EQ(points_of(known).size(), known.series.samples.size());
}

TEST(exact_curve, is_bounded_in_long_runs) {
    const Known known = known_of("oscillator", 1.9, 8000);
    EXPECT_LE(points_of(known).size(), 5 * RunSamples::most);
}

TEST(exact_curve, keeps_what_it_found_when_the_closed_form_is_known_no_more) {
    const Known known = known_of("chain", 1.2, 30);
    ExactCurve curve;
    const std::vector<double> before = times_of(curve.of(known.series, 0, known.motion, known.particles));
    SampleSeries series = known.series;
    series.samples.push_back(series.samples.back());
    series.samples.back().particles[0]->exact_displacement.reset();
    const std::vector<double> after = times_of(curve.of(series, 0, std::nullopt, known.particles));
    ASSERT_EQ(after.size(), before.size() + 1);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
    EXPECT_TRUE(std::isnan(curve.of(series, 0, std::nullopt, known.particles).back().displacement.x));
}

TEST(exact_curve, is_found_again_for_other_samples_and_another_particle) {
    const Known chain = known_of("chain", 1.2, 30), other = known_of("chain", 0.7, 30);
    ExactCurve curve;
    curve.of(chain.series, 0, chain.motion, chain.particles);
    EXPECT_EQ(times_of(curve.of(other.series, 0, other.motion, other.particles)), times_of(points_of(other)));
    std::optional<ExactMotion> neighbour = other.motion;
    neighbour->particle -= 1;
    const auto points = curve.of(other.series, 0, neighbour, other.particles);
    EXPECT_EQ(points[1].displacement, *neighbour->displacement(points[1].time));
}

// Few steps of a large scene have no corners either; of many the curve takes no longer than that of a small scene.
TEST(exact_curve, of_a_large_scene_has_as_many_points_as_it_has_time_for) {
    const Known known = known_of("chain", 1.2, 300);
    const std::size_t samples = known.series.samples.size(), in_full = points_of(known).size();
    std::size_t before = in_full;
    for (const std::size_t particles : {1000u, 4000u, 20000u, 1000000u}) {
        ExactCurve curve;
        const std::size_t points = curve.of(known.series, 0, known.motion, particles).size();
        EXPECT_LE(points, before) << particles;
        EXPECT_LE((points - samples) * particles, 4 * RunSamples::most * ExactCurve::most_particles_in_full);
        before = points;
    }
    ExactCurve thousand, million;
    const std::size_t gaps = (in_full - samples) / 15;
    EXPECT_GE(thousand.of(known.series, 0, known.motion, 1000).size(), samples + 3 * gaps) << "four parts or more";
    EXPECT_EQ(million.of(known.series, 0, known.motion, 1000000).size(), samples);
}

TEST(exact_curve, is_none_where_no_closed_form_is_known) {
    const Known known = known_of("morse", 0.01, 30);
    EXPECT_FALSE(known.motion);
    EXPECT_TRUE(points_of(known).empty());
}

/// The table of a kind of plot of a chain at a large dt.
std::string table_of(const std::string& kind) {
    const OwnFolder folder;
    RunDescription description = describe("chain");
    description.dt = 1.2;
    Recorded recorded(description, 20);
    choose(recorded.desk, 1, kind);
    return saved_csv(recorded.desk, kind);
}

TEST(exact_curve, is_in_plots_of_displacement_position_velocity_and_in_phase_portraits) {
    RunDescription description = describe("chain");
    description.dt = 1.2;
    Simulation run(description);
    const std::size_t last = run.particles() - 1;
    const ExactMotion exact = run.exact_motion(last).value();
    const double time = 1.2 / 16;
    const double u = exact.displacement(time)->x, v = exact.velocity(time).x, x = run.shape()->rest[last].x + u;
    const auto expect_row = [](const std::string& kind, const std::string& row) {
        EXPECT_NE(table_of(kind).find("\n" + row + "\n"), std::string::npos) << kind << ", " << row;
    };
    expect_row("displacement", number_text(time) + ",," + number_text(u));
    expect_row("position", number_text(time) + ",," + number_text(x));
    expect_row("velocity", number_text(time) + ",," + number_text(v));
    expect_row("phase portrait", "exact," + number_text(u) + "," + number_text(v));
}

TEST(exact_curve, position_is_that_of_the_particle_in_the_scene) {
    const OwnFolder folder;
    Recorded recorded("mesh");
    choose(recorded.desk, 1, "position");
    const std::string table = saved_csv(recorded.desk, "position");
    const RunView& view = recorded.desk.view;
    const Vec3 there = view.frame.positions[view.tracked->particle];
    const std::string last = table.substr(table.rfind('\n', table.size() - 2) + 1);
    const double shown = std::stod(last.substr(last.find(',') + 1));
    const double nearest = std::min({std::abs(shown - there.x), std::abs(shown - there.y), std::abs(shown - there.z)});
    EXPECT_LE(nearest, 1e-12);  // rounding of rest position plus displacement
}

}  // namespace
}  // namespace steplab::ui
