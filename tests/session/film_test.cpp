#include "session/replay.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <string>

namespace steplab::test {
namespace {

RunDescription filmed_chain() { return run_of("chain", "verlet", Precision::double_, 0.1); }

/// Pulls, a change and a way back, with steps between them.
Recording recorded() {
    Session session(filmed_chain());
    session.record();
    session.handle(event::Play{true});
    session.advance(30);
    session.handle(event::Do{Pull{3, {2.5, 0.25, 0}}});
    session.handle(event::Do{Kick{4, {0, 0.5, 0}}});
    session.advance(30);
    session.handle(event::Seek{20});
    session.finish();
    session.handle(event::Step{5});
    RunDescription other = session.run().description();
    other.dt = 0.05;
    session.handle(event::Change{other});
    session.advance(40);
    session.handle(event::Play{false});
    return *session.recorded();
}

class FilmTest : public testing::Test {
protected:
    FilmTest() {
        worker.on_view(News::wake);
        worker.send(event::SetRate{{.as_fast_as_possible = true}});
    }
    template <class Condition>
    bool see(Condition condition) {
        while (true) {
            while (worker.take(session)) {
                if (condition(session)) return true;
            }
            if (!News::wait()) return false;
        }
    }

    Worker worker{recorded()};
    SessionView session;
};

TEST_F(FilmTest, plays_to_the_end_and_stands_there) {
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const SessionView& now) { return !now.leading.playing && now.leading.frame.step == 65; }));
    EXPECT_EQ(session.leading.error, "");
    EXPECT_EQ(session.leading.dt, 0.05);
    EXPECT_EQ(session.line.branches.size(), 1u);
    const Recording again = worker.recording().get();
    ASSERT_TRUE(again.end);
    EXPECT_EQ(again.end->hashes, recorded().end->hashes);
}

TEST_F(FilmTest, tells_how_far_it_is_until_it_ends_or_something_else_is_done) {
    EXPECT_TRUE(see([](const SessionView& now) { return now.film == FilmView{0}; }));
    worker.send(event::Play{true});
    EXPECT_TRUE(see([](const SessionView& now) { return now.film && now.film->done > 0.5; }));
    EXPECT_TRUE(see([](const SessionView& now) { return !now.film && now.leading.frame.step == 65; }));
    worker.begin(recorded());
    EXPECT_TRUE(see([](const SessionView& now) { return now.film.has_value(); }));
    worker.send(event::Step{1});
    EXPECT_TRUE(see([](const SessionView& now) { return !now.film && now.leading.frame.step == 1; }));
}

/// Two steps, with a pause of so many seconds before the second one.
Recording recorded_with_pause(double seconds) {
    Session session(filmed_chain());
    session.record();
    session.handle(event::SetRate{{.seconds_per_second = 2}});
    session.handle(event::Step{1});
    session.stood_still(seconds);
    session.handle(event::Step{1});
    return *session.recorded();
}

// A film cannot be faster than its pauses; how much longer it takes is a matter of the machine.
TEST(Film, has_the_pauses_and_speeds_of_the_session) {
    constexpr std::chrono::duration<double> pause{0.3};
    Worker worker{recorded_with_pause(pause.count())};
    worker.on_view(News::wake);
    const auto begin = std::chrono::steady_clock::now();
    worker.send(event::Play{true});
    SessionView session;
    bool first = false;
    while (!(worker.take(session) && session.leading.frame.step == 2)) {
        first = first || (session.leading.frame.step == 1 && session.leading.rate.seconds_per_second == 2);
        ASSERT_TRUE(News::wait());
    }
    EXPECT_TRUE(first) << "the step before the pause is seen, at the speed of then";
    EXPECT_GE(std::chrono::steady_clock::now() - begin, pause);
    const Recording again = worker.recording().get();
    ASSERT_EQ(again.events.size(), 4u) << "the play that began the film, too";
    EXPECT_EQ(again.events[3].pause, pause.count());
}

TEST_F(FilmTest, pauses_and_ends_where_something_else_is_done) {
    worker.send(event::Play{false});
    ASSERT_TRUE(see([](const SessionView& now) { return !now.leading.playing; }));
    EXPECT_EQ(session.leading.frame.step, 0u);
    worker.send(event::Do{TurnRound{}});
    worker.send(event::Step{100});
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.frame.step > 150; }));
    EXPECT_EQ(session.line.changes.size(), 1u) << "no pull came";
}

TEST_F(FilmTest, ends_where_it_is_played_backwards) {
    worker.send(event::Play{true, true});
    worker.send(event::Magnify{2});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.frame.magnified == 2; }));
    worker.send(event::Play{true});
    ASSERT_TRUE(see([](const SessionView& now) { return now.leading.frame.step > 150; }));
    EXPECT_TRUE(session.line.changes.empty()) << "no pull came";
}

TEST(Film, of_another_run_says_so) {
    Recording other = recorded();
    other.start.scene.set("k", 1.5);
    Worker worker(other);
    worker.on_view(News::wake);
    worker.send(event::SetRate{{.as_fast_as_possible = true}});
    worker.send(event::Play{true});
    SessionView session;
    const auto failed = [&] { return worker.take(session) && session.leading.failures > 0; };
    while (!failed()) ASSERT_TRUE(News::wait());
    EXPECT_NE(session.leading.error.find("event 2 (pull) at step 30"), std::string::npos) << session.leading.error;
    EXPECT_FALSE(session.leading.playing);
}

TEST(Film, of_a_run_that_diverges_goes_on) {
    Session session(run_of("chain", "rk4", Precision::double_, 2));
    session.record();
    session.advance(5000);
    ASSERT_TRUE(session.line().is_over());
    RunDescription shorter = session.run().description();
    shorter.dt = 0.1;
    session.handle(event::Change{shorter});
    session.advance(20);
    const Recording film = *session.recorded();
    Worker worker(film);
    worker.on_view(News::wake);
    worker.send(event::SetRate{{.as_fast_as_possible = true}});
    worker.send(event::Play{true});
    SessionView view;
    const auto ended = [&] { return worker.take(view) && view.leading.frame.step == film.end->step; };
    while (!ended()) ASSERT_TRUE(News::wait());
    EXPECT_EQ(view.leading.error, "");
}

TEST(Worker, records_what_happens_to_its_session) {
    Worker worker(filmed_chain());
    worker.on_view(News::wake);
    worker.send(event::Do{Pull{3, {2.5, 0.25, 0}}});
    worker.send(event::Step{20});
    const Recording recording = worker.recording().get();
    EXPECT_EQ(recording.start, filmed_chain());
    Session session(recording.start);
    Replay replay(recording, session);
    while (!replay.is_done()) {
        replay.approach(10);
        if (!replay.is_due()) continue;
        EXPECT_EQ(replay.perform(), std::nullopt);
    }
}

TEST(Worker, hands_out_its_recording_when_it_is_destroyed_in_a_long_step) {
    auto worker = std::make_unique<Worker>(filmed_chain());
    worker->send(event::Do{Pull{3, {2.5, 0.25, 0}}});
    worker->send(event::Step{1'000'000'000'000});
    std::future<Recording> recording = worker->recording();
    worker.reset();
    EXPECT_LE(recording.get().events.size(), 1u);
}

}  // namespace
}  // namespace steplab::test
