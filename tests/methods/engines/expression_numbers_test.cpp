// Expressions in every number type against the functions of the standard library in long double and complex numbers.

#include "core/elementary_numbers.hpp"
#include "core/expression_graph.hpp"
#include "methods/engines/power_series.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using Place = ExpressionGraph::Place;
using Real = long double;
using Complex = std::complex<Real>;

/// An expression in x and y, and the same in C++. Complex numbers take the branch that holds near the path below.
struct Written {
    std::string text;
    Complex (*value)(Complex x, Complex y);
};

constexpr Complex one(1), two(2);

const std::vector<Written> written{
    {"log(x)", [](Complex x, Complex) { return std::log(x); }},
    {"log(1 + x*y)", [](Complex x, Complex y) { return std::log(one + x * y); }},
    {"sin(x*y)", [](Complex x, Complex y) { return std::sin(x * y); }},
    {"cos(x) + sin(y)^2", [](Complex x, Complex y) { return std::cos(x) + std::sin(y) * std::sin(y); }},
    {"tan(x/2)*cos(y)", [](Complex x, Complex y) { return std::tan(x / two) * std::cos(y); }},
    {"tanh(x - y/4)", [](Complex x, Complex y) { return std::tanh(x - y / Real(4)); }},
    {"exp(-x*y)", [](Complex x, Complex y) { return std::exp(-x * y); }},
    {"sqrt(x + y)", [](Complex x, Complex y) { return std::sqrt(x + y); }},
    {"x^3 - y^-2", [](Complex x, Complex y) { return x * x * x - one / (y * y); }},
    {"x^2.5 + y^-0.75", [](Complex x, Complex y) { return std::pow(x, Real(2.5)) + std::pow(y, Real(-0.75)); }},
    {"x^0.3 - y^-1.7", [](Complex x, Complex y) { return std::pow(x, Real(0.3)) - std::pow(y, Real(-1.7)); }},
    {"x^y", [](Complex x, Complex y) { return std::exp(y * std::log(x)); }},
    {"(x + y)^(x/y)", [](Complex x, Complex y) { return std::exp(x / y * std::log(x + y)); }},
    {"2^x", [](Complex x, Complex) { return std::exp(x * std::numbers::ln2_v<Real>); }},
    {"x/(1 + y^2) - 3", [](Complex x, Complex y) { return x / (one + y * y) - Real(3); }},
    {"1/x^12 - 1/x^6",
     [](Complex x, Complex) {
         const Complex s = one / (x * x * x * x * x * x);
         return s * s - s;
     }},
    {"abs(x - 2)*min(x, y)", [](Complex x, Complex) { return (two - x) * x; }},
    {"max(x, y)^2.5 + max(0, x - 5)", [](Complex, Complex y) { return std::pow(y, Real(2.5)); }},
};

/// x and y move along polynomials in time; all functions above are smooth within a distance of 2.5.
constexpr std::array<Real, 3> path_x{0.90625L, 0.1875L, -0.046875L}, path_y{1.75L, -0.28125L, 0};

template <class N>
N along(const std::array<Real, 3>& path, N t) {
    return (N(path[2]) * t + N(path[1])) * t + N(path[0]);
}

constexpr std::size_t coefficients = 20;
constexpr Real radius = 2.4L;

/// The coefficients of a function's power series in time, by Cauchy's integral over a circle of radius 2^power: off by
/// (2^power / 2.5)^512 and rounding of long double, divided by the power of the radius.
std::array<Real, coefficients> series_by_integral(const Written& of, int power) {
    constexpr std::size_t points = 512;
    std::array<Real, coefficients> sum{};
    for (std::size_t p = 0; p < points; ++p) {
        const auto turn = [&](std::size_t k) {
            return std::polar(Real(1), 2 * std::numbers::pi_v<Real> * static_cast<Real>(p * k % points) / points);
        };
        const Complex time = std::ldexp(Real(1), power) * turn(1);
        const Complex value = of.value(along(path_x, time), along(path_y, time));
        for (std::size_t k = 0; k < coefficients; ++k)
            sum[k] += std::ldexp((value * std::conj(turn(k))).real() / points, -power * static_cast<int>(k));
    }
    return sum;
}

/// An expression as a graph, and programs of what is made of it, run in any number type made of T.
struct WrittenGraph {
    explicit WrittenGraph(const std::string& text) : expression(text) {
        for (const std::string& name : expression.names()) names.push_back(graph.variable(name == "y" ? 1 : 0));
        value = graph.add(expression, names);
    }
    template <class T, class N>
    N at(Place place, const N& x, const N& y) const {
        const ExpressionProgram program = graph.program(std::array{place}, 2);
        std::vector<N> slots(program.slots, N(T(0)));
        program.set_constants<T>(std::span<N>(slots));
        slots[0] = x, slots[1] = y;
        program.run(std::span<N>(slots));
        return slots[program.results[0]];
    }

    Expression expression;
    ExpressionGraph graph;
    std::vector<Place> names;
    Place value = 0;
};

template <class T>
class ExpressionNumbers : public testing::Test {
protected:
    static constexpr Real eps = std::numeric_limits<T>::epsilon();
    static constexpr T x0 = static_cast<T>(path_x[0]), y0 = static_cast<T>(path_y[0]);
    static constexpr T x1 = static_cast<T>(path_x[1]), y1 = static_cast<T>(path_y[1]);
};
using AllNumbers = testing::Types<float, double, long double>;
TYPED_TEST_SUITE(ExpressionNumbers, AllNumbers);

// A few operations whose arguments are off by eps, of functions that change by at most 13 times that (x^-12).
TYPED_TEST(ExpressionNumbers, have_the_value_of_the_functions) {
    for (const Written& one_of : written) {
        const WrittenGraph g(one_of.text);
        const Real right = one_of.value(path_x[0], path_y[0]).real();
        const Real found = g.at<TypeParam>(g.value, this->x0, this->y0);
        EXPECT_LE(std::abs(found - right), 16 * this->eps * (1 + std::abs(right))) << one_of.text;
    }
}

// By dual numbers along the path, and by the graph's derivatives, in which numbers are those of double.
TYPED_TEST(ExpressionNumbers, have_the_derivative_of_the_functions) {
    for (const Written& one_of : written) {
        WrittenGraph g(one_of.text);
        const Real right = series_by_integral(one_of, -3)[1];
        const Dual<TypeParam> x(this->x0, this->x1), y(this->y0, this->y1);
        const Real found = g.at<TypeParam>(g.value, x, y).derivative;
        EXPECT_LE(std::abs(found - right), 16 * this->eps * (1 + std::abs(right))) << one_of.text;

        const Place by_x = g.graph.derivative(g.value, 0), by_y = g.graph.derivative(g.value, 1);
        const Real slope = Real(g.at<TypeParam>(by_x, this->x0, this->y0)) * path_x[1] +
                           Real(g.at<TypeParam>(by_y, this->x0, this->y0)) * path_y[1];
        const Real rounding = std::max<Real>(this->eps, std::numeric_limits<double>::epsilon());
        EXPECT_LE(std::abs(slope - right), 16 * rounding * (1 + std::abs(right))) << one_of.text;
    }
}

// Coefficients fall with the powers of the radius, and so do their errors: those of sums of 20 products.
TYPED_TEST(ExpressionNumbers, have_the_power_series_of_the_functions) {
    using T = TypeParam;
    using S = Series<T>;
    std::vector<Lanes<T>> memory(SeriesTape<T>::most_kept * coefficients, Lanes<T>(T(0)));
    for (const Written& one_of : written) {
        const WrittenGraph g(one_of.text);
        const auto right = series_by_integral(one_of, 1);
        Real size = 0;
        for (std::size_t k = 0; k < coefficients; ++k)
            size = std::max(size, std::abs(right[k]) * std::pow(radius, static_cast<Real>(k)));
        for (std::size_t k = 0; k < coefficients; ++k) {
            SeriesTape<T> tape(memory.data(), coefficients, k);
            const auto variable = [&](const std::array<Real, 3>& path) {
                return S::variable(tape, Lanes<T>(k < path.size() ? static_cast<T>(path[k]) : T(0)));
            };
            const S x = variable(path_x), y = variable(path_y);
            const Real found = g.at<T>(g.value, x, y).coefficient()[0];
            EXPECT_LE(std::abs(found - right[k]) * std::pow(radius, static_cast<Real>(k)), 16 * this->eps * size)
                << one_of.text << " coefficient " << k;
            EXPECT_FALSE(tape.singular()) << one_of.text;
        }
        EXPECT_GT(std::abs(right[2]), 1e-4L) << one_of.text << ": it is no straight line";
    }
}

}  // namespace
}  // namespace steplab::test
