#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/pair_range.hpp"
#include "core/stages.hpp"
#include "models/forces/morse_pair.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// For every pair i < j, row by row, whether its particles act on each other.
using ActingPairs = std::vector<bool>;

/// Whether a pair at the vector d, which moves with w, is within a cut-off; at it, whether it approaches.
template <class T>
bool is_within(const Vector<T>& d, const Vector<T>& w, T cutoff) {
    const T beyond = square_root(d.x * d.x + d.y * d.y + d.z * d.z) - cutoff;
    if (magnitude(beyond) > cutoff_width(cutoff)) return beyond < T(0);
    return d.x * w.x + d.y * w.y + d.z * w.z < T(0);
}

/// Pairs that act on each other, and no others, for as long as they are held: by the formula that holds within the
/// cut-off and goes on smoothly beyond it.
template <class T>
class HeldPairs {
public:
    /// True if they are others than before.
    bool hold(ActingPairs acting, std::size_t particles) {
        if (acting == acting_) return false;
        acting_ = std::move(acting);
        pairs_.clear();
        std::size_t pair = 0;
        for (std::uint32_t i = 0; i < particles; ++i) {
            for (std::uint32_t j = i + 1; j < particles; ++j) {
                if (acting_[pair++]) pairs_.push_back({i, j});
            }
        }
        return true;
    }
    bool any() const { return !acting_.empty(); }
    const ActingPairs& acting() const { return acting_; }

    template <class F>
    void each(F f) const {
        for (const auto& [i, j] : pairs_) f(std::size_t{i}, std::size_t{j});
    }

    /// The sum of the pulls, pair after pair. `separation`: the vector between two particles at the positions.
    template <class Separation>
    void accelerations(const CutMorseConstants<T>& morse, Separation separation, Field<T>& a) const {
        std::fill(a.flat().begin(), a.flat().end(), T(0));
        if constexpr (HasLanes<T>) {
            for (const auto& [i, j] : pairs_) scatter(i, j, morse_pull(morse, separation(j, i)), a);
        } else {
            for (std::size_t first = 0; first < pairs_.size(); first += N::count)
                add_register(constants_as<N>(morse), separation, first, a);
        }
    }

private:
    template <class Number>
    struct InLanes {
        using Type = Lanes<Number>;
    };
    template <HasLanes Number>
    struct InLanes<Number> {
        using Type = Number;
    };
    using N = typename InLanes<T>::Type;

    template <class Separation>
    void add_register(const CutMorseConstants<N>& morse, Separation separation, std::size_t first, Field<T>& a) const {
        const std::size_t count = std::min(N::count, pairs_.size() - first);
        alignas(64) std::array<std::array<T, N::count>, 3> along;
        for (auto& axis : along) axis.fill(T(1));
        for (std::size_t lane = 0; lane < count; ++lane) {
            const auto d = separation(pairs_[first + lane].second, pairs_[first + lane].first);
            along[0][lane] = d.x, along[1][lane] = d.y, along[2][lane] = d.z;
        }
        const auto load = [&](std::size_t axis) { return N::load(along[axis].data()); };
        const Vector<N> pull = morse_pull(morse, Vector<N>{load(0), load(1), load(2)});
        for (std::size_t lane = 0; lane < count; ++lane) {
            const auto& [i, j] = pairs_[first + lane];
            scatter(i, j, Vector<T>{pull.x[lane], pull.y[lane], pull.z[lane]}, a);
        }
    }

    static void scatter(std::size_t i, std::size_t j, const Vector<T>& pull, Field<T>& a) {
        a.x()[i] = a.x()[i] + pull.x, a.y()[i] = a.y()[i] + pull.y, a.z()[i] = a.z()[i] + pull.z;
        a.x()[j] = a.x()[j] - pull.x, a.y()[j] = a.y()[j] - pull.y, a.z()[j] = a.z()[j] - pull.z;
    }

    ActingPairs acting_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

}  // namespace steplab
