#pragma once

#include <steplab/visibility.hpp>
#include <string>

namespace steplab::library {

/// A formula, written in C++ and computed by steplab: what an operator does is recorded, not computed. As a potential
/// it is differentiated exactly and compiled for vectors, so that it costs no call per pair.
///
///     const Expression r = Expression::named("r");
///     scene.with_pair_force(PairForce{.potential = (0.5 * pow(r - 1, 2)).text()});
class STEPLAB_PUBLIC Expression {
public:
    /// A number. Throws UsageError unless it is finite.
    explicit(false) Expression(double number);
    /// "r", the distance of two particles, their masses "m1", "m2" or charges "q1", "q2"; "x", "y", "z" in a field.
    static Expression named(const std::string& name);

    /// As scene files have it.
    const std::string& text() const { return text_; }

    friend STEPLAB_PUBLIC Expression operator+(const Expression& a, const Expression& b);
    friend STEPLAB_PUBLIC Expression operator-(const Expression& a, const Expression& b);
    friend STEPLAB_PUBLIC Expression operator*(const Expression& a, const Expression& b);
    friend STEPLAB_PUBLIC Expression operator/(const Expression& a, const Expression& b);
    friend STEPLAB_PUBLIC Expression operator-(const Expression& a);
    friend STEPLAB_PUBLIC Expression pow(const Expression& base, const Expression& exponent);
    friend STEPLAB_PUBLIC Expression exp(const Expression& a);
    friend STEPLAB_PUBLIC Expression log(const Expression& a);
    friend STEPLAB_PUBLIC Expression sqrt(const Expression& a);
    friend STEPLAB_PUBLIC Expression sin(const Expression& a);
    friend STEPLAB_PUBLIC Expression cos(const Expression& a);
    friend STEPLAB_PUBLIC Expression tanh(const Expression& a);

private:
    struct Text {};
    Expression(Text, std::string text);
    std::string text_;
};

}  // namespace steplab::library
