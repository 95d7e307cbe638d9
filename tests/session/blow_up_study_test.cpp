// What it costs to explain why a run diverged: some times the part in which it did, not the run.

#include "lab/limits/blow_up.hpp"
#include "session/session.hpp"
#include "sim/run/linear_limit.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace steplab::test {
namespace {

/// The cause alone: no remedy is tried.
BlowUpStudy studied(const TimeLine& line, bool with_moments) {
    BlowUpStudy study(line.past(), line.run().divergence().value(),
                      with_moments ? line.kept_moments() : std::vector<ReplayedRun::Moment>{});
    study.next();
    return study;
}

void expect_same_cause(const BlowUp& a, const BlowUp& b) {
    EXPECT_EQ(a.step, b.step);
    EXPECT_EQ(a.growth, b.growth);
    EXPECT_EQ(a.limit.step, b.limit.step);
    EXPECT_EQ(a.limit.limit, b.limit.limit);
    EXPECT_EQ(a.share, b.share);
    EXPECT_EQ(a.why, b.why);
}

/// Steps from the last moment kept before its energy was wrong.
std::uint64_t part_that_matters(const TimeLine& line, std::uint64_t good) {
    std::uint64_t last = 0;
    for (const ReplayedRun::Moment& moment : line.kept_moments()) {
        if (moment.snapshot.step() <= good) last = std::max(last, moment.snapshot.step());
    }
    return line.step() - last;
}

// It is gone through to look at the end, to find where it began, for its growth, and for the limit on the way, and to
// stand at the end again: five times, and some steps more.
constexpr std::uint64_t times = 6;

TEST(BlowUpStudy, of_a_long_run_costs_some_times_the_part_in_which_it_blew_up) {
    constexpr std::uint64_t calm = 300'000;
    RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 0.1);
    TimeLine line(run);
    line.advance(calm);
    run.dt = 1.05 * stability_limit(run)->limit;
    line.change(run);
    line.advance(100'000);
    ASSERT_TRUE(line.is_over());
    const BlowUpStudy study = studied(line, true);
    const std::uint64_t part = part_that_matters(line, study.found().step);
    EXPECT_LT(part, calm / 100);
    EXPECT_LT(study.steps(), times * part);
    const BlowUpStudy alone = studied(line, false);
    expect_same_cause(study.found(), alone.found());
    EXPECT_GT(alone.steps(), calm) << "the partner: without moments it is computed once from the start";
    EXPECT_LT(alone.steps(), calm + calm / 8) << "and no second time: it keeps moments on the way";
}

// Energy that is wrong for a long time before the run ends: that is the part that matters.
TEST(BlowUpStudy, of_slow_growth_costs_some_times_the_growth) {
    TimeLine line(run_of("chain", "euler-forward", Precision::double_, 0.002));
    while (!line.is_over()) line.advance(20'000);
    ASSERT_GT(line.step(), 1'000u);
    const BlowUpStudy study = studied(line, true);
    EXPECT_LT(study.steps(), times * part_that_matters(line, study.found().step));
    expect_same_cause(study.found(), studied(line, false).found());
}

// The baseline is that of the last act that did work; what was before it is another energy.
TEST(BlowUpStudy, measures_by_the_energy_after_the_last_act) {
    TimeLine line(run_of("chain", "velocity-verlet", Precision::double_, 0.1));
    line.advance(50'000);
    line.act(Kick{4, {20, 0, 0}});
    line.advance(20'000);
    RunDescription run = line.run().description();
    run.dt = 1.05 * stability_limit(run)->limit;
    line.change(run);
    line.advance(100'000);
    ASSERT_TRUE(line.is_over());
    const BlowUpStudy study = studied(line, true);
    expect_same_cause(study.found(), studied(line, false).found());
    EXPECT_GE(study.found().step, 70'000u);
}

}  // namespace
}  // namespace steplab::test
