#include "core/elementary.hpp"
#include "core/expression_graph.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace steplab {

/// Makes the operations of a program: powers become products and roots, and slots are used again.
class ExpressionGraph::Lowering {
public:
    using Step = ExpressionProgram::Step;
    using Made = ExpressionProgram::Operation;

    Lowering(const ExpressionGraph& graph, std::size_t variables) : graph_(graph) { program_.variables = variables; }

    ExpressionProgram program(std::span<const Place> results) {
        const std::vector<bool> needed = graph_.needed_for(results);
        std::vector<Value> values(graph_.nodes_.size());
        for (std::size_t place = 0; place < values.size(); ++place) {
            if (needed[place]) values[place] = lowered(graph_.nodes_[place], values);
        }
        std::vector<Value> last;
        for (const Place result : results) last.push_back(values[result]);
        assign_slots(last);
        return std::move(program_);
    }

private:
    /// A variable, a constant, or the result of a step.
    struct Value {
        enum class Kind : std::uint8_t { variable, constant, step };
        Kind kind = Kind::variable;
        std::uint32_t index = 0;

        std::uint64_t key() const { return std::uint64_t(kind) << 32 | index; }
    };
    struct Planned {
        Made operation;
        std::array<Value, 4> operands;
        std::size_t count;

        std::array<std::uint64_t, 5> key() const {
            return {static_cast<std::uint64_t>(operation), operands[0].key(), operands[1].key(), operands[2].key(),
                    operands[3].key()};
        }
    };

    Value constant(double number) {
        auto& all = program_.constants;
        const auto same = [number](double known) {
            return std::bit_cast<std::uint64_t>(known) == std::bit_cast<std::uint64_t>(number);
        };
        const auto found = std::find_if(all.begin(), all.end(), same);
        const auto index = static_cast<std::uint32_t>(found - all.begin());
        if (found == all.end()) all.push_back(number);
        return {Value::Kind::constant, index};
    }

    Value step(Made operation, std::initializer_list<Value> operands) {
        Planned planned{operation, {}, operands.size()};
        std::copy(operands.begin(), operands.end(), planned.operands.begin());
        const auto [known, is_new] = known_.try_emplace(planned.key(), static_cast<std::uint32_t>(planned_.size()));
        if (is_new) planned_.push_back(planned);
        return {Value::Kind::step, known->second};
    }

    Value lowered(const Node& node, const std::vector<Value>& values) {
        using Kind = Node::Kind;
        const auto at = [&](std::size_t k) { return values[node.arguments[k]]; };
        switch (node.kind) {
            case Kind::number:
                return constant(node.value);
            case Kind::variable:
                return {Value::Kind::variable, node.arguments[0]};
            case Kind::sum:
                return lowered_sum(node, values);
            case Kind::product:
                if (graph_.is_number(node.arguments[0], -1)) return negative(at(1));
                return step(Made::multiply, {at(0), at(1)});
            case Kind::power:
                return lowered_power(node, at(0), at(1));
            case Kind::function:
                return step(made(node.function), {at(0)});
            default:
                return step(Made::choose, {at(0), at(1), at(2), at(3)});
        }
    }

    Value negative(Value a) { return step(Made::negate, {a, constant(0)}); }
    Value inverse(Value a) { return step(Made::invert, {a, constant(1)}); }

    Value lowered_sum(const Node& node, const std::vector<Value>& values) {
        const auto [a, b] = std::pair(node.arguments[0], node.arguments[1]);
        for (const auto& [first, second] : {std::pair(a, b), std::pair(b, a)}) {
            const Node& part = graph_.nodes_[second];
            const bool negated = part.kind == Node::Kind::product && graph_.is_number(part.arguments[0], -1);
            if (negated) return step(Made::subtract, {values[first], values[part.arguments[1]]});
        }
        return step(Made::add, {values[a], values[b]});
    }

    /// x^n by repeated multiplication, with roots x^(n + 1/2) and x^(n + 1/4), which powers of a distance are of its
    /// square; of negative exponents of the inverse.
    Value lowered_power(const Node& node, Value base, Value exponent) {
        constexpr double most = 1024;
        const bool known = graph_.is_number(node.arguments[1]);
        const double p = known ? graph_.nodes_[node.arguments[1]].value : 0;
        if (!known || !is_whole(4 * p) || std::abs(p) > most) return step(Made::power, {base, exponent});
        if (is_whole(p)) return whole_power(p < 0 ? inverse(base) : base, static_cast<unsigned>(std::abs(p)));
        if (!is_whole(2 * p)) return root_power(step(Made::sqrt, {base}), 2 * p);
        return root_power(base, p);
    }

    /// x^(n + 1/2).
    Value root_power(Value base, double p) {
        const Value root = step(Made::sqrt, {base});
        if (p < 0) return whole_power(inverse(root), static_cast<unsigned>(-2 * p));
        if (p == 0.5) return root;
        return step(Made::multiply, {whole_power(base, static_cast<unsigned>(p)), root});
    }

    Value whole_power(Value base, unsigned exponent) {
        if (exponent == 1) return base;
        const Value half = whole_power(base, exponent / 2), square = step(Made::multiply, {half, half});
        return exponent % 2 == 0 ? square : step(Made::multiply, {square, base});
    }

    static Made made(Operation function) {
        switch (function) {
            case Operation::exp:
                return Made::exp;
            case Operation::log:
                return Made::log;
            case Operation::sin:
                return Made::sin;
            case Operation::cos:
                return Made::cos;
            case Operation::tan:
                return Made::tan;
            default:
                return Made::tanh;
        }
    }

    /// A step's slot is free again after the last step that reads it.
    void assign_slots(const std::vector<Value>& results) {
        const std::size_t never = planned_.size();
        std::vector<std::size_t> last_use(planned_.size());
        for (std::size_t s = 0; s < planned_.size(); ++s) {
            for (std::size_t k = 0; k < planned_[s].count; ++k) {
                const Value operand = planned_[s].operands[k];
                if (operand.kind == Value::Kind::step) last_use[operand.index] = s;
            }
        }
        for (const Value result : results) {
            if (result.kind == Value::Kind::step) last_use[result.index] = never;
        }
        program_.slots = program_.variables + program_.constants.size();
        slot_of_step_.resize(planned_.size());
        for (std::size_t s = 0; s < planned_.size(); ++s) add_step(s, last_use);
        for (const Value result : results) program_.results.push_back(slot(result));
    }

    void add_step(std::size_t s, const std::vector<std::size_t>& last_use) {
        const Planned& planned = planned_[s];
        Step step{.operation = planned.operation};
        for (std::size_t k = 0; k < planned.count; ++k) {
            const Value operand = planned.operands[k];
            step.operands[k] = slot(operand);
            const bool done = operand.kind == Value::Kind::step && last_use[operand.index] == s;
            const bool again = std::find(free_.begin(), free_.end(), step.operands[k]) != free_.end();
            if (done && !again) free_.push_back(step.operands[k]);
        }
        if (free_.empty()) free_.push_back(static_cast<std::uint32_t>(program_.slots++));
        step.target = slot_of_step_[s] = free_.back();
        free_.pop_back();
        program_.steps.push_back(step);
    }

    std::uint32_t slot(Value value) const {
        if (value.kind == Value::Kind::step) return slot_of_step_[value.index];
        const std::size_t before = value.kind == Value::Kind::constant ? program_.variables : 0;
        return static_cast<std::uint32_t>(before) + value.index;
    }

    const ExpressionGraph& graph_;
    ExpressionProgram program_;
    std::vector<Planned> planned_;
    std::map<std::array<std::uint64_t, 5>, std::uint32_t> known_;
    std::vector<std::uint32_t> slot_of_step_, free_;
};

ExpressionProgram ExpressionGraph::program(std::span<const Place> results, std::size_t variables) const {
    return Lowering(*this, variables).program(results);
}

}  // namespace steplab
