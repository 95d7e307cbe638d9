#include "lab/study/distances.hpp"

#include "core/entry.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

std::vector<double> squared_distances(const Field<double>& a, const Field<double>& b) {
    std::vector<double> squares;
    squares.reserve(a.count());
    for (std::size_t i = 0; i < a.count(); ++i) {
        const Vec3 between = a.at(i) - b.at(i);
        squares.push_back(dot(between, between));
    }
    return squares;
}

double largest_distance(const Field<double>& a, const Field<double>& b) {
    double largest = 0;
    for (const double square : squared_distances(a, b)) {
        if (std::isnan(square)) return infinity;
        largest = std::max(largest, square);
    }
    return std::sqrt(largest);
}

double largest_distance(const State<long double>& a, const State<long double>& b) {
    Field<double> between(a.displacement.count());
    for (std::size_t k = 0; k < between.flat().size(); ++k)
        between.flat()[k] = static_cast<double>(a.displacement.flat()[k] - b.displacement.flat()[k]);
    return largest_distance(between, Field<double>(between.count()));
}

double rounding_of(const Field<double>& field) {
    constexpr double half_ulp = 1.2e-16;  // of a number near 1
    double largest = 0;
    for (const double number : field.flat()) largest = std::max(largest, std::abs(number));
    return half_ulp * largest;
}

}  // namespace steplab
