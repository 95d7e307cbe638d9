#pragma once

#include "core/coupling.hpp"
#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/power.hpp"
#include "methods/adaptive.hpp"
#include "methods/compensated.hpp"
#include "methods/series_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

namespace steplab {

/// The motion as its power series in time, summed as far as it converges to the tolerance. A series whose last
/// coefficient is that of t^K has taken the accelerations in K - 1 orders: it counts as K - 1 evaluations.
struct Taylor {
    static constexpr ParameterInfo parameters[] = {tolerance_parameter};

    static constexpr MethodInfo info{
        .id = "taylor",
        .name = "Taylor series",
        .what = "Chooses step and order itself; every moment between two steps is known as exactly as their ends.",
        .order = 20,
        .order_with_drag = 20,
        .evaluations = 19,
        .linear_limit = infinity,
        .adaptive = true,
        .numbers_of_interactions = 600,
        .conserves = "everything, within the tolerance",
        .source = "Jorba, Zou, Experimental Mathematics 14 (2005) 99",
        .parameters = parameters,
    };

    /// Every pair's series take some 1500 bytes.
    static std::optional<std::string> refusal(const Coupling& coupling) {
        constexpr std::size_t most = 2000;
        if (coupling.kind != Coupling::Kind::all || coupling.particles <= most) return std::nullopt;
        return "it holds the series of all pairs in memory, which is possible for up to " + std::to_string(most) +
               " particles, not for " + std::to_string(coupling.particles);
    }

    template <class T>
    class Integrator;
};

namespace detail {

/// 2^n nearest below or at a positive number.
template <class T>
T power_of_two_below(T x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(T(1), exponent - 1);
}

}  // namespace detail

/// Coefficient k of a displacement is held as x_k unit^k, unit being a power of two near the step's length: exact, and
/// far from the ends of the range of numbers.
template <class T>
class Taylor::Integrator {
    /// Times have the digits of double at least.
    using Time = std::conditional_t<std::is_same_v<T, float>, double, T>;

public:
    explicit Integrator(const ParameterValues& values)
        : log_tolerance_(logarithm(std::clamp(values[tolerance_parameter.name],
                                              2 * static_cast<double>(std::numeric_limits<T>::epsilon()), 0.1))),
          last_(highest_order(log_tolerance_)) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        x_.assign(last_ + 1, Field<T>(state.displacement.count()));
        lost_ = Lost<T>(true, state.displacement.count());
        a_ = Field<T>(state.displacement.count());
        x_[0] = state.displacement;
        v_ = state.velocity;
        forces_ = SeriesForces<T>(system, state, last_ - 1);
        progress_ = {};
        progress_.unit = detail::power_of_two_below(system.dt());
        expand(system);
    }

    template <class System>
    void step(System& system) {
        ++progress_.frames;
        const Time target = frame_time(system);
        while (target - progress_.begin - progress_.begin_lost > static_cast<Time>(progress_.length)) {
            advance();
            // here a step has been accepted: what looks for collisions in it finds its end in x_[0] and v_
            expand(system);
            const T least = std::max(static_cast<T>(target * (4 * std::numeric_limits<Time>::epsilon())), shortest());
            if (!(progress_.length > least)) progress_.length = least;
        }
    }

    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        out.displacement = x_[0];
        out.velocity = v_;
        T *const x = out.displacement.flat().data(), *const v = out.velocity.flat().data();
        const Time since = frame_time(system) - progress_.begin - progress_.begin_lost;
        each_change(static_cast<T>(since), [=](std::size_t p, N change_of_x, N change_of_v) {
            (N::load(x + p) + change_of_x).store(x + p);
            (N::load(v + p) + change_of_v).store(v + p);
        });
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        for (auto& coefficient : self.x_) f(coefficient);
        f(self.v_);
        f(self.lost_.x);
        f(self.lost_.v);
    }

    /// What of the internal state is no field: plain data.
    struct Progress {
        std::uint64_t frames = 0;
        Time begin = 0, begin_lost = 0;  ///< time at which the series begins, and what rounding has cut off it
        T length = T(0);                 ///< how far the series reaches
        T unit = T(1);
    };
    Progress progress() const { return progress_; }
    void progress(const Progress& progress) { progress_ = progress; }

private:
    using N = Lanes<T>;

    /// -ln(tolerance) / 2 + 1 is best where the work of a step grows with the square of the order (Jorba, Zou,
    /// proposition 3.1). Here most of it grows with the order itself, up to some 25: the best orders, as measured, are
    /// higher and nearly the same for all tolerances.
    static std::size_t highest_order(double log_tolerance) {
        return static_cast<std::size_t>(std::ceil(14 - log_tolerance / 4));
    }
    static constexpr double order_per_digit = 0.6;

    /// A time in which nothing moves by more than rounding: steps need not be shorter, nor can they.
    T shortest() const {
        const T fastest = largest(v_);
        return fastest > T(0) ? std::numeric_limits<T>::epsilon() * (T(1) + largest(x_[0])) / fastest : T(0);
    }

    template <class System>
    Time frame_time(const System& system) const {
        return static_cast<Time>(progress_.frames) * static_cast<Time>(system.dt());
    }

    /// To the end of the series, which becomes the next one's beginning.
    void advance() {
        T *const x = x_[0].flat().data(), *const v = v_.flat().data();
        T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
        each_change(progress_.length, [=](std::size_t p, N change_of_x, N change_of_v) {
            add_lanes(x + p, lost_x + p, change_of_x);
            add_lanes(v + p, lost_v + p, change_of_v);
        });
        add_compensated(progress_.begin, progress_.begin_lost, static_cast<Time>(progress_.length));
    }

    static void add_lanes(T* to, T* left, N increment) {
        N sum = N::load(to), lost = N::load(left);
        add_compensated(sum, lost, increment);
        sum.store(to);
        lost.store(left);
    }

    /// Calls f(p, change of x, change of v) for the places p of the axes that move, a register at a time: the sums of
    /// the series at time t after their beginning, from the highest order down.
    template <class F>
    void each_change(T t, F f) const {
        const T scaled = t / progress_.unit;
        const N time(scaled), rate(t / (progress_.unit * progress_.unit));
        const std::size_t size = x_[0].flat().size() / 3 * forces_.axes();
        for (std::size_t p = 0; p < size; p += N::count) {
            N x(T(0)), v(T(0));
            for (std::size_t k = last_; k >= 2; --k) {
                const N coefficient = N::load(x_[k].flat().data() + p);
                x = x * time + coefficient;
                v = v * time + N(number(k)) * coefficient;
            }
            f(p, time * (N::load(x_[1].flat().data() + p) + time * x), rate * v);
        }
    }

    static T number(std::size_t k) { return static_cast<T>(static_cast<int>(k)); }

    /// The series of the motion from x_[0] and v_, in a unit of time that suits how far it reaches.
    template <class System>
    void expand(System& system) {
        for (int attempt = 0; attempt < 40; ++attempt) {
            if (forces_.axes() == 1) compute_series<1>(system);
            if (forces_.axes() == 2) compute_series<2>(system);
            if (forces_.axes() == 3) compute_series<3>(system);
            const T share = reach();
            // in too small a unit all coefficients vanish, and the series seems to end
            const bool too_small = share >= longest && progress_.unit < system.dt() / longest;
            const bool fits = share > T(1) / T(64) && share < T(64) && !too_small;
            progress_.length = progress_.unit * (std::isfinite(share) ? share : T(1) / T(4096));
            if (fits || forces_.singular()) break;
            progress_.unit = detail::power_of_two_below(progress_.length);
        }
        if (system.force().coupling().kind == Coupling::Kind::near) end_at_jump(system);
    }

    /// Where a pair comes in or goes out of the cut-off the force jumps: the series ends just behind the first such
    /// time, looked for in eighths of its length and then by bisection.
    template <class System>
    void end_at_jump(System& system) {
        const std::uint64_t now = pairs_at(system, T(0));
        T before = T(0), behind = progress_.length;
        for (int eighth = 1; eighth <= 8; ++eighth, before = behind) {
            behind = progress_.length * (number(static_cast<std::size_t>(eighth)) / T(8));
            if (pairs_at(system, behind) == now) continue;
            while (behind - before > progress_.length * std::numeric_limits<T>::epsilon()) {
                const T middle = before + (behind - before) / T(2);
                (pairs_at(system, middle) == now ? before : behind) = middle;
            }
            progress_.length = behind;
            return;
        }
    }

    /// A number that tells the set of pairs that interact at time t of the series from others.
    template <class System>
    std::uint64_t pairs_at(System& system, T t) {
        const T* const x = x_[0].flat().data();
        T* const then = a_.flat().data();
        std::copy_n(x, a_.flat().size(), then);
        each_change(t, [=](std::size_t p, N change, N) { (N::load(x + p) + change).store(then + p); });
        std::uint64_t digest = 0;
        system.force().each_interaction(a_, [&](std::size_t i, std::size_t j, std::size_t) {
            digest = (digest ^ (std::uint64_t(i) << 32 | j)) * 0x9E3779B97F4A7C15;
        });
        return digest;
    }

    /// How far the series is good, in its unit of time. Its radius of convergence follows from the last coefficients
    /// relative to 1 + |x| and 1 + |v|, and the share of it that leaves terms below the tolerance, from the order
    /// (Jorba, Zou, section 3.2). Where forces are so weak that the terms need not fall to be below the tolerance, they
    /// must.
    T reach() const {
        if (forces_.singular()) return square_root(std::numeric_limits<T>::epsilon());
        const T of_x = T(1) / (T(1) + largest(x_[0])), of_v = T(1) / (T(1) + largest(v_)) / progress_.unit;
        double log_radius = infinity;
        T high = T(0), low = T(0);
        for (std::size_t k = last_ - 3; k <= last_; ++k) {
            const T size = largest(x_[k]);
            if (!std::isfinite(size)) return size;
            high = std::max(high, size);
            low = std::max(low, largest(x_[k - 4]));
            const double order = static_cast<double>(k);
            log_radius =
                std::min({log_radius, log_root(of_x * size, order), log_root(of_v * number(k) * size, order - 1)});
        }
        if (log_radius == infinity) return longest;
        const double order = static_cast<double>(last_);
        const T share = static_cast<T>(exponential(log_radius + (log_tolerance_ - 0.7) / order));
        const T falling = T(0.8) * square_root(square_root(low / high));
        return std::min({share, falling > T(0) ? falling : share});
    }
    /// ln of the time at which a term of this coefficient is 1.
    static double log_root(T coefficient, double order) {
        const double size = static_cast<double>(coefficient);
        return size > std::numeric_limits<double>::min() ? -logarithm(size) / order : infinity;
    }
    static constexpr T longest = T(16);  ///< of a series that ends, in its unit

    /// The largest component, not a number if one is none.
    T largest(const Field<T>& field) const {
        N most(T(0)), invalid(T(0));
        const T* const components = field.flat().data();
        for (std::size_t p = 0; p < field.flat().size() / 3 * forces_.axes(); p += N::count) {
            const N component = N::load(components + p);
            const N size = where(component < N(T(0)), N(T(0)) - component, component);
            most = where(size > most, size, most);
            invalid = invalid + (component - component);
        }
        T result = T(0);
        for (std::size_t lane = 0; lane < N::count; ++lane) result = std::max(result, most[lane]);
        for (std::size_t lane = 0; lane < N::count; ++lane) result += invalid[lane];
        return result;
    }

    /// All coefficients, order by order: (k + 1) (k + 2) x_(k+2) = a_k - gamma (k + 1) x_(k+1).
    template <std::size_t Axes, class System>
    void compute_series(System& system) {
        forces_.find_groups(system, x_[0]);
        multiply(v_, progress_.unit, x_[1]);
        for (std::size_t k = 0; k + 2 <= last_; ++k) {
            forces_.template accelerations<Axes>(system, x_[k], k, a_);
            const T scale = T(1) / number((k + 1) * (k + 2));
            const T of_a = progress_.unit * progress_.unit, of_v = system.drag() * progress_.unit * number(k + 1);
            const T *const a = a_.flat().data(), *const v = x_[k + 1].flat().data();
            T* const next = x_[k + 2].flat().data();
            elementwise(a_.flat().size() / 3 * Axes,
                        [=](std::size_t p) { next[p] = (of_a * a[p] - of_v * v[p]) * scale; });
        }
        system.count_evaluations(last_ - 1);
    }

    static void multiply(const Field<T>& from, T factor, Field<T>& to) {
        const T* const numbers = from.flat().data();
        T* const products = to.flat().data();
        elementwise(from.flat().size(), [=](std::size_t p) { products[p] = factor * numbers[p]; });
    }

    double log_tolerance_;
    std::size_t last_;         ///< order of the last coefficient, K
    std::vector<Field<T>> x_;  ///< coefficients of the displacements
    Field<T> v_;               ///< velocities at the beginning of the series
    Lost<T> lost_;
    Progress progress_;

    Field<T> a_;
    SeriesForces<T> forces_;
};

}  // namespace steplab
