#include "sim/run/run_variant.hpp"

#include "core/error.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TEST(RunVariant, changes_what_its_text_names) {
    const RunDescription run = run_of("chain", "verlet", Precision::double_, 0.1, {{"k", 3}});
    const RunDescription variant = variant_of(run, "tolerance=1e-9,method=dopri5,dt=0.02,precision=float,v0=0.5");
    EXPECT_EQ(variant.method, "dopri5");
    EXPECT_EQ(variant.method_parameters["tolerance"], 1e-9);
    EXPECT_EQ(variant.dt, 0.02);
    EXPECT_EQ(variant.precision, Precision::float_);
    EXPECT_EQ(variant.scene["v0"], 0.5);
    EXPECT_EQ(variant.scene["k"], 3);
    EXPECT_EQ(variant_of(run, "dt=0.1"), run);
}

TEST(RunVariant, is_made_again_from_its_text) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 0.1, {{"k", 3}});
    for (const char* text : {"method=verlet", "dt=0.1234567890123456789", "k=2", "method=taylor,tolerance=1e-7,v0=2",
                             "method=stoermer,precision=float,substeps=3"}) {
        const RunDescription variant = variant_of(run, text);
        EXPECT_EQ(variant_of(run, variant_text(variant, run)), variant) << text;
    }
    EXPECT_EQ(variant_text(run, run), "method=rk4,dt=0.1,precision=double");
}

TEST(RunVariant, refuses_what_it_does_not_know) {
    const RunDescription run = describe("chain");
    const auto refuses = [&](const char* text, const char* message) {
        EXPECT_THAT([&] { variant_of(run, text); }, ThrowsMessage<UsageError>(HasSubstr(message))) << text;
    };
    refuses("", "not of the form name=value");
    refuses("rk4", "'rk4' is not of the form name=value");
    refuses("=3", "not of the form name=value");
    refuses("dt=0.1,", "not of the form name=value");
    refuses("methud=rk4", "'methud'");
    refuses("method=rk5", "rk4");
    refuses("precision=half", "float");
    refuses("dt=0", "dt");
    refuses("dt=-0.1", "dt");
    refuses("dt=0.1,dt=0.2", "'dt' is set more than once");
    refuses("tolerance=1e-9", "'tolerance'");
}

TEST(RunVariant, of_a_run_backward_may_be_one) {
    RunDescription back = describe("chain");
    back.dt = -0.1;
    EXPECT_EQ(variant_of(back, "dt=-0.2").dt, -0.2);
}

}  // namespace
}  // namespace steplab::test
