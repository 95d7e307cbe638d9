#include "core/error.hpp"
#include "session/playback_test.hpp"
#include "session/worker_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <future>

namespace steplab::test {
namespace {

using testing::HasSubstr;

class PlaybackWorker : public testing::Test {
protected:
    PlaybackWorker() { worker.on_view(News::wake); }
    template <class Condition>
    bool see(Condition condition) {
        while (true) {
            while (worker.take(view)) {
                if (condition(view)) return true;
            }
            if (!News::wait()) return false;
        }
    }

    Written written{played_chain()};
    Worker worker{TrajectoryFile{written.path}};
    SessionView view;
};

TEST_F(PlaybackWorker, plays_to_the_end_at_any_rate) {
    for (const Rate rate : {Rate{.as_fast_as_possible = true}, Rate{.seconds_per_second = 200}}) {
        worker.send(event::SetRate{rate});
        worker.send(event::Restart{});
        worker.send(event::Play{true});
        ASSERT_TRUE(see([](const SessionView& now) { return now.playback->frame == 23 && !now.leading.playing; }));
        EXPECT_EQ(bits_of(view.leading.frame), bits_of(written.frames[23]));
    }
    worker.send(event::SetRate{{.as_fast_as_possible = true}});
    worker.send(event::Play{true});
    std::size_t frames = 0;
    ASSERT_TRUE(see([&](const SessionView& now) {
        ++frames;
        return now.playback->frame == 23 && !now.leading.playing;
    }));
    EXPECT_GT(frames, 3u) << "some are seen on the way";
}

// A loop cannot be faster than its frames; how much longer it takes is a matter of the machine.
TEST_F(PlaybackWorker, plays_each_turn_of_a_loop_in_its_time) {
    const auto begin = std::chrono::steady_clock::now();
    worker.send(event::SetRate{{.seconds_per_second = 4}});  // 50 ms for a frame
    worker.send(event::Loop{StepRange{0, 2}});
    worker.send(event::Play{true});
    for (int turn = 0; turn < 4; ++turn) {
        for (const std::uint64_t frame : {1u, 0u})
            ASSERT_TRUE(see([=](const SessionView& now) { return now.playback->frame == frame; }));
    }
    EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(8 * 50));
}

TEST_F(PlaybackWorker, reports_what_it_refuses) {
    worker.send(event::Do{TurnRound{}});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.failures == 1; }));
    EXPECT_THAT(view.leading.error, HasSubstr("a trajectory is played back"));
    std::future<Recording> recording = worker.recording();
    EXPECT_THROW(recording.get(), UsageError);
}

TEST_F(PlaybackWorker, gives_way_to_a_run_and_a_run_to_it) {
    worker.send(event::Track{4});
    worker.send(event::Seek{12});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.frame.step == 12; }));
    const std::uint64_t run = view.leading.run;
    worker.begin(continued(view));
    ASSERT_TRUE(see([](const SessionView& now) { return !now.playback; }));
    EXPECT_EQ(view.leading.frame.positions, written.frames[6].positions);
    EXPECT_NE(view.leading.run, run) << "plots begin again";
    ASSERT_TRUE(view.leading.tracked);
    EXPECT_EQ(view.leading.tracked->particle, 4u);
    worker.send(event::Step{3});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.frame.step == 3; }));
    EXPECT_EQ(worker.recording().get().events.size(), 2u) << "the speed that stays, and the step";
    worker.begin(TrajectoryFile{written.path});
    ASSERT_TRUE(see([](const SessionView& now) { return now.playback.has_value(); }));
    EXPECT_EQ(bits_of(view.leading.frame), bits_of(written.frames[0]));
}

TEST_F(PlaybackWorker, stays_if_what_is_asked_for_cannot_begin) {
    worker.begin(TrajectoryFile{"there is no such file"});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.failures == 1; }));
    EXPECT_THAT(view.leading.error, HasSubstr("there is no such file"));
    EXPECT_TRUE(view.playback);
    worker.send(event::Step{1});
    EXPECT_TRUE(see([](const SessionView& now) { return now.playback->frame == 1; }));
}

}  // namespace
}  // namespace steplab::test
