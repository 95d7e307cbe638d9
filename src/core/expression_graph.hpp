#pragma once

#include "core/expression.hpp"
#include "core/expression_program.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

namespace steplab {

/// Expressions as one graph, in which equal parts are one node: simplified as they are added, differentiated exactly,
/// and made into a program. Sums and products of numbers are those of double.
class ExpressionGraph {
public:
    /// A node, valid as long as the graph.
    using Place = std::uint32_t;

    Place number(double value);
    /// A variable of the program, from 0.
    Place variable(std::size_t index);
    /// An expression whose names are these nodes, in the order of its names().
    Place add(const Expression& expression, std::span<const Place> names);

    Place sum(Place a, Place b);
    Place difference(Place a, Place b) { return sum(a, product(number(-1), b)); }
    Place product(Place a, Place b);
    Place quotient(Place a, Place b) { return product(a, power(b, number(-1))); }
    Place power(Place base, Place exponent);
    Place square_root(Place a) { return power(a, number(0.5)); }

    /// The derivative with respect to a variable. That of a function at a seam (abs, min, max) is that of one side.
    Place derivative(Place of, std::size_t variable);

    /// The same with a variable replaced by a node.
    Place substituted(Place in, std::size_t variable, Place by);

    /// Whether a variable occurs in it.
    bool depends(Place on, std::size_t variable) const;
    /// The operations that are needed for these results.
    ExpressionProgram program(std::span<const Place> results, std::size_t variables) const;

private:
    using Operation = Expression::Operation;

    /// Of arguments less than four, the others are 0. A comparison chooses the third where first < second.
    struct Node {
        enum class Kind : std::uint8_t { number, variable, sum, product, power, function, choice };
        Kind kind = Kind::number;
        Operation function = Operation::number;  ///< exp log sin cos tan tanh
        std::array<Place, 4> arguments{};        ///< of a variable its index
        double value = 0;

        std::size_t count() const;
    };
    using Key = std::tuple<Node::Kind, Operation, std::array<Place, 4>, std::uint64_t>;
    class Lowering;

    Place node(const Node& node);
    Place function(Operation operation, Place a);
    /// c where a < b, else d.
    Place choice(Place a, Place b, Place c, Place d);
    Place rebuilt(const Node& node, std::span<const Place> places);
    Place applied(Operation operation, Place a, Place b);
    Place slope(Place of, std::span<const Place> slopes);
    Place slope_of_power(const Node& node, std::span<const Place> slopes);
    Place slope_of_function(Place of, Place inner_slope);

    bool is_number(Place place) const { return nodes_[place].kind == Node::Kind::number; }
    bool is_number(Place place, double value) const { return is_number(place) && nodes_[place].value == value; }
    /// The number that multiplies the rest of a product, and the rest.
    std::pair<double, Place> with_factor(Place place);
    /// Base and number of a power; any other node is one to the power 1.
    std::pair<Place, double> as_power(Place place) const;
    std::vector<bool> needed_for(std::span<const Place> results) const;

    std::vector<Node> nodes_;
    std::map<Key, Place> known_;
};

}  // namespace steplab
