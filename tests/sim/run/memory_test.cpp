#include "sim/run/simulation.hpp"
#include "support/allocations.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cstddef>

namespace steplab::test {
namespace {

class Steps : public testing::TestWithParam<MethodCase> {};

template <class Work>
std::size_t allocations_of(const Work& work) {
    const std::size_t before = allocations();
    work();
    return allocations() - before;
}

// What a step needs is there before the first one: ten times as many steps ask for memory as often, if at all. All
// are taken before the first check of the energy.
TEST_P(Steps, of_fixed_methods_ask_nobody_for_memory) {
    // two functions a step go to the team that sums the lists of a crystal
    const auto has_no_lists = [](const Model* model) { return model->info.id != "crystal"; };
    for (const Model* const model : those_where(models_for(GetParam().id(), GetParam().precision), has_no_lists)) {
        Simulation simulation(small_run_of(model->info.id, GetParam().id(), GetParam().precision, 0.001));
        simulation.advance(2);
        const std::size_t few = allocations_of([&] { simulation.advance(20); });
        const std::size_t many = allocations_of([&] { simulation.advance(200); });
        EXPECT_EQ(many, few) << model->info.id;
    }
}

// The others ask for linear systems and for steps tried in vain.
INSTANTIATE_TEST_SUITE_P(Catalogue, Steps, testing::ValuesIn(methods_where(has_equal_steps)), case_name);

TEST(Allocations, are_counted) {
    EXPECT_EQ(allocations_of([] {}), 0U);
    EXPECT_GT(allocations_of([] { const Simulation simulation(describe("chain")); }), 0U);
}

}  // namespace
}  // namespace steplab::test
