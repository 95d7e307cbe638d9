#pragma once

#include "core/number.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace steplab {

namespace detail {

// g++ drops the attribute where the element type is a template's parameter
template <class T, std::size_t Bytes>
struct RegisterOf;
template <>
struct RegisterOf<float, 64> {
    using type = float __attribute__((vector_size(64)));
};
template <>
struct RegisterOf<float, 32> {
    using type = float __attribute__((vector_size(32)));
};
template <>
struct RegisterOf<double, 64> {
    using type = double __attribute__((vector_size(64)));
};

}  // namespace detail

/// One number for itself where there are no registers of them (long double, dual numbers), so that an engine written
/// with lanes serves every number type.
template <class T>
class SingleLane {
public:
    static constexpr std::size_t count = 1;

    SingleLane() = default;
    explicit(false) SingleLane(T number) : number_(number) {}

    static SingleLane load(const T* from) { return *from; }
    template <class F>
    static SingleLane each(F f) {
        return SingleLane(f(std::size_t(0)));
    }
    void store(T* to) const { *to = number_; }
    static SingleLane load_anywhere(const T* from) { return *from; }
    void store_anywhere(T* to) const { *to = number_; }
    T operator[](std::size_t) const { return number_; }
    static bool first(std::size_t number) { return number > 0; }
    static SingleLane shifted_down(SingleLane, SingleLane next) { return next; }
    static SingleLane shifted_up(SingleLane previous, SingleLane) { return previous; }

    friend SingleLane operator+(SingleLane a, SingleLane b) { return a.number_ + b.number_; }
    friend SingleLane operator-(SingleLane a, SingleLane b) { return a.number_ - b.number_; }
    friend SingleLane operator*(SingleLane a, SingleLane b) { return a.number_ * b.number_; }
    friend SingleLane operator/(SingleLane a, SingleLane b) { return a.number_ / b.number_; }
    friend auto operator<(SingleLane a, SingleLane b) { return a.number_ < b.number_; }
    friend auto operator>(SingleLane a, SingleLane b) { return a.number_ > b.number_; }
    friend SingleLane where(bool condition, SingleLane then, SingleLane otherwise) {
        return condition ? then : otherwise;
    }
    /// Of a number that has lanes itself.
    template <class Mask>
    friend SingleLane where(Mask condition, SingleLane then, SingleLane otherwise) {
        return where(condition, then.number_, otherwise.number_);
    }
    friend SingleLane square_root(SingleLane x) { return square_root(x.number_); }
    [[gnu::always_inline]] friend SingleLane exponential(SingleLane x) { return exponential(x.number_); }

private:
    T number_;
};

/// Numbers side by side in one vector register, by default as many as fill the widest (64 bytes; the compiler splits it
/// where registers are narrower): a number type for formulas, each lane computed exactly as a number by itself would
/// be.
template <class T, std::size_t Count = 64 / sizeof(T)>
class RegisterLanes {
public:
    static constexpr std::size_t count = Count;
    using Register = typename detail::RegisterOf<T, Count * sizeof(T)>::type;
    /// All bits set in the lanes where a condition holds.
    using Mask = decltype(Register{} < Register{});

    RegisterLanes() = default;
    explicit(false) RegisterLanes(T number) : register_(number - Register{}) {}
    template <class U>
    requires std::is_arithmetic_v<U>
    explicit RegisterLanes(U number) : RegisterLanes(static_cast<T>(number)) {}
    explicit RegisterLanes(Register lanes) : register_(lanes) {}

    /// From and to memory that is aligned as a register is (fields start on a cache line).
    static RegisterLanes load(const T* aligned) {
        return RegisterLanes(*static_cast<const Register*>(__builtin_assume_aligned(aligned, sizeof(Register))));
    }
    void store(T* aligned) const {
        *static_cast<Register*>(__builtin_assume_aligned(aligned, sizeof(Register))) = register_;
    }
    /// The same from and to any place.
    static RegisterLanes load_anywhere(const T* from) {
        Register lanes;
        std::memcpy(&lanes, from, sizeof(Register));
        return RegisterLanes(lanes);
    }
    void store_anywhere(T* to) const { std::memcpy(to, &register_, sizeof(Register)); }

    /// f(lane) in every lane.
    template <class F>
    static RegisterLanes each(F f) {
        return of_each(f, Indices{});
    }

    T operator[](std::size_t lane) const { return register_[lane]; }
    Register lanes() const { return register_; }

    /// Set in the first `number` lanes.
    static Mask first(std::size_t number) { return places(Indices{}) < RegisterLanes(static_cast<T>(number)); }

    /// The lanes after the first, then the first lane of `next`.
    static RegisterLanes shifted_down(RegisterLanes first, RegisterLanes next) {
        return shuffled<1>(first, next, Indices{});
    }
    /// The last lane of `previous`, then all lanes but the last.
    static RegisterLanes shifted_up(RegisterLanes previous, RegisterLanes last) {
        return shuffled<count - 1>(previous, last, Indices{});
    }

    friend RegisterLanes operator+(RegisterLanes a, RegisterLanes b) {
        return RegisterLanes(a.register_ + b.register_);
    }
    friend RegisterLanes operator-(RegisterLanes a, RegisterLanes b) {
        return RegisterLanes(a.register_ - b.register_);
    }
    friend RegisterLanes operator*(RegisterLanes a, RegisterLanes b) {
        return RegisterLanes(a.register_ * b.register_);
    }
    friend RegisterLanes operator/(RegisterLanes a, RegisterLanes b) {
        return RegisterLanes(a.register_ / b.register_);
    }
    friend RegisterLanes operator-(RegisterLanes a) { return RegisterLanes(-a.register_); }
    RegisterLanes& operator+=(RegisterLanes b) { return *this = *this + b; }
    RegisterLanes& operator-=(RegisterLanes b) { return *this = *this - b; }
    friend Mask operator<(RegisterLanes a, RegisterLanes b) { return a.register_ < b.register_; }
    friend Mask operator>(RegisterLanes a, RegisterLanes b) { return a.register_ > b.register_; }

    friend RegisterLanes where(Mask condition, RegisterLanes then, RegisterLanes otherwise) {
        return RegisterLanes(condition ? then.register_ : otherwise.register_);
    }

    friend RegisterLanes square_root(RegisterLanes x) {
        Register root;
        for (std::size_t lane = 0; lane < count; ++lane) root[lane] = std::sqrt(x.register_[lane]);
        return RegisterLanes(root);
    }
    [[gnu::always_inline]] friend RegisterLanes exponential(RegisterLanes x) {
        return detail::exponential_of<T, Mask>(x);
    }

private:
    using Indices = std::make_index_sequence<count>;

    template <class F, std::size_t... I>
    static RegisterLanes of_each(F f, std::index_sequence<I...>) {
        return RegisterLanes(Register{f(I)...});
    }

    template <std::size_t... I>
    static RegisterLanes places(std::index_sequence<I...>) {
        return RegisterLanes(Register{static_cast<T>(I)...});
    }

    template <std::size_t Shift, std::size_t... I>
    static RegisterLanes shuffled(RegisterLanes a, RegisterLanes b, std::index_sequence<I...>) {
        return RegisterLanes(__builtin_shufflevector(a.register_, b.register_, static_cast<int>(I + Shift)...));
    }

    Register register_;
};

/// The same without registers: for numbers that none holds, and to compare with.
template <class T, std::size_t Count>
class PlainLanes {
public:
    static constexpr std::size_t count = Count;
    using Mask = std::array<bool, Count>;

    PlainLanes() = default;
    explicit(false) PlainLanes(T number) { numbers_.fill(number); }
    template <class U>
    requires std::is_arithmetic_v<U>
    explicit PlainLanes(U number) : PlainLanes(static_cast<T>(number)) {}

    static PlainLanes load(const T* from) {
        return each([=](std::size_t lane) { return from[lane]; });
    }
    void store(T* to) const {
        for (std::size_t lane = 0; lane < Count; ++lane) to[lane] = numbers_[lane];
    }
    T operator[](std::size_t lane) const { return numbers_[lane]; }

    friend PlainLanes operator+(const PlainLanes& a, const PlainLanes& b) {
        return each([&](std::size_t lane) { return a[lane] + b[lane]; });
    }
    friend PlainLanes operator-(const PlainLanes& a, const PlainLanes& b) {
        return each([&](std::size_t lane) { return a[lane] - b[lane]; });
    }
    friend PlainLanes operator*(const PlainLanes& a, const PlainLanes& b) {
        return each([&](std::size_t lane) { return a[lane] * b[lane]; });
    }
    friend PlainLanes operator/(const PlainLanes& a, const PlainLanes& b) {
        return each([&](std::size_t lane) { return a[lane] / b[lane]; });
    }
    friend PlainLanes operator-(const PlainLanes& a) {
        return each([&](std::size_t lane) { return -a[lane]; });
    }
    PlainLanes& operator+=(const PlainLanes& b) { return *this = *this + b; }
    PlainLanes& operator-=(const PlainLanes& b) { return *this = *this - b; }
    friend Mask operator<(const PlainLanes& a, const PlainLanes& b) { return b > a; }
    friend Mask operator>(const PlainLanes& a, const PlainLanes& b) {
        Mask mask{};
        for (std::size_t lane = 0; lane < Count; ++lane) mask[lane] = a[lane] > b[lane];
        return mask;
    }
    friend PlainLanes where(const Mask& condition, const PlainLanes& then, const PlainLanes& otherwise) {
        return each([&](std::size_t lane) { return condition[lane] ? then[lane] : otherwise[lane]; });
    }
    friend PlainLanes square_root(const PlainLanes& x) {
        return each([&](std::size_t lane) { return steplab::square_root(x[lane]); });
    }

private:
    template <class F>
    static PlainLanes each(F f) {
        PlainLanes result;
        for (std::size_t lane = 0; lane < Count; ++lane) result.numbers_[lane] = f(lane);
        return result;
    }

    std::array<T, Count> numbers_;
};

/// The lanes of a number type.
template <class T>
using Lanes =
    std::conditional_t<std::is_same_v<T, float> || std::is_same_v<T, double>, RegisterLanes<T>, SingleLane<T>>;

/// The size of a number, or of each lane.
template <class N>
N magnitude(N x) {
    return where(x < N(0), N(0) - x, x);
}

/// Calls f(k) for the places k = 0, Lanes<T>::count, ... of a field's numbers where its registers begin. The step
/// written with them is in vector registers even where the compiler would not find the way there itself.
template <class T, class F>
inline void lanewise(std::size_t size, F f) {
    for (std::size_t k = 0; k < size; k += Lanes<T>::count) f(k);
}

}  // namespace steplab
