#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"

#include <cstddef>
#include <type_traits>

namespace steplab {

/// A view of a field in registers of particles: register r holds particles r * width, r * width + 1, ... With a
/// constant T it is read-only. N is the type of a register of numbers. With `Axes` 1 the components along y and z are
/// zero, and neither read nor written.
template <class T, class N, std::size_t Axes = 3>
class BasicFieldLanes {
public:
    using Of = std::conditional_t<std::is_const_v<T>, const Field<std::remove_const_t<T>>, Field<T>>;
    static constexpr std::size_t width = N::count, axes = Axes;
    static_assert(axes == 1 || axes == 3);

    BasicFieldLanes() = default;
    explicit BasicFieldLanes(Of& field) : x_(field.x()), y_(field.y()), z_(field.z()) {}

    [[gnu::always_inline]] Vector<N> get(std::size_t r) const {
        return of_each([=](const T* component) { return N::load(component + r * width); });
    }
    [[gnu::always_inline]] void set(std::size_t r, const Vector<N>& vector) const requires(!std::is_const_v<T>) {
        vector.x.store(x_ + r * width);
        if constexpr (axes == 1) return;
        vector.y.store(y_ + r * width);
        vector.z.store(z_ + r * width);
    }
    /// The register that begins with this particle.
    [[gnu::always_inline]] Vector<N> get_from(std::size_t particle) const {
        return of_each([=](const T* component) { return N::load_anywhere(component + particle); });
    }

private:
    template <class F>
    [[gnu::always_inline]] Vector<N> of_each(F f) const {
        const N zero(std::remove_const_t<T>(0));
        if constexpr (axes == 1) return {f(x_), zero, zero};
        return {f(x_), f(y_), f(z_)};
    }

    T *x_ = nullptr, *y_ = nullptr, *z_ = nullptr;
};

/// With the vector registers of the machine.
template <class T, std::size_t Axes = 3>
using FieldLanes = BasicFieldLanes<T, Lanes<std::remove_const_t<T>>, Axes>;

}  // namespace steplab
