#pragma once

#include "core/elementary_numbers.hpp"
#include "core/expression_program.hpp"
#include "core/force_layout.hpp"
#include "core/vector.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// A potential that was written as an expression, and the force that follows from it, as programs. Variables of a pair
/// force: r^2, the masses in the unit of mass, the charges; its result is the factor -V'(r) / r. Of a field: x, y, z,
/// mass, charge; results are the components of the force. Energies and forces are divided by the unit of mass.
struct ExpressionForce {
    ExpressionProgram force, energy;
    bool takes_properties = false;  ///< masses or charges
};

/// The results of a program whose constants are of type T. Not inlined: it is large, and a call of it nothing.
template <class T, std::size_t Results, class N, std::size_t Variables>
[[gnu::noinline]] std::array<N, Results> results_of(const ExpressionProgram& program,
                                                    const std::array<N, Variables>& variables) {
    std::vector<N> slots(program.slots, N(T(0)));
    std::copy(variables.begin(), variables.end(), slots.begin());
    program.set_constants<T>(std::span<N>(slots));
    program.run(std::span<N>(slots));
    return [&]<std::size_t... K>(std::index_sequence<K...>) {
        return std::array<N, Results>{slots[program.results[K]]...};
    }
    (std::make_index_sequence<Results>());
}

/// A pair potential given as an expression. Its energy and factor are those of potential.hpp, its cut-off included.
template <class T>
class ExpressionPotential {
public:
    explicit ExpressionPotential(std::shared_ptr<const ExpressionForce> of) : of_(std::move(of)) {}

    template <class N>
    N energy(const N& distance2, const PairProperties<N>& pair) const {
        return results_of<T, 1>(of_->energy, variables(distance2, pair))[0];
    }
    template <class N>
    N factor(const N& distance2, const PairProperties<N>& pair) const {
        return results_of<T, 1>(of_->force, variables(distance2, pair))[0];
    }
    /// A factor that is a smooth function of r^2 is so at 0 if it is finite there.
    bool jumps_at_contact() const {
        return of_->force.has_roots() || !of_->force.is_smooth() || !std::isfinite(factor(T(0), {1, 1, 1, 1}));
    }

private:
    template <class N>
    static std::array<N, 5> variables(const N& distance2, const PairProperties<N>& pair) {
        return {distance2, pair.first_mass, pair.second_mass, pair.first_charge, pair.second_charge};
    }

    std::shared_ptr<const ExpressionForce> of_;
};

/// The factors of a pair potential given as an expression, many one after the other: in slots that are used again.
/// Keeps a pointer to the program.
template <class T, class N>
class ExpressionFactors {
public:
    explicit ExpressionFactors(const ExpressionProgram& force) : program_(&force), slots_(force.slots, N(T(0))) {
        force.template set_constants<T>(std::span<N>(slots_));
    }
    const N& operator()(const N& distance2, const PairProperties<N>& pair) {
        slots_[0] = distance2, slots_[1] = pair.first_mass, slots_[2] = pair.second_mass;
        slots_[3] = pair.first_charge, slots_[4] = pair.second_charge;
        program_->run(std::span<N>(slots_));
        return slots_[program_->results[0]];
    }

private:
    const ExpressionProgram* program_;
    std::vector<N> slots_;
};

/// The potential of one particle at a position, given as an expression.
template <class T>
class FieldPotential {
public:
    explicit FieldPotential(std::shared_ptr<const ExpressionForce> of) : of_(std::move(of)) {}

    template <class N>
    N energy(const Vector<N>& at, const N& mass, const N& charge) const {
        return results_of<T, 1>(of_->energy, std::array<N, 5>{at.x, at.y, at.z, mass, charge})[0];
    }
    template <class N>
    Vector<N> force(const Vector<N>& at, const N& mass, const N& charge) const {
        const auto [x, y, z] = results_of<T, 3>(of_->force, std::array<N, 5>{at.x, at.y, at.z, mass, charge});
        return {x, y, z};
    }

private:
    std::shared_ptr<const ExpressionForce> of_;
};

}  // namespace steplab
