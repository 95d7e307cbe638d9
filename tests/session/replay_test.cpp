#include "session/replay_test.hpp"

#include "session/random_events.hpp"

#include <gmock/gmock.h>

#include <memory>
#include <random>
#include <string_view>

namespace steplab::test {
namespace {

using testing::HasSubstr;

/// A session in which everything happens that can be recorded.
Recording of_every_kind(const RunDescription& start) {
    Session session(start);
    session.record();
    const auto at = [&](std::uint64_t steps, const Event& event) {
        session.advance(steps);
        session.handle(event);
    };
    at(0, event::Play{true});
    at(20, event::Do{Pull{3, {2.5, 0.25, -0.0}}});
    at(10, event::Do{Kick{4, {0, 0.1, 0.2}}});
    at(7, event::Play{false});
    at(0, event::Step{3});
    at(0, event::Step{-15});
    session.handle(event::Change{with(session.run().description(), "k", 1.25)});
    at(11, event::Do{TurnRound{}});
    session.handle(event::AddRun{with(start, "dt", 0.05)});
    session.handle(event::AddRun{with_method(start, "dopri5")});
    session.handle(event::EqualCost{true});
    at(11, event::Bookmark{"a \"mark\"\nof two lines"});
    at(5, event::Undo{});
    session.handle(event::Redo{});
    at(4, event::ChangeRun{2, with_method(start, "rk4")});
    session.handle(event::SeekTime{1.5});
    session.finish();
    session.handle(event::Do{Kick{2, {0.01, 0, 0}}});
    at(3, event::TakeBranch{0});
    session.handle(event::Seek{30});
    session.finish();
    at(2, event::Lead{1});
    at(9, event::Do{Pull{5, {4.5, 0.5, 0}}});
    at(9, event::RemoveRun{1});
    at(9, event::Restart{});
    at(3, event::Begin{with_method(start, "velocity-verlet")});
    at(4, event::AddRun{start});
    at(2, event::AddRun{with_method(start, "euler")});
    at(2, event::Undo{});
    at(12, event::Change{with_method(start, "rk4")});
    session.advance(5);
    session.finish();
    return *session.recorded();
}

TEST(Replay, every_kind_of_event_has_the_same_hashes) {
    for (const Precision precision : precisions) {
        const Recording recording = of_every_kind(replayed_chain(precision));
        EXPECT_EQ(recording.events.size(), 28u);
        ASSERT_TRUE(recording.end);
        EXPECT_EQ(recording.end->hashes.size(), 2u);
        EXPECT_EQ(replayed_from_text(recording), "the same");
    }
}

TEST(Replay, works_for_every_model) {
    for (const Model& model : models()) {
        Session session(small_run_of(model.info.id, "velocity-verlet", Precision::double_, 0.01));
        session.record();
        session.advance(10);
        session.handle(event::Do{Kick{session.run().particles() - 1, {0, 0.1, 0}}});
        session.advance(10);
        session.handle(event::Change{with(session.run().description(), "dt", 0.005)});
        session.advance(10);
        EXPECT_EQ(replayed_from_text(*session.recorded()), "the same") << model.info.id;
    }
}

TEST(Replay, carries_a_scene_file_and_what_it_reads) {
    Session session(of_scene_file());
    session.record();
    session.advance(20);
    session.handle(event::Change{with(session.run().description(), "G", 1.75)});
    session.advance(20);
    session.handle(event::Change{replayed_chain()});
    session.advance(20);
    session.handle(event::Undo{});
    session.advance(20);
    const Recording recording = *session.recorded();
    EXPECT_EQ(replayed_from_text(recording), "the same");
    const std::string text = session_text(recording);
    EXPECT_EQ(text.find("[[scenes]]"), text.rfind("[[scenes]]")) << "the scene is there once";
    const Recording read = parse_session(text, "a.session");
    EXPECT_EQ(read.start.origin->parts, recording.start.origin->parts);
    EXPECT_EQ(read.start.origin->given, "folder/a.toml");
}

TEST(Replay, carries_the_values_that_a_run_starts_from) {
    RunDescription start = replayed_chain();
    StartingValues values;
    for (int i = 0; i < 10; ++i) {
        values.positions.push_back({1.01 * i, 0.1 * i, 0});
        values.velocities.push_back({0, 0.3, -1e-17});
    }
    values.given = "start.csv:12";
    start.start = {std::make_shared<const StartingValues>(values), true};
    start.scene.set("fixed", 0);
    Session session(start);
    session.record();
    session.advance(30);
    session.handle(event::Restart{});
    session.advance(30);
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

/// As a person and a worker do it: what is gone to is not always reached, and what goes beside the run not always
/// there.
Recording random_session(Precision precision, unsigned seed, int events) {
    Session session(replayed_chain(precision));
    session.record();
    Visitor visitor(seed);
    for (int i = 0; i < events; ++i) {
        std::uint64_t left = visitor.below(40);
        if (session.goal()) left = std::min(left, *session.goal() - std::min(*session.goal(), session.run().step()));
        if (session.playing() || session.goal()) session.advance(left);
        if (visitor.below(2) == 0) {
            std::uint64_t pieces = visitor.below(4);
            session.catch_up([&] { return pieces-- == 0; });
        }
        try {
            session.handle(visitor.any_of_all(session));
        } catch (const UsageError&) {  // of what is not there
        }
    }
    session.finish();
    return *session.recorded();
}

TEST(Replay, five_hundred_random_events_have_the_same_hashes) {
    for (const Precision precision : precisions) {
        for (unsigned seed = 1; seed <= 10; ++seed) {
            const Recording recording = random_session(precision, seed, 500);
            EXPECT_GT(recording.events.size(), 250u);
            EXPECT_EQ(replayed_from_text(recording), "the same") << "seed " << seed;
        }
    }
}

TEST(Replay, says_where_a_changed_number_makes_a_difference) {
    const std::string text = session_text(of_every_kind(replayed_chain()));
    const auto found = [&](const std::string& from, const std::string& to) {
        return replayed(parse_session(replaced(text, from, to), "a.session"));
    };
    EXPECT_THAT(found("position = [2.5, ", "position = [2.5000001, "),
                HasSubstr("event 2 (pull) at step 20: the hash"));
    EXPECT_THAT(found("velocity = [0.0, 0.1, ", "velocity = [0.0, 0.11, "), HasSubstr("event 3 (kick) at step 30: "));
    EXPECT_THAT(found("steps = -15", "steps = -16"), HasSubstr("event 6 (step) at step 40: "));
    EXPECT_THAT(found("dt = 0.1", "dt = 0.2"), HasSubstr("event 2 (pull) at step 20: "));
    EXPECT_THAT(found("do = \"lead\"\nnumber = 1", "do = \"lead\"\nnumber = 3"), HasSubstr("it is refused: "));
}

TEST(Replay, finds_a_run_beside_the_first_that_differs) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::AddRun{with(replayed_chain(), "dt", 0.05)});
    session.advance(40);
    session.finish();
    const std::string text = session_text(*session.recorded());
    const std::string added = text.substr(text.find("add-run"));
    const std::string changed = replaced(text, added, replaced(added, "dt = 0.05", "dt = 0.04"));
    EXPECT_THAT(replayed(parse_session(changed, "a.session")), HasSubstr("the end at step 40: the hash of run 1 is "));
}

TEST(Replay, of_a_run_that_diverged_goes_as_far) {
    Session session(run_of("chain", "rk4", Precision::double_, 2));
    session.record();
    session.handle(event::Play{true});
    session.advance(5000);
    ASSERT_TRUE(session.line().is_over());
    const std::uint64_t last = session.run().step();
    session.handle(event::Step{5});
    session.handle(event::Change{with(session.run().description(), "dt", 0.1)});
    session.advance(50);
    session.handle(event::Seek{last / 2});
    session.finish();
    session.handle(event::Do{Kick{5, {0.1, 0, 0}}});
    session.advance(5000);
    const Recording recording = *session.recorded();
    EXPECT_TRUE(recording.events[1].diverged);
    EXPECT_EQ(recording.events[1].step, last);
    EXPECT_EQ(replayed_from_text(recording), "the same");
    Recording later = recording;
    later.events[1].diverged = false;
    later.events[1].step += 2000;
    EXPECT_THAT(replayed(later), HasSubstr("the run diverged after step"));
}

TEST(Replay, takes_what_is_done_to_a_run_that_diverged) {
    Session session(run_of("chain", "rk4", Precision::double_, 2));
    session.record();
    session.advance(5000);
    ASSERT_TRUE(session.line().is_over());
    const std::uint64_t last = session.run().step();
    for (int i = 0; i < 3; ++i) session.handle(event::Do{Pull{3, {2 + 0.01 * i, 0, 0}}});
    session.handle(event::Change{with(session.run().description(), "dt", 0.1)});
    EXPECT_FALSE(session.run().divergence());
    EXPECT_EQ(session.run().dt(), 0.1);
    session.advance(10);
    EXPECT_EQ(session.run().step(), last + 10);
    const std::string there = session.run().hash();
    session.handle(event::Seek{0});
    session.finish();
    session.handle(event::Seek{last + 10});
    session.finish();
    EXPECT_EQ(session.run().hash(), there);
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

TEST(Replay, knows_how_many_steps_it_takes_forward) {
    Session session(replayed_chain());
    session.record();
    session.advance(40);
    session.handle(event::Seek{0});
    session.handle(event::Bookmark{"here"});
    session.advance(15);
    const Recording recording = *session.recorded();
    Session again(recording.start);
    Replay replay(recording, again);
    EXPECT_EQ(replay.all_steps(), 40u + 15u);
    while (!replay.is_done()) {
        replay.approach(7);
        if (!replay.is_due()) continue;
        EXPECT_EQ(replay.perform(), std::nullopt);
    }
    EXPECT_EQ(replay.steps(), 40u + 15u);
}

// The end is where the run stood, not where it was on its way to.
TEST(Replay, of_a_run_that_was_on_its_way_ends_where_it_was) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::AddRun{with(replayed_chain(), "dt", 0.05)});
    session.handle(event::Seek{1000});
    session.advance(100);
    session.catch_up([] { return false; });
    ASSERT_EQ(session.goal(), 1000u);
    const Recording recording = *session.recorded();
    ASSERT_EQ(recording.end->hashes.size(), 2u);
    EXPECT_EQ(replayed_from_text(recording), "the same");
}

TEST(Replay, misses_a_run_that_was_recorded) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::AddRun{with(replayed_chain(), "dt", 0.05)});
    session.advance(40);
    session.finish();
    Recording recording = *session.recorded();
    recording.end->hashes.push_back(recording.end->hashes.back());
    EXPECT_THAT(replayed(recording), HasSubstr("the end at step 40: there are 2 runs, but 3 were recorded"));
}

// The other run has not caught up: where it stands says nothing.
TEST(Replay, of_runs_that_are_not_together_has_the_hash_of_the_first_alone) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::AddRun{with(replayed_chain(), "dt", 0.05)});
    session.advance(40);
    ASSERT_TRUE(session.is_behind());
    EXPECT_EQ(session.recorded()->end->hashes.size(), 1u);
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

TEST(SessionFile, with_changed_bytes_is_answered) {
    const std::string text = session_text(of_every_kind(replayed_chain()));
    std::mt19937 random(7);
    for (int i = 0; i < 600; ++i) {
        std::string changed = text;
        const std::size_t changes = 1 + random() % 3;
        for (std::size_t k = 0; k < changes; ++k) {
            // as often what a number or a name is made of as any byte
            const bool any = random() % 2 == 0;
            const std::string_view likely = "0123456789.-e\"[]{}=,ab";
            changed[random() % text.size()] =
                any ? static_cast<char>(random() % 256) : likely[random() % likely.size()];
        }
        expect_answer(changed);
    }
}

}  // namespace
}  // namespace steplab::test
