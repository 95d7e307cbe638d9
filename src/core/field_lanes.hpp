#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"

#include <cstddef>
#include <type_traits>

namespace steplab {

/// A field as vectors of a register of particles each: the r-th are those from particle r * width on. Refers to it. Of
/// a constant T, a field that is not changed. N is what a register of numbers is.
template <class T, class N>
class BasicFieldLanes {
public:
    using Of = std::conditional_t<std::is_const_v<T>, const Field<std::remove_const_t<T>>, Field<T>>;
    static constexpr std::size_t width = N::count;

    BasicFieldLanes() = default;
    explicit BasicFieldLanes(Of& field) : x_(field.x()), y_(field.y()), z_(field.z()) {}

    [[gnu::always_inline]] Vector<N> get(std::size_t r) const {
        return {N::load(x_ + r * width), N::load(y_ + r * width), N::load(z_ + r * width)};
    }
    [[gnu::always_inline]] void set(std::size_t r, const Vector<N>& vector) const requires(!std::is_const_v<T>) {
        vector.x.store(x_ + r * width);
        vector.y.store(y_ + r * width);
        vector.z.store(z_ + r * width);
    }
    /// Of the particles from this one on.
    [[gnu::always_inline]] Vector<N> get_from(std::size_t particle) const {
        return {N::load_anywhere(x_ + particle), N::load_anywhere(y_ + particle), N::load_anywhere(z_ + particle)};
    }

private:
    T *x_ = nullptr, *y_ = nullptr, *z_ = nullptr;
};

/// By registers of the machine.
template <class T>
using FieldLanes = BasicFieldLanes<T, Lanes<std::remove_const_t<T>>>;

}  // namespace steplab
