#include "lab/study/reference_motion.hpp"
#include "session/replay_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace steplab::test {
namespace {

constexpr auto never_enough = [] { return false; };

void step_on_to(Session& session, std::uint64_t step) {
    session.handle(event::Seek{step});
    session.finish();
}

RunDescription altered(const Session& session, const std::vector<Alteration>& alterations) {
    return with_alterations(session.run().description(), alterations);
}

using Hashes = std::map<std::uint64_t, std::string>;

/// Takes steps one by one and notes the hash of each.
void play(Session& session, Hashes& hashes, int steps) {
    for (int i = 0; i < steps; ++i) {
        session.advance(1);
        session.keep_moment();
        session.catch_up(never_enough);
        hashes[session.run().step()] = session.run().hash();
    }
}

/// What is done at a step is seen there.
void handle(Session& session, Hashes& hashes, const Event& event) {
    session.handle(event);
    hashes[session.run().step()] = session.run().hash();
}

/// Two particles that are not fixed, the first one being the last of the scene.
std::pair<std::size_t, std::size_t> moving_ones(const Session& session) {
    std::vector<std::size_t> found;
    const auto shape = session.run().shape();
    for (std::size_t i = shape->roles.size(); i-- > 0 && found.size() < 2;) {
        if (shape->roles[i] != Role::fixed) found.push_back(i);
    }
    return {found.front(), found.back()};
}

/// Holds a particle for some frames, of three steps each.
void hold(Session& session, Hashes& hashes, std::size_t particle, const ParticleList& others, int frames = 12) {
    for (int i = 0; i < frames; ++i) {
        handle(session, hashes, event::Do{Tug{particle, {0.3 * i, 0.5, 0.1 * i}, 4, i > 0, others}});
        play(session, hashes, 3);
    }
}

/// All that a hand does to a scene while it plays, from its step on.
void use_hands(Session& session, Hashes& hashes) {
    const auto [one, two] = moving_ones(session);
    session.handle(event::Play{});
    play(session, hashes, 10);
    hold(session, hashes, one, {});
    handle(session, hashes, event::Change{altered(session, {{one, std::nullopt, 3.0}, {two, std::nullopt, 0.5}})});
    play(session, hashes, 10);
    handle(session, hashes, event::Do{Kick{one, {0.2, 0.1, 0}, ParticleList({two})}});
    play(session, hashes, 10);
    handle(session, hashes, event::Change{altered(session, {{one, true}})});
    play(session, hashes, 10);
    hold(session, hashes, two, ParticleList({one}));
    handle(session, hashes, event::Change{altered(session, {{one, false}})});
    handle(session, hashes, event::Do{Pull{one, {1, 1, 0.5}, ParticleList({two})}});
    play(session, hashes, 10);
}

/// Models and a scene of files, in both precisions.
std::vector<RunDescription> scenes() {
    std::vector<RunDescription> all;
    for (const Precision precision : precisions) {
        for (const char* model : {"chain", "mesh", "rope", "morse", "crystal", "free"})
            all.push_back(small_run_of(model, "velocity-verlet", precision, 0.01));
        RunDescription of_file = with_method(of_scene_file(), "velocity-verlet");
        of_file.precision = precision;
        of_file.dt = 0.01;
        all.push_back(of_file);
    }
    return all;
}

TEST(Hands, every_moment_of_what_they_did_is_gone_to_with_the_same_bits) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        Hashes hashes;
        use_hands(session, hashes);
        ASSERT_EQ(hashes.size(), session.run().step());
        for (auto moment = hashes.rbegin(); moment != hashes.rend(); ++moment) {
            step_on_to(session, moment->first);
            ASSERT_EQ(session.run().hash(), moment->second) << scene.model << ", step " << moment->first;
        }
        for (std::uint64_t step = 1; step < hashes.size(); step += 7) {
            step_on_to(session, step);
            ASSERT_EQ(session.run().hash(), hashes.at(step)) << scene.model << ", step " << step;
        }
    }
}

TEST(Hands, a_session_file_has_all_that_they_did) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        session.record();
        session.handle(event::AddRun{with_method(scene, "rk4")});
        Hashes hashes;
        use_hands(session, hashes);
        session.handle(event::Undo{});
        session.handle(event::Undo{});
        session.handle(event::Redo{});
        play(session, hashes, 5);
        session.finish();
        const Recording recording = *session.recorded();
        EXPECT_EQ(replayed_from_text(recording), "the same") << scene.model;
        const std::string text = session_text(recording);
        EXPECT_NE(replayed(parse_session(replaced(text, "rate = 4.0", "rate = 4.5"), "a.session")), "the same");
        if (scene.model == "free") continue;  // no force acts there
        EXPECT_NE(replayed(parse_session(replaced(text, "mass = 3.0", "mass = 3.5"), "a.session")), "the same");
    }
}

// Which way the session was taken makes no difference to a run that is made beside it later.
TEST(Hands, runs_beside_the_leading_one_follow) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        RunDescription beside = scene;
        beside.dt = 0.007;
        session.handle(event::AddRun{beside});
        session.handle(event::AddRun{scene});
        Hashes hashes;
        use_hands(session, hashes);
        session.finish();
        EXPECT_EQ(session.followers()[1].run().hash(), session.run().hash()) << "the same run: " << scene.model;
        FollowerRun fresh(beside, TimeLine::usual_bytes);
        fresh.follow(session.line(), never_enough);
        EXPECT_EQ(session.followers()[0].run().hash(), fresh.run().hash()) << scene.model;
        EXPECT_EQ(session.followers()[0].run().description().alterations, session.run().description().alterations);
        Simulation alone(beside);
        alone.advance(fresh.run().step());
        EXPECT_NE(fresh.run().hash(), alone.hash()) << "what was done to it";
    }
}

TEST(Hands, a_run_that_is_added_later_is_the_same_from_the_start) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        Hashes hashes;
        use_hands(session, hashes);
        RunDescription changed = session.run().description();
        if (changed.scene.contains("k")) changed.scene.set("k", 1.5 * changed.scene["k"]);
        session.handle(event::Change{changed});
        play(session, hashes, 5);
        session.handle(event::AddRun{session.run().description()});
        session.finish();
        EXPECT_EQ(session.followers()[0].run().hash(), session.run().hash()) << scene.model;
    }
}

TEST(Hands, a_waiting_tug_is_overtaken_by_the_next_of_its_hold) {
    const auto tug = [](bool goes_on) { return event::Do{Tug{1, {0, 0, 0}, 2, goes_on}}; };
    EXPECT_TRUE(overtakes(tug(true), tug(true)));
    EXPECT_FALSE(overtakes(tug(false), tug(true))) << "it began the hold";
    EXPECT_FALSE(overtakes(tug(true), tug(false))) << "another hold";
    EXPECT_FALSE(overtakes(event::Do{Kick{1, {1, 0, 0}}}, tug(true)));
    EXPECT_TRUE(overtakes(event::Do{Pull{1, {1, 0, 0}}}, event::Do{Pull{1, {2, 0, 0}}}));
    EXPECT_FALSE(overtakes(event::Do{Pull{1, {1, 0, 0}, ParticleList({2})}}, event::Do{Pull{1, {2, 0, 0}}}));
}

// Drawn to a place, runs of other steps come to the same one.
TEST(Hands, a_hold_takes_all_runs_to_one_place) {
    const RunDescription scene = run_of("free", "velocity-verlet", Precision::double_, 0.01);
    RunDescription coarse = scene;
    coarse.dt = 0.035;
    Session session(scene);
    session.handle(event::AddRun{coarse});
    session.handle(event::Play{});
    for (int i = 0; i < 200; ++i) {
        session.handle(event::Do{Tug{0, {2, 1, 0}, 4, i > 0}});
        session.advance(5);
        session.catch_up(never_enough);
    }
    EXPECT_LT(length(session.run().frame().positions[0] - Vec3{2, 1, 0}), 0.05);
    EXPECT_LT(length(session.followers()[0].run().frame().positions[0] - Vec3{2, 1, 0}), 0.05);
}

TEST(Hands, one_undo_takes_back_a_whole_hold) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        const auto [one, two] = moving_ones(session);
        Hashes before, held, later;
        session.handle(event::Play{});
        play(session, before, 20);
        hold(session, held, one, {});
        const std::uint64_t end = session.run().step();
        hold(session, later, one, ParticleList({two}), 5);
        const std::uint64_t second = session.run().step();
        session.handle(event::Undo{});
        EXPECT_EQ(session.run().step(), end) << "the second of two holds";
        EXPECT_EQ(session.run().hash(), held.at(end));
        session.handle(event::Undo{});
        EXPECT_EQ(session.run().step(), 20u);
        EXPECT_EQ(session.run().hash(), before.at(20));
        EXPECT_EQ(session.line().changes().size(), 1u);
        session.handle(event::Redo{});
        step_on_to(session, end);
        EXPECT_EQ(session.run().hash(), held.at(end)) << scene.model;
        session.handle(event::Redo{});
        step_on_to(session, second);
        EXPECT_EQ(session.run().hash(), later.at(second)) << scene.model;
        SessionView view;
        session.observe(view);
        EXPECT_EQ(view.line.changes.size(), 2u) << "one mark for each hold";
    }
}

TEST(Hands, each_alteration_is_undone_and_done_again) {
    for (const RunDescription& scene : scenes()) {
        Session session(scene);
        session.handle(event::Step{20});
        const auto [one, two] = moving_ones(session);
        const std::string plain = session.run().hash();
        session.handle(event::Change{altered(session, {{one, true}})});
        const std::string fixed = session.run().hash();
        session.handle(event::Change{altered(session, {{two, true}})});
        EXPECT_EQ(session.line().changes().size(), 3u) << "of another particle: another change";
        session.handle(event::Undo{});
        EXPECT_EQ(session.run().hash(), fixed) << scene.model;
        EXPECT_EQ(session.run().shape()->roles[one], Role::fixed);
        session.handle(event::Undo{});
        EXPECT_EQ(session.run().hash(), plain) << scene.model;
        EXPECT_TRUE(session.run().description().alterations.empty());
        EXPECT_NE(session.run().shape()->roles[one], Role::fixed);
        session.handle(event::Redo{});
        EXPECT_EQ(session.run().hash(), fixed) << scene.model;
        session.handle(event::Restart{});
        EXPECT_EQ(session.run().shape()->roles[one], Role::fixed) << "what was altered stays for the next run";
        session.handle(event::Undo{});
        EXPECT_EQ(session.run().step(), 20u) << "no run is lost";
    }
}

TEST(Hands, a_dragged_mass_leaves_one_change) {
    Session session(replayed_chain());
    session.handle(event::Step{20});
    for (int i = 1; i < 30; ++i) session.handle(event::Change{altered(session, {{5, std::nullopt, 0.1 * i}})});
    EXPECT_EQ(session.line().changes().size(), 2u);
    SessionView view;
    session.observe(view);
    EXPECT_EQ(view.line.changes[0].text, "mass 2.9000000000000004 kg of particle 5");
    session.handle(event::Undo{});
    EXPECT_TRUE(session.run().description().alterations.empty());
}

TEST(Hands, a_tug_without_time_in_between_does_nothing) {
    Session session(replayed_chain());
    session.handle(event::Step{20});
    session.handle(event::Do{Tug{5, {9, 1, 0}, 4}});
    const std::string tugged = session.run().hash();
    session.handle(event::Do{Tug{5, {9, 2, 0}, 4, true}});
    EXPECT_EQ(session.run().hash(), tugged);
    EXPECT_EQ(session.line().changes().size(), 2u);
    session.handle(event::Do{Tug{0, {9, 2, 0}, 4}});
    EXPECT_EQ(session.line().changes().size(), 2u) << "particle 0 is fixed";
}

TEST(Hands, a_hold_is_over_where_something_else_was_done) {
    Session session(replayed_chain());
    session.handle(event::Do{Tug{5, {9, 1, 0}, 4}});
    session.handle(event::Step{20});
    session.handle(event::Do{Kick{3, {0.1, 0, 0}}});
    session.handle(event::Step{20});
    session.handle(event::Do{Tug{5, {9, 1, 0}, 4, true}});
    const Tug tug = std::get<Tug>(session.line().past().back().act.value());
    EXPECT_FALSE(tug.goes_on);
    EXPECT_EQ(tug.duration, session.run().dt()) << "not the 20 steps since the kick";
}

TEST(Hands, long_holds_keep_their_history_within_bounds) {
    Session session(replayed_chain());
    session.handle(event::Play{});
    for (int i = 0; i < 6000; ++i) {
        session.handle(event::Do{Tug{5, {9, 1, 0}, 4, i > 0}});
        session.advance(2);
        session.keep_moment();
    }
    const std::string end = session.run().hash();
    step_on_to(session, 5000);
    step_on_to(session, 12000);
    EXPECT_EQ(session.run().hash(), end);
    EXPECT_LT(session.line().bytes(), std::size_t{4} << 20);
    session.handle(event::Undo{});
    EXPECT_EQ(session.run().step(), 0u);
}

TEST(Hands, the_reference_of_altered_runs_is_that_of_the_altered_scene) {
    Session session(run_of("chain", "rk4", Precision::double_, 0.001));
    Hashes hashes;
    use_hands(session, hashes);
    ReferenceMotion reference(session.line().changes().front().description);
    reference.follow(session.line().past());
    const ReferenceMoment moment = reference.at(session.run().time());
    double largest = 0;
    const State<double>& state = session.run().state();
    for (std::size_t i = 0; i < session.run().particles(); ++i)
        largest = std::max(largest, length(state.displacement.at(i) - moment.state.displacement.at(i)));
    EXPECT_LT(largest, 1e-9);
    EXPECT_LT(moment.error, 1e-12);
    EXPECT_FALSE(reference.is_exact());
    std::vector<SegmentBegin> without(session.line().past().begin(), session.line().past().end());
    without.erase(without.begin() + 3);  // one tug is missing
    reference.follow(without);
    const ReferenceMoment other = reference.at(session.run().time());
    EXPECT_GT(length(state.displacement.at(9) - other.state.displacement.at(9)), 1e-7);
}

}  // namespace
}  // namespace steplab::test
