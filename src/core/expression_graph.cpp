#include "core/expression_graph.hpp"

#include "core/elementary.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

double function_of(Expression::Operation operation, double x) {
    using Operation = Expression::Operation;
    switch (operation) {
        case Operation::exp:
            return exponential(x);
        case Operation::log:
            return natural_logarithm(x);
        case Operation::sin:
            return sine(x);
        case Operation::cos:
            return cosine(x);
        case Operation::tan:
            return tangent(x);
        default:
            return hyperbolic_tangent(x);
    }
}

}  // namespace

std::size_t ExpressionGraph::Node::count() const {
    switch (kind) {
        case Kind::number:
        case Kind::variable:
            return 0;
        case Kind::function:
            return 1;
        case Kind::choice:
            return 4;
        default:
            return 2;
    }
}

ExpressionGraph::Place ExpressionGraph::node(const Node& node) {
    const Key key{node.kind, node.function, node.arguments, std::bit_cast<std::uint64_t>(node.value)};
    const auto [known, is_new] = known_.try_emplace(key, static_cast<Place>(nodes_.size()));
    if (is_new) nodes_.push_back(node);
    return known->second;
}

ExpressionGraph::Place ExpressionGraph::number(double value) { return node({.value = value + 0.0}); }

ExpressionGraph::Place ExpressionGraph::variable(std::size_t index) {
    return node({.kind = Node::Kind::variable, .arguments = {static_cast<Place>(index)}});
}

ExpressionGraph::Place ExpressionGraph::sum(Place a, Place b) {
    if (is_number(a) && is_number(b)) return number(nodes_[a].value + nodes_[b].value);
    if (is_number(a, 0)) return b;
    if (is_number(b, 0)) return a;
    const auto [factor_a, rest_a] = with_factor(a);
    const auto [factor_b, rest_b] = with_factor(b);
    if (rest_a == rest_b) return product(number(factor_a + factor_b), rest_a);
    if (a > b) std::swap(a, b);
    return node({.kind = Node::Kind::sum, .arguments = {a, b}});
}

std::pair<double, ExpressionGraph::Place> ExpressionGraph::with_factor(Place place) {
    const Node node = nodes_[place];  // number() moves them
    if (node.kind == Node::Kind::number) return {node.value, number(1)};
    if (node.kind == Node::Kind::product && is_number(node.arguments[0]))
        return {nodes_[node.arguments[0]].value, node.arguments[1]};
    return {1, place};
}

std::pair<ExpressionGraph::Place, double> ExpressionGraph::as_power(Place place) const {
    const Node& node = nodes_[place];
    if (node.kind == Node::Kind::power && is_number(node.arguments[1]))
        return {node.arguments[0], nodes_[node.arguments[1]].value};
    return {place, 1};
}

ExpressionGraph::Place ExpressionGraph::product(Place a, Place b) {
    const auto [factor_a, rest_a] = with_factor(a);
    const auto [factor_b, rest_b] = with_factor(b);
    const double factor = factor_a * factor_b;
    if (factor == 0) return number(0);
    Place rest = 0;
    const auto [base_a, exponent_a] = as_power(rest_a);
    const auto [base_b, exponent_b] = as_power(rest_b);
    if (is_number(rest_a)) {
        rest = rest_b;
    } else if (is_number(rest_b)) {
        rest = rest_a;
    } else if (base_a == base_b) {
        rest = power(base_a, number(exponent_a + exponent_b));
    } else {
        rest = node({.kind = Node::Kind::product, .arguments = {std::min(rest_a, rest_b), std::max(rest_a, rest_b)}});
    }
    if (is_number(rest)) return number(factor * nodes_[rest].value);
    if (factor == 1) return rest;
    return node({.kind = Node::Kind::product, .arguments = {number(factor), rest}});
}

ExpressionGraph::Place ExpressionGraph::power(Place base, Place exponent) {
    if (is_number(exponent, 0)) return number(1);
    if (is_number(exponent, 1)) return base;
    if (is_number(base) && is_number(exponent))
        return number(general_power(nodes_[base].value, nodes_[exponent].value));
    const Node& node_of_base = nodes_[base];
    if (is_number(exponent) && node_of_base.kind == Node::Kind::power && is_number(node_of_base.arguments[1])) {
        // (x^a)^b = x^(a b) but where a negative x has become positive.
        const double inner = nodes_[node_of_base.arguments[1]].value, outer = nodes_[exponent].value;
        const Place inmost = node_of_base.arguments[0];
        if (is_whole(outer) || !is_whole(inner)) return power(inmost, number(inner * outer));
    }
    if (is_number(exponent) && is_whole(nodes_[exponent].value) && node_of_base.kind == Node::Kind::product) {
        // (r / w)^2 of a distance r is known without a root.
        const std::array<Place, 4> factors = node_of_base.arguments;
        const Place first = power(factors[0], exponent);
        return product(first, power(factors[1], exponent));
    }
    return node({.kind = Node::Kind::power, .arguments = {base, exponent}});
}

ExpressionGraph::Place ExpressionGraph::function(Operation operation, Place a) {
    if (is_number(a)) return number(function_of(operation, nodes_[a].value));
    return node({.kind = Node::Kind::function, .function = operation, .arguments = {a}});
}

ExpressionGraph::Place ExpressionGraph::choice(Place a, Place b, Place c, Place d) {
    if (is_number(a) && is_number(b)) return nodes_[a].value < nodes_[b].value ? c : d;
    if (c == d) return c;
    return node({.kind = Node::Kind::choice, .arguments = {a, b, c, d}});
}

ExpressionGraph::Place ExpressionGraph::applied(Operation operation, Place a, Place b) {
    switch (operation) {
        case Operation::add:
            return sum(a, b);
        case Operation::subtract:
            return difference(a, b);
        case Operation::multiply:
            return product(a, b);
        case Operation::divide:
            return quotient(a, b);
        case Operation::power:
            return power(a, b);
        case Operation::negate:
            return product(number(-1), a);
        case Operation::sqrt:
            return square_root(a);
        case Operation::abs:
            return choice(a, number(0), product(number(-1), a), a);
        case Operation::min:
            return choice(b, a, b, a);
        case Operation::max:
            return choice(a, b, b, a);
        default:
            return function(operation, a);
    }
}

ExpressionGraph::Place ExpressionGraph::add(const Expression& expression, std::span<const Place> names) {
    std::vector<Place> places;
    for (const Expression::Node& part : expression.nodes()) {
        if (part.operation == Operation::number) {
            places.push_back(number(part.number));
        } else if (part.operation == Operation::name) {
            places.push_back(names[part.first]);
        } else {
            places.push_back(applied(part.operation, places[part.first], places[part.second]));
        }
    }
    return places.back();
}

std::vector<bool> ExpressionGraph::needed_for(std::span<const Place> results) const {
    std::vector<bool> needed(nodes_.size());
    for (const Place result : results) needed[result] = true;
    for (std::size_t place = nodes_.size(); place-- > 0;) {
        if (!needed[place]) continue;
        for (std::size_t k = 0; k < nodes_[place].count(); ++k) needed[nodes_[place].arguments[k]] = true;
    }
    return needed;
}

bool ExpressionGraph::depends(Place on, std::size_t variable) const {
    const std::vector<bool> needed = needed_for(std::array{on});
    for (std::size_t place = 0; place < nodes_.size(); ++place) {
        const Node& node = nodes_[place];
        if (needed[place] && node.kind == Node::Kind::variable && node.arguments[0] == variable) return true;
    }
    return false;
}

ExpressionGraph::Place ExpressionGraph::substituted(Place in, std::size_t variable, Place by) {
    const std::vector<bool> needed = needed_for(std::array{in});
    std::vector<Place> places(in + 1, 0);
    for (Place place = 0; place <= in; ++place) {
        if (!needed[place]) continue;
        const Node node = nodes_[place];
        const bool replaced = node.kind == Node::Kind::variable && node.arguments[0] == variable;
        places[place] = replaced ? by : node.count() == 0 ? place : rebuilt(node, places);
    }
    return places[in];
}

ExpressionGraph::Place ExpressionGraph::rebuilt(const Node& node, std::span<const Place> places) {
    const auto at = [&](std::size_t k) { return places[node.arguments[k]]; };
    switch (node.kind) {
        case Node::Kind::sum:
            return sum(at(0), at(1));
        case Node::Kind::product:
            return product(at(0), at(1));
        case Node::Kind::power:
            return power(at(0), at(1));
        case Node::Kind::function:
            return function(node.function, at(0));
        default:
            return choice(at(0), at(1), at(2), at(3));
    }
}

ExpressionGraph::Place ExpressionGraph::derivative(Place of, std::size_t variable) {
    const std::vector<bool> needed = needed_for(std::array{of});
    std::vector<Place> slopes(of + 1, number(0));
    for (Place place = 0; place <= of; ++place) {
        if (!needed[place]) continue;
        const bool is_variable = nodes_[place].kind == Node::Kind::variable;
        slopes[place] = is_variable ? number(nodes_[place].arguments[0] == variable ? 1 : 0) : slope(place, slopes);
    }
    return slopes[of];
}

ExpressionGraph::Place ExpressionGraph::slope(Place of, std::span<const Place> slopes) {
    const Node node = nodes_[of];
    const auto& [a, b, c, d] = node.arguments;
    switch (node.kind) {
        case Node::Kind::sum:
            return sum(slopes[a], slopes[b]);
        case Node::Kind::product:
            return sum(product(slopes[a], b), product(a, slopes[b]));
        case Node::Kind::power:
            return slope_of_power(node, slopes);
        case Node::Kind::function:
            return slope_of_function(of, slopes[a]);
        case Node::Kind::choice:
            return choice(a, b, slopes[c], slopes[d]);
        default:
            return number(0);
    }
}

/// Of x^p: p x^(p - 1) x', and where p varies x^p ln x p' besides.
ExpressionGraph::Place ExpressionGraph::slope_of_power(const Node& node, std::span<const Place> slopes) {
    const auto [base, exponent] = std::pair(node.arguments[0], node.arguments[1]);
    const Place lower = power(base, difference(exponent, number(1)));
    const Place along = product(product(exponent, lower), slopes[base]);
    if (is_number(slopes[exponent], 0)) return along;
    const Place logarithm = product(power(base, exponent), function(Operation::log, base));
    return sum(along, product(logarithm, slopes[exponent]));
}

ExpressionGraph::Place ExpressionGraph::slope_of_function(Place of, Place inner_slope) {
    const Node node = nodes_[of];
    const Place a = node.arguments[0], square = power(of, number(2));
    switch (node.function) {
        case Operation::exp:
            return product(of, inner_slope);
        case Operation::log:
            return quotient(inner_slope, a);
        case Operation::sin:
            return product(function(Operation::cos, a), inner_slope);
        case Operation::cos:
            return product(product(number(-1), function(Operation::sin, a)), inner_slope);
        case Operation::tan:
            return product(sum(number(1), square), inner_slope);
        default:
            return product(difference(number(1), square), inner_slope);
    }
}

}  // namespace steplab
