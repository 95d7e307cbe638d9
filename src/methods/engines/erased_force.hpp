#pragma once

#include "core/block.hpp"
#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "core/pair_approach.hpp"
#include "core/polymorphic.hpp"
#include "core/stages.hpp"
#include "core/vector.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/series_forces.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// Accelerations at all stages of a step at once, whatever the layout of forces.
template <class T>
class ErasedStageForce {
public:
    class Face {
    public:
        virtual ~Face() = default;
        virtual std::unique_ptr<Face> copy() const = 0;
        virtual void accelerations(const Field<Stages<T>>& x, Field<Stages<T>>& a) = 0;
        virtual void hold(const std::vector<bool>& acting) = 0;
        virtual void accelerations_along_x(const Field<Stages<T>>& x, Field<Stages<T>>& a) = 0;
    };

    static constexpr ForceCapabilities capabilities{.along_x = true};

    explicit ErasedStageForce(std::unique_ptr<Face> face) : face_(std::move(face)) {}

    void accelerations(const Field<Stages<T>>& x, Field<Stages<T>>& a) { face_->accelerations(x, a); }
    /// Holds the pairs that another engine of the same forces holds; none if it holds none.
    void hold(const std::vector<bool>& acting) { face_->hold(acting); }
    void accelerations_along_x(const Field<Stages<T>>& x, Field<Stages<T>>& a) { face_->accelerations_along_x(x, a); }

private:
    Polymorphic<Face> face_;
};

/// The forces of a scene whatever their layout, at the cost of a virtual call per evaluation: methods whose steps are
/// long are compiled once on it instead of once for each layout. T is float or double.
template <class T>
class ErasedForce {
public:
    using PairVisitor = std::function<void(std::uint32_t, std::uint32_t)>;
    using InteractionVisitor = std::function<void(std::size_t, std::size_t, std::size_t)>;
    using RegisterVisitor = std::function<void(std::size_t, const Vector<Lanes<T>>&)>;
    using HeldVisitor = std::function<void(std::size_t, std::size_t, T, bool)>;
    using BlockVisitor = std::function<void(std::size_t, std::size_t, const Block<T>&)>;

    /// What a layout does here; the members are those of ForceLayout and ForceCapabilities.
    class Face {
    public:
        virtual ~Face() = default;
        virtual std::unique_ptr<Face> copy() const = 0;

        virtual void accelerations(const Field<T>& x, Field<T>& a) = 0;
        virtual void accelerations_along_x(const Field<T>& x, Field<T>& a) = 0;
        virtual void uncounted_accelerations(const Field<T>& x, Field<T>& a) = 0;
        virtual void each_acceleration(const Field<T>& x, const RegisterVisitor& f) = 0;
        virtual std::unique_ptr<typename ErasedStageForce<T>::Face> at_stages() const = 0;

        virtual Coupling coupling() const = 0;
        virtual bool moves(std::size_t particle) const = 0;
        virtual Vector<T> separation(const Field<T>& x, std::size_t i, std::size_t j) const = 0;
        virtual void passing_pairs(const Field<T>& from, const Field<T>& to, const PairVisitor& f) = 0;
        virtual void each_interaction(const Field<T>& x, const InteractionVisitor& f) = 0;
        virtual void each_block(const Field<T>& x, const BlockVisitor& f) = 0;
        virtual std::unique_ptr<SeriesForces<T>> series(const State<T>& state, std::size_t length) = 0;

        /// In the unit of mass; empty where all are 1.
        virtual const std::vector<T>& masses() const = 0;

        virtual bool damped() const = 0;
        virtual void damp(const Field<T>& x, Field<T>& v, T time) const = 0;
        virtual void add_damping(const Field<T>& x, const Field<T>& v, Field<T>& a) const = 0;
        virtual void each_damping(const Field<T>& x, const BlockVisitor& f) const = 0;

        /// None where the layout has none.
        virtual std::optional<PairRange<T>> range() const = 0;
        virtual const Approaches& approaches() const = 0;
        virtual bool has_local_fields() const = 0;
        virtual double field_bound(const Field<T>& x, const Field<T>& v, const Field<T>& a, std::size_t i, double from,
                                   double to) const = 0;
        virtual bool hold(const Field<T>& x, const Field<T>& v) = 0;
        virtual const std::vector<bool>& held() const = 0;
        virtual void each_held(const HeldVisitor& f) const = 0;

        virtual std::size_t moving_axes(const State<T>& state) const = 0;
        virtual std::size_t axes_of_steps(const State<T>& state) const = 0;

        /// Empty where the layout has none.
        virtual const Field<T>& history() const = 0;
        virtual void history(const Field<T>& made_at) = 0;
    };

    static constexpr ForceCapabilities capabilities{.along_x = true,
                                                    .hands_out = true,
                                                    .history = true,
                                                    .damping = true,
                                                    .range = true,
                                                    .approaches = true,
                                                    .holds = true};

    explicit ErasedForce(std::unique_ptr<Face> face) : face_(std::move(face)) {}

    void accelerations(const Field<T>& x, Field<T>& a) { face_->accelerations(x, a); }
    void accelerations_along_x(const Field<T>& x, Field<T>& a) { face_->accelerations_along_x(x, a); }
    void uncounted_accelerations(const Field<T>& x, Field<T>& a) { face_->uncounted_accelerations(x, a); }
    template <class Sink>
    void each_acceleration(const Field<T>& x, Sink sink) {
        face_->each_acceleration(x, std::ref(sink));
    }
    template <class N>
    requires std::is_same_v<N, Stages<T>> ErasedStageForce<T> in()
    const { return ErasedStageForce<T>(face_->at_stages()); }

    Coupling coupling() const { return face_->coupling(); }
    bool moves(std::size_t particle) const { return face_->moves(particle); }
    Vector<T> separation(const Field<T>& x, std::size_t i, std::size_t j) const { return face_->separation(x, i, j); }
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) {
        face_->passing_pairs(from, to, std::ref(f));
    }
    template <class F>
    void each_interaction(const Field<T>& x, F f) {
        face_->each_interaction(x, std::ref(f));
    }

    /// Of each particle in the unit of mass; empty where all are 1.
    const std::vector<T>& masses() const { return face_->masses(); }

    bool damped() const { return face_->damped(); }
    void damp(const Field<T>& x, Field<T>& v, T time) const { face_->damp(x, v, time); }
    void add_damping(const Field<T>& x, const Field<T>& v, Field<T>& a) const { face_->add_damping(x, v, a); }
    template <class F>
    void each_damping(const Field<T>& x, F f) const {
        face_->each_damping(x, std::ref(f));
    }

    std::optional<PairRange<T>> range() const { return face_->range(); }
    const Approaches& approaches() const { return face_->approaches(); }
    bool has_local_fields() const { return face_->has_local_fields(); }
    double field_bound(const Field<T>& x, const Field<T>& v, const Field<T>& a, std::size_t i, double from,
                       double to) const {
        return face_->field_bound(x, v, a, i, from, to);
    }
    /// False where the layout holds no pairs.
    bool hold(const Field<T>& x, const Field<T>& v) { return face_->hold(x, v); }
    const std::vector<bool>& held() const { return face_->held(); }
    template <class F>
    void each_held(F f) const {
        face_->each_held(std::ref(f));
    }

    const Field<T>& history() const { return face_->history(); }
    void history(const Field<T>& made_at) { face_->history(made_at); }

    // What other layouts have as functions beside them.

    template <class F>
    friend void each_block(ErasedForce& force, const Field<T>& x, F f) {
        force.face_->each_block(x, std::ref(f));
    }
    friend std::unique_ptr<SeriesForces<T>> series_forces(ErasedForce& force, const State<T>& state,
                                                          std::size_t length) {
        return force.face_->series(state, length);
    }
    friend std::size_t moving_axes(const ErasedForce& force, const State<T>& state) {
        return force.face_->moving_axes(state);
    }
    friend std::size_t axes_of_steps(const ErasedForce& force, const State<T>& state) {
        return force.face_->axes_of_steps(state);
    }

private:
    Polymorphic<Face> face_;
};

}  // namespace steplab
