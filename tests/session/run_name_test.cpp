#include "session/run_name.hpp"

#include "sim/run/run_variant.hpp"
#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab {
namespace {

TEST(RunName, is_of_what_runs_beside_each_other_differ_in) {
    const RunDescription run = describe("rope", "rk4");
    const auto name = [&](const char* variant) { return run_name(variant_of(run, variant), run); };
    EXPECT_EQ(run_name(run, run), "rk4, dt 0.1 s, double");
    EXPECT_EQ(name("method=euler,dt=0.025,precision=float"), "euler, dt 0.025 s, float");
    EXPECT_EQ(name("method=dopri5,tolerance=1e-9"), "dopri5, tolerance 1e-9, double");
    EXPECT_EQ(name("k=150"), "rk4, dt 0.1 s, double, k 150");
    EXPECT_EQ(run_name(run, describe("free", "rk4")), "rk4, dt 0.1 s, double") << "another scene was asked for";
}

TEST(RunName, is_short_whatever_the_numbers_are) {
    for (const double number : special_doubles()) {
        RunDescription run = describe("rope", "rk4"), leading = run;
        run.dt = number;
        EXPECT_LE(run_name(run, leading).size(), 80u) << number;
        if (!(number > 0) || std::isinf(number)) continue;  // no parameter may be that
        run.scene.set("k", number);
        EXPECT_LE(run_name(run, leading).size(), 80u) << number;
        run = with_method(run, "dopri5");
        run.method_parameters.set("tolerance", number);
        EXPECT_LE(run_name(run, leading).size(), 80u) << number;
    }
}

}  // namespace
}  // namespace steplab
