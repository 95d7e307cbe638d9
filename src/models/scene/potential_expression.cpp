#include "models/scene/potential_expression.hpp"

#include "core/error.hpp"
#include "core/expression_graph.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace steplab {

namespace {

using Place = ExpressionGraph::Place;

constexpr std::array<std::string_view, 5> pair_variables{"r", "m1", "m2", "q1", "q2"};
constexpr std::array<std::string_view, 5> field_variables{"x", "y", "z", "m", "q"};

/// The value of a name that is no variable.
template <class Term>
double value_of(const Term& term, const std::string& name) {
    if (const auto value = term.values.find(name); value != term.values.end()) return value->second.value;
    if (const auto value = term.parameters.find(name); value != term.parameters.end()) return value->second;
    throw UsageError(fmt::format("the potential names '{}', which has no value", shown(name)));
}

/// The potential of a term in a graph, its variables being these nodes.
template <class Term>
Place added(ExpressionGraph& graph, const Term& term, std::span<const std::string_view> names,
            const std::array<Place, 5>& variables) {
    const Expression expression(term.potential);
    std::vector<Place> places;
    for (const std::string& name : expression.names()) {
        const auto variable = std::find(names.begin(), names.end(), name);
        places.push_back(variable == names.end() ? graph.number(value_of(term, name))
                                                 : variables[static_cast<std::size_t>(variable - names.begin())]);
    }
    return graph.add(expression, places);
}

ExpressionProgram program_of(const ExpressionGraph& graph, std::span<const Place> results) {
    ExpressionProgram program = graph.program(results, 5);
    constexpr std::size_t most = ExpressionProgram::most_operations;
    if (program.steps.size() > most)
        throw UsageError(
            fmt::format("the potential needs {} operations; there may be at most {}", program.steps.size(), most));
    return program;
}

/// V(r) - V(c) - (r - c) V'(c).
Place shifted(ExpressionGraph& graph, Place potential, Place distance, double cutoff) {
    const auto at_cutoff = [&](Place of) { return graph.substituted(of, 0, graph.number(cutoff * cutoff)); };
    const Place slope = graph.product(graph.number(2 * cutoff), at_cutoff(graph.derivative(potential, 0)));
    const Place beyond = graph.product(graph.difference(distance, graph.number(cutoff)), slope);
    return graph.difference(graph.difference(potential, at_cutoff(potential)), beyond);
}

}  // namespace

std::span<const std::string_view> variables_of_pairs() { return pair_variables; }
std::span<const std::string_view> variables_of_fields() { return field_variables; }

/// Differentiated by r^2, a potential of even powers of r needs no root: V'(r) / r is twice that derivative.
std::shared_ptr<const ExpressionForce> expression_of(const PairTerm& term, double unit) {
    ExpressionGraph graph;
    const Place distance = graph.square_root(graph.variable(0));
    const auto mass = [&](std::size_t index) { return graph.product(graph.number(unit), graph.variable(index)); };
    Place potential =
        added(graph, term, pair_variables, {distance, mass(1), mass(2), graph.variable(3), graph.variable(4)});
    if (term.cutoff) potential = shifted(graph, potential, distance, term.cutoff->value);
    const Place energy = graph.product(graph.number(1 / unit), potential);
    const Place factor = graph.product(graph.number(-2), graph.derivative(energy, 0));
    auto force = std::make_shared<ExpressionForce>();
    force->energy = program_of(graph, std::array{energy});
    force->force = program_of(graph, std::array{factor});
    for (std::size_t k = 1; k < 5; ++k) force->takes_properties = force->takes_properties || graph.depends(energy, k);
    return force;
}

ComposedField expression_of(const FieldTerm& term, double unit) {
    ExpressionGraph graph;
    const Place mass = graph.product(graph.number(unit), graph.variable(3));
    const Place potential = added(graph, term, field_variables,
                                  {graph.variable(0), graph.variable(1), graph.variable(2), mass, graph.variable(4)});
    const Place energy = graph.product(graph.number(1 / unit), potential);
    std::array<Place, 3> pull{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        pull[axis] = graph.product(graph.number(-1), graph.derivative(energy, axis));
    auto force = std::make_shared<ExpressionForce>();
    force->energy = program_of(graph, std::array{energy});
    force->force = program_of(graph, pull);
    force->takes_properties = graph.depends(energy, 3) || graph.depends(energy, 4);
    const Place none = graph.number(0);
    return {.expression = std::move(force), .along_y = pull[1] != none, .along_z = pull[2] != none, .particles = {}};
}

}  // namespace steplab
