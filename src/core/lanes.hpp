#pragma once

#include "core/number.hpp"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <utility>

namespace steplab {

namespace detail {

// g++ drops the attribute where the element type is a template's parameter
template <class T>
struct RegisterOf;
template <>
struct RegisterOf<float> {
    using type = float __attribute__((vector_size(64)));
};
template <>
struct RegisterOf<double> {
    using type = double __attribute__((vector_size(64)));
};

}  // namespace detail

/// So many numbers side by side as fill one widest vector register (64 bytes; the compiler splits it where registers
/// are narrower): a number type for formulas, each lane computed exactly as a number by itself would be.
template <class T>
class Lanes {
public:
    static constexpr std::size_t count = 64 / sizeof(T);
    using Register = typename detail::RegisterOf<T>::type;
    /// All bits set in the lanes where a condition holds.
    using Mask = decltype(Register{} < Register{});

    Lanes() = default;
    explicit(false) Lanes(T number) : register_(number - Register{}) {}
    explicit Lanes(Register lanes) : register_(lanes) {}

    /// From and to memory that starts on a cache line.
    static Lanes load(const T* aligned) {
        return Lanes(*static_cast<const Register*>(__builtin_assume_aligned(aligned, 64)));
    }
    void store(T* aligned) const { *static_cast<Register*>(__builtin_assume_aligned(aligned, 64)) = register_; }

    T operator[](std::size_t lane) const { return register_[lane]; }
    Register lanes() const { return register_; }

    /// Set in the first `number` lanes.
    static Mask first(std::size_t number) { return places(Indices{}) < Lanes(static_cast<T>(number)); }

    /// The lanes after the first, then the first lane of `next`.
    static Lanes shifted_down(Lanes first, Lanes next) { return shuffled<1>(first, next, Indices{}); }
    /// The last lane of `previous`, then all lanes but the last.
    static Lanes shifted_up(Lanes previous, Lanes last) { return shuffled<count - 1>(previous, last, Indices{}); }

    friend Lanes operator+(Lanes a, Lanes b) { return Lanes(a.register_ + b.register_); }
    friend Lanes operator-(Lanes a, Lanes b) { return Lanes(a.register_ - b.register_); }
    friend Lanes operator*(Lanes a, Lanes b) { return Lanes(a.register_ * b.register_); }
    friend Lanes operator/(Lanes a, Lanes b) { return Lanes(a.register_ / b.register_); }
    friend Mask operator<(Lanes a, Lanes b) { return a.register_ < b.register_; }
    friend Mask operator>(Lanes a, Lanes b) { return a.register_ > b.register_; }

    friend Lanes where(Mask condition, Lanes then, Lanes otherwise) {
        return Lanes(condition ? then.register_ : otherwise.register_);
    }

    friend Lanes square_root(Lanes x) {
        Register root;
        for (std::size_t lane = 0; lane < count; ++lane) root[lane] = std::sqrt(x.register_[lane]);
        return Lanes(root);
    }

private:
    using Indices = std::make_index_sequence<count>;

    template <std::size_t... I>
    static Lanes places(std::index_sequence<I...>) {
        return Lanes(Register{static_cast<T>(I)...});
    }

    template <std::size_t Shift, std::size_t... I>
    static Lanes shuffled(Lanes a, Lanes b, std::index_sequence<I...>) {
        return Lanes(__builtin_shufflevector(a.register_, b.register_, static_cast<int>(I + Shift)...));
    }

    Register register_;
};

}  // namespace steplab
