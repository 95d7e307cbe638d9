#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "core/stages.hpp"
#include "methods/engines/particles.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

// A sweep goes once over all particles, a register of them at a time: it computes their accelerations and hands them to
// a sink, which moves the particles at once. A layout of forces that sweeps (ForceCapabilities) reads no position again
// that it has handed out; those of the others are computed for all particles first. As many sweeps as the layout's
// sweeps_together go one behind the other, by turns of registers_a_turn registers of all quantities, so that they find
// particles in a cache; where these take no more than bytes_alone, they do anyway.
//
// An integrator describes its step as sweeps, part after part: stage(part, f) calls f(q, sink), where q (an
// std::integral_constant) is the quantity that holds the positions of this part's evaluation, and sink(particles, r, a)
// moves the particles of register r, whose accelerations are a. Quantities behind those in use are empty fields.
// Stage::in_registers says how many quantities are worth code for particles that stay in registers; 0: none.

namespace detail {

template <class Force>
struct SweepOf {
    struct Type {};
};
template <class Force>
requires(Force::capabilities.sweeps) struct SweepOf<Force> {
    using Type = typename Force::Sweep;
};

}  // namespace detail

/// Positions of particles as a sweep reads them.
template <class Particles, std::size_t Q>
struct PositionsOf {
    static constexpr std::size_t axes = Particles::axes;
    const Particles& particles;

    [[gnu::always_inline]] auto get(std::size_t r) const { return particles.get(Q, r); }
    [[gnu::always_inline]] auto get_from(std::size_t particle) const { return particles.get_from(Q, particle); }
};

/// Accelerations for output, which change nothing: the history of a layout that has one stays as it is.
template <class T, class Force>
void accelerations_for_output(Force& force, const Field<T>& x, Field<T>& a) {
    if constexpr (Force::capabilities.history) {
        force.uncounted_accelerations(x, a);
    } else {
        force.accelerations(x, a);
    }
}

/// Calls sink(r, a) with the accelerations of every register r of particles, for output.
template <class T, class Force, class Sink>
void emit_accelerations(Force& force, const Field<T>& x, Sink sink) {
    const std::size_t registers = (x.count() + Lanes<T>::count - 1) / Lanes<T>::count;
    if constexpr (!HasLanes<T> && Force::capabilities.sweeps) {
        typename Force::Sweep().to(force, registers, FieldLanes<const T>(x), sink);
    } else {
        Field<T> accelerations(x.count());
        accelerations_for_output(force, x, accelerations);
        for (std::size_t r = 0; r < registers; ++r) sink(r, FieldLanes<const T>(accelerations).get(r));
    }
}

/// Runs the sweeps of one layout of forces.
template <class T, class Force>
class Sweeps {
public:
    /// `steps` steps of `parts` sweeps each over the particles whose quantities are `fields`. With `axes` 1 these are
    /// zero along y and z, and stay so.
    template <std::size_t Quantities, class Stage>
    void run(Force& force, const std::array<Field<T>*, Quantities>& fields, std::uint64_t steps, std::size_t parts,
             Stage stage, std::size_t axes) {
        if constexpr (Force::capabilities.along_x) {
            if (axes == 1) return run_along<1>(force, fields, steps, parts, stage);
        }
        run_along<3>(force, fields, steps, parts, stage);
    }

private:
    static constexpr std::size_t width = Lanes<T>::count;

    template <std::size_t Axes, std::size_t Quantities, class Stage>
    void run_along(Force& force, const std::array<Field<T>*, Quantities>& fields, std::uint64_t steps,
                   std::size_t parts, Stage stage) {
        if constexpr (Force::capabilities.sweeps_in_turn) {
            InMemory<T, Quantities, Axes> particles(fields);
            for (std::uint64_t s = 0; s < steps; ++s) {
                for (std::size_t part = 0; part < parts; ++part) sweep_in_turn(force, particles, part, stage);
            }
        } else if constexpr (!Force::capabilities.sweeps) {
            for (std::uint64_t s = 0; s < steps * parts; ++s) sweep_whole(force, fields, s % parts, stage);
        } else {
            const std::size_t registers = (fields[0]->count() + width - 1) / width;
            const std::size_t used = in_use(fields);
            if constexpr (Force::capabilities.sweeps_in_registers && Stage::in_registers > 0 && !HasLanes<T>) {
                std::array<Field<T>*, Stage::in_registers> few;
                std::copy_n(fields.begin(), few.size(), few.begin());
                if (registers <= Force::most_registers && used == few.size())
                    return run_in_registers<Axes, Force::most_registers>(force, few, registers, steps, parts, stage);
            }
            InMemory<T, Quantities, Axes> particles(fields);
            run_in_memory(force, particles, {used, registers}, steps, parts, stage);
        }
    }

    template <std::size_t Quantities>
    static std::size_t in_use(const std::array<Field<T>*, Quantities>& fields) {
        const auto empty = std::find_if(fields.begin(), fields.end(), [](Field<T>* f) { return f->count() == 0; });
        return static_cast<std::size_t>(empty - fields.begin());
    }

    template <std::size_t Quantities, class Stage>
    void sweep_whole(Force& force, const std::array<Field<T>*, Quantities>& fields, std::size_t part, Stage stage) {
        InMemory<T, Quantities, 3> particles(fields);
        if constexpr (Force::capabilities.hands_out) {
            return stage(part, [&](auto q, auto sink) {
                force.each_acceleration(
                    *fields[q], [&](std::size_t r, const auto& a)
                                    __attribute__((always_inline)) { sink(particles, r, a); });
            });
        }
        if (accelerations_.count() != fields[0]->count()) accelerations_ = Field<T>(fields[0]->count());
        InMemory<T, 1, 3> accelerations({&accelerations_});
        stage(part, [&](auto q, auto sink) {
            force.accelerations(*fields[q], accelerations_);
            const std::size_t registers = (fields[0]->count() + width - 1) / width;
            for (std::size_t r = 0; r < registers; ++r) sink(particles, r, accelerations.get(0, r));
        });
    }

    template <class Particles, class Stage>
    [[gnu::always_inline]] void sweep_in_turn(const Force& force, Particles& particles, std::size_t part, Stage stage) {
        stage(
            part, [&](auto q, auto sink) __attribute__((always_inline)) {
                force.sweep_in_turn(
                    PositionsOf<Particles, q>{particles}, [&](std::size_t r, const auto& a) __attribute__((
                                                              always_inline)) { sink(particles, r, a); });
            });
    }

    /// The same for few particles, in code of its own for every number of registers.
    template <std::size_t Axes, std::size_t Registers, std::size_t Quantities, class Stage>
    void run_in_registers(Force& force, const std::array<Field<T>*, Quantities>& fields, std::size_t registers,
                          std::uint64_t steps, std::size_t parts, Stage stage) {
        if constexpr (Registers > 1) {
            if (registers < Registers)
                return run_in_registers<Axes, Registers - 1>(force, fields, registers, steps, parts, stage);
        }
        InMemory<T, Quantities, Axes> memory(fields);
        InRegisters<T, Quantities, Axes, Registers> particles;
        particles.load(memory);
        const Force own = force;
        for (std::uint64_t i = 0; i < steps; ++i) {
            for (std::size_t part = 0; part < parts; ++part) {
                stage(
                    part, [&](auto q, auto sink) __attribute__((always_inline)) {
                        own.template sweep<Registers>(
                            PositionsOf<InRegisters<T, Quantities, Axes, Registers>, q>{particles},
                            [&](std::size_t r, const auto& a)
                                __attribute__((always_inline)) { sink(particles, r, a); });
                    });
            }
        }
        particles.store(memory);
    }

    /// What a sweep goes over.
    struct Extent {
        std::size_t quantities, registers;
    };

    template <class Particles, class Stage>
    void run_in_memory(Force& force, Particles& particles, const Extent& extent, std::uint64_t steps, std::size_t parts,
                       Stage stage) {
        const std::size_t bytes = extent.quantities * Particles::axes * sizeof(Lanes<T>) * extent.registers;
        const std::size_t most = bytes > Force::bytes_alone ? Force::sweeps_together : 1;
        std::size_t part = 0;
        for (std::uint64_t left = steps * parts; left > 0;) {
            const std::size_t together = std::min<std::uint64_t>(left, most);
            sweep_together(force, particles, extent, together,
                           [&](std::size_t s, auto f) { stage((part + s) % parts, f); });
            part = (part + together) % parts;
            left -= together;
        }
    }

    /// Several sweeps at once, each behind the one before it by no more than it must be, so that particles are moved
    /// several times while they are in a cache.
    template <class Particles, class Stage>
    void sweep_together(const Force& force, Particles& particles, const Extent& extent, std::size_t together,
                        Stage stage) {
        if (under_way_.size() < together) under_way_.resize(together);
        for (std::size_t s = 0; s < together; ++s) under_way_[s].restart();
        const std::size_t behind = force.registers_ahead(), registers = extent.registers;
        static_assert(Force::registers_a_turn >= Particles::quantities);
        const std::size_t block = together > 1 ? Force::registers_a_turn / extent.quantities : registers;
        for (std::size_t front = block; under_way_[together - 1].at() < registers; front += block) {
            for (std::size_t s = 0; s < together && s * behind < front; ++s) {
                auto& sweep = under_way_[s];
                const std::size_t end = std::min(registers, front - s * behind);
                if (end <= sweep.at()) continue;
                stage(s, [&](auto q, auto sink) {
                    sweep.to(
                        force, end, PositionsOf<Particles, q>{particles},
                        [&](std::size_t r, const auto& a) __attribute__((always_inline)) { sink(particles, r, a); });
                });
            }
        }
    }

    std::vector<typename detail::SweepOf<Force>::Type> under_way_;
    Field<T> accelerations_;  ///< of layouts without sweeps
};

}  // namespace steplab
