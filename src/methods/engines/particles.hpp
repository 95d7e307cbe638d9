#pragma once

#include "core/field_lanes.hpp"
#include "core/vector.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

// The vector quantities (positions, velocities, ...) of all particles as the sweeps of a step see them: a register of
// particles at a time, the r-th of them, quantity q. Where they are, the sweeps do not know. With `Axes` 1 components
// along y and z are zero, and neither read nor written.

/// In memory.
template <class T, std::size_t Quantities, std::size_t Axes>
class InMemory {
public:
    static constexpr std::size_t quantities = Quantities, axes = Axes;

    /// `fields` are of one count.
    explicit InMemory(const std::array<Field<T>*, Quantities>& fields) {
        for (std::size_t q = 0; q < Quantities; ++q) quantities_[q] = FieldLanes<T, Axes>(*fields[q]);
    }

    [[gnu::always_inline]] auto get(std::size_t q, std::size_t r) const { return quantities_[q].get(r); }
    [[gnu::always_inline]] void set(std::size_t q, std::size_t r, const Vector<Lanes<T>>& vector) {
        quantities_[q].set(r, vector);
    }
    /// Of the particles from this one on.
    [[gnu::always_inline]] auto get_from(std::size_t q, std::size_t particle) const {
        return quantities_[q].get_from(particle);
    }

private:
    std::array<FieldLanes<T, Axes>, Quantities> quantities_;
};

/// In registers of the processor: few particles, over many steps.
template <class T, std::size_t Quantities, std::size_t Axes, std::size_t Registers>
class InRegisters {
public:
    using N = Lanes<T>;
    static constexpr std::size_t quantities = Quantities, registers = Registers, axes = Axes;

    [[gnu::always_inline]] Vector<N> get(std::size_t q, std::size_t r) const {
        const Vector<N>& value = values_[q][r];
        if constexpr (axes == 1) return {value.x, N(T(0)), N(T(0))};
        return value;
    }
    [[gnu::always_inline]] void set(std::size_t q, std::size_t r, const Vector<N>& vector) { values_[q][r] = vector; }

    /// From and to where they are between.
    [[gnu::always_inline]] void load(const InMemory<T, Quantities, Axes>& memory) {
        for (std::size_t q = 0; q < Quantities; ++q) {
            for (std::size_t r = 0; r < Registers; ++r) values_[q][r] = memory.get(q, r);
        }
    }
    [[gnu::always_inline]] void store(InMemory<T, Quantities, Axes>& memory) const {
        for (std::size_t q = 0; q < Quantities; ++q) {
            for (std::size_t r = 0; r < Registers; ++r) memory.set(q, r, values_[q][r]);
        }
    }

private:
    std::array<std::array<Vector<N>, Registers>, Quantities> values_;
};

}  // namespace steplab
