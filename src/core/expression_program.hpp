#pragma once

#include "core/elementary.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

/// A few operations on numbered slots, which run in any number type: variables come first, then constants, then what is
/// computed. Made by ExpressionGraph.
class ExpressionProgram {
public:
    /// Simplified expressions of more operations are refused.
    static constexpr std::size_t most_operations = 200;

    enum class Operation : std::uint8_t {
        add,
        subtract,
        multiply,
        invert,
        negate,
        exp,
        log,
        sqrt,
        sin,
        cos,
        tan,
        tanh,
        power,
        choose  ///< the third where the first is less than the second, else the fourth
    };
    struct Step {
        Operation operation;
        std::uint32_t target = 0;
        std::array<std::uint32_t, 4> operands{};
    };

    std::size_t variables = 0;
    std::vector<double> constants;
    std::vector<Step> steps;
    std::size_t slots = 0;
    std::vector<std::uint32_t> results;  ///< their slots

    /// False if it chooses between results, as min, max and abs do.
    bool is_smooth() const {
        return std::none_of(steps.begin(), steps.end(),
                            [](const Step& step) { return step.operation == Operation::choose; });
    }

    /// True if it has roots or powers, which end where their argument is 0.
    bool has_roots() const {
        return std::any_of(steps.begin(), steps.end(), [](const Step& step) {
            return step.operation == Operation::sqrt || step.operation == Operation::power;
        });
    }

    /// True if it only adds and multiplies: what it does anywhere is seen from everywhere.
    bool is_polynomial() const {
        return std::all_of(steps.begin(), steps.end(), [](const Step& step) {
            return step.operation == Operation::add || step.operation == Operation::subtract ||
                   step.operation == Operation::multiply || step.operation == Operation::negate;
        });
    }

    /// Sets the constants, T being the type of single numbers.
    template <class T, class N>
    void set_constants(std::span<N> in) const {
        for (std::size_t k = 0; k < constants.size(); ++k) in[variables + k] = N(static_cast<T>(constants[k]));
    }
    /// Computes the results of slots in which variables and constants are set.
    template <class N>
    void run(std::span<N> in) const {
        for (const Step& step : steps) in[step.target] = computed(step, in);
    }

private:
    template <class N>
    static N computed(const Step& step, std::span<N> in) {
        const auto& [a, b, c, d] = step.operands;
        switch (step.operation) {
            case Operation::add:
                return in[a] + in[b];
            case Operation::subtract:
                return in[a] - in[b];
            case Operation::multiply:
                return in[a] * in[b];
            case Operation::invert:
                return in[b] / in[a];
            case Operation::negate:
                return in[b] - in[a];
            case Operation::exp:
                return exponential(in[a]);
            case Operation::log:
                return natural_logarithm(in[a]);
            case Operation::sqrt:
                return square_root(in[a]);
            case Operation::sin:
                return sine(in[a]);
            case Operation::cos:
                return cosine(in[a]);
            case Operation::tan:
                return tangent(in[a]);
            case Operation::tanh:
                return hyperbolic_tangent(in[a]);
            case Operation::power:
                return general_power(in[a], in[b]);
            default:
                return where(in[a] < in[b], in[c], in[d]);
        }
    }
};

}  // namespace steplab
