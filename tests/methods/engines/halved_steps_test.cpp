#include "methods/engines/halved_steps.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

/// Lengths of the attempts that succeed, where only those up to `longest` do.
std::vector<double> pieces(double step, double longest, bool& done) {
    std::vector<double> taken;
    done = in_halves(step, [&](double h) {
        if (h > longest) return false;
        taken.push_back(h);
        return true;
    });
    return taken;
}

TEST(HalvedSteps, cover_the_whole_step) {
    bool done = false;
    EXPECT_EQ(pieces(1, 1, done), std::vector<double>{1});
    EXPECT_EQ(pieces(1, 0.3, done), std::vector<double>(4, 0.25));
    EXPECT_TRUE(done);
}

// Only the piece that fails is halved.
TEST(HalvedSteps, are_no_shorter_than_needed) {
    std::vector<double> taken;
    double time = 0;
    EXPECT_TRUE(in_halves(1.0, [&](double h) {
        if (time < 0.5 && h > 0.25) return false;
        taken.push_back(h);
        time += h;
        return true;
    }));
    EXPECT_EQ(taken, (std::vector<double>{0.25, 0.25, 0.5}));
}

TEST(HalvedSteps, of_a_millionth_that_fail_too_are_a_divergence) {
    Field<double> v(1);
    int attempts = 0;
    step_in_halves(1.0, v, [&](double) { return ++attempts < 0; });
    EXPECT_EQ(attempts, 21);
    EXPECT_TRUE(std::isnan(v.x()[0]));
    Field<double> fine(1);
    step_in_halves(1.0, fine, [](double h) { return h < 1e-5; });
    EXPECT_EQ(fine.x()[0], 0);
}

}  // namespace
}  // namespace steplab::test
