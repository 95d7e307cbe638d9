#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/integrator.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// v += gain a - loss v, where a is the acceleration at x without drag, then x += drift v.
template <class T>
struct KickDrift {
    T gain{}, loss{}, drift{};
};

/// A step as kicks and drifts in turn. What the end of a step and the beginning of the next both do is done at once:
/// between steps a part of it is still to be done for x and v of one time.
template <class T>
struct KickDriftStep {
    std::vector<KickDrift<T>> parts;
    T lead{};               ///< the drift that begins the first step, with which no other is merged
    KickDrift<T> first;     ///< instead of the first part in the first step
    KickDrift<T> rest;      ///< still to be done after a step: a kick or a drift
    std::size_t times = 1;  ///< number of them in a step of the method
};

/// Takes such steps: an integrator once its step is known. Those of methods inherit it and set the step.
template <class T>
class KickDriftSteps {
public:
    static constexpr IntegratorCapabilities capabilities{.forcing = Forcing::kick_drift,
                                                         .lanes = true,
                                                         .advances = true,
                                                         .emits = true,
                                                         .reach = true,
                                                         .progress = true};

    explicit KickDriftSteps(bool compensated) : compensated_(compensated) {}
    KickDriftSteps(KickDriftStep<T> step, bool compensated) : step_(std::move(step)), compensated_(compensated) {}

    template <class System>
    void start(System&, State<T> state) {
        x_ = std::move(state.displacement);
        v_ = std::move(state.velocity);
        lost_ = Lost<T>(compensated_, x_.count());
        progress_ = {};
    }

    template <class System>
    void step(System& system) {
        advance(system, 1);
    }

    /// Defined below, so that one translation unit can instantiate it for all methods.
    template <class System>
    void advance(System& system, std::uint64_t steps);

    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        if (out.velocity.count() != x_.count()) out = {Field<T>(x_.count()), Field<T>(x_.count())};
        const FieldLanes<T> displacement(out.displacement), velocity(out.velocity);
        emit(system, [&](std::size_t r, const Vector<N>& at, const Vector<N>& moving) {
            displacement.set(r, at);
            velocity.set(r, moving);
        });
    }

    /// Calls sink(r, x, v) with displacements and velocities of one time for every register r of particles in turn.
    template <class System, class Sink>
    void emit(const System& system, Sink sink) const {
        if constexpr (System::can_be_damped) {
            if (system.damped()) return emit_damped(system, sink);
        }
        const FieldLanes<const T> position(x_), velocity(v_);
        if (progress_.fresh || step_.rest.gain == T(0)) {
            const std::size_t registers = (x_.count() + N::count - 1) / N::count;
            for (std::size_t r = 0; r < registers; ++r) sink(r, drifted(r), velocity.get(r));
        } else {
            system.emit(x_, [&](std::size_t r, const Vector<N>& a) {
                const Vector<N> before = velocity.get(r);
                sink(r, position.get(r), before + (N(step_.rest.gain) * a - N(step_.rest.loss) * before));
            });
        }
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.KickDriftSteps::x_);
        f(self.KickDriftSteps::v_);
        f(self.KickDriftSteps::lost_.x);
        f(self.KickDriftSteps::lost_.v);
    }

    /// Springs that a step reaches.
    std::size_t reach() const { return step_.times * step_.parts.size(); }

    struct Progress {
        bool fresh = true;  ///< no step was taken yet
    };
    Progress progress() const { return progress_; }
    void progress(const Progress& progress) { progress_ = progress; }

    bool compensated() const { return compensated_; }

protected:
    void set_step(KickDriftStep<T> step) { step_ = std::move(step); }

private:
    using N = Lanes<T>;

    template <class System>
    void take_first(System& system) {
        if (step_.lead != T(0)) drift(step_.lead, x_, v_, lost_);
        std::vector<KickDrift<T>> parts = step_.parts;
        parts.front() = step_.first;
        take(system, 1, parts);
        progress_.fresh = false;
    }

    template <class System>
    void take(System& system, std::uint64_t steps, const std::vector<KickDrift<T>>& parts) {
        if constexpr (System::can_be_damped) {
            if (system.damped()) return take_damped(system, steps, parts);
        }
        const bool drag = parts.front().loss != T(0);
        if (lost_.kept()) {
            const std::array<Field<T>*, 4> fields{&x_, &v_, &lost_.x, &lost_.v};
            if (drag) return system.sweep(fields, steps, parts.size(), Stage<true, true>{parts.data()});
            return system.sweep(fields, steps, parts.size(), Stage<false, true>{parts.data()});
        }
        const std::array<Field<T>*, 2> fields{&x_, &v_};
        if (drag) return system.sweep(fields, steps, parts.size(), Stage<true, false>{parts.data()});
        return system.sweep(fields, steps, parts.size(), Stage<false, false>{parts.data()});
    }

    /// Each kick is between two flows of the damping over half its time: of order 2, and symmetric. The drag of all
    /// particles is 0 then.
    template <class System>
    void take_damped(System& system, std::uint64_t steps, const std::vector<KickDrift<T>>& parts) {
        Field<T> a(x_.count());
        for (std::uint64_t step = 0; step < steps; ++step) {
            for (const KickDrift<T>& part : parts) {
                system.accelerations(x_, a);
                damped_kick(system, part.gain, a, v_, lost_.v);
                drift(part.drift, x_, v_, lost_);
            }
        }
    }

    template <class System>
    void damped_kick(const System& system, T time, const Field<T>& a, Field<T>& velocity, Field<T>& lost) const {
        system.damp(x_, velocity, time / T(2));
        T* const speed = velocity.flat().data();
        const T* const acceleration = a.flat().data();
        if (lost.count() > 0) {
            T* const low = lost.flat().data();
            elementwise(a.flat().size(),
                        [=](std::size_t k) { add_compensated(speed[k], low[k], time * acceleration[k]); });
        } else {
            elementwise(a.flat().size(), [=](std::size_t k) { speed[k] += time * acceleration[k]; });
        }
        system.damp(x_, velocity, time / T(2));
    }

    template <class System, class Sink>
    void emit_damped(const System& system, Sink sink) const {
        Field<T> moving = v_, lost = lost_.v;
        const bool kicked = !progress_.fresh && step_.rest.gain != T(0);
        if (kicked) {
            Field<T> a(x_.count());
            system.uncounted_accelerations(x_, a);
            damped_kick(system, step_.rest.gain, a, moving, lost);
        }
        const FieldLanes<const T> position(x_), velocity(moving);
        const std::size_t registers = (x_.count() + N::count - 1) / N::count;
        for (std::size_t r = 0; r < registers; ++r) sink(r, kicked ? position.get(r) : drifted(r), velocity.get(r));
    }

    enum : std::size_t { x, v, lost_x, lost_v };

    /// What a sweep does with the accelerations (sweeps.hpp).
    template <bool Drag, bool Compensated>
    struct Stage {
        static constexpr std::size_t in_registers = Compensated ? 0 : 2;
        const KickDrift<T>* parts;

        template <class F>
        [[gnu::always_inline]] void operator()(std::size_t part, F f) const {
            const N gain(parts[part].gain), loss(parts[part].loss), drift(parts[part].drift);
            f(
                std::integral_constant<std::size_t, x>{}, [=](auto& particles, std::size_t r,
                                                              const Vector<N>& a) __attribute__((always_inline)) {
                    const Vector<N> before = particles.get(v, r);
                    Vector<N> kick = gain * a;
                    if constexpr (Drag) kick = kick - loss * before;
                    const Vector<N> after = add(particles, v, lost_v, r, before, kick);
                    add(particles, x, lost_x, r, particles.get(x, r), drift * after);
                });
        }

        /// Returns the sum.
        template <class Particles>
        [[gnu::always_inline]] static Vector<N> add(Particles& particles, std::size_t q, std::size_t lost,
                                                    std::size_t r, Vector<N> sum, const Vector<N>& change) {
            if constexpr (Compensated) {
                Vector<N> low = particles.get(lost, r);
                add_compensated(sum, low, change);
                particles.set(lost, r, low);
            } else {
                sum = sum + change;
            }
            particles.set(q, r, sum);
            return sum;
        }
    };

    /// Displacements of one time with the velocities.
    Vector<N> drifted(std::size_t r) const {
        Vector<N> at = FieldLanes<const T>(x_).get(r);
        if (progress_.fresh || step_.rest.drift == T(0)) return at;
        const Vector<N> change = N(step_.rest.drift) * FieldLanes<const T>(v_).get(r);
        if (!lost_.kept()) return at + change;
        Vector<N> low = FieldLanes<const T>(lost_.x).get(r);
        add_compensated(at, low, change);
        return at;
    }

    /// x += drift v.
    static void drift(T drift, Field<T>& x, const Field<T>& v, Lost<T>& lost) {
        T* const position = x.flat().data();
        const T* const velocity = v.flat().data();
        if (lost.kept()) {
            T* const lost_x = lost.x.flat().data();
            return elementwise(x.flat().size(),
                               [=](std::size_t k) { add_compensated(position[k], lost_x[k], drift * velocity[k]); });
        }
        elementwise(x.flat().size(), [=](std::size_t k) { position[k] += drift * velocity[k]; });
    }

    KickDriftStep<T> step_;
    bool compensated_;
    Field<T> x_;  ///< displacements
    Field<T> v_;
    Lost<T> lost_;
    Progress progress_;
};

template <class T>
template <class System>
void KickDriftSteps<T>::advance(System& system, std::uint64_t steps) {
    steps *= step_.times;
    if (steps > 0 && progress_.fresh) {
        take_first(system);
        --steps;
    }
    if (steps > 0) take(system, steps, step_.parts);
}

}  // namespace steplab
