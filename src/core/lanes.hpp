#pragma once

#include "core/number.hpp"

#include <algorithm>
#include <array>
#include <bit>
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
struct RegisterOf<float, 16> {
    using type = float __attribute__((vector_size(16)));
};
template <>
struct RegisterOf<float, 32> {
    using type = float __attribute__((vector_size(32)));
};
template <>
struct RegisterOf<float, 64> {
    using type = float __attribute__((vector_size(64)));
};
template <>
struct RegisterOf<double, 16> {
    using type = double __attribute__((vector_size(16)));
};
template <>
struct RegisterOf<double, 32> {
    using type = double __attribute__((vector_size(32)));
};
template <>
struct RegisterOf<double, 64> {
    using type = double __attribute__((vector_size(64)));
};

/// Bytes of the widest vector register of the machine the code is compiled for.
#if defined(__AVX512F__)
inline constexpr std::size_t register_bytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t register_bytes = 32;
#else
inline constexpr std::size_t register_bytes = 16;
#endif

}  // namespace detail

/// A single lane, for number types without vector registers (long double, dual numbers), so that code written with
/// lanes serves every number type.
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
    /// For a number type that itself has lanes.
    template <class Mask>
    friend SingleLane where(Mask condition, SingleLane then, SingleLane otherwise) {
        return where(condition, then.number_, otherwise.number_);
    }
    friend SingleLane square_root(SingleLane x) { return square_root(x.number_); }
    [[gnu::always_inline]] friend SingleLane exponential(SingleLane x) { return exponential(x.number_); }

private:
    T number_;
};

/// A number type of `Count` SIMD lanes, by default those of one vector register of the machine, else in as many
/// registers as needed. Each lane is computed exactly as a single number would be.
template <class T, std::size_t Count = detail::register_bytes / sizeof(T)>
class RegisterLanes {
    static constexpr std::size_t bytes = std::min(Count * sizeof(T), detail::register_bytes);

public:
    static constexpr std::size_t count = Count, width = bytes / sizeof(T), parts = Count / width;
    using Register = typename detail::RegisterOf<T, bytes>::type;
    using Bits = decltype(Register{} < Register{});
    /// All bits set in the lanes where a condition holds.
    struct Mask {
        std::array<Bits, parts> bits;
        auto operator[](std::size_t lane) const { return bits[lane / width][lane % width]; }
    };

    RegisterLanes() = default;
    [[gnu::always_inline]] explicit(false) RegisterLanes(T number)
        : RegisterLanes(of_each([=](std::size_t) { return number - Register{}; })) {}
    template <class U>
    requires std::is_arithmetic_v<U>
    explicit RegisterLanes(U number) : RegisterLanes(static_cast<T>(number)) {}

    /// From and to memory that is aligned to 64 bytes (fields start on a cache line).
    [[gnu::always_inline]] static RegisterLanes load(const T* aligned) {
        return of_each([=](std::size_t p) {
            return *static_cast<const Register*>(__builtin_assume_aligned(aligned + p * width, bytes));
        });
    }
    [[gnu::always_inline]] void store(T* aligned) const {
        each_part([&](std::size_t p) {
            *static_cast<Register*>(__builtin_assume_aligned(aligned + p * width, bytes)) = registers_[p];
        });
    }
    /// The same for unaligned memory.
    [[gnu::always_inline]] static RegisterLanes load_anywhere(const T* from) {
        return of_each([=](std::size_t p) {
            Register lanes;
            std::memcpy(&lanes, from + p * width, bytes);
            return lanes;
        });
    }
    [[gnu::always_inline]] void store_anywhere(T* to) const {
        each_part([&](std::size_t p) { std::memcpy(to + p * width, &registers_[p], bytes); });
    }

    /// f(lane) in every lane.
    template <class F>
    [[gnu::always_inline]] static RegisterLanes each(F f) {
        return of_each([&](std::size_t p) { return register_of_each(f, p * width, Places{}); });
    }

    T operator[](std::size_t lane) const { return registers_[lane / width][lane % width]; }

    /// Set in the first `number` lanes.
    [[gnu::always_inline]] static Mask first(std::size_t number) {
        return each([](std::size_t lane) { return static_cast<T>(lane); }) < RegisterLanes(static_cast<T>(number));
    }

    /// The lanes after the first, then the first lane of `next`.
    [[gnu::always_inline]] static RegisterLanes shifted_down(const RegisterLanes& first, const RegisterLanes& next) {
        return of_each([&](std::size_t p) {
            return shuffled<1>(first.registers_[p], p + 1 < parts ? first.registers_[p + 1] : next.registers_[0],
                               Places{});
        });
    }
    /// The last lane of `previous`, then all lanes but the last.
    [[gnu::always_inline]] static RegisterLanes shifted_up(const RegisterLanes& previous, const RegisterLanes& last) {
        return of_each([&](std::size_t p) {
            return shuffled<width - 1>(p > 0 ? last.registers_[p - 1] : previous.registers_[parts - 1],
                                       last.registers_[p], Places{});
        });
    }

    [[gnu::always_inline]] friend RegisterLanes operator+(const RegisterLanes& a, const RegisterLanes& b) {
        return of_each([&](std::size_t p) { return a.registers_[p] + b.registers_[p]; });
    }
    [[gnu::always_inline]] friend RegisterLanes operator-(const RegisterLanes& a, const RegisterLanes& b) {
        return of_each([&](std::size_t p) { return a.registers_[p] - b.registers_[p]; });
    }
    [[gnu::always_inline]] friend RegisterLanes operator*(const RegisterLanes& a, const RegisterLanes& b) {
        return of_each([&](std::size_t p) { return a.registers_[p] * b.registers_[p]; });
    }
    [[gnu::always_inline]] friend RegisterLanes operator/(const RegisterLanes& a, const RegisterLanes& b) {
        return of_each([&](std::size_t p) { return a.registers_[p] / b.registers_[p]; });
    }
    [[gnu::always_inline]] friend RegisterLanes operator-(const RegisterLanes& a) {
        return of_each([&](std::size_t p) { return -a.registers_[p]; });
    }
    [[gnu::always_inline]] RegisterLanes& operator+=(const RegisterLanes& b) { return *this = *this + b; }
    [[gnu::always_inline]] RegisterLanes& operator-=(const RegisterLanes& b) { return *this = *this - b; }
    [[gnu::always_inline]] friend Mask operator<(const RegisterLanes& a, const RegisterLanes& b) {
        return mask_of_each([&](std::size_t p) { return a.registers_[p] < b.registers_[p]; }, Parts{});
    }
    [[gnu::always_inline]] friend Mask operator>(const RegisterLanes& a, const RegisterLanes& b) { return b < a; }

    /// In all lanes.
    friend bool operator==(const RegisterLanes& a, const RegisterLanes& b) {
        bool equal = true;
        for (std::size_t lane = 0; lane < Count; ++lane) equal = equal && a[lane] == b[lane];
        return equal;
    }

    [[gnu::always_inline]] friend RegisterLanes where(const Mask& condition, const RegisterLanes& then,
                                                      const RegisterLanes& otherwise) {
        return of_each([&](std::size_t p) __attribute__((always_inline)) {
            return condition.bits[p] ? then.registers_[p] : otherwise.registers_[p];
        });
    }

    [[gnu::always_inline]] friend RegisterLanes square_root(const RegisterLanes& x) {
        return of_each([&](std::size_t p) __attribute__((always_inline)) {
            Register root = x.registers_[p];  // every lane of it is set below
            for (std::size_t lane = 0; lane < width; ++lane) root[lane] = std::sqrt(x.registers_[p][lane]);
            return root;
        });
    }
    [[gnu::always_inline]] friend RegisterLanes magnitude(const RegisterLanes& x) {
        const Bits signs = std::bit_cast<Bits>(-Register{});
        return of_each(
            [&](std::size_t p) { return std::bit_cast<Register>(std::bit_cast<Bits>(x.registers_[p]) & ~signs); });
    }
    [[gnu::always_inline]] friend RegisterLanes exponential(const RegisterLanes& x) {
        if constexpr (parts == 1) {
            return detail::exponential_of<T, Bits>(x);
        } else {
            return of_each(
                [&](std::size_t p) { return exponential(RegisterLanes<T, width>(x.registers_[p])).registers()[0]; });
        }
    }

    explicit RegisterLanes(Register lanes) requires(parts == 1) : registers_{lanes} {}
    explicit RegisterLanes(const std::array<Register, parts>& registers) : registers_(registers) {}
    const std::array<Register, parts>& registers() const { return registers_; }

private:
    using Parts = std::make_index_sequence<parts>;
    using Places = std::make_index_sequence<width>;

    template <class F>
    [[gnu::always_inline]] static RegisterLanes of_each(F f) {
        return of_each(f, Parts{});
    }
    template <class F, std::size_t... P>
    [[gnu::always_inline]] static RegisterLanes of_each(F f, std::index_sequence<P...>) {
        RegisterLanes lanes;
        ((lanes.registers_[P] = f(P)), ...);
        return lanes;
    }
    template <class F, std::size_t... P>
    [[gnu::always_inline]] static Mask mask_of_each(F f, std::index_sequence<P...>) {
        return Mask{{f(P)...}};
    }
    template <class F>
    [[gnu::always_inline]] static void each_part(F f) {
        [&]<std::size_t... P>(std::index_sequence<P...>) { (f(P), ...); }
        (Parts{});
    }
    template <class F, std::size_t... I>
    [[gnu::always_inline]] static Register register_of_each(F f, std::size_t begin, std::index_sequence<I...>) {
        return Register{f(begin + I)...};
    }
    template <std::size_t Shift, std::size_t... I>
    [[gnu::always_inline]] static Register shuffled(Register a, Register b, std::index_sequence<I...>) {
        return __builtin_shufflevector(a, b, static_cast<int>(I + Shift)...);
    }

    std::array<Register, parts> registers_;
};

/// The same without vector registers: for number types that no register holds, and for comparison.
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

/// As many numbers as a cache line holds, on every machine: for sums, whose order must not depend on registers.
template <class T>
using CacheLineLanes = std::conditional_t<std::is_same_v<T, float> || std::is_same_v<T, double>,
                                          RegisterLanes<T, 64 / sizeof(T)>, SingleLane<T>>;

/// Calls f(k) for the indices k = 0, Lanes<T>::count, ... at which the registers of a field begin. Code written with
/// lanes is vectorised even where the compiler would not do so by itself.
template <class T, class F>
inline void lanewise(std::size_t size, F f) {
    for (std::size_t k = 0; k < size; k += Lanes<T>::count) f(k);
}

}  // namespace steplab
