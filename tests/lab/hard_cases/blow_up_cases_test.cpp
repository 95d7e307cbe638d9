// What is said of the hard cases in which methods diverge, and what was tried against it.

#include "core/error.hpp"
#include "lab/hard_cases/hard_case.hpp"
#include "lab/limits/blow_up.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

std::string name_of(const testing::TestParamInfo<HardCase>& info) {
    std::string name(info.param.id);
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

std::vector<HardCase> diverging_cases() {
    std::vector<HardCase> all = hard_cases();
    std::erase_if(all, [](const HardCase& each) { return each.diverging == nullptr; });
    return all;
}

class BlowUpCase : public testing::TestWithParam<HardCase> {};

bool can_run(const Trial& trial, const Method& method) {
    try {
        check(trial.with(method.info.id).description());
        return true;
    } catch (const UsageError&) {
        return false;
    }
}

BlowUp studied(const Simulation& run) {
    const std::vector<SegmentBegin> changes{{0, run.description()}};
    BlowUpStudy study(changes, *run.divergence());
    while (study.next()) {
    }
    return study.found();
}

/// A remedy that is said to work does: the run does not diverge within its trial, here from the start.
void expect_to_work(const TriedRemedy& tried) {
    if (tried.from > 0) return;
    Simulation run(tried.run);
    run.advance(static_cast<std::uint64_t>(tried.until / std::abs(tried.run.dt)));
    EXPECT_FALSE(run.divergence()) << tried.run.method << " with dt = " << tried.run.dt;
}

void expect_explained(const BlowUp& found) {
    EXPECT_TRUE(found.complete);
    EXPECT_LE(found.step, found.divergence.step);
    if (found.divergence.stop) {
        EXPECT_TRUE(found.why.empty()) << "the message of the method says all";
        return;
    }
    EXPECT_THAT(found.why, testing::HasSubstr("step")) << "since when";
    EXPECT_GT(found.why.size(), 80u);
    EXPECT_THAT(found.why, testing::Not(testing::AnyOf(testing::HasSubstr("nan"), testing::HasSubstr("inf"))));
    EXPECT_FALSE(found.tried.empty()) << found.why;
    for (const TriedRemedy& tried : found.tried) {
        if (tried.works) expect_to_work(tried);
    }
}

TEST_P(BlowUpCase, is_explained_and_its_remedies_are_tried) {
    std::size_t explained = 0, cured = 0;
    for (const Method& method : methods()) {
        for (const Trial& trial : GetParam().diverging(method)) {
            if (!can_run(trial, method)) continue;
            SCOPED_TRACE(method.info.id);
            Simulation run = trial.with(method.info.id);
            run.advance(std::min<std::uint64_t>(trial.steps(), 100'000));
            run.conclude();
            if (!run.divergence()) continue;
            const BlowUp found = studied(run);
            expect_explained(found);
            ++explained;
            if (std::any_of(found.tried.begin(), found.tried.end(),
                            [](const TriedRemedy& tried) { return tried.works; }))
                ++cured;
        }
    }
    EXPECT_GT(explained, 0u) << "the case diverges with some method";
    EXPECT_EQ(cured, explained) << "and something helps";
}

INSTANTIATE_TEST_SUITE_P(HardCases, BlowUpCase, testing::ValuesIn(diverging_cases()), name_of);

TEST(BlowUpCases, are_all_those_whose_tables_have_runs_that_blow_up_by_their_steps) {
    std::vector<std::string> ids;
    for (const HardCase& each : diverging_cases()) ids.emplace_back(each.id);
    EXPECT_THAT(ids, testing::ElementsAre("marginal-dt", "deep", "stiff-rope", "long-time", "subnormal"));
}

}  // namespace
}  // namespace steplab::test
