#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// What is wrong in the text of an expression, and at which of its characters, from 0.
class ExpressionError : public std::runtime_error {
public:
    ExpressionError(std::size_t place, const std::string& message) : std::runtime_error(message), place_(place) {}
    std::size_t place() const { return place_; }

private:
    std::size_t place_;
};

/// A formula such as "2*k - exp(-r/r0)", parsed once: + - * / ^, brackets, numbers, names, pi, and the functions exp
/// log sqrt sin cos tan tanh abs min max. ^ binds tightest, to the right, above unary minus; there is no implied
/// multiplication. A constant whole exponent means repeated multiplication.
class Expression {
public:
    enum class Operation : std::uint8_t {
        number,
        name,
        add,
        subtract,
        multiply,
        divide,
        power,
        negate,
        exp,
        log,
        sqrt,
        sin,
        cos,
        tan,
        tanh,
        abs,
        min,
        max
    };

    /// An operation on results of earlier ones.
    struct Node {
        Operation operation = Operation::number;
        std::uint32_t first = 0;  ///< of nodes(); of names() for a name
        std::uint32_t second = 0;
        double number = 0;
    };

    /// Throws ExpressionError.
    explicit Expression(std::string_view text);

    /// Each after those it depends on; the last is the value of the whole.
    std::span<const Node> nodes() const { return nodes_; }
    /// In the order in which they first occur.
    std::span<const std::string> names() const { return names_; }
    /// The value for values of names().
    double operator()(std::span<const double> values) const;

private:
    std::vector<Node> nodes_;
    std::vector<std::string> names_;
};

/// True for what can be a name: a letter or underscore, then also digits.
bool is_name(std::string_view text);

}  // namespace steplab
