#pragma once

#include "core/elementwise.hpp"
#include "methods/engines/kick_drift.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/system.hpp"
#include "models/forces/layouts.hpp"
#include "models/forces/plain.hpp"
#include "sim/steppers/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// True for methods that work on absolute positions with the plain force loop.
template <class Method>
inline constexpr bool is_plain = requires {
    Method::plain;
};

/// What of an integrator's internal state is no field.
template <class Integrator>
inline constexpr bool has_progress = requires(const Integrator& integrator) {
    integrator.progress();
};
template <class Integrator>
struct ProgressType {
    struct None {};
    using Type = None;
};
template <class Integrator>
requires has_progress<Integrator>
struct ProgressType<Integrator> {
    using Type = typename Integrator::Progress;
};
template <class Integrator>
using ProgressOf = typename ProgressType<Integrator>::Type;

/// Methods that find collisions where a force jumps and record them.
template <class Integrator>
inline constexpr bool has_collisions = requires(const Integrator& integrator) {
    integrator.collisions();
};

/// A method in one precision on one layout of forces.
template <class Method, class T, class Force>
class StepperOf final : public Stepper {
public:
    StepperOf(const StepperSetup& setup, Force force, typename Method::template Integrator<T> integrator)
        : system_(std::move(force), static_cast<T>(setup.scene.drag), static_cast<T>(setup.dt)),
          integrator_(std::move(integrator)) {
        State<T> state = setup.start.state<T>();
        particles_ = state.displacement.count();
        if constexpr (is_plain<Method>) {
            reference_ = Field<T>(particles_);
            for (std::size_t i = 0; i < particles_; ++i) reference_.set(i, setup.scene.reference.at(i));
            add_reference(state.displacement, T(1));
        }
        if constexpr (SweepingAlongX<Force>) system_.axes(moving_axes(system_, state));
        integrator_.start(system_, std::move(state));
    }

    void advance(std::uint64_t steps) override {
        if constexpr (requires { integrator_.advance(system_, steps); }) {
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
            if constexpr (is_plain<Method>) add_reference(seen_.displacement, T(-1));
            show(sink, 0, particles_);
        }
    }

    std::uint64_t evaluations() const override { return system_.evaluations(); }

    CollisionRecord collisions() const override {
        if constexpr (has_collisions<Integrator>) {
            return integrator_.collisions();
        } else {
            return {};
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
        if constexpr (has_history) saved.history = system_.force().history();
        saved.axes = system_.axes();
        saved.evaluations = system_.evaluations();
    }

    void restore(const std::any& state) override {
        const Saved& saved = std::any_cast<const Saved&>(state);
        auto part = saved.parts.begin();
        Integrator::each_part(integrator_, [&](Field<T>& mine) { mine = *part++; });
        if constexpr (has_progress<Integrator>) integrator_.progress(saved.progress);
        if constexpr (has_history) system_.force().history(saved.history);
        system_.axes(saved.axes);
        system_.evaluations(saved.evaluations);
    }

    std::size_t bytes() const override {
        std::size_t sum = 0;
        Integrator::each_part(integrator_, [&](const Field<T>& part) { sum += part.flat().size_bytes(); });
        if constexpr (has_history) sum += system_.force().history().flat().size_bytes();
        return sum;
    }

    std::optional<std::size_t> reach() const override {
        if constexpr (requires { integrator_.reach(); }) {
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

    /// Forces whose last bits hang on the way of the run.
    static constexpr bool has_history = requires(const Force& force) { force.history(); };

    static constexpr bool shows_registers =
        !is_plain<Method> && requires(const Integrator& integrator, const System<T, Force>& system) {
        integrator.emit(system, [](std::size_t, const Vec&, const Vec&) {});
    };

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
        Field<T> history;  ///< of the force, if it has one
        std::size_t axes = 3;
        std::uint64_t evaluations = 0;
    };

    ProgressOf<Integrator> progress() const {
        if constexpr (has_progress<Integrator>) {
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
    mutable State<T> seen_;        ///< memory for look()
    mutable State<double> shown_;  ///< the same in double
};

/// What all methods of kicks and drifts are once their step is known: one stepper serves them.
struct KickDriftMethod {
    template <class T>
    using Integrator = KickDriftSteps<T>;
};
template <class Method, class T>
inline constexpr bool is_kick_drift = std::is_base_of_v<KickDriftSteps<T>, typename Method::template Integrator<T>>;

/// The integrator as those of all such methods are.
template <class Integrator, class T>
KickDriftSteps<T> kick_drift_steps(const Integrator& integrator, const T& dt, const T& drag) {
    return {integrator.step_of(dt, drag), integrator.compensated()};
}

/// Chooses at the border what is static inside: the layout of forces.
template <class Method, class T>
std::unique_ptr<Stepper> make_stepper_with(const StepperSetup& setup,
                                           typename Method::template Integrator<T> integrator) {
    return std::visit(
        [&](const auto& forces) -> std::unique_ptr<Stepper> {
            using Force = decltype(engine<T>(forces));
            return std::make_unique<StepperOf<Method, T, Force>>(setup, engine<T>(forces), std::move(integrator));
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
    typename Method::template Integrator<T> integrator(setup.parameters);
    if constexpr (is_plain<Method>) {
        return std::make_unique<StepperOf<Method, T, Plain<T>>>(setup, Plain<T>(setup.scene.forces),
                                                                std::move(integrator));
    } else if constexpr (is_kick_drift<Method, T>) {
        return make_stepper_with<KickDriftMethod, T>(
            setup, kick_drift_steps(integrator, static_cast<T>(setup.dt), static_cast<T>(setup.scene.drag)));
    } else {
        return make_stepper_with<Method, T>(setup, std::move(integrator));
    }
}

template <class Method>
std::unique_ptr<Stepper> make_stepper(const StepperSetup& setup) {
    return setup.precision == Precision::float_ ? make_stepper_in<Method, float>(setup)
                                                : make_stepper_in<Method, double>(setup);
}

}  // namespace steplab
