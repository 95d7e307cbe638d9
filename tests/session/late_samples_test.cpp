#include "session/late_samples.hpp"

#include "core/error.hpp"
#include "session/random_events.hpp"
#include "session/session_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using Rows = std::vector<Sample>;

/// Those of every run, the leading one first.
std::vector<Rows> samples_in(const SessionView& view) {
    std::vector<Rows> rows{view.leading.series.samples};
    for (const RunView& run : view.followers) rows.push_back(run.series.samples);
    return rows;
}

std::vector<Rows> samples_of(const Session& session) {
    SessionView view;
    session.observe(view);
    return samples_in(view);
}

void complete(Session& session) {
    session.finish();
    while (session.lacks_samples()) session.complete_samples([] { return false; });
}

void expect_same(const std::vector<Rows>& a, const std::vector<Rows>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t run = 0; run < a.size(); ++run) {
        SCOPED_TRACE("run " + std::to_string(run));
        ASSERT_EQ(a[run].size(), b[run].size());
        for (std::size_t i = 0; i < a[run].size(); ++i) {
            ASSERT_EQ(a[run][i].step, b[run][i].step);
            EXPECT_EQ(a[run][i].time, b[run][i].time);
            EXPECT_EQ(a[run][i].energy_error, b[run][i].energy_error);
            ASSERT_EQ(a[run][i].particle() != nullptr, b[run][i].particle() != nullptr);
            if (a[run][i].particle()) {
                EXPECT_EQ(a[run][i].particle()->displacement, b[run][i].particle()->displacement);
            }
        }
    }
}

/// What cannot be done is refused.
void attempt(Session& session, const Event& event) {
    try {
        session.handle(event);
    } catch (const UsageError&) {
    }
    session.finish();
}

/// Without those of runs beside the leading one that went on before it was found to have diverged.
std::vector<Rows> samples_reached(const Session& session) {
    auto rows = samples_of(session);
    const double end = session.line().reached_time();
    for (Rows& run : rows) std::erase_if(run, [end](const Sample& sample) { return sample.time > end + 1e-6; });
    return rows;
}

/// A session of three runs in which something was done: another dt, a kick.
class Late : public ::testing::TestWithParam<Precision> {
protected:
    static Session begun(std::optional<std::size_t> tracked, bool sampled) {
        Session session(chain("rk4", GetParam()));
        session.handle(event::Track{tracked});
        session.handle(event::ShowSamples{sampled});
        session.handle(event::AddRun{with(chain("verlet", GetParam()), "dt", 0.03)});
        session.handle(event::AddRun{chain("dopri5", GetParam())});
        return session;
    }
    /// The last of its runs beside the leading one has diverged.
    static Session with_diverged() {
        Session session = begun(1, true);
        session.handle(event::AddRun{with(chain("verlet", GetParam()), "dt", 3)});
        session.handle(event::Step{3000});
        complete(session);
        return session;
    }
    static void play(Session& session, std::int64_t steps = 12000) {
        session.handle(event::Step{300});
        session.handle(event::Change{with(session.run().description(), "dt", 0.05)});
        session.handle(event::Step{200});
        session.handle(event::Do{Kick{2, {0, 1, 0}}});
        session.handle(event::Step{steps});
        complete(session);
    }
};

TEST_P(Late, samples_of_another_particle_are_those_that_it_has_when_it_is_followed_from_the_start) {
    Session session = begun(1, true), always = begun(3, true);
    for (Session* const each : {&session, &always}) play(*each);
    const std::string before = session.run().hash();
    session.handle(event::Track{3});
    EXPECT_FALSE(samples_of(session)[0].front().particle()) << "they are not known yet";
    complete(session);
    expect_same(samples_of(session), samples_of(always));
    EXPECT_EQ(session.run().hash(), before) << "the run stands where it was";
}

TEST_P(Late, samples_of_before_plots_were_shown_are_those_of_a_session_that_always_showed_them) {
    Session session = begun(2, false), always = begun(2, true);
    for (Session* const each : {&session, &always}) play(*each);
    session.handle(event::ShowSamples{true});
    complete(session);
    expect_same(samples_of(session), samples_of(always));
    Session alone(chain("rk4", GetParam()));
    alone.handle(event::Step{10});
    alone.handle(event::ShowSamples{true});
    EXPECT_TRUE(alone.complete_samples([] { return false; })) << "they are to be shown";
    EXPECT_FALSE(alone.complete_samples([] { return false; }));
}

TEST_P(Late, samples_are_taken_piece_by_piece_while_the_session_goes_on) {
    Session session = begun(1, true), always = begun(3, true);
    for (Session* const each : {&session, &always}) play(*each);
    session.handle(event::Track{3});
    int pieces = 0;
    for (; session.lacks_samples(); ++pieces) {
        session.complete_samples([asked = 0]() mutable { return ++asked > 3; });
        for (Session* const each : {&session, &always}) {
            each->advance(5);
            each->finish();
        }
    }
    EXPECT_GT(pieces, 3);
    expect_same(samples_of(session), samples_of(always));
}

TEST_P(Late, runs_beside_have_samples_as_far_as_the_leading_run_when_a_change_is_done_again) {
    Session session = begun(1, true);
    play(session);
    const auto whole = samples_of(session);
    session.handle(event::Undo{});
    complete(session);
    EXPECT_LT(samples_of(session)[1].size(), whole[1].size() / 2);
    session.handle(event::Redo{});
    session.finish();
    EXPECT_TRUE(session.complete_samples([] { return false; })) << "there is something to show";
    expect_same(samples_of(session), whole);
}

TEST_P(Late, runs_beside_keep_their_samples_where_the_session_goes_back_before_a_change) {
    Session session = begun(1, true);
    session.handle(event::AddRun{with(chain("verlet", GetParam()), "dt", 0.7)});
    play(session);
    const auto whole = samples_of(session);
    for (const std::uint64_t step : {100u, 499u, 400u, 299u}) {  // 499: the long step before the kick has begun
        go_to(session, step);
        complete(session);
        expect_same(samples_of(session), whole);
    }
}

// The way that is gone over to has other kicks than what was known of the one before.
TEST_P(Late, samples_of_a_way_that_is_taken_again_are_its_own) {
    Session session = begun(1, true);
    play(session, 2000);
    go_to(session, 350);
    session.handle(event::Change{with(session.run().description(), "dt", 0.04)});  // nothing to runs beside it
    session.handle(event::Step{600});
    session.handle(event::Do{Kick{4, {0, 0.5, 0}}});
    session.handle(event::Step{3000});
    complete(session);
    for (int i = 0; i < 2; ++i) {
        session.handle(event::TakeBranch{0});
        complete(session);
        const auto known = samples_of(session);
        session.handle(event::Track{2});
        session.handle(event::Track{1});
        complete(session);
        expect_same(samples_of(session), known);
    }
}

// Beyond it, too, where the run beside takes the change once more.
TEST_P(Late, runs_beside_keep_their_samples_where_a_change_is_stepped_over) {
    Session session = begun(1, true);
    session.handle(event::AddRun{with(chain("verlet", GetParam()), "dt", 0.3)});
    session.handle(event::Step{301});
    session.handle(event::Do{Kick{2, {0, 1, 0}}});
    session.handle(event::Step{1000});
    complete(session);
    const auto whole = samples_of(session);
    go_to(session, 300);
    complete(session);
    session.handle(event::Step{3});
    complete(session);
    expect_same(samples_of(session), whole);
    go_to(session, 300);
    complete(session);
    session.handle(event::Play{true});
    session.advance(5);
    complete(session);
    expect_same(samples_of(session), whole);
}

// A branch that is taken again told of the particle that was followed when it was left.
TEST_P(Late, samples_of_a_branch_tell_of_the_particle_that_is_followed_now) {
    Session session = begun(1, true), always = begun(2, true);
    for (Session* const each : {&session, &always}) play(*each, 1000);
    session.handle(event::Undo{});
    session.handle(event::Track{2});
    session.handle(event::Redo{});
    complete(session);
    expect_same(samples_of(session), samples_of(always));
}

// As far as it is stopped in the middle.
TEST_P(Late, samples_in_pieces_of_a_run_that_diverges_have_no_impossible_energies) {
    Session session = with_diverged();
    const auto whole = samples_of(session);
    session.handle(event::Track{0});
    complete(session);
    session.handle(event::Track{1});
    while (session.lacks_samples()) {
        session.complete_samples([] { return true; });
        ASSERT_LE(samples_of(session).back().size(), whole.back().size());
    }
    expect_same(samples_of(session), whole);
}

// Many changes take long to compare; each piece gets on all the same.
TEST_P(Late, samples_come_also_where_there_is_never_time) {
    Session session = begun(1, true);
    for (int i = 0; i < 300; ++i) {
        session.handle(event::Do{Kick{2, {0, 0.001 * i, 0}}});
        session.handle(event::Step{1});
    }
    session.handle(event::Track{3});
    for (int pieces = 0; session.lacks_samples(); ++pieces) {
        ASSERT_LT(pieces, 5000);
        session.complete_samples([] { return true; });
    }
    EXPECT_TRUE(samples_of(session)[1].front().particle());
}

// What runs beside would have done on a way that was left is not shown on the new one.
TEST_P(Late, samples_of_the_way_ahead_are_forgotten_where_another_way_is_taken) {
    for (const bool again : {false, true}) {
        Session session = begun(1, true), fresh = begun(1, true);
        play(session, 2000);  // so few that every step has a sample
        if (again) {
            session.handle(event::Undo{});
            session.handle(event::Redo{});
        }
        complete(session);
        go_to(session, 100);
        for (Session* const each : {&session, &fresh}) {
            if (each == &fresh) go_to(fresh, 100);
            each->handle(event::Change{with(each->run().description(), "dt", 0.02)});
            each->handle(event::Step{1000});
            complete(*each);
        }
        expect_same(samples_of(session), samples_of(fresh));
    }
}

// A view that had them is told the new ones, however many there are.
TEST_P(Late, samples_of_the_way_ahead_do_not_stay_in_a_view_of_another_way) {
    Session session = begun(1, true);
    SessionView kept;
    session.handle(event::Step{300});
    session.handle(event::Do{Kick{2, {0, 1, 0}}});
    session.handle(event::Step{200});
    session.handle(event::Undo{});
    session.handle(event::Redo{});
    complete(session);
    session.observe(kept);
    session.handle(event::Do{Kick{3, {0, 1, 0}}});
    session.handle(event::Step{1000});
    complete(session);
    session.observe(kept);
    expect_same(samples_in(kept), samples_of(session));
}

TEST_P(Late, samples_of_a_run_that_diverges_end_where_it_does) {
    Session session = with_diverged();
    const auto whole = samples_of(session);
    ASSERT_TRUE(session.followers().back().run().divergence());
    session.handle(event::Track{0});
    complete(session);
    session.handle(event::Track{1});
    complete(session);
    expect_same(samples_of(session), whole);
}

// However the session came to stand where it does, what is known of its runs is what they would be found to do again.
TEST_P(Late, samples_are_the_same_again_after_any_events) {
    Session session = begun(1, true);
    SessionView kept;  // only what is new is copied into it
    Visitor visitor(5);
    for (int i = 0; i < 600; ++i) {
        attempt(session, i % 2 == 0 ? visitor.any(session) : visitor.any_of_all(session));
        session.observe(kept);
        expect_same(samples_in(kept), samples_of(session));
        if (i % 5 != 0) continue;
        SCOPED_TRACE("event " + std::to_string(i));
        complete(session);
        const auto known = samples_reached(session);
        session.handle(event::Track{2});
        complete(session);
        session.handle(event::Track{1});
        complete(session);
        expect_same(samples_reached(session), known);
        if (HasFailure()) return;
    }
}

INSTANTIATE_TEST_SUITE_P(Precisions, Late, ::testing::ValuesIn(precisions), [](const auto& info) {
    return info.param == Precision::double_ ? std::string("double") : std::string("float");
});

}  // namespace
}  // namespace steplab::test
