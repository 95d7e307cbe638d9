#include "sim/run/execution.hpp"

#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace steplab::test {
namespace {

Instructions instructions_of_run(std::string_view method_id, std::string_view model_id, Settings settings,
                                 const Execution& execution = {}) {
    const Model& of = model(model_id);
    ParameterValues values(of.info.parameters);
    for (const auto& [name, value] : settings) values.set(name, value);
    return instructions_for(method(method_id), of.plan(values), execution);
}

TEST(Execution, takes_the_instructions_that_are_said) {
    for (const Instructions said : instructions_here()) {
        EXPECT_EQ(instructions_of_run("velocity-verlet", "chain", {{"n", 10}}, {.instructions = said}), said);
        EXPECT_EQ(instructions_of({.instructions = said}), said);
    }
}

TEST(Execution, takes_the_fastest_otherwise) {
    const Instructions fastest = fastest_instructions();
    EXPECT_EQ(instructions_of({}), fastest);
    EXPECT_EQ(instructions_of_run("velocity-verlet", "chain", {{"n", 13}}), fastest);
    EXPECT_EQ(instructions_of_run("rk4", "mesh", {{"dim", 4}}), fastest);
    EXPECT_EQ(instructions_of_run("rk4", "morse", {{"edge", 2}}), fastest);
    EXPECT_EQ(instructions_of_run("gauss-16", "chain", {{"n", 10}}), fastest);
}

bool is_of_intel() {
#if defined(__x86_64__)
    return __builtin_cpu_is("intel") != 0;
#else
    return false;
#endif
}

TEST(Execution, of_a_few_springs_is_narrower_where_wide_divisions_take_longer) {
    const auto here = instructions_here();
    const bool narrower = is_of_intel() && here.back() == Instructions::avx512 && here.size() > 1;
    const Instructions expected = narrower ? here[here.size() - 2] : here.back();
    for (const char* const id : {"euler", "rk4"})
        for (const double n : {2.0, 12.0}) EXPECT_EQ(instructions_of_run(id, "chain", {{"n", n}}), expected) << id;
    EXPECT_EQ(instructions_of_run("rk4", "mesh", {{"dim", 3}}), expected);
}

}  // namespace
}  // namespace steplab::test
