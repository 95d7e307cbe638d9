// Parts of a recording in the session that is played, as lessons have them.

#include "session/playback_test.hpp"
#include "session/replay.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace steplab::test {
namespace {

RunDescription oscillator(std::string_view method) { return run_of("oscillator", method, Precision::double_, 0.1); }

/// Two parts: a run beside the first one, up to step 20; from there reversed, up to step 40.
FilmPart part(std::size_t from, std::size_t to) {
    static const auto recording = [] {
        Recording lesson{.start = oscillator("verlet")};
        lesson.events = {{event::AddRun{oscillator("rk4")}, 0},
                         {event::Bookmark{"there"}, 20},
                         {event::Do{TurnRound{}}, 20},
                         {event::Bookmark{"back"}, 40}};
        return std::make_shared<const Recording>(lesson);
    }();
    return {recording, from, to};
}

class FilmPartTest : public WorkerTest {
protected:
    FilmPartTest() { worker.send(event::SetRate{{.as_fast_as_possible = true}}); }

    bool stands_at(std::uint64_t step) {
        return see([&](const RunView& now) { return !now.playing && now.frame.step == step; });
    }
};

TEST_F(FilmPartTest, plays_to_its_end_and_stands_there) {
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    EXPECT_EQ(view.description.model, "oscillator");
    ASSERT_EQ(session.followers.size(), 1u);
    EXPECT_EQ(session.followers[0].description.method, "rk4");
    EXPECT_EQ(session.line.bookmarks.size(), 1u);
}

TEST_F(FilmPartTest, is_followed_by_the_next_one_in_the_same_run) {
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    const std::uint64_t run = view.run;
    worker.play_part(part(2, 4));
    ASSERT_TRUE(stands_at(40));
    EXPECT_EQ(view.run, run);
    EXPECT_EQ(session.line.changes.size(), 1u);
}

// Where something else was done, the part has to begin from the start of the recording.
TEST_F(FilmPartTest, begins_again_where_something_was_done_between) {
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    const std::uint64_t run = view.run;
    worker.send(event::RemoveRun{1});
    worker.play_part(part(2, 4));
    ASSERT_TRUE(stands_at(40));
    EXPECT_GT(view.run, run);
    EXPECT_EQ(session.followers.size(), 1u);
}

TEST_F(FilmPartTest, begins_in_the_middle_of_the_recording) {
    worker.play_part(part(2, 4));
    ASSERT_TRUE(stands_at(40));
    EXPECT_EQ(session.followers.size(), 1u);
    EXPECT_EQ(session.line.bookmarks.size(), 2u);
}

TEST_F(FilmPartTest, begins_again_where_an_earlier_one_is_played) {
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    worker.play_part(part(2, 4));
    ASSERT_TRUE(stands_at(40));
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    EXPECT_TRUE(session.line.changes.empty());
    EXPECT_EQ(session.line.bookmarks.size(), 1u);
}

// At a thousandth of real time, step 20 would be 2000 s away.
TEST_F(FilmPartTest, hastens_to_where_it_begins) {
    worker.send(event::SetRate{{.as_fast_as_possible = false, .seconds_per_second = 1e-3}});
    worker.play_part(part(2, 3));
    ASSERT_TRUE(stands_at(20));
    EXPECT_EQ(session.line.changes.size(), 1u);
}

TEST_F(FilmPartTest, is_undone_to_what_there_was_before) {
    worker.send(event::Step{7});
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    worker.send(event::Undo{});  // the run that was added
    worker.send(event::Undo{});  // the beginning of the lesson
    ASSERT_TRUE(see([](const RunView& now) { return now.description.model == "chain"; }));
    EXPECT_EQ(view.frame.step, 7u);
    EXPECT_TRUE(session.followers.empty());
}

// Played on by hand, the run goes on alone: the next part's reversal does not come.
TEST_F(FilmPartTest, is_over_where_the_run_is_played_on) {
    worker.play_part(part(0, 2));
    ASSERT_TRUE(stands_at(20));
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const RunView& now) { return now.frame.step > 60; }));
    EXPECT_TRUE(session.line.changes.empty());
}

TEST(FilmPart, takes_the_place_of_a_trajectory) {
    const Written written(played_chain());
    Worker worker(TrajectoryFile{written.path});
    worker.on_view(News::wake);
    worker.send(event::SetRate{{.as_fast_as_possible = true}});
    worker.play_part(part(0, 2));
    SessionView view;
    const auto ended = [&] { return worker.take(view) && !view.playback && view.leading.frame.step == 20; };
    while (!ended()) ASSERT_TRUE(News::wait());
    EXPECT_EQ(view.leading.description.model, "oscillator");
}

TEST_F(FilmPartTest, is_recorded_so_that_it_can_be_replayed) {
    worker.play_part(part(0, 4));
    ASSERT_TRUE(stands_at(40));
    const Recording recording = worker.recording().get();
    ASSERT_EQ(recording.events.size(), 6u);  // the speed, the beginning and its four events
    EXPECT_TRUE(std::holds_alternative<event::Begin>(recording.events[1].event));
    Session again(recording.start);
    Replay replay(recording, again);
    while (!replay.is_done()) {
        replay.approach(1000);
        if (!replay.is_due()) continue;
        const auto difference = replay.perform();
        ASSERT_FALSE(difference) << *difference;
    }
    EXPECT_TRUE(replay.compared());
}

}  // namespace
}  // namespace steplab::test
