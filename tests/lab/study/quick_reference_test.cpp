#include "lab/study/quick_reference.hpp"

#include "lab/study/cost_scan.hpp"
#include "lab/study/distances.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string>

namespace steplab::test {
namespace {

constexpr double some_terms = 1e8;  ///< some tenths of a second

// What it says of its error is true, whatever the model: against the closed form, or a reference in long double.
TEST(QuickReference, of_every_model_is_no_further_off_than_it_says) {
    for (const Model& model : models()) {
        if (model.info.id == "crystal") continue;  // long double is worse there, see CostScan
        SCOPED_TRACE(model.info.id);
        const RunDescription scene = describe(model.info.id);
        const double time = CostScan::time_for(scene);
        const auto quick = quick_reference(scene, time, some_terms);
        ASSERT_TRUE(quick);
        const Reference known = reference(scene, std::span(&time, 1));
        const ReferenceMoment& end = quick->moments.back();
        EXPECT_EQ(end.time, time);
        EXPECT_LE(largest_distance(end.state.displacement, known.moments.back().state.displacement),
                  end.error + known.moments.back().error);
        EXPECT_LT(end.error, 1e-6) << "and it is worth something";
        EXPECT_FALSE(quick->exact);
    }
}

// The partner: with few terms it ends early, and says so.
TEST(QuickReference, with_fewer_terms_is_worse) {
    const RunDescription scene = describe("mesh");
    const auto good = quick_reference(scene, 10, some_terms), bad = quick_reference(scene, 10, 1);
    ASSERT_TRUE(good && bad);
    EXPECT_LT(100 * good->moments.back().error, bad->moments.back().error);
    EXPECT_NE(bad->how.find("tolerance 1e-07"), std::string::npos) << bad->how;
}

// The method, the precision and dt are those of the run that asks.
TEST(QuickReference, is_that_of_the_scene_alone) {
    const auto one = quick_reference(run_of("oscillator", "euler", Precision::float_, 0.5), 3, some_terms);
    const auto other = quick_reference(run_of("oscillator", "rk4", Precision::double_, 0.1), 3, some_terms);
    ASSERT_TRUE(one && other);
    EXPECT_EQ(largest_distance(one->moments.back().state.displacement, other->moments.back().state.displacement), 0);
}

// A potential far narrower than the distance between two numbers where the bullet comes to it.
TEST(QuickReference, is_none_where_the_method_gets_nowhere) {
    const RunDescription scene = run_of("morse", "rk4", Precision::double_, 20, {{"edge", 1}, {"k", 1e20}});
    EXPECT_FALSE(quick_reference(scene, 20, some_terms));
}

}  // namespace
}  // namespace steplab::test
