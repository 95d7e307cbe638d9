#include "session/run_name.hpp"

#include "sim/run/run_variant.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace steplab
