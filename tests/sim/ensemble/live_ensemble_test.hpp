#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <variant>
#include <vector>

namespace steplab::test {

inline constexpr std::size_t count = 11;  // fills no register

inline LiveEnsemble::Variation spread(const LiveEnsembleOptions& ensemble) {
    return [ensemble](const RunDescription& description, std::size_t i) {
        return run_in_range(description, std::vector{range_of(ensemble, description)}, i, ensemble.runs);
    };
}

/// A run and the members of it, to which the same is done.
struct Flock {
    Simulation run;
    std::vector<SegmentBegin> segments;
    LiveEnsemble live_ensemble;
    std::vector<Simulation> alone;  ///< what the members are to be

    Flock(const RunDescription& description, const LiveEnsembleOptions& wanted)
        : run(description), segments{{0, description}}, live_ensemble(wanted.runs, spread(wanted)), ensemble(wanted) {
        for (std::size_t i = 0; i < ensemble.runs; ++i) alone.emplace_back(spread(ensemble)(description, i));
    }

    void advance(std::uint64_t steps) {
        run.advance(steps);
        for (Simulation& simulation : alone) simulation.advance(steps);
    }
    void change(const RunDescription& description) {
        segments.push_back({run.step(), description});
        run.change(description);
        for (std::size_t i = 0; i < ensemble.runs; ++i) alone[i].change(spread(ensemble)(description, i));
    }
    void pull(std::size_t particle, Vec3 position) {
        const Pull pull{particle, position};
        const auto* const last = segments.back().act ? std::get_if<Pull>(&*segments.back().act) : nullptr;
        if (last && last->particle == particle && segments.back().step == run.step()) segments.pop_back();
        segments.push_back({run.step(), run.description(), pull});
        run.act(pull);
        for (Simulation& simulation : alone) simulation.act(pull);
    }
    void act(const Act& act) {
        segments.push_back({run.step(), run.description(), act});
        run.act(act);
        for (Simulation& simulation : alone) simulation.act(act);
    }
    EnsembleSpread observe(Frame& frame) {
        EXPECT_TRUE(live_ensemble.go_to(run.step(), segments));
        EXPECT_TRUE(live_ensemble.are_at(run.step(), segments));
        run.frame(frame);
        return live_ensemble.observe(frame);
    }
    void expect_the_bits_of_runs_alone() {
        Frame frame;
        observe(frame);
        for (std::size_t i = 0; i < ensemble.runs; ++i) {
            const auto begin = frame.ensemble.begin() + static_cast<std::ptrdiff_t>(i * run.particles());
            const std::vector<Vec3> places(begin, begin + static_cast<std::ptrdiff_t>(run.particles()));
            ASSERT_EQ(places, alone[i].frame().positions) << "member " << i << " at step " << run.step();
        }
    }

    LiveEnsembleOptions ensemble;
};

}  // namespace steplab::test
