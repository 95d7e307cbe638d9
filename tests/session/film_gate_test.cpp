// When the frames of a film are due that is taken of what is played.
#include "session/film_gate.hpp"

#include "session/compared.hpp"
#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {
namespace {

/// The steps that the frames of a film show, in pieces of at most so many steps; frames that show a step again follow
/// its first one.
std::vector<std::uint64_t> shown_steps(double spacing, double dt, std::uint64_t frames, std::uint64_t piece) {
    FilmGate gate(spacing);
    std::vector<std::uint64_t> steps{0};
    std::uint64_t step = 0;
    while (steps.size() < frames) {
        gate.go_on();
        const std::uint64_t last = steps.back();
        const std::uint64_t take = std::min(piece, gate.steps_to_frame(dt));
        steps.resize(gate.frames(), last);
        step += take;
        if (gate.played(take, dt)) steps.resize(gate.frames(), step);
    }
    steps.resize(frames);
    return steps;
}

TEST(FilmGate, frame_k_shows_the_last_step_that_is_not_after_k_spacings) {
    for (const double spacing : {1.0 / 30, 0.25, 2.0}) {
        for (const double dt : {0.001, 0.01, 1.0 / 30, 0.1, 0.7, 5.0}) {
            for (const std::uint64_t piece : {1u, 7u, 1000000u}) {
                const auto steps = shown_steps(spacing, dt, 200, piece);
                for (std::uint64_t k = 0; k < steps.size(); ++k)
                    EXPECT_EQ(steps[k], step_at(static_cast<double>(k) * spacing, dt))
                        << "frame " << k << " spacing " << spacing << " dt " << dt << " piece " << piece;
            }
        }
    }
}

TEST(FilmGate, waits_after_each_frame_and_only_there) {
    FilmGate gate(0.1);
    EXPECT_TRUE(gate.waits()) << "the first frame is that of now";
    EXPECT_EQ(gate.frames(), 1u);
    gate.go_on();
    EXPECT_EQ(gate.steps_to_frame(0.03), 3u);
    EXPECT_FALSE(gate.played(2, 0.03));
    EXPECT_FALSE(gate.waits());
    EXPECT_EQ(gate.steps_to_frame(0.03), 1u);
    EXPECT_TRUE(gate.played(1, 0.03));
    EXPECT_TRUE(gate.waits());
    EXPECT_EQ(gate.frames(), 2u);
}

TEST(FilmGate, without_a_step_no_frame_is_due) {
    FilmGate gate(0.1);
    gate.go_on();
    EXPECT_FALSE(gate.played(0, 1));
    EXPECT_EQ(gate.frames(), 1u);
}

TEST(FilmGate, goes_on_with_another_dt) {
    FilmGate gate(1);
    gate.go_on();
    EXPECT_EQ(gate.steps_to_frame(0.25), 4u);
    gate.played(2, 0.25);
    EXPECT_EQ(gate.steps_to_frame(0.125), 4u);
    EXPECT_TRUE(gate.played(4, 0.125));
}

TEST(FilmGate, has_whole_numbers_for_every_spacing_and_dt) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        const double spacing = std::abs(a), dt = std::abs(b);
        if (!(spacing > 0) || !(dt > 0)) continue;
        FilmGate gate(spacing);
        for (int i = 0; i < 3; ++i) {
            gate.go_on();
            const std::uint64_t steps = gate.steps_to_frame(dt), frames = gate.frames();
            EXPECT_GE(steps, 1u) << spacing << ' ' << dt;
            EXPECT_LE(steps, 1'000'000'000'000'000u) << spacing << ' ' << dt;
            gate.played(steps, dt);
            EXPECT_GE(gate.frames(), frames);
            EXPECT_LE(gate.frames(), 1'000'000'000'000'010u) << spacing << ' ' << dt;
        }
    }
}

}  // namespace
}  // namespace steplab
