#include "methods/dop853.hpp"
#include "methods/dopri5.hpp"
#include "methods/rkn-12-10.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

using Number = long double;

// What the tables print: more digits than long double has; the sums over 16 coefficients of size 100 round at 1e-17.
constexpr Number digits = 1e-14L;

template <class Row>
Number moment(const Row& weights, const Row& c, int power) {
    Number sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * (power == 0 ? 1 : std::pow(c[i], power));
    return sum;
}

/// Largest violation of the quadrature conditions of order p and of the row conditions of a Nystrom table.
template <std::size_t Stages>
Number violation(const NystromTable<Stages>& table) {
    Number worst = 0;
    const auto hold = [&](Number left, Number right) { worst = std::max(worst, std::abs(left - right)); };
    for (int k = 0; k < 12; ++k) {
        const Number n = k + 1;
        if (k < 11) hold(moment(table.b, table.c, k), 1 / (n * (n + 1)));
        hold(moment(table.b_slope, table.c, k), 1 / n);
        if (k < 9) hold(moment(table.embedded, table.c, k), 1 / (n * (n + 1)));
        if (k < 10) hold(moment(table.embedded_slope, table.c, k), 1 / n);
    }
    for (std::size_t i = 0; i < Stages; ++i) {
        hold(moment(table.a[i], table.c, 0), table.c[i] * table.c[i] / 2);
        hold(table.b[i], table.b_slope[i] * (1 - table.c[i]));
        // c^4 and below are integrated exactly in the stages that count; those before have less to do
        for (int k = 1; k <= 4 && i >= 7; ++k) {
            hold(moment(table.a[i], table.c, k), std::pow(table.c[i], k + 2) / static_cast<Number>((k + 1) * (k + 2)));
        }
        // sum_j b'_j a_ji = b'_i (1 - c_i)^2 / 2
        Number column = 0;
        for (std::size_t j = 0; j < Stages; ++j) column += table.b_slope[j] * table.a[j][i];
        hold(column, table.b_slope[i] * (1 - table.c[i]) * (1 - table.c[i]) / 2);
    }
    return worst;
}

TEST(Rkn1210Table, holds_its_order_conditions) { EXPECT_LT(violation(Rkn1210::table), digits); }

TEST(Rkn1210Table, with_a_wrong_digit_does_not) {
    auto wrong = Rkn1210::table;
    wrong.a[14][6] += 1e-12L;
    EXPECT_GT(violation(wrong), digits);
    wrong = Rkn1210::table;
    wrong.embedded[8] += 1e-12L;
    EXPECT_GT(violation(wrong), digits);
}

/// The same for a Runge-Kutta table: its last row and its error's rows, which must not see polynomials below the order
/// of the embedded method.
template <class Table>
Number violation(const Table& table, int order, std::vector<int> embedded) {
    typename Table::Row c{};
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = moment(table.a[i], c, 0);
    Number worst = 0;
    const auto hold = [&](Number left, Number right) { worst = std::max(worst, std::abs(left - right)); };
    for (int k = 0; k < order; ++k) hold(moment(table.a[Table::stages - 1], c, k), 1 / static_cast<Number>(k + 1));
    for (std::size_t e = 0; e < embedded.size(); ++e) {
        for (int k = 0; k < embedded[e]; ++k) hold(moment(table.error[e], c, k), 0);
    }
    // sum_i b_i a_ij = b_j (1 - c_j)
    const auto& b = table.a[Table::stages - 1];
    for (std::size_t j = 0; j < Table::stages; ++j) {
        Number sum = 0;
        for (std::size_t i = 0; i < Table::stages; ++i) sum += b[i] * table.a[i][j];
        hold(sum, b[j] * (1 - c[j]));
    }
    // second moments of the rows: sum_j a_ij c_j = c_i^2 / 2 but in the second, whose weight is zero
    for (std::size_t i = 2; i < Table::all; ++i) hold(moment(table.a[i], c, 1), c[i] * c[i] / 2);
    return worst;
}

TEST(EmbeddedTables, hold_their_order_conditions) {
    EXPECT_LT(violation(Dopri5::table, 5, {4}), digits);
    EXPECT_LT(violation(Dop853::table, 8, {5, 3}), digits);
}

TEST(EmbeddedTables, with_a_wrong_digit_do_not) {
    auto wrong = Dop853::table;
    wrong.a[15][8] += 1e-12L;
    EXPECT_GT(violation(wrong, 8, {5, 3}), digits);
    wrong = Dop853::table;
    wrong.error[0][7] += 1e-12L;
    EXPECT_GT(violation(wrong, 8, {5, 3}), digits);
    auto wrong_5 = Dopri5::table;
    wrong_5.error[0][3] += 1e-12L;
    EXPECT_GT(violation(wrong_5, 5, {4}), digits);
}

}  // namespace
}  // namespace steplab::test
