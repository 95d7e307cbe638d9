#include "support/extreme_doubles.hpp"
#include "ui/desk.hpp"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

namespace steplab::ui {
namespace {

using Pair = std::pair<double, double>;

Vec3 mixed(const Pair& pair) { return {pair.first, pair.second, -pair.first}; }

/// A run in which every number that panels show is one of the pair.
void fill(RunView& view, const Pair& pair) {
    const auto [a, b] = pair;
    view.frame.time = a;
    view.diagnostics = {.kinetic = a,
                        .potential = b,
                        .energy = a,
                        .energy_error = b,
                        .momentum = mixed(pair),
                        .angular_momentum = mixed({b, a}),
                        .max_displacement = a,
                        .farthest = b,
                        .max_speed = a,
                        .error = b};
    view.tracked = Tracked{.particle = 1, .displacement = mixed(pair), .exact_displacement = mixed({b, a})};
    view.frame.positions[1] = mixed(pair);
    view.frame.velocities[1] = mixed({b, a});
    view.limit = StabilityLimit{a, b};
    view.resolution = Resolution{a, b, a};
    view.facts.drag = std::abs(b);
    view.rate = {.seconds_per_second = a};
    view.segment_start = b;
    view.smooth_since = a;
    view.dt = a;
    view.opening_dt = b;
    view.ensemble = {.runs = 1, .spread = "v0", .width = b};
    view.ensemble_spread = {.largest = a, .root_mean_square = b};
    view.steps_per_second = view.evaluations_per_second = a;
    view.cost = b;
    view.description.dt = b;
}

void fill_samples(RunView& view, const Pair& pair) {
    const auto [a, b] = pair;
    view.series.samples.clear();
    for (const auto& [time, number] : {Pair{0, a}, {1, b}, {a, b}, {b, a}}) {
        view.series.samples.push_back({.step = view.series.samples.size(),
                                       .time = time,
                                       .kinetic = number,
                                       .potential = number,
                                       .energy_error = number,
                                       .momentum = mixed({number, time}),
                                       .largest_displacement = number,
                                       .error = number,
                                       .particles = {Sample::Particle{mixed(pair), mixed(pair), mixed(pair)}}});
    }
    view.series.stretch = std::make_shared<const int>();
}

void fill(SessionView& session, const Pair& pair) {
    const auto [a, b] = pair;
    fill(session.leading, pair);
    fill_samples(session.leading, pair);
    for (RunView& run : session.followers) fill(run, {b, a});
    session.line = {.reached_time = a, .changes = {{1, b, "dt"}}, .bookmarks = {{2, a, "here"}}, .branches = {{a, b}}};
    session.line.loop = TimeLineView::Loop{b, a};
    const Compared compared{.time = a,
                            .error = b,
                            .rms_error = a,
                            .energy_error = b,
                            .momentum_error = a,
                            .phase_error = b,
                            .reference_error = a};
    session.errors = SessionErrors{.time = a, .runs = {compared, compared}, .how = "gauss-16"};
    session.error_series.assign(2, {});
    for (ErrorSeries& series : session.error_series) series.samples = {{.step = 1, .time = b, .error = a}};
    CostsView costs{.time = a, .done = b, .complete = true, .how = "gauss-16"};
    costs.points = {{session.leading.description, a, b, a}, {session.leading.description, b, a, b}};
    costs.runs = {costs.points.front(), costs.points.back()};
    session.costs = std::make_shared<const CostsView>(costs);
    PresentLimit present;
    present.time = a;
    present.limit = b;
    present.resolution = Resolution{b, a, b};
    session.present = std::make_shared<const PresentLimit>(present);
}

/// Everything is shown: two runs, an ensemble, and two plots of a kind.
struct FullDesk : Desk {
    explicit FullDesk(PlotKind kind) : Desk(describe("chain"), {1280, 1600, 1}) {
        ViewChoices choices;
        choices.plots = {{kind, plot::Scale::linear}, {kind, plot::Scale::symmetric_logarithmic}};
        interface.use(choices, choices);
        session.followers.push_back(view);
        view.frame.ensemble = view.frame.positions;
        for (int i = 0; i < 3; ++i) frame();
    }
    void show(const Pair& pair) {
        fill(session, pair);
        ++view.frame.step;
        interface.record(view);
        frame();
    }
    void expect_a_picture(const Pair& pair, int most) const {
        const ImDrawData& data = interface.draw_data();
        EXPECT_LE(data.TotalVtxCount, most) << pair.first << ", " << pair.second;
        for (int i = 0; i < data.CmdListsCount; ++i) {
            const auto& vertices = data.CmdLists[i]->VtxBuffer;
            const auto lost = std::find_if(vertices.begin(), vertices.end(), [](const ImDrawVert& vertex) {
                return !std::isfinite(vertex.pos.x) || !std::isfinite(vertex.pos.y);
            });
            EXPECT_TRUE(lost == vertices.end())
                << pair.first << ", " << pair.second << ": " << data.CmdLists[i]->_OwnerName << ", vertex "
                << lost - vertices.begin() << " behind " << (lost == vertices.begin() ? 0 : (lost - 1)->pos.x) << ", "
                << (lost == vertices.begin() ? 0 : (lost - 1)->pos.y);
        }
    }
};

// The texts of all rows, cards and marks together are no longer than three times those of an everyday moment: a number
// that is written out takes 300 digits.
TEST(ExtremeValues, give_panels_that_are_drawn_and_texts_that_are_short) {
    for (const PlotKindInfo& kind : plot_kinds) {
        FullDesk desk(kind.kind);
        desk.show({0.5, 0.25});
        const int everyday = desk.interface.draw_data().TotalVtxCount;
        ASSERT_GT(everyday, 1000);
        for (const Pair& pair : extreme_pairs(100)) {
            desk.show(pair);
            desk.expect_a_picture(pair, 3 * everyday);
            if (testing::Test::HasFailure()) return;
        }
    }
}

}  // namespace
}  // namespace steplab::ui
