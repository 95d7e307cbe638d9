#include "session/replay_test.hpp"

#include <gmock/gmock.h>

#include <cstdint>

namespace steplab::test {
namespace {

using testing::HasSubstr;

std::string refusal_of(const std::string& text) {
    try {
        parse_session(text, "a.session");
        return "read";
    } catch (const FileError& error) {
        return error.what();
    }
}

TEST(Recording, keeps_one_event_of_a_drag) {
    Session session(replayed_chain());
    session.record(0);
    session.advance(100);
    for (int i = 0; i < 50; ++i) session.handle(event::Do{Pull{3, {2 + 0.01 * i, 0, 0}}});
    for (std::uint64_t step = 90; step > 50; --step) session.handle(event::Seek{step});
    const Recording recording = *session.recorded();
    ASSERT_EQ(recording.events.size(), 2u);
    EXPECT_EQ(std::get<event::Seek>(recording.events[1].event).step, 51u);
    EXPECT_EQ(recording.events[0].hash, "") << "no hashes were asked for";
    session.finish();
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

TEST(Recording, keeps_what_was_done_to_a_particle_at_two_steps) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::Do{Pull{3, {2.25, 0, 0}}});
    session.advance(10);
    session.handle(event::Do{Pull{3, {2.5, 0, 0}}});
    session.advance(10);
    EXPECT_EQ(session.recorded()->events.size(), 2u);
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

TEST(Recording, keeps_both_of_two_moments_between_which_it_played) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::Step{100});
    session.handle(event::Play{true});
    for (const std::uint64_t step : {50u, 20u}) {
        session.handle(event::Seek{step});
        session.finish();
        session.advance(10);
    }
    EXPECT_EQ(session.recorded()->events.size(), 4u) << "there was something to see from 50 to 60";
    EXPECT_EQ(replayed_from_text(*session.recorded()), "the same");
}

TEST(Recording, is_bounded) {
    Recording recording{.start = replayed_chain()};
    for (std::size_t i = 0; i < Recording::most_events + 10; ++i) recording.add({event::Step{1}, i}, false);
    EXPECT_EQ(recording.events.size(), Recording::most_events);
    EXPECT_FALSE(recording.complete);
}

// They are part of how it was done, and of no hash.
TEST(SessionFile, holds_that_a_slider_was_held) {
    Session session(replayed_chain());
    session.record();
    const RunDescription start = session.run().description();
    for (int i = 1; i <= 3; ++i) {
        RunDescription changed = start;
        changed.dt = start.dt + 0.01 * i;
        session.handle(event::Change{changed, i > 1});
        session.handle(event::Step{2});
    }
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().description(), start);
    const std::string text = session_text(*session.recorded());
    EXPECT_THAT(text, HasSubstr("held = true\n"));
    EXPECT_EQ(session_text(parse_session(text, "a.session")), text);
    EXPECT_EQ(replayed_from_text(parse_session(text, "a.session")), "the same");
    std::string single = text;
    for (std::size_t at = 0; (at = single.find("held = true\n")) != std::string::npos;) single.erase(at, 12);
    EXPECT_NE(replayed_from_text(parse_session(single, "a.session")), "the same") << "undo takes back one change then";
}

TEST(SessionFile, holds_with_which_runs_a_session_opened) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::AddRun{replayed_chain(), true});
    session.handle(event::AddRun{replayed_chain()});
    session.handle(event::Step{2});
    session.handle(event::Undo{});
    EXPECT_EQ(session.followers().size(), 1u);
    session.handle(event::Undo{});
    EXPECT_EQ(session.followers().size(), 1u) << "that one was there when it opened";
    session.finish();
    const std::string text = session_text(*session.recorded());
    EXPECT_THAT(text, HasSubstr("opening = true\n"));
    EXPECT_EQ(session_text(parse_session(text, "a.session")), text);
    EXPECT_EQ(replayed_from_text(parse_session(text, "a.session")), "the same");
    EXPECT_NE(replayed_from_text(parse_session(replaced(text, "opening = true\n", ""), "a.session")), "the same");
}

TEST(SessionFile, holds_speeds_and_pauses) {
    Session session(replayed_chain());
    session.record();
    session.handle(event::SetRate{{.seconds_per_second = 0.5}});
    session.handle(event::SetRate{{.seconds_per_second = 0.25}});
    session.advance(10);
    session.handle(event::SetRate{{.as_fast_as_possible = true}});
    session.advance(10);
    session.stood_still(1.5);
    session.handle(event::Step{1});
    session.handle(event::Step{1});
    const std::string text = session_text(*session.recorded());
    EXPECT_THAT(text, HasSubstr("steplab-session = 2\n"));
    EXPECT_THAT(text, HasSubstr("step = 0\ndo = \"speed\"\nrate = 0.25\n\n"));
    EXPECT_THAT(text, HasSubstr("step = 10\ndo = \"speed\"\nunlimited = true\n\n"));
    EXPECT_THAT(text, HasSubstr("step = 20\npause = 1.5\ndo = \"step\"\nsteps = 1\nhash"));
    const Recording read = parse_session(text, "a.session");
    ASSERT_EQ(read.events.size(), 4u) << "a slider that is dragged leaves one";
    EXPECT_EQ(read.events[2].pause, 1.5);
    EXPECT_EQ(read.events[3].pause, 0) << "of one event alone";
    EXPECT_EQ(session_text(read), text);
    EXPECT_EQ(replayed_from_text(read), "the same");
    Session played(replayed_chain());
    Replay replay(read, played);
    while (replay.handled() < 1) replay.perform();
    EXPECT_EQ(played.rate().seconds_per_second, 0.25);
    EXPECT_EQ(replay.pause(), 0);
    EXPECT_THAT(refusal_of(replaced(text, "pause = 1.5", "pause = -1.5")), HasSubstr("a pause must be >= 0 s"));
    EXPECT_THAT(refusal_of(replaced(text, "rate = 0.25", "rate = 0.0")), HasSubstr("a rate must be > 0"));
}

TEST(SessionFile, of_version_1_is_read) {
    Session session(replayed_chain());
    session.record();
    session.advance(10);
    session.handle(event::Do{Kick{3, {0.5, 0, 0}}});
    session.advance(10);
    const std::string text = session_text(*session.recorded());
    const Recording old = parse_session(replaced(text, "steplab-session = 2", "steplab-session = 1"), "a.session");
    EXPECT_EQ(session_text(old), text);
    EXPECT_EQ(replayed_from_text(old), "the same");
}

TEST(SessionFile, says_what_is_wrong_and_where) {
    const std::string head =
        "steplab-session = 1\n[start]\nmodel = \"chain\"\nparameters = {}\nmethod = \"rk4\"\n"
        "precision = \"double\"\ndt = 0.1\n";
    EXPECT_EQ(refusal_of(head), "read");
    const auto refuses = [&](const std::string& text, const std::string& message) {
        EXPECT_THAT(refusal_of(text), HasSubstr(message));
    };
    refuses("", "a.session:1:1: a session file begins with its version: steplab-session = 2");
    refuses("steplab-session = 3\n", "a.session:1:19: this program reads versions 1 and 2");
    refuses("steplab-session = 1\n", "needs 'start'");
    refuses(head + "dt = 0.2\n", "a.session:8:");
    refuses(replaced(head, "0.1", "0.0"), "a.session:2:1: dt must be");
    refuses(replaced(head, "0.1", "-0.1"), "a.session:7:6: a session goes forward in time: dt must be > 0");
    refuses(replaced(head, "\"chain\"", "\"chian\""), "a.session:3:9: unknown model 'chian' (did you mean 'chain'?)");
    refuses(replaced(head, "{}", "{ m = 0 }"), "a.session:4:20: ");
    refuses(replaced(head, "{}", "{ fixd = 1 }"), "unknown parameter 'fixd' of chain (did you mean 'fixed'?)");
    refuses(replaced(head, "[start]", "[strat]"), "unknown key 'strat' of a session file (did you mean 'start'?)");
    refuses(head + "[[events]]\nstep = 1\ndo = \"pul\"\n",
            "a.session:10:6: unknown event 'pul' (did you mean 'pull'?)");
    refuses(head + "[[events]]\nstep = 1\ndo = \"pull\"\nparticle = 1\n", "a.session:8:1: 'pull' needs 'position'");
    refuses(head + "[[events]]\nstep = 1\ndo = \"undo\"\nto = 3\n", "a.session:11:1: unknown key 'to' of 'undo'");
    refuses(head + "[[events]]\nstep = -1\ndo = \"undo\"\n", "a.session:9:8: must be an integer >= 0");
    refuses(head + "[[events]]\nstep = 1\ndo = \"undo\"\nhash = \"abc\"\n", "a hash must be 16 hexadecimal digits");
    refuses(head + "[[events]]\nstep = 1\ndo = \"seek-time\"\ntime = nan\n", "must be a finite number");
    refuses(head + "[end]\nhashes = []\n", "[end] needs 'step'");
    refuses(replaced(head, "model = \"chain\"", "scene = 0"), "a.session:3:9: the file has 0 [[scenes]]");
    refuses("[[scenes]]\nname = \"a\"\n[[scenes.files]]\nname = \"\"\ncontent = \"steplab = 1\"\n",
            "begins with its version");
    refuses(
        "steplab-session = 1\n[[scenes]]\nname = \"a\"\n[[scenes.files]]\nname = \"\"\ncontent = \"steplab = 1\"\n" +
            head.substr(20),
        "a:1:1: a scene needs [[particles]]");
}

// A scene that comes with the program may be named without its text; any other may not.
TEST(SessionFile, names_a_shipped_scene_alone) {
    const auto with_scene = [](const std::string& name) {
        return "steplab-session = 1\n[[scenes]]\nname = \"" + name +
               "\"\n[start]\nscene = 0\nparameters = {}\nmethod = \"rk4\"\nprecision = \"double\"\ndt = 0.02\n";
    };
    const Recording recording = parse_session(with_scene("double-well"), "a.session");
    EXPECT_EQ(recording.start.origin, find_scene("double-well"));
    EXPECT_THAT(refusal_of(replaced(with_scene("double-well"), "rk4", "verlet-2008")),
                HasSubstr("a.session:4:1: verlet-2008 cannot run this scene"));
    EXPECT_EQ(refusal_of(with_scene("double-wel")),
              "a.session:2:1: 'double-wel' is no scene that comes with the program: [[scenes.files]] must have it");
}

TEST(SessionFile, has_equal_scenes_of_two_names_and_every_byte_of_their_files) {
    const auto named = [](const std::string& name) {
        const std::string particles = replaced(particles_text, "Step=0", "Step=0 note=\"a\x7f\x01\t\"");
        return describe(
            scene_from({{.name = "", .content = scene_text}, {.name = "a.xyz", .content = particles}}, name));
    };
    Recording recording{.start = named("one.toml")};
    recording.events.push_back({event::Begin{named("other.toml")}});
    const Recording read = parse_session(session_text(recording), "a.session");
    EXPECT_EQ(read.start.origin->parts, recording.start.origin->parts);
    EXPECT_EQ(read.start.origin->given, "one.toml");
    EXPECT_EQ(std::get<event::Begin>(read.events[0].event).description.origin->given, "other.toml");
}

TEST(SessionFile, truncated_anywhere_is_answered) {
    Session session(of_scene_file());
    session.record();
    session.advance(5);
    session.handle(event::Do{Pull{1, {1, 0.5, 0}}});
    session.handle(event::AddRun{with_method(of_scene_file(), "rk4")});
    session.advance(5);
    session.finish();
    const std::string text = session_text(*session.recorded());
    for (std::size_t size = 0; size < text.size(); ++size) expect_answer(text.substr(0, size));
}

}  // namespace
}  // namespace steplab::test
