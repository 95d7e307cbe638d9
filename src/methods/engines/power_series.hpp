#pragma once

#include "core/elementary_numbers.hpp"
#include "core/lanes.hpp"
#include "core/number.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace steplab {

/// Memory for the power series in time that a formula of a force needs to continue from order to order (Jorba, Zou,
/// Experimental Mathematics 14 (2005) 99, section 2). The formula is run once for every order k = 0, 1, ...; its
/// operations come in the same order each time, and those whose coefficient k needs all earlier ones find these here.
template <class T>
class SeriesTape {
public:
    using N = Lanes<T>;
    /// Enough for the longest expressions (ExpressionProgram::most_operations): no function keeps more than four.
    static constexpr std::size_t most_kept = 1024;

    /// Series of `length` coefficients each, beginning at `memory`; coefficient `order` is computed now.
    SeriesTape(N* memory, std::size_t length, std::size_t order) : memory_(memory), length_(length), order_(order) {}

    std::size_t order() const { return order_; }
    /// A root of zero was taken, where there is no series.
    bool singular() const { return singular_; }
    void take_root_of(N number) {
        for (std::size_t lane = 0; lane < N::count; ++lane) singular_ = singular_ || !(number[lane] > T(0));
    }
    /// Series kept so far.
    std::size_t kept() const { return kept_; }

    /// The place of the next series.
    std::size_t claim() { return kept_++; }
    N* series(std::size_t place) const { return memory_ + place * length_; }
    std::size_t keep(N coefficient) {
        const std::size_t place = claim();
        series(place)[order_] = coefficient;
        return place;
    }

    /// a_1 b_(k-1) + ... + a_(k-1) b_1, in four independent sums.
    N inner(std::size_t a, std::size_t b) const { return convolution(series(a) + 1, series(b) + order_ - 1); }

    /// The same of a series with itself: every product once. Of each series computed once in an order.
    N inner_square(std::size_t a) {
        const std::uint64_t bit = std::uint64_t(1) << a % 64;
        if ((known_[a / 64] & bit) == 0) squares_[a] = square(series(a));
        known_[a / 64] |= bit;
        return squares_[a];
    }

private:
    N convolution(const N* up, const N* down) const { return products(up, down, order_ - 1); }

    N square(const N* a) const {
        const N half = products(a + 1, a + order_ - 1, (order_ - 1) / 2);
        const N sum = half + half;
        return order_ % 2 == 0 ? sum + a[order_ / 2] * a[order_ / 2] : sum;
    }

    static N products(const N* up, const N* down, std::size_t count) {
        N a(T(0)), b(T(0)), c(T(0)), d(T(0));
        std::size_t j = 0;
        for (; j + 4 <= count; j += 4, up += 4, down -= 4) {
            a = a + up[0] * down[0];
            b = b + up[1] * down[-1];
            c = c + up[2] * down[-2];
            d = d + up[3] * down[-3];
        }
        for (; j < count; ++j) a = a + *up++ * *down--;
        return (a + b) + (c + d);
    }

    N* memory_;
    std::size_t length_, order_, kept_ = 0;
    std::array<N, most_kept> squares_;
    std::array<std::uint64_t, most_kept / 64> known_{};  ///< a bit for each
    bool singular_ = false;
};

/// A number type for the formulas of forces: a power series in time of which one coefficient after the other is
/// computed, for the interactions in the SIMD lanes of a register. A formula evaluated with it yields the coefficient
/// of the order at which its tape is; the rules are those of Knuth, The Art of Computer Programming 2, 4.7.
template <class T>
class Series {
public:
    using N = Lanes<T>;

    /// A constant.
    explicit(false) Series(T number) : zero_(number == T(0)), head_(number), now_(T(0)) {}

    /// A constant that differs between lanes.
    static Series constant(N lanes) { return Series(lanes); }

    /// A variable whose coefficient of the tape's order is given.
    static Series variable(SeriesTape<T>& tape, N coefficient) {
        const std::size_t place = tape.keep(coefficient);
        return Series(tape, tape.series(place)[0], coefficient, place);
    }

    /// The coefficient of the tape's order.
    N coefficient() const { return at_start() ? head_ : now_; }

    friend Series operator+(const Series& a, const Series& b) {
        return combined(a, b, a.head_ + b.head_, a.now_ + b.now_);
    }
    friend Series operator-(const Series& a, const Series& b) {
        Series difference = combined(a, b, a.head_ - b.head_, a.now_ - b.now_);
        if (a.is_constant()) difference.place_ = none;
        return difference;
    }

    friend Series operator*(const Series& a, const Series& b) {
        if (a.zero_ || b.zero_) return Series(T(0));
        if (a.is_constant()) return b.scaled(a);
        if (b.is_constant()) return a.scaled(b);
        const std::size_t p = a.kept(), q = b.kept();
        Series product(*a.tape_, a.head_ * b.head_, N(T(0)));
        if (product.at_start()) return product;
        product.now_ = p == q ? (a.head_ + b.head_) * a.now_ + a.tape_->inner_square(p)
                              : (a.head_ * b.now_ + a.now_ * b.head_) + a.tape_->inner(p, q);
        return product;
    }

    friend Series operator/(const Series& a, const Series& b) {
        if (a.zero_) return a;
        if (b.is_constant())
            return a.is_constant() ? Series(a.head_ / b.head_) : Series(*a.tape_, a.head_ / b.head_, a.now_ / b.head_);
        SeriesTape<T>& tape = *b.tape_;
        const std::size_t divisor = b.kept(), place = tape.claim();
        N* const quotient = tape.series(place);
        if (tape.order() == 0) return begun(tape, place, a.head_ / b.head_);
        const N now = ((a.now_ - b.now_ * quotient[0]) - tape.inner(divisor, place)) * (N(T(1)) / b.head_);
        return continued(tape, place, now);
    }

    /// Where the number is zero its root has no series; the coefficients are then zero.
    friend Series square_root(const Series& x) {
        if (x.is_constant()) return Series(square_root(x.head_));
        SeriesTape<T>& tape = *x.tape_;
        const std::size_t place = tape.claim();
        if (tape.order() == 0) {
            tape.take_root_of(x.head_);
            return begun(tape, place, square_root(x.head_));
        }
        const N root = tape.series(place)[0];
        const auto positive = root > N(T(0));
        const N now = (x.now_ - tape.inner_square(place)) * (N(T(1)) / where(positive, root + root, N(T(1))));
        return continued(tape, place, where(positive, now, N(T(0))));
    }

    /// k e_k = x_1 e_(k-1) + 2 x_2 e_(k-2) + ... + k x_k e_0.
    friend Series exponential(const Series& x) {
        if (x.is_constant()) return Series(of_lanes(x.head_));
        SeriesTape<T>& tape = *x.tape_;
        const N k(static_cast<T>(static_cast<int>(tape.order())));
        const std::size_t slope = tape.keep(k * x.now_), place = tape.claim();
        if (tape.order() == 0) return begun(tape, place, of_lanes(x.head_));
        return continued(tape, place, x.now_ * tape.series(place)[0] + tape.inner(slope, place) / k);
    }

    /// Of a number that is not positive there is no series.
    friend Series natural_logarithm(const Series& x) {
        if (x.is_constant()) return each_lane(x, [](T number) { return natural_logarithm(number); });
        SeriesTape<T>& tape = *x.tape_;
        const std::size_t argument = x.kept(), place = tape.claim(), slope = tape.claim();  // k l_k
        if (tape.order() == 0) {
            tape.take_root_of(x.head_);
            return begun(tape, place, each_lane(x, [](T number) { return natural_logarithm(number); }).head_);
        }
        const N k = order_of(tape), now = (x.now_ - tape.inner(slope, argument) / k) / x.head_;
        tape.series(slope)[tape.order()] = k * now;
        return continued(tape, place, now);
    }

    friend Series sine(const Series& x) { return circle(x).first; }
    friend Series cosine(const Series& x) { return circle(x).second; }
    friend Series tangent(const Series& x) {
        return of_slope(x, N(T(1)), [](T number) { return tangent(number); });
    }
    friend Series hyperbolic_tangent(const Series& x) {
        return of_slope(x, N(T(-1)), [](T number) { return hyperbolic_tangent(number); });
    }

    /// k x_0 b_k = sum over j < k of (p (k - j) - j) x_(k-j) b_j for a constant p.
    friend Series general_power(const Series& x, const Series& p) {
        if (!p.is_constant()) return exponential(p * natural_logarithm(x));
        const auto start = [&] {
            return N::each([&](std::size_t lane) { return general_power(x.head_[lane], p.head_[lane]); });
        };
        if (x.is_constant()) return Series(start());
        SeriesTape<T>& tape = *x.tape_;
        const N k = order_of(tape);
        const std::size_t argument = x.kept(), place = tape.claim(), slope_of_power = tape.claim();
        const std::size_t slope = tape.keep(k * x.now_);
        if (tape.order() == 0) {
            tape.take_root_of(x.head_);
            return begun(tape, place, start());
        }
        const N up = p.head_ * (k * x.now_ * tape.series(place)[0] + tape.inner(slope, place));
        const N now = (up - tape.inner(argument, slope_of_power)) / (k * x.head_);
        tape.series(slope_of_power)[tape.order()] = k * now;
        return continued(tape, place, now);
    }

    /// Conditions are those at the beginning of the step.
    friend auto operator>(const Series& a, const Series& b) { return a.head_ > b.head_; }
    friend auto operator<(const Series& a, const Series& b) { return a.head_ < b.head_; }

    template <class Condition>
    friend Series where(const Condition& condition, const Series& then, const Series& otherwise) {
        return combined(then, otherwise, where(condition, then.head_, otherwise.head_),
                        where(condition, then.now_, otherwise.now_), false);
    }

private:
    static constexpr std::size_t none = SeriesTape<T>::most_kept;

    explicit Series(N constant) : head_(constant), now_(T(0)) {}
    Series(SeriesTape<T>& tape, N head, N now, std::size_t place = none)
        : tape_(&tape), place_(place), head_(head), now_(now) {}

    bool is_constant() const { return tape_ == nullptr; }
    bool at_start() const { return tape_ == nullptr || tape_->order() == 0; }

    /// A series that differs from another by a constant has the same coefficients but for the first.
    static Series combined(const Series& a, const Series& b, N head, N now, bool same_tail = true) {
        if (a.is_constant() && b.is_constant()) return Series(head);
        SeriesTape<T>& tape = a.is_constant() ? *b.tape_ : *a.tape_;
        if (!same_tail || !(a.is_constant() || b.is_constant())) return Series(tape, head, now);
        return Series(tape, head, now, a.is_constant() ? b.place_ : a.place_);
    }
    Series scaled(const Series& constant) const {
        if (is_constant()) return Series(constant.head_ * head_);
        return Series(*tape_, constant.head_ * head_, constant.head_ * now_);
    }

    /// Where its coefficients are kept, the first one not of use: it may be that of a series with the same others.
    std::size_t kept() const { return place_ != none ? place_ : tape_->keep(now_); }

    static Series begun(SeriesTape<T>& tape, std::size_t place, N head) {
        tape.series(place)[0] = head;
        return Series(tape, head, N(T(0)), place);
    }
    static Series continued(SeriesTape<T>& tape, std::size_t place, N now) {
        tape.series(place)[tape.order()] = now;
        return Series(tape, tape.series(place)[0], now, place);
    }

    static N order_of(const SeriesTape<T>& tape) { return N(static_cast<T>(static_cast<int>(tape.order()))); }

    template <class F>
    static Series each_lane(const Series& x, F f) {
        return Series(N::each([&](std::size_t lane) { return f(x.head_[lane]); }));
    }

    /// Sine and cosine: k s_k = sum of j x_j c_(k-j), k c_k = -sum of j x_j s_(k-j).
    static std::pair<Series, Series> circle(const Series& x) {
        const Series sines = each_lane(x, [](T number) { return sine(number); });
        const Series cosines = each_lane(x, [](T number) { return cosine(number); });
        if (x.is_constant()) return {sines, cosines};
        SeriesTape<T>& tape = *x.tape_;
        const N k = order_of(tape);
        const std::size_t s = tape.claim(), c = tape.claim(), slope = tape.keep(k * x.now_);
        if (tape.order() == 0) return {begun(tape, s, sines.head_), begun(tape, c, cosines.head_)};
        const N sine_now = x.now_ * tape.series(c)[0] + tape.inner(slope, c) / k;
        const N cosine_now = N(T(0)) - (x.now_ * tape.series(s)[0] + tape.inner(slope, s) / k);
        return {continued(tape, s, sine_now), continued(tape, c, cosine_now)};
    }

    /// A function t whose slope is 1 + sign t^2.
    template <class F>
    static Series of_slope(const Series& x, N sign, F f) {
        const Series start = each_lane(x, f);
        if (x.is_constant()) return start;
        SeriesTape<T>& tape = *x.tape_;
        const N k = order_of(tape);
        const std::size_t t = tape.claim(), w = tape.claim(), slope = tape.keep(k * x.now_);
        if (tape.order() == 0) {
            tape.series(w)[0] = N(T(1)) + sign * start.head_ * start.head_;
            return begun(tape, t, start.head_);
        }
        const N now = x.now_ * tape.series(w)[0] + tape.inner(slope, w) / k;
        const N first = tape.series(t)[0];
        tape.series(w)[tape.order()] = sign * (first * now + first * now + tape.inner_square(t));
        return continued(tape, t, now);
    }

    static N of_lanes(N x) {
        return N::each([&](std::size_t lane) { return exponential(x[lane]); });
    }

    SeriesTape<T>* tape_ = nullptr;
    std::size_t place_ = none;
    bool zero_ = false;
    N head_;  ///< coefficient 0
    N now_;   ///< that of the tape's order, 0 if that is 0
};

}  // namespace steplab
