#pragma once

#include "core/vec3.hpp"

#include <array>
#include <string>

namespace steplab {

/// A number of a scene and how it is written: as an expression in the scene's parameters, or as the number it is.
struct WrittenNumber {
    double value = 0;
    std::string text = {};  ///< of the expression; empty: the number

    WrittenNumber() = default;
    WrittenNumber(double number) : value(number) {}  // NOLINT(google-explicit-constructor): a number is one
    WrittenNumber(double result, std::string expression) : value(result), text(std::move(expression)) {}

    bool operator==(const WrittenNumber&) const = default;
};

/// Products and negatives are written where a factor is an expression.
WrittenNumber operator*(const WrittenNumber& a, const WrittenNumber& b);
WrittenNumber operator-(const WrittenNumber& a);

struct WrittenVector {
    WrittenNumber x, y, z;

    Vec3 value() const { return {x.value, y.value, z.value}; }
    bool operator==(const WrittenVector&) const = default;
};

}  // namespace steplab
