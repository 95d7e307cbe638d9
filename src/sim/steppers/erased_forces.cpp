#include "sim/steppers/erased_forces.hpp"

#include "methods/engines/sweeps.hpp"
#include "models/forces/layouts.hpp"

#include <optional>
#include <variant>
#include <vector>

// Every layout behind the face of ErasedForce: compiled once for all methods of long steps, in each instruction set.

namespace steplab {

namespace {

template <class T, class Force>
class StageFace final : public ErasedStageForce<T>::Face {
public:
    using Face = typename ErasedStageForce<T>::Face;
    using AtStages = Field<Stages<T>>;

    explicit StageFace(Force force) : force_(std::move(force)) {}
    std::unique_ptr<Face> copy() const override { return std::make_unique<StageFace>(*this); }
    void accelerations(const AtStages& x, AtStages& a) override { force_.accelerations(x, a); }
    void accelerations_along_x(const AtStages& x, AtStages& a) override {
        if constexpr (Force::capabilities.along_x) {
            force_.accelerations_along_x(x, a);
        } else {
            force_.accelerations(x, a);
        }
    }

    void hold(const std::vector<bool>& acting) override {
        if constexpr (Force::capabilities.holds) force_.hold(acting);
    }

private:
    Force force_;
};

template <class T, class Force>
class ForceFace final : public ErasedForce<T>::Face {
public:
    using Erased = ErasedForce<T>;
    using Face = typename Erased::Face;

    explicit ForceFace(Force force) : force_(std::move(force)) {}
    std::unique_ptr<Face> copy() const override { return std::make_unique<ForceFace>(*this); }

    void accelerations(const Field<T>& x, Field<T>& a) override { force_.accelerations(x, a); }
    void accelerations_along_x(const Field<T>& x, Field<T>& a) override {
        if constexpr (Force::capabilities.along_x) {
            force_.accelerations_along_x(x, a);
        } else {
            force_.accelerations(x, a);
        }
    }
    void uncounted_accelerations(const Field<T>& x, Field<T>& a) override { accelerations_for_output(force_, x, a); }
    void each_acceleration(const Field<T>& x, const typename Erased::RegisterVisitor& f) override {
        if constexpr (Force::capabilities.hands_out) {
            force_.each_acceleration(x, std::cref(f));
        } else {
            if (accelerations_.count() != x.count()) accelerations_ = Field<T>(x.count());
            force_.accelerations(x, accelerations_);
            const FieldLanes<const T> a(accelerations_);
            for (std::size_t r = 0; r < (x.count() + Lanes<T>::count - 1) / Lanes<T>::count; ++r) f(r, a.get(r));
        }
    }
    std::unique_ptr<typename ErasedStageForce<T>::Face> at_stages() const override {
        auto force = force_.template in<Stages<T>>();
        return std::make_unique<StageFace<T, decltype(force)>>(std::move(force));
    }

    Coupling coupling() const override { return force_.coupling(); }
    bool moves(std::size_t particle) const override { return force_.moves(particle); }
    Vector<T> separation(const Field<T>& x, std::size_t i, std::size_t j) const override {
        return force_.separation(x, i, j);
    }
    void passing_pairs(const Field<T>& from, const Field<T>& to, const typename Erased::PairVisitor& f) override {
        force_.passing_pairs(from, to, std::cref(f));
    }
    void each_interaction(const Field<T>& x, const typename Erased::InteractionVisitor& f) override {
        force_.each_interaction(x, std::cref(f));
    }
    void each_block(const Field<T>& x, const typename Erased::BlockVisitor& f) override {
        steplab::each_block(force_, x, std::cref(f));
    }
    std::unique_ptr<SeriesForces<T>> series(const State<T>& state, std::size_t length) override {
        return series_forces(force_, state, length);
    }

    const std::vector<T>& masses() const override {
        if constexpr (Force::capabilities.masses) {
            return force_.masses();
        } else {
            return no_masses_;
        }
    }

    bool damped() const override {
        if constexpr (Force::capabilities.damping) return force_.damped();
        return false;
    }
    void damp(const Field<T>& x, Field<T>& v, T time) const override {
        if constexpr (Force::capabilities.damping) force_.damp(x, v, time);
    }
    void add_damping(const Field<T>& x, const Field<T>& v, Field<T>& a) const override {
        if constexpr (Force::capabilities.damping) force_.add_damping(x, v, a);
    }
    void each_damping(const Field<T>& x, const typename Erased::BlockVisitor& f) const override {
        if constexpr (Force::capabilities.damping) force_.each_damping(x, std::cref(f));
    }

    std::optional<PairRange<T>> range() const override {
        if constexpr (Force::capabilities.range) {
            return force_.range();
        } else {
            return std::nullopt;
        }
    }
    const Approaches& approaches() const override {
        if constexpr (Force::capabilities.approaches) {
            return force_.approaches();
        } else {
            static const Approaches none;
            return none;
        }
    }
    bool has_local_fields() const override {
        if constexpr (Force::capabilities.approaches) return force_.has_local_fields();
        return false;
    }
    double field_bound(const Field<T>& x, const Field<T>& v, const Field<T>& a, std::size_t i, double from,
                       double to) const override {
        if constexpr (Force::capabilities.approaches) return force_.field_bound(x, v, a, i, from, to);
        return 0;
    }
    bool hold(const Field<T>& x, const Field<T>& v) override {
        if constexpr (Force::capabilities.holds) {
            return x.count() <= Coupling::most_held && force_.hold(x, v);
        } else {
            return false;
        }
    }
    const std::vector<bool>& held() const override {
        if constexpr (Force::capabilities.holds) {
            return force_.held();
        } else {
            return none_held_;
        }
    }
    void each_held(const typename Erased::HeldVisitor& f) const override {
        if constexpr (Force::capabilities.holds) force_.each_held(std::cref(f));
    }

    std::size_t moving_axes(const State<T>& state) const override { return steplab::moving_axes(force_, state); }
    std::size_t axes_of_steps(const State<T>& state) const override { return steplab::axes_of_steps(force_, state); }

    const Field<T>& history() const override {
        if constexpr (Force::capabilities.history) {
            return force_.history();
        } else {
            return no_history_;
        }
    }
    void history(const Field<T>& made_at) override {
        if constexpr (Force::capabilities.history) force_.history(made_at);
    }

private:
    Force force_;
    Field<T> no_history_;
    std::vector<bool> none_held_;
    std::vector<T> no_masses_;
    Field<T> accelerations_;  ///< scratch of each_acceleration()
};

}  // namespace

template <class T>
ErasedForce<T> erased_force(const Forces& forces) {
    return std::visit(
        [](const auto& layout) {
            using Force = decltype(engine<T>(layout));
            return ErasedForce<T>(std::make_unique<ForceFace<T, Force>>(engine<T>(layout)));
        },
        forces);
}
template ErasedForce<float> erased_force(const Forces&);
template ErasedForce<double> erased_force(const Forces&);

}  // namespace steplab
