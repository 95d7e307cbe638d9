#pragma once

#include "core/along_x.hpp"
#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "core/stages.hpp"
#include "core/sum.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/spring.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace steplab {

/// The engine of LineForces. Every spring is computed once, a register of them at a time; the acceleration of particle
/// i is (pull of the spring to i + 1) - (pull of the spring from i - 1), in this order, then gravity.
template <class T>
class Line {
    using N = Lanes<T>;
    using Vec = Vector<N>;
    static constexpr std::size_t width = N::count;
    /// Registers of springs that a sweep computes before they are needed, to hide the latency of roots and divisions.
    static constexpr std::size_t ahead = 3;

public:
    static constexpr ForceCapabilities capabilities{.sweeps = true,
                                                    .sweeps_in_registers = true,
                                                    .sweeps_in_turn = HasLanes<T>,
                                                    .along_x = true,
                                                    .bounds_energy = HasLanes<T>};

    explicit Line(const LineForces& forces)
        : forces_(forces),
          first_moving_(forces.first_fixed ? 1 : 0),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          gravity_(static_cast<T>(forces.gravity)),
          falls_(forces.gravity != 0) {}

    /// The same forces in another number type.
    template <class N>
    Line<N> in() const {
        return Line<N>(forces_);
    }

    /// Calls f(number) for the constants that depend on the scene's parameters.
    template <class Self, class F>
    static void each_constant(Self& self, F f) {
        f(self.stiffness_), f(self.length_), f(self.gravity_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) const { accelerate<3>(u, a); }

    /// The same where all particles move along x alone; for number types with lanes, the other components of `a` are
    /// not set.
    void accelerations_along_x(const Field<T>& u, Field<T>& a) const { accelerate<1>(u, a); }

    /// One sweep over all particles (methods/engines/sweeps.hpp). `positions.get(r)` are those of the r-th register of
    /// particles; sink(r, a) is called with their accelerations when their positions are no longer needed. Where
    /// `positions.axes` is 1, only x components are used and computed.
    class Sweep {
    public:
        void restart() { at_ = 0; }
        /// The next register.
        std::size_t at() const { return at_; }
        /// Continues up to this register.
        template <class Positions, class Sink>
        void to(const Line& line, std::size_t end, Positions positions, Sink sink) {
            const std::size_t registers = line.registers();
            constexpr std::size_t axes = Positions::axes;
            Moving<N, axes> here = moving<axes>(here_), before = moving<axes>(before_);
            const auto emit = [&](std::size_t r) __attribute__((always_inline)) {
                const Moving<N, axes> next = r + 1 < registers ? moving<axes>(positions.get(r + 1)) : here;
                keep<axes>(r, line, line.springs(here, next));
                here = next;
            };
            if (at_ == 0) {
                here = moving<axes>(positions.get(0));
                before = moving<axes>(none());
                for (std::size_t r = 0; r < std::min(ahead, registers); ++r) emit(r);
            }
            for (std::size_t r = at_; r < end; ++r) {
                if (r + ahead < registers) emit(r + ahead);
                sink(r, as_vector(line.sum(r, registers, kept<axes>(r), before)));
            }
            here_ = as_vector(here);
            before_ = as_vector(before);
            at_ = end;
        }

    private:
        /// Registers of springs 0, 1, ... are stored in places 0, 1, ... of a ring.
        static constexpr std::size_t places = ahead + 1;

        /// The factor and the vector of each: their product is the pull.
        template <std::size_t Axes>
        [[gnu::always_inline]] void keep(std::size_t r, const Line& line, const SpringGeometry<N>& springs) {
            T* const to = ahead_.data() + r % places * 4 * width;
            spring_factor(springs, N(line.length_), N(line.stiffness_)).store(to);
            springs.d.x.store(to + width);
            if constexpr (Axes == 1) return;
            springs.d.y.store(to + 2 * width), springs.d.z.store(to + 3 * width);
        }
        template <std::size_t Axes>
        [[gnu::always_inline]] Moving<N, Axes> kept(std::size_t r) const {
            const T* const from = ahead_.data() + r % places * 4 * width;
            if constexpr (Axes == 1)
                return N::load(from) * N::load(from + width);
            else
                return N::load(from) * Vec{N::load(from + width), N::load(from + 2 * width), N::load(from + 3 * width)};
        }

        std::size_t at_ = 0;
        Vec here_{}, before_{};  ///< current positions; pulls of the previous springs
        alignas(64) std::array<T, places * 4 * width> ahead_;
    };

    /// Number of registers that a sweep reads ahead.
    static constexpr std::size_t registers_ahead() { return ahead + 1; }
    static constexpr std::size_t sweeps_together = 16, registers_a_turn = 128, bytes_alone = 0;

    /// A whole sweep over particles that fill `Registers` registers, a number known to the compiler.
    static constexpr std::size_t most_registers = std::max<std::size_t>(2, (10 + width - 1) / width);
    template <std::size_t Registers, class Positions, class Sink>
    [[gnu::always_inline]] void sweep(Positions positions, Sink sink) const {
        constexpr std::size_t axes = Positions::axes;
        Moving<N, axes> here = moving<axes>(positions.get(0)), before = moving<axes>(none());
        [&]<std::size_t... R>(std::index_sequence<R...>) __attribute__((always_inline)) {
            (pass(R, Registers, positions, sink, here, before), ...);
        }
        (std::make_index_sequence<Registers>{});
    }

    /// A whole sweep, particle by particle, for number types with lanes. It computes two springs ahead, so that their
    /// roots and divisions overlap with those of the previous springs.
    template <class Positions, class Sink>
    [[gnu::always_inline]] void sweep_in_turn(const Positions& positions, Sink sink) const requires HasLanes<T> {
        constexpr std::size_t axes = Positions::axes;
        using V = Moving<N, axes>;
        const std::size_t count = forces_.count;
        const V still = moving<axes>(none());
        V before = still, first = still, second = still, here = moving<axes>(positions.get(0));
        for (std::size_t i = 0; i < count + 2; ++i) {
            V third = still;
            if (i + 1 < count) {
                const V next = moving<axes>(positions.get(i + 1));
                third = pulls(here, next);
                here = next;
            }
            if (i >= 2) {
                V sum = first - before;
                if (falls_) fall(sum, N(gravity_));
                sink(i - 2, as_vector(i - 2 < first_moving_ ? still : sum));
            }
            before = first, first = second, second = third;
        }
    }

    PotentialEnergy potential(const Field<T>& u) const { return potential(u, forces_.count); }
    /// The energy of the first `own` particles and of the springs that begin at them.
    PotentialEnergy potential(const Field<T>& u, std::size_t own) const {
        using Many = CacheLineLanes<T>;
        const BasicFieldLanes<const T, Many> at(u);
        const std::size_t springs = std::min(own, forces_.count - 1);
        LanesSum<Many> energies, heights;
        for (std::size_t i = 0; i < own; i += Many::count) {
            const Vector<Many> here = at.get_from(i), e = at.get_from(i + 1) - here;
            const Many energy = spring_energy(Offset<Many, Zero, Zero>{Many(length_), {}, {}}, Many(length_), e);
            energies.add(where(Many::first(springs - std::min(springs, i)), energy, Many(T(0))));
            if (falls_) heights.add(where(Many::first(own - i), here.y, Many(T(0))));
        }
        const double elastic = forces_.k * energies.value();
        const double external = forces_.mass * forces_.gravity * heights.value();
        return {elastic + external, elastic + std::abs(external), external};
    }

    /// k / (2 m) times the sum of |e|^2: an upper bound, because no spring is stretched by more than |e|.
    T elastic_bound(const Field<T>& u) const requires HasLanes<T> {
        T sum(0);
        for (std::size_t i = 0; i + 1 < forces_.count; ++i) {
            const T x = u.x()[i + 1] - u.x()[i], y = u.y()[i + 1] - u.y()[i], z = u.z()[i + 1] - u.z()[i];
            sum += x * x + (y * y + z * z);
        }
        return stiffness_ * sum / T(2);
    }

    /// Calls f(i, i + 1) for springs that reverse between two positions. With rest length 0 the force does not jump
    /// there.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) const {
        if (length_ == T(0)) return;
        const std::size_t springs = forces_.count - 1;
        const auto turned = [&](std::size_t i) { return turned_round(spring(from, i), spring(to, i)); };
        if (!any_of_all(springs, turned)) return;
        for (std::uint32_t i = 0; i < springs; ++i) {
            if (turned(i)) f(i, i + 1);
        }
    }
    /// The vector from particle i to particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const T rest = length_ * (static_cast<T>(j) - static_cast<T>(i));
        return {rest + (u.x()[j] - u.x()[i]), u.y()[j] - u.y()[i], u.z()[j] - u.z()[i]};
    }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t i) const { return i >= first_moving_; }
    Vector<T> external(std::size_t) const { return {T(0), T(0) - gravity_, T(0)}; }

    std::array<SpringFormula<T>, 1> formulas() const { return {{{{length_, T(0), T(0)}, length_, stiffness_}}}; }

    template <class F>
    void each_interaction(const Field<T>&, F f) const {
        for (std::size_t i = 0; i + 1 < forces_.count; ++i) f(i, i + 1, std::size_t(0));
    }

private:
    /// The vector along the spring that begins at particle i.
    Vector<T> spring(const Field<T>& u, std::size_t i) const {
        return {length_ + (u.x()[i + 1] - u.x()[i]), u.y()[i + 1] - u.y()[i], u.z()[i + 1] - u.z()[i]};
    }

    std::size_t registers() const { return (forces_.count + width - 1) / width; }

    static Vec none() { return {N(T(0)), N(T(0)), N(T(0))}; }

    /// Passes the accelerations of register r to the sink. `here` are its positions and `before` the pulls of the
    /// previous springs; both are updated for the next register.
    template <class Positions, class Sink, class V>
    [[gnu::always_inline]] void pass(std::size_t r, std::size_t registers, const Positions& positions, Sink& sink,
                                     V& here, V& before) const {
        const V next = r + 1 < registers ? moving<Positions::axes>(positions.get(r + 1)) : here;
        const V pull = pulls(here, next);
        here = next;
        sink(r, as_vector(sum(r, registers, pull, before)));
    }

    [[gnu::always_inline]] N pulls(const N& here, const N& next) const {
        return spring_pull(springs(here, next), N(length_), N(stiffness_)).x;
    }
    [[gnu::always_inline]] Vec pulls(const Vec& here, const Vec& next) const {
        return spring_pull(springs(here, next), N(length_), N(stiffness_));
    }

    /// The springs that begin at the particles of one register; `next` holds the particles after them.
    template <class V>
    [[gnu::always_inline]] SpringGeometry<N> springs(const V& here, const V& next) const {
        const auto along = [](const N& from, const N& to) __attribute__((always_inline)) {
            return N::shifted_down(from, to) - from;
        };
        return geometry(N(length_), each_component(along, here, next));
    }
    template <class M>
    [[gnu::always_inline]] static SpringGeometry<M> geometry(const M& length, const M& along_x) {
        return SpringGeometry<M>::along_x(length, along_x);
    }
    template <class M>
    [[gnu::always_inline]] static SpringGeometry<M> geometry(const M& length, const Vector<M>& e) {
        return {Offset<M, Zero, Zero>{length, {}, {}}, e};
    }

    /// The accelerations of register r, from the pulls of its springs and of those of the previous register, which they
    /// replace.
    template <class V>
    [[gnu::always_inline]] V sum(std::size_t r, std::size_t registers, V pull, V& before) const {
        const bool last = r + 1 == registers;
        if (last) pull = first_lanes(forces_.count - 1 - r * width, pull);
        const auto less = [](const N& own, const N& behind) __attribute__((always_inline)) {
            return own - N::shifted_up(behind, own);
        };
        V sum = each_component(less, pull, before);
        if (falls_) fall(sum, last ? where(N::first(forces_.count - r * width), N(gravity_), N(T(0))) : N(gravity_));
        if (r == 0 && first_moving_ > 0) sum = after_first(sum);
        before = pull;
        return sum;
    }

    [[gnu::always_inline]] static void fall(Vec& a, const N& gravity) { a.y = a.y - gravity; }
    /// There is no gravity along x.
    [[gnu::always_inline]] static void fall(N&, const N&) {}

    template <std::size_t Axes>
    void accelerate(const Field<T>& u, Field<T>& a) const {
        if constexpr (HasLanes<T>) return accelerate_in_turn<Axes>(u, a);
        const FieldLanes<T> out(a);
        const FieldLanes<const T, Axes> positions(u);
        Sweep sweep;  // not Sweep(), which would be zeroed
        sweep.to(*this, registers(), positions, [&](std::size_t r, const Vec& sum) { out.set(r, sum); });
    }

    /// For number types that themselves have lanes: spring by spring, its pull staying in registers for the next one.
    /// Components along other axes, all zero, are neither read nor written.
    template <std::size_t Axes>
    void accelerate_in_turn(const Field<T>& u, Field<T>& a) const {
        const T zero(0);
        const auto at = [&](std::size_t i) {
            return Vector<T>{u.x()[i], Axes > 1 ? u.y()[i] : zero, Axes > 2 ? u.z()[i] : zero};
        };
        Vector<T> here = at(0), before{zero, zero, zero};
        for (std::size_t i = 0; i < forces_.count; ++i) {
            Vector<T> pull{zero, zero, zero};
            if (i + 1 < forces_.count) {
                const Vector<T> next = at(i + 1);
                const Vector<T> e = next - here;
                pull = spring_pull(Axes == 1 ? geometry(length_, e.x) : geometry(length_, e), length_, stiffness_);
                here = next;
            }
            const bool moves = i >= first_moving_;
            a.x()[i] = moves ? pull.x - before.x : zero;
            if constexpr (Axes > 1) a.y()[i] = moves ? pull.y - before.y : zero;
            if constexpr (Axes > 2) a.z()[i] = moves ? pull.z - before.z : zero;
            before = pull;
        }
        if (Axes > 1 && falls_) add_gravity(a);
    }

    /// Clears the lanes of springs that do not exist: the last particle has none behind it.
    template <class V>
    static V first_lanes(std::size_t count, const V& pull) {
        const auto kept = N::first(count);
        return each_component([&](const N& number) { return where(kept, number, N(T(0))); }, pull);
    }

    /// Sets the acceleration of a fixed first particle to zero.
    template <class V>
    static V after_first(const V& sum) {
        const auto fixed = N::first(1);
        return each_component([&](const N& number) { return where(fixed, N(T(0)), number); }, sum);
    }

    void add_gravity(Field<T>& a) const {
        T* const y = a.y() + first_moving_;
        elementwise(forces_.count - first_moving_, [=, gravity = gravity_](std::size_t i) { y[i] -= gravity; });
    }

    LineForces forces_;
    std::size_t first_moving_;
    T stiffness_;  ///< k / m
    T length_;
    T gravity_;
    bool falls_;
};

}  // namespace steplab
