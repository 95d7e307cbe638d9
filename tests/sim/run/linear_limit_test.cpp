#include "sim/run/linear_limit.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

double measured(const char* id) {
    const Method& each = method(id);
    return measured_linear_limit(each, ParameterValues(each.info.parameters));
}

TEST(MeasuredLinearLimit, is_what_entries_of_explicit_methods_say) {
    // found to rounding, by growth of more than 1e-12: a little beyond where it begins
    for (const char* id : {"verlet", "velocity-verlet", "rk4", "forest-ruth", "pefrl"}) {
        const Method& each = method(id);
        const double entry = linear_limit(each.info, ParameterValues(each.info.parameters));
        EXPECT_NEAR(measured(id) / entry, 1, 1e-3) << id;
    }
}

TEST(MeasuredLinearLimit, is_zero_where_a_method_gains_at_any_dt) {
    EXPECT_EQ(measured("euler-forward"), 0);
    EXPECT_EQ(measured("midpoint"), 0);
}

TEST(MeasuredLinearLimit, is_infinite_where_nothing_grows) {
    EXPECT_EQ(measured("implicit-midpoint"), infinity);
    EXPECT_NE(measured("rk4"), infinity);
}

}  // namespace
}  // namespace steplab::test
