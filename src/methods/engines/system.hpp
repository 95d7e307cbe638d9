#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/pair_approach.hpp"
#include "core/pair_range.hpp"
#include "core/stages.hpp"
#include "methods/engines/sweeps.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace steplab {

namespace detail {

/// The engine of a force at the stages of a step, in SIMD lanes. Runs that are in lanes themselves have none, nor has a
/// force that is in one number type only (Plain).
template <class T, class Force>
struct AtStages {
    struct Type {};
};
template <class T, class Force>
requires(!HasLanes<T> && requires(const Force& force) { force.template in<Stages<T>>(); }) struct AtStages<T, Force> {
    using Type = decltype(std::declval<const Force&>().template in<Stages<T>>());
};

}  // namespace detail

/// What a method integrates: x'' = a(x) - gamma v, in steps of dt. Force is the layout's engine; it is known at compile
/// time, so nothing is called through a pointer inside a step.
template <class T, ForceEngine<T> Force>
class System {
public:
    System(Force force, T drag, T dt) : force_(std::move(force)), drag_(drag), dt_(dt) {}

    /// a(x) of all particles, drag not included: one evaluation.
    void accelerations(const Field<T>& x, Field<T>& a) {
        ++evaluations_;
        if constexpr (Force::capabilities.along_x) {
            if (axes_ == 1) return force_.accelerations_along_x(x, a);
        }
        force_.accelerations(x, a);
    }

    /// The same for output: not counted.
    void uncounted_accelerations(const Field<T>& x, Field<T>& a) const { accelerations_for_output(force_, x, a); }

    /// Takes `steps` steps that consist of `parts` sweeps each over the particles, whose quantities are `fields`
    /// (sweeps.hpp); an evaluation each.
    template <std::size_t Quantities, class Stage>
    void sweep(const std::array<Field<T>*, Quantities>& fields, std::uint64_t steps, std::size_t parts, Stage stage) {
        sweeps_.run(force_, fields, steps, parts, stage, axes_);
        evaluations_ += steps * parts;
    }

    /// Calls sink(r, a) with the accelerations of every register r of particles, for output: not counted.
    template <class Sink>
    void emit(const Field<T>& x, Sink sink) const {
        emit_accelerations(force_, x, sink);
    }

    /// Calls f(i, j) for the pairs of particles whose distance vector turns by a right angle or more on the way between
    /// two positions, if they act on each other with a force that jumps where they coincide.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) const {
        force_.passing_pairs(from, to, f);
    }
    /// The vector from particle i to particle j at displacements x.
    auto separation(const Field<T>& x, std::size_t i, std::size_t j) const { return force_.separation(x, i, j); }

    /// The same, and calls f(i, j, block) for every pair of particles that interact: block is how the acceleration of i
    /// changes with the position of j (and of j with that of i), exactly. One evaluation.
    template <class F>
    void accelerations_and_blocks(const Field<T>& x, Field<T>& a, F f) {
        accelerations(x, a);
        each_block(force_, x, f);  // of the force's own header
    }

    /// What the force is made of: see ForceLayout.
    Force& force() { return force_; }
    const Force& force() const { return force_; }
    /// For methods that compute accelerations in ways of their own.
    void count_evaluations(std::uint64_t computed) { evaluations_ += computed; }

    /// How the force between two particles changes with their distance; none where there is no such force.
    std::optional<PairRange<T>> range() const {
        if constexpr (Force::capabilities.range) return force_.range();
        return std::nullopt;
    }
    /// The same of the forces of composed scenes; empty where there are none.
    const Approaches& approaches() const {
        static const Approaches none;
        if constexpr (Force::capabilities.approaches) return force_.approaches();
        return none;
    }
    /// Whether fields act that may be felt at some places alone, and how large the acceleration of a particle by them
    /// is at most between two times from now, on its way if its acceleration stays a.
    bool has_local_fields() const {
        if constexpr (Force::capabilities.approaches) return force_.has_local_fields();
        return false;
    }
    double field_bound(const Field<T>& x, const Field<T>& v, const Field<T>& a, std::size_t i, double from,
                       double to) const {
        if constexpr (Force::capabilities.approaches) return force_.field_bound(x, v, a, i, from, to);
        return 0;
    }
    /// From now on those pairs act on each other that do at x and v (NearPairs::hold()): until the next call nothing
    /// jumps where a pair crosses the cut-off. True if they are others than before; false where no pairs are held.
    /// To be called where a step begins, and so no part of the internal state.
    bool hold(const Field<T>& x, const Field<T>& v) const {
        if constexpr (Force::capabilities.holds) {
            if (!force_.hold(x, v)) return false;
            hold_at_stages();
            return true;
        }
        return false;
    }
    /// Whether each pair that has a cut-off acts; empty where no pairs are held.
    const std::vector<bool>& held() const {
        static const std::vector<bool> none;
        if constexpr (Force::capabilities.holds) return force_.held();
        return none;
    }
    /// Calls f(i, j, cutoff, acts) for every pair that has a cut-off; to be called where pairs are held.
    template <class F>
    void each_held(F f) const {
        if constexpr (Force::capabilities.holds) force_.each_held(f);
    }

    /// a(x) at the eight stages of a step at once: eight evaluations. With `axes` 1 all moves along x alone; the rest
    /// of `a` may be left as it is.
    void accelerations(const Field<Stages<T>>& x, Field<Stages<T>>& a, std::size_t axes = 3) {
        if (!force_at_stages_) {
            force_at_stages_.emplace(force_.template in<Stages<T>>());
            hold_at_stages();
        }
        evaluations_ += stage_count;
        if constexpr (Force::capabilities.along_x) {
            if (axes == 1) return force_at_stages_->accelerations_along_x(x, a);
        }
        force_at_stages_->accelerations(x, a);
    }

    /// The axes along which something moves: with 1, all fields that the method hands out are zero along y and z, and
    /// stay so (moving_axes.hpp).
    std::size_t axes() const { return axes_; }
    void axes(std::size_t count) { axes_ = count; }

    T drag() const { return drag_; }

    static constexpr bool can_be_damped = Force::capabilities.damping;
    /// True if forces -D(x) v act besides the drag: dashpots, or drag that differs between particles.
    bool damped() const {
        if constexpr (Force::capabilities.damping) return force_.damped();
        return false;
    }
    /// v by the flow of v' = -D(x) v over a time: symmetric, of order 2 in it; exact where D is diagonal.
    void damp(const Field<T>& x, Field<T>& v, T time) const {
        if constexpr (Force::capabilities.damping) force_.damp(x, v, time);
    }
    /// a -= D(x) v.
    void add_damping(const Field<T>& x, const Field<T>& v, Field<T>& a) const {
        if constexpr (Force::capabilities.damping) force_.add_damping(x, v, a);
    }
    /// Calls f(i, j, block) for the parts of D times the masses: block in the diagonal of i and of j and its opposite
    /// beside it, with i = j in the diagonal alone.
    template <class F>
    void each_damping(const Field<T>& x, F f) const {
        if constexpr (Force::capabilities.damping) force_.each_damping(x, f);
    }
    T dt() const { return dt_; }
    std::uint64_t evaluations() const { return evaluations_; }
    void evaluations(std::uint64_t count) { evaluations_ = count; }

private:
    void hold_at_stages() const {
        if constexpr (Force::capabilities.holds) {
            if (force_at_stages_) force_at_stages_->hold(force_.held());
        }
    }

    /// Its memory is scratch, but for a history() on which accelerations hang beside positions.
    mutable Force force_;
    mutable std::optional<typename detail::AtStages<T, Force>::Type> force_at_stages_;  ///< once asked for
    Sweeps<T, Force> sweeps_;
    T drag_;
    T dt_;
    std::size_t axes_ = 3;
    std::uint64_t evaluations_ = 0;
};

}  // namespace steplab
