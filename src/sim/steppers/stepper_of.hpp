#pragma once

#include "core/elementwise.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/kick_drift.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "models/forces/plain.hpp"
#include "sim/steppers/erased_forces.hpp"
#include "sim/steppers/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// What of an integrator's internal state is no field.
template <class Integrator>
struct ProgressType {
    struct None {};
    using Type = None;
};
template <class Integrator>
requires(Integrator::capabilities.progress) struct ProgressType<Integrator> {
    using Type = typename Integrator::Progress;
};
template <class Integrator>
using ProgressOf = typename ProgressType<Integrator>::Type;

/// A method in one precision on one layout of forces.
template <class Method, class T, class Force>
class StepperOf final : public Stepper {
public:
    StepperOf(const StepperSetup& setup, Force force, typename Method::template Integrator<T> integrator)
        : system_(std::move(force), static_cast<T>(setup.scene.drag), static_cast<T>(setup.dt)),
          integrator_(std::move(integrator)) {
        State<T> state = setup.start.state<T>();
        particles_ = state.displacement.count();
        if constexpr (on_positions) {
            reference_ = Field<T>(particles_);
            for (std::size_t i = 0; i < particles_; ++i) reference_.set(i, setup.scene.reference.at(i));
            add_reference(state.displacement, T(1));
        }
        system_.axes(axes_of_steps(system_.force(), state));
        integrator_.start(system_, std::move(state));
    }

    void advance(std::uint64_t steps) override {
        if constexpr (Integrator::capabilities.advances) {
            integrator_.advance(system_, steps);
        } else {
            for (std::uint64_t i = 0; i < steps; ++i) integrator_.step(system_);
        }
    }

    bool finite() const override {
        bool all = true;
        Integrator::each_part(integrator_, [&](const Field<T>& part) { all = all && all_finite(part); });
        return all;
    }

    std::size_t particles() const override { return particles_; }

    void emit(const PortionSink& sink) const override {
        if constexpr (shows_registers) {
            show_in_portions(sink);
        } else {
            integrator_.synchronised(system_, seen_);
            if constexpr (on_positions) add_reference(seen_.displacement, T(-1));
            show(sink, 0, particles_);
        }
    }

    std::uint64_t evaluations() const override { return system_.evaluations(); }

    CollisionRecord collisions() const override {
        if constexpr (Integrator::capabilities.collisions) {
            return integrator_.collisions();
        } else {
            return {};
        }
    }

    std::optional<OwnStop> stopped() const override {
        if constexpr (Integrator::capabilities.stops) {
            return integrator_.stopped();
        } else {
            return std::nullopt;
        }
    }

    void count_drag_work(std::vector<double> coefficients) override {
        if constexpr (Integrator::capabilities.drag_work)
            integrator_.counted_drag() = CountedDrag(std::move(coefficients));
    }

    double drag_work() const override {
        if constexpr (Integrator::capabilities.drag_work) {
            return integrator_.counted_drag().on() ? integrator_.drag_work(system_) : 0;
        } else {
            return 0;
        }
    }

    void save(std::any& to) const override {
        if (!std::any_cast<Saved>(&to)) to = Saved{};
        Saved& saved = *std::any_cast<Saved>(&to);
        std::size_t count = 0;
        Integrator::each_part(integrator_, [&](const Field<T>& part) {
            if (saved.parts.size() == count) saved.parts.emplace_back();
            saved.parts[count++] = part;
        });
        saved.progress = progress();
        if constexpr (Force::capabilities.history) saved.history = system_.force().history();
        if constexpr (Integrator::capabilities.drag_work) saved.drag = integrator_.counted_drag().sum();
        saved.axes = system_.axes();
        saved.evaluations = system_.evaluations();
    }

    void restore(const std::any& state) override {
        const Saved& saved = std::any_cast<const Saved&>(state);
        auto part = saved.parts.begin();
        Integrator::each_part(integrator_, [&](Field<T>& mine) { mine = *part++; });
        if constexpr (Integrator::capabilities.progress) integrator_.progress(saved.progress);
        if constexpr (Force::capabilities.history) system_.force().history(saved.history);
        if constexpr (Integrator::capabilities.drag_work) integrator_.counted_drag().sum(saved.drag);
        system_.axes(saved.axes);
        system_.evaluations(saved.evaluations);
    }

    std::size_t bytes() const override {
        std::size_t sum = 0;
        Integrator::each_part(integrator_, [&](const Field<T>& part) { sum += part.flat().size_bytes(); });
        if constexpr (Force::capabilities.history) sum += system_.force().history().flat().size_bytes();
        return sum;
    }

    std::optional<std::size_t> reach() const override {
        if constexpr (Integrator::capabilities.reach) {
            return integrator_.reach();
        } else {
            return std::nullopt;
        }
    }

    void take_over(const Stepper& other, std::size_t from, std::size_t to, std::size_t count) override {
        const StepperOf& owner = static_cast<const StepperOf&>(other);
        system_.axes(std::max(system_.axes(), owner.system_.axes()));
        std::vector<const Field<T>*> theirs;
        Integrator::each_part(owner.integrator_, [&](const Field<T>& part) { theirs.push_back(&part); });
        auto their = theirs.begin();
        Integrator::each_part(integrator_, [&](Field<T>& mine) {
            const Field<T>& part = **their++;
            if (part.count() == 0) return;
            copy(part, from, count, mine, to);
        });
    }

private:
    using Integrator = typename Method::template Integrator<T>;
    using Vec = Vector<Lanes<T>>;

    /// Methods that work on absolute positions with the plain force loop.
    static constexpr bool on_positions = Integrator::capabilities.forcing == Forcing::plain;

    static constexpr bool shows_registers = Integrator::capabilities.emits && !on_positions;

    /// Particles of a portion: a multiple of every register's.
    static constexpr std::size_t portion = 1024;

    void show_in_portions(const PortionSink& sink) const {
        const std::size_t size = std::min(portion, particles_);
        if (seen_.velocity.count() != size) seen_ = {Field<T>(size), Field<T>(size)};
        const FieldLanes<T> displacement(seen_.displacement), velocity(seen_.velocity);
        constexpr std::size_t width = Lanes<T>::count, registers = portion / width;
        integrator_.emit(system_, [&](std::size_t r, const Vec& x, const Vec& v) {
            displacement.set(r % registers, x);
            velocity.set(r % registers, v);
            const std::size_t shown = r / registers * portion, behind = (r + 1) * width;
            if (behind >= particles_ || behind % portion == 0) show(sink, shown, std::min(behind, particles_) - shown);
        });
    }

    /// What was seen are the particles from `first` on.
    void show(const PortionSink& sink, std::size_t first, std::size_t count) const {
        if constexpr (std::is_same_v<T, double>) {
            sink({first, count, seen_});
        } else {
            convert(seen_.displacement, shown_.displacement);
            convert(seen_.velocity, shown_.velocity);
            sink({first, count, shown_});
        }
    }

    struct Saved {
        std::vector<Field<T>> parts;
        ProgressOf<Integrator> progress{};
        Field<T> history;     ///< of the force, if it has one
        CompensatedSum drag;  ///< its work as far as it is a sum
        std::size_t axes = 3;
        std::uint64_t evaluations = 0;
    };

    ProgressOf<Integrator> progress() const {
        if constexpr (Integrator::capabilities.progress) {
            return integrator_.progress();
        } else {
            return {};
        }
    }

    /// A number minus itself is zero if it is finite, else not a number.
    static bool all_finite(const Field<T>& field) {
        const T* const numbers = field.flat().data();
        return !any_of_all(field.flat().size(), [=](std::size_t k) { return !(numbers[k] - numbers[k] == T(0)); });
    }

    void add_reference(Field<T>& positions, T sign) const {
        for (std::size_t k = 0; k < positions.flat().size(); ++k) positions.flat()[k] += sign * reference_.flat()[k];
    }

    System<T, Force> system_;
    Integrator integrator_;
    Field<T> reference_;  ///< of plain methods
    std::size_t particles_ = 0;
    mutable State<T> seen_;        ///< memory for emit()
    mutable State<double> shown_;  ///< the same in double
};

/// What all methods of kicks and drifts are once their step is known: one stepper serves them.
struct KickDriftMethod {
    template <class T>
    using Integrator = KickDriftSteps<T>;
};

/// The integrator as those of all methods of kicks and drifts are.
template <class Integrator, class T>
KickDriftSteps<T> kick_drift_steps(const Integrator& integrator, const T& dt, const T& drag) {
    return {integrator.step_of(dt, drag), integrator.compensated()};
}

/// On any layout of forces.
template <class Method, class T>
std::unique_ptr<Stepper> make_erased_stepper(const StepperSetup& setup,
                                             typename Method::template Integrator<T> integrator) {
    return std::make_unique<StepperOf<Method, T, ErasedForce<T>>>(setup, erased_force<T>(setup.scene.forces),
                                                                  std::move(integrator));
}

/// Chooses at the border what is static inside: the layout of forces. An evaluation of the composed layout is long
/// enough for a virtual call.
template <class Method, class T>
std::unique_ptr<Stepper> make_stepper_with(const StepperSetup& setup,
                                           typename Method::template Integrator<T> integrator) {
    return std::visit(
        [&](const auto& forces) -> std::unique_ptr<Stepper> {
            using Force = decltype(engine<T>(forces));
            if constexpr (std::is_same_v<Force, Composed<T>>) {
                return make_erased_stepper<Method, T>(setup, std::move(integrator));
            } else {
                return std::make_unique<StepperOf<Method, T, Force>>(setup, engine<T>(forces), std::move(integrator));
            }
        },
        setup.scene.forces);
}

/// The same where only layouts that sweep are known, and all pairs, of which a few take so little time that a virtual
/// call for each register of particles counts; the others are behind one face.
template <class Method, class T>
std::unique_ptr<Stepper> make_sweeping_stepper(const StepperSetup& setup,
                                               typename Method::template Integrator<T> integrator) {
    return std::visit(
        [&](const auto& forces) -> std::unique_ptr<Stepper> {
            using Force = decltype(engine<T>(forces));
            if constexpr (Force::capabilities.sweeps || std::is_same_v<Force, Pairs<T>>) {
                return std::make_unique<StepperOf<Method, T, Force>>(setup, engine<T>(forces), std::move(integrator));
            } else {
                return make_erased_stepper<Method, T>(setup, std::move(integrator));
            }
        },
        setup.scene.forces);
}
// kick_drift_steps.cpp
extern template std::unique_ptr<Stepper> make_stepper_with<KickDriftMethod, float>(const StepperSetup&,
                                                                                   KickDriftSteps<float>);
extern template std::unique_ptr<Stepper> make_stepper_with<KickDriftMethod, double>(const StepperSetup&,
                                                                                    KickDriftSteps<double>);

template <class Method, class T>
std::unique_ptr<Stepper> make_stepper_in(const StepperSetup& setup) {
    using Integrator = typename Method::template Integrator<T>;
    constexpr Forcing forcing = Integrator::capabilities.forcing;
    Integrator integrator(setup.parameters);
    if constexpr (forcing == Forcing::plain) {
        return std::make_unique<StepperOf<Method, T, Plain<T>>>(setup, Plain<T>(setup.scene.forces),
                                                                std::move(integrator));
    } else if constexpr (forcing == Forcing::kick_drift) {
        return make_stepper_with<KickDriftMethod, T>(
            setup, kick_drift_steps(integrator, static_cast<T>(setup.dt), static_cast<T>(setup.scene.drag)));
    } else if constexpr (forcing == Forcing::runge_kutta) {
        return make_sweeping_stepper<Method, T>(setup, std::move(integrator));
    } else {
        return make_erased_stepper<Method, T>(setup, std::move(integrator));
    }
}

template <class Method>
std::unique_ptr<Stepper> make_stepper(const StepperSetup& setup) {
    return setup.precision == Precision::float_ ? make_stepper_in<Method, float>(setup)
                                                : make_stepper_in<Method, double>(setup);
}

}  // namespace steplab
