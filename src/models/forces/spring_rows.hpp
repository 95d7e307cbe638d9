#pragma once

#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/lane_vectors.hpp"
#include "core/lanes.hpp"
#include "core/team.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_formula.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/particle_registers.hpp"
#include "models/forces/spring.hpp"
#include "models/periods.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace steplab {

/// A quantity of every spring in a row: a list of it, or one number where all are equal.
template <class T>
class SpringQuantity {
    using N = Lanes<T>;

public:
    void add(T number) { numbers_.push_back(number); }
    void finish() {
        const auto other = [this](T number) { return number != numbers_.front(); };
        if (numbers_.empty() || std::any_of(numbers_.begin(), numbers_.end(), other)) return;
        common_ = numbers_.front();
        numbers_ = {};
    }
    bool is(T number) const { return numbers_.empty() && common_ == number; }
    [[gnu::always_inline]] N operator[](std::size_t slot) const {
        return numbers_.empty() ? N(common_) : N::load(numbers_.data() + slot);
    }

private:
    std::vector<T, CacheLineAllocator<T>> numbers_;
    T common_ = T(0);
};

/// The springs of a composition by particles: a row of springs for each register of particles, in which each lane has
/// those of its particle in the order of the scene. Every spring is computed from both ends, so that no two particles
/// add to one sum: lanes and threads need not wait for each other, and each sum has the bits of springs added one by
/// one to both ends. T is float or double.
template <class T>
class SpringRows {
    using N = Lanes<T>;
    using Vec = Vector<N>;

public:
    /// Nothing without springs, and where most lanes would stay empty, as beside a particle with many springs.
    static std::optional<SpringRows> of(const Composition& composition) {
        if (composition.springs.empty()) return std::nullopt;
        const Ends ends = ends_of(composition);
        std::size_t slots = 0;
        for (std::size_t first = 0; first < ends.size(); first += N::count) slots += longest(ends, first) * N::count;
        if (slots > 4 * (composition.springs.size() + N::count)) return std::nullopt;
        return SpringRows(composition, ends);
    }

    /// Calls sink(r, a) for every register r of particles, by all members of the team in parallel, when others' u are
    /// no longer read: a are the accelerations by springs and from outside.
    template <class Sink>
    void each(const Field<T>& u, const ParticleRegisters<T>& particles, Team& team, Sink sink) {
        place_.resize(padded(u.count()) * stride());
        team.run([&](std::size_t member) {
            const auto [begin, end] = team.part(rows(), member);
            const FieldLanes<const T> own(u);
            for (std::size_t r = begin; r < end; ++r) keep(own.get(r), r * N::count, 0);
            team.meet();
            for (std::size_t r = begin; r < end; ++r) sink(r, sum(r, own.get(r), particles));
        });
    }

private:
    using Four = RegisterLanes<T, 4>;
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// One end of a spring as seen from the other.
    struct End {
        std::uint32_t other, spring;
    };
    using Ends = std::vector<std::vector<End>>;  ///< of each particle

    static constexpr std::size_t four = 4;

    SpringRows(const Composition& of, const Ends& ends)
        : periods_{Periods<N>(of.box.x), Periods<N>(of.box.y), Periods<N>(of.box.z)},
          boxed_(of.box != Vec3{}),
          from_reference_(is_difference_of_references(of)) {
        if (from_reference_) keep_references(of);
        last_ = SpringLaw<T>::of(of.springs.front(), of.mass);
        append_rows(of, ends);
        for (SpringQuantity<T>* const quantity :
             {&rest_[0], &rest_[1], &rest_[2], &length_, &stretch_, &k_, &quadratic_, &cubic_})
            quantity->finish();
        linear_ = quadratic_.is(T(0)) && cubic_.is(T(0));
    }

    static std::size_t padded(std::size_t count) { return (count + N::count - 1) / N::count * N::count; }
    std::size_t rows() const { return begin_.size() - 1; }
    /// Numbers that are kept for a particle: its displacement and an unused one, and its reference position likewise.
    std::size_t stride() const { return from_reference_ ? 2 * four : four; }

    /// True if the vector of every spring at rest is the difference of two reference positions in T: there are fewer of
    /// these than of springs.
    static bool is_difference_of_references(const Composition& of) {
        const auto at = [&](std::uint32_t i) { return ComposedParticles<T>::vector(of.reference[i]); };
        return !of.reference.empty() && std::all_of(of.springs.begin(), of.springs.end(), [&](const auto& spring) {
            const Vector<T> rest = ComposedParticles<T>::vector(spring.rest), d = at(spring.second) - at(spring.first);
            return rest.x == d.x && rest.y == d.y && rest.z == d.z;
        });
    }

    void keep_references(const Composition& of) {
        references_ = Field<T>(of.count);
        for (std::size_t i = 0; i < of.count; ++i) references_.set(i, of.reference[i]);
        place_.resize(padded(of.count) * stride());
        for (std::size_t r = 0; r < padded(of.count) / N::count; ++r)
            keep(FieldLanes<const T>(references_).get(r), r * N::count, four);
    }

    static Ends ends_of(const Composition& of) {
        Ends ends(padded(of.count));
        for (std::uint32_t s = 0; s < of.springs.size(); ++s) {
            ends[of.springs[s].first].push_back({of.springs[s].second, s});
            ends[of.springs[s].second].push_back({of.springs[s].first, s});
        }
        return ends;
    }

    /// Springs of that particle of a register that has most.
    static std::size_t longest(const Ends& ends, std::size_t first) {
        std::size_t most = 0;
        for (std::size_t lane = 0; lane < N::count; ++lane) most = std::max(most, ends[first + lane].size());
        return most;
    }

    void append_rows(const Composition& of, const Ends& ends) {
        for (std::size_t first = 0; first < ends.size(); first += N::count) {
            begin_.push_back(others_.size());
            const std::size_t springs = longest(ends, first);
            for (std::size_t k = 0; k < springs; ++k) {
                for (std::size_t i = first; i < first + N::count; ++i) {
                    if (k < ends[i].size())
                        append(of, i, ends[i][k]);
                    else
                        append_empty(i);
                }
            }
        }
        begin_.push_back(others_.size());
    }

    void append(const Composition& of, std::size_t i, const End& end) {
        const ComposedSpring& spring = of.springs[end.spring];
        const Vec3 rest = spring.first == i ? spring.rest : Vec3{} - spring.rest;
        append(end.other, ComposedParticles<T>::vector(rest), SpringLaw<T>::of(spring, of.mass));
    }
    /// A spring of the particle with itself, which pulls it nowhere whatever the other numbers are: they are repeated,
    /// as they may be common to all.
    void append_empty(std::size_t i) { append(static_cast<std::uint32_t>(i), {T(0), T(0), T(0)}, last_); }
    void append(std::uint32_t other, const Vector<T>& rest, const SpringLaw<T>& law) {
        others_.push_back(static_cast<std::uint32_t>(other * stride()));
        if (!from_reference_) rest_[0].add(rest.x), rest_[1].add(rest.y), rest_[2].add(rest.z);
        length_.add(law.length), stretch_.add(law.stretch);
        k_.add(law.k), quadratic_.add(law.quadratic), cubic_.add(law.cubic);
        last_ = law;
    }

    /// Keeps the vectors of a register of particles one after the other, from the first particle's on.
    [[gnu::always_inline]] void keep(const Vec& vectors, std::size_t first, std::size_t from) {
        T* const to = place_.data() + first * stride() + from;
        each_vector(
            vectors, [&](std::size_t lane, const Four& vector)
                         __attribute__((always_inline)) { vector.store(to + lane * stride()); });
    }

    [[gnu::always_inline]] Vec gathered(std::size_t slot, std::size_t from) const {
        const std::uint32_t* const others = others_.data() + slot;
        const T* const numbers = place_.data() + from;
        return gathered_vectors<T, N::count>([=](std::size_t lane)
                                                 __attribute__((always_inline)) { return numbers + others[lane]; });
    }

    [[gnu::always_inline]] Vec sum(std::size_t r, const Vec& own, const ParticleRegisters<T>& particles) const {
        Vec sum = particles.outside(r);
        const Vec reference = from_reference_ ? FieldLanes<const T>(references_).get(r) : Vec{};
        for (std::size_t slot = begin_[r]; slot < begin_[r + 1]; slot += N::count) {
            Vec e = gathered(slot, 0) - own;
            if (boxed_) e = {periods_[0].within(e.x), periods_[1].within(e.y), periods_[2].within(e.z)};
            const Vec rest = from_reference_ ? gathered(slot, four) - reference
                                             : Vec{rest_[0][slot], rest_[1][slot], rest_[2][slot]};
            const SpringGeometry<N> spring(rest, e);
            sum = sum + particles.of_forces(r, factor(slot, spring) * spring.d);
        }
        return sum;
    }

    [[gnu::always_inline]] N factor(std::size_t slot, const SpringGeometry<N>& spring) const {
        const SpringLaw<N> law{length_[slot], stretch_[slot], k_[slot], quadratic_[slot], cubic_[slot]};
        if (!linear_) return law.nonlinear_factor(spring);
        return where(law.length > N(T(0)), law.linear_factor(spring), law.k);
    }

    std::array<Periods<N>, 3> periods_;
    bool boxed_, from_reference_, linear_ = true;
    Field<T> references_;
    std::vector<std::size_t> begin_;     ///< of the row of each register of particles; one more
    std::vector<std::uint32_t> others_;  ///< where the other end of each spring is kept
    std::array<SpringQuantity<T>, 3> rest_;
    SpringQuantity<T> length_, stretch_, k_, quadratic_, cubic_;
    SpringLaw<T> last_;
    Numbers place_;  ///< of every particle
};

}  // namespace steplab
