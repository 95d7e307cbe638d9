#pragma once

#include "core/vec3.hpp"

#include <array>
#include <string>

namespace steplab {

/// A number of a scene and how it is written: as an expression in the scene's parameters, or as the number it is.
struct Quantity {
    double value = 0;
    std::string text = {};  ///< of the expression; empty: the number

    Quantity() = default;
    Quantity(double number) : value(number) {}  // NOLINT(google-explicit-constructor): a number is one
    Quantity(double result, std::string expression) : value(result), text(std::move(expression)) {}

    bool operator==(const Quantity&) const = default;
};

/// Products and negatives are written where a factor is an expression.
Quantity operator*(const Quantity& a, const Quantity& b);
Quantity operator-(const Quantity& a);

struct QuantityVector {
    Quantity x, y, z;

    Vec3 value() const { return {x.value, y.value, z.value}; }
    bool operator==(const QuantityVector&) const = default;
};

}  // namespace steplab
