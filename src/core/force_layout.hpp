#pragma once

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/pair_range.hpp"
#include "core/vector.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace steplab {

struct Approaches;  // core/pair_approach.hpp

/// What a formula may ask of two particles: their masses in the unit of mass, and their charges.
template <class N>
struct PairProperties {
    N first_mass{1}, second_mass{1}, first_charge{0}, second_charge{0};
};

/// The optional members of a layout of forces. Each capability names its members; ForceLayout is satisfied only if
/// exactly the capabilities whose members exist are declared.
struct ForceCapabilities {
    /// `Sweep`, registers_ahead(), sweeps_together, registers_a_turn, bytes_alone: accelerations register by register,
    /// of positions that are read once (methods/engines/sweeps.hpp).
    bool sweeps = false;
    /// sweep<Registers>(positions, sink), most_registers: whole sweeps over scenes small enough to stay in registers.
    bool sweeps_in_registers = false;
    /// sweep_in_turn(positions, sink): whole sweeps particle by particle, for number types with SIMD lanes.
    bool sweeps_in_turn = false;
    /// accelerations_along_x(u, a), and sweeps of positions whose `axes` is 1: where all motion is along x.
    bool along_x = false;
    /// each_acceleration(u, sink): accelerations of all particles, passed to the sink by several threads. The sink
    /// accesses only its own register and does not throw.
    bool hands_out = false;
    /// history(), history(made_at), uncounted_accelerations(u, a): rounding also depends on the history of the run.
    bool history = false;
    /// difference(u, i, j): u_j - u_i to the nearest image, where space is periodic.
    bool periodic = false;
    /// masses(), inverse_mass(i), properties(i, j, kind): particles differ, in mass by the unit in which formulas are.
    /// Formulas take the properties of their pair after e (PairProperties).
    bool masses = false;
    /// place(u, i): accelerations from outside depend on the position. Such an interaction is one of a particle with
    /// itself, i = j, whose formula takes the position instead of e.
    bool fields = false;
    /// damped(), damp(u, v, time), add_damping(u, v, a), each_damping(u, f): forces -D(u) v besides, D symmetric and
    /// linear: of dashpots, and of drag that differs between particles.
    bool damping = false;
    /// range(): how the force between two particles changes with their distance (core/pair_range.hpp).
    bool range = false;
    /// approaches(): the same of any number of pair forces (core/pair_approach.hpp); has_local_fields(),
    /// field_bound(u, v, a, i, from, to): how large the acceleration of particle i by fields that are not polynomials
    /// is at most between two times from now, on its way if its acceleration stays a.
    bool approaches = false;
    /// hold(u, v), held(), each_held(f): the pairs within a cut-off can be held, so that nothing jumps where one
    /// crosses it. f(i, j, cutoff, whether it acts) for every pair that has one.
    bool holds = false;
    /// elastic_bound(u): an upper bound of the elastic energy divided by a particle's mass.
    bool bounds_energy = false;
};

namespace detail {

// The members of each capability.

template <class Force>
concept HasSweeps = requires(const Force& force) {
    typename Force::Sweep;
    { force.registers_ahead() } -> std::convertible_to<std::size_t>;
    { Force::sweeps_together } -> std::convertible_to<std::size_t>;
    { Force::registers_a_turn } -> std::convertible_to<std::size_t>;
    { Force::bytes_alone } -> std::convertible_to<std::size_t>;
};

template <class Force>
concept HasMostRegisters = requires {
    { Force::most_registers } -> std::convertible_to<std::size_t>;
};

/// A visitor of the blocks of damping.
struct AnyDampingVisitor {
    template <class B>
    void operator()(std::size_t, std::size_t, const B&) const {}
};

/// Positions and a sink that every sweep accepts, to test its signature.
struct AnyPositions {};
struct AnySink {
    template <class A>
    void operator()(std::size_t, const A&) const {}
};

template <class Force>
concept HasSweepInTurn = requires(const Force& force) {
    force.sweep_in_turn(AnyPositions{}, AnySink{});
};

template <class Force, class T>
concept HasAlongX = requires(Force& force, const Field<T>& u, Field<T>& a) {
    force.accelerations_along_x(u, a);
};

template <class Force, class T>
concept HasEachAcceleration = requires(Force& force, const Field<T>& u) {
    force.each_acceleration(u, AnySink{});
};

template <class Force, class T>
concept HasHistory = requires(Force& force, const Force& same, const Field<T>& u, Field<T>& a) {
    { same.history() } -> std::same_as<const Field<T>&>;
    force.history(u);
    force.uncounted_accelerations(u, a);
};

template <class Force, class T>
concept HasDifference = requires(const Force& force, const Field<T>& u) {
    { force.difference(u, 0, 0) } -> std::same_as<Vector<T>>;
};

template <class Force, class T>
concept HasMasses = requires(const Force& force) {
    { force.masses() } -> std::convertible_to<const std::vector<T>&>;
    { force.inverse_mass(0) } -> std::same_as<T>;
    { force.properties(0, 0, 0) } -> std::same_as<PairProperties<T>>;
};

template <class Force, class T>
concept HasFields = requires(const Force& force, const Field<T>& u) {
    { force.place(u, 0) } -> std::same_as<Vector<T>>;
};

template <class Force, class T>
concept HasDamping = requires(const Force& force, const Field<T>& u, Field<T>& v) {
    { force.damped() } -> std::same_as<bool>;
    force.damp(u, v, T(1));
    force.add_damping(u, v, v);
    force.each_damping(u, AnyDampingVisitor());
};

template <class Force, class T>
concept HasRange = requires(const Force& force) {
    { force.range() } -> std::convertible_to<std::optional<PairRange<T>>>;
};

template <class Force, class T>
concept HasApproaches = requires(const Force& force, const Field<T>& u) {
    { force.approaches() } -> std::same_as<const Approaches&>;
    { force.has_local_fields() } -> std::same_as<bool>;
    { force.field_bound(u, u, u, 0, 0.0, 1.0) } -> std::same_as<double>;
};

/// A visitor of held pairs.
struct AnyHeldVisitor {
    template <class T>
    void operator()(std::size_t, std::size_t, const T&, bool) const {}
};

template <class Force, class T>
concept HasHold = requires(Force& force, const Force& same, const Field<T>& u) {
    { force.hold(u, u) } -> std::same_as<bool>;
    { same.held() } -> std::convertible_to<const std::vector<bool>&>;
    same.each_held(AnyHeldVisitor());
};

template <class Force, class T>
concept HasElasticBound = requires(const Force& force, const Field<T>& u) {
    { force.elastic_bound(u) } -> std::same_as<T>;
};

/// A visitor of interactions: (i, j, kind) and (i, j).
struct AnyVisitor {
    void operator()(std::size_t, std::size_t, std::size_t) const {}
    void operator()(std::uint32_t, std::uint32_t) const {}
};

}  // namespace detail

/// Forces that can be asked for the masses of particles.
template <class Force>
concept KnowsMasses = requires(const Force& force) {
    force.masses();
};

/// The forces as a method sees them: accelerations, and the declared capabilities.
template <class Force, class T>
concept ForceEngine = requires(Force& force, const Field<T>& u, Field<T>& a) {
    { Force::capabilities } -> std::convertible_to<ForceCapabilities>;
    force.accelerations(u, a);
};

/// A layout of forces in number type T (models/forces/layouts.hpp). It describes its individual forces, for methods
/// that need more than their sum:
///   coupling()                    which particles act on which
///   formulas()                    the kinds of interaction: each computes from e = u_j - u_i, in any number type, the
///                                 acceleration of i; that of j is its opposite
///   each_interaction(u, f)        f(i, j, kind) once for every pair that interacts at the displacements u, kind after
///                                 kind, always in the same order
///   external(i)                   the acceleration that is not caused by other particles
///   moves(i)                      false for fixed particles
///   passing_pairs(from, to, f)    f(i, j) for pairs that pass each other between two positions, where forces jump
///   separation(u, i, j)           the vector from particle i to particle j
/// and declares exactly its capabilities.
template <class Force, class T>
concept ForceLayout = ForceEngine<Force, T> && requires(Force& force, const Force& same, const Field<T>& u) {
    { same.coupling() } -> std::same_as<Coupling>;
    same.formulas();
    force.each_interaction(u, detail::AnyVisitor());
    { same.external(0) } -> std::same_as<Vector<T>>;
    { same.moves(0) } -> std::same_as<bool>;
    force.passing_pairs(u, u, detail::AnyVisitor());
    { same.separation(u, 0, 0) } -> std::same_as<Vector<T>>;
} && Force::capabilities.sweeps == detail::HasSweeps<Force>&& Force::capabilities.sweeps_in_registers ==
    detail::HasMostRegisters<Force>&& Force::capabilities.sweeps_in_turn ==
    detail::HasSweepInTurn<Force>&& Force::capabilities.along_x ==
    detail::HasAlongX<Force, T>&& Force::capabilities.hands_out ==
    detail::HasEachAcceleration<Force, T>&& Force::capabilities.history ==
    detail::HasHistory<Force, T>&& Force::capabilities.periodic ==
    detail::HasDifference<Force, T>&& Force::capabilities.masses ==
    detail::HasMasses<Force, T>&& Force::capabilities.fields ==
    detail::HasFields<Force, T>&& Force::capabilities.damping ==
    detail::HasDamping<Force, T>&& Force::capabilities.range ==
    detail::HasRange<Force, T>&& Force::capabilities.approaches ==
    detail::HasApproaches<Force, T>&& Force::capabilities.holds ==
    detail::HasHold<Force, T>&& Force::capabilities.bounds_energy == detail::HasElasticBound<Force, T>;

}  // namespace steplab
