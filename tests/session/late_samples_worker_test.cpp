// Samples that were not taken when the runs were where they belong, in the thread of the window's session.
#include "session/session_test.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace steplab::test {
namespace {

/// True if they begin at the start and end at this step, all of them with the particle.
bool are_complete(const SampleSeries& series, std::uint64_t last) {
    const auto& samples = series.samples;
    const auto tells = [](const Sample& sample) { return sample.particle() != nullptr; };
    return samples.front().step == 0 && samples.back().step == last &&
           std::all_of(samples.begin(), samples.end(), tells);
}

class LateInTheWindow : public WorkerTest {
protected:
    LateInTheWindow() {
        worker.send(event::Track{1});
        worker.send(event::ShowSamples{true});
        worker.send(event::AddRun{chain("rk4")});
        worker.send(event::Step{2000});
        EXPECT_TRUE(see([](const RunView& view) { return view.frame.step == 2000; }));
    }
    /// Until all runs have all samples of another particle.
    bool completes(std::size_t particle) {
        worker.send(event::Track{particle});
        return see([&](const RunView& view) {
            const std::uint64_t step = session.followers.at(0).frame.step;
            return view.tracked && view.tracked->particle == particle &&
                   are_complete(view.series, session.line.reached) && are_complete(session.followers[0].series, step);
        });
    }
};

TEST_F(LateInTheWindow, samples_are_taken_while_the_session_stands) {
    EXPECT_TRUE(completes(3));
    EXPECT_EQ(view.frame.step, 2000u);
}

// Nothing else wakes the worker then.
TEST_F(LateInTheWindow, samples_of_a_run_alone_are_taken) {
    worker.send(event::RemoveRun{1});
    EXPECT_TRUE(see([&](const RunView&) { return session.followers.empty(); }));
    worker.send(event::Step{126000});  // many pieces
    worker.send(event::Track{2});
    EXPECT_TRUE(see([](const RunView& view) {
        return view.tracked && view.tracked->particle == 2 && are_complete(view.series, 128000);
    }));
}

TEST_F(LateInTheWindow, samples_are_taken_while_it_plays_with_time_to_spare) {
    worker.send(event::Play{true});
    EXPECT_TRUE(completes(4));
    EXPECT_TRUE(view.playing);
}

}  // namespace
}  // namespace steplab::test
