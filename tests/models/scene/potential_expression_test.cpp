#include "models/scene/potential_expression.hpp"

#include "core/error.hpp"
#include "core/expression.hpp"
#include "models/forces/pair_potential.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

struct Twin {
    std::string name;
    std::vector<double> values;
    std::string expression;
};

/// Each built-in potential, and the same typed.
const std::vector<Twin> twins{
    {"morse", {1.5, 40, 1.1}, "1.5*((1 - exp(-sqrt(40/(2*1.5))*(r - 1.1)))^2 - 1)"},
    {"lennard-jones", {0.7, 1.2}, "4*0.7*((1.2/r)^12 - (1.2/r)^6)"},
    {"gravity", {0.3, 0.2}, "-0.3*m1*m2/sqrt(r^2 + 0.2^2)"},
    {"coulomb", {2, 0}, "2*q1*q2/r"},
};

TEST(PotentialExpression, every_built_in_potential_has_a_twin) {
    ASSERT_EQ(twins.size(), BuiltInPotentials::infos.size());
    for (const Twin& twin : twins) EXPECT_TRUE(built_in_potential(twin.name)) << twin.name;
}

// Rounding of a few operations, of terms up to 10^3 times the sum where two nearly cancel.
TEST(PotentialExpression, is_the_built_in_potential_typed) {
    const double unit = 2.5;
    for (const Twin& twin : twins) {
        for (const double cutoff : {0.0, 2.5}) {
            ComposedPairs built_in;
            built_in.potential = twin.name;
            built_in.values = twin.values;
            built_in.cutoff = cutoff;
            PairTerm term{.potential = twin.expression};
            if (cutoff > 0) term.cutoff = cutoff;
            ComposedPairs typed;
            typed.cutoff = cutoff;
            typed.expression = expression_of(term, unit);
            const PairPotential<double> a(built_in, unit), b(typed, unit);
            const PairProperties<double> pair{1, 0.4, -1, 0.5};
            for (double r = 0.9; r < 2.5; r += 0.1) {
                const double energy = a.energy(r * r, pair), factor = a.factor(r * r, pair);
                EXPECT_NEAR(b.energy(r * r, pair), energy, 1e-12 * (1 + std::abs(energy))) << twin.name << ' ' << r;
                EXPECT_NEAR(b.factor(r * r, pair), factor, 1e-12 * (1 + std::abs(factor))) << twin.name << ' ' << r;
            }
            if (cutoff > 0) {
                EXPECT_NEAR(b.energy(6.25, pair), 0, 1e-14);
                EXPECT_NEAR(b.factor(6.25, pair), 0, 1e-14);
            }
        }
    }
}

TEST(PotentialExpression, asks_for_masses_and_charges_only_where_it_names_them) {
    EXPECT_FALSE(expression_of(PairTerm{.potential = "r^2"}, 1)->takes_properties);
    EXPECT_FALSE(expression_of(PairTerm{.potential = "r^2 + 0*m1"}, 1)->takes_properties);
    EXPECT_TRUE(expression_of(PairTerm{.potential = "r^2*m2"}, 1)->takes_properties);
    EXPECT_TRUE(expression_of(FieldTerm{.potential = "q*x"}, 1).expression->takes_properties);
}

TEST(PotentialExpression, knows_the_axes_of_a_field) {
    const ComposedField field = expression_of(FieldTerm{.potential = "x^4 + z"}, 1);
    EXPECT_FALSE(field.along_y);
    EXPECT_TRUE(field.along_z);
}

TEST(PotentialExpression, too_long_or_of_unknown_names_is_an_error) {
    std::string text = "r";
    for (int k = 1; k < 150; ++k) text += " + sin(" + std::to_string(k) + "*r)";
    EXPECT_THROW(expression_of(PairTerm{.potential = text}, 1), UsageError);
    EXPECT_THROW(expression_of(PairTerm{.potential = "unheard*r"}, 1), UsageError);
    EXPECT_THROW(expression_of(PairTerm{.potential = "r +"}, 1), ExpressionError);
}

}  // namespace
}  // namespace steplab::test
