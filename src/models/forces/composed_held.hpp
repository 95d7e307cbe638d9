#pragma once
// The pairs of a composition that are held within their cut-offs.

#include "core/field.hpp"
#include "core/pair_approach.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_pairs.hpp"
#include "models/forces/held_pairs.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace steplab {

template <class T>
class HeldTerms {
public:
    /// For every pair of a term with a cut-off, whether it is within it, or at it and approaches. `separation`: the
    /// vector between two particles.
    template <class Separation>
    static ActingPairs acting(const Approaches& approaches, const Field<T>& v, Separation separation) {
        ActingPairs acting;
        const auto at = [&](std::size_t i) { return Vector<T>{v.x()[i], v.y()[i], v.z()[i]}; };
        each_cut(approaches, [&](const Approaches::Pair& pair, T cutoff) {
            const Vector<T> d = separation(pair.first, pair.second);
            acting.push_back(is_within(d, at(pair.second) - at(pair.first), cutoff));
        });
        return acting;
    }

    /// Holds those that act in their terms. True if they are others than before.
    bool hold(const Approaches& approaches, ActingPairs acting, std::vector<PairForce<T>>& terms) {
        if (acting == acting_) return false;
        acting_ = std::move(acting);
        std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> of_terms(terms.size());
        std::size_t pair = 0;
        each_cut(approaches, [&](const Approaches::Pair& of, T) {
            if (acting_[pair++]) of_terms[of.term].emplace_back(of.first, of.second);
        });
        for (std::size_t t = 0; t < terms.size(); ++t) {
            if (terms[t].potential().cut()) terms[t].hold(std::move(of_terms[t]));
        }
        return true;
    }

    const ActingPairs& pairs() const { return acting_; }

    /// Calls f(i, j, cutoff, whether it acts) for every pair of a term with a cut-off.
    template <class F>
    void each(const Approaches& approaches, F f) const {
        std::size_t pair = 0;
        each_cut(approaches, [&](const Approaches::Pair& of, T cutoff) {
            f(std::size_t{of.first}, std::size_t{of.second}, cutoff, bool(acting_[pair++]));
        });
    }

private:
    template <class F>
    static void each_cut(const Approaches& approaches, F f) {
        for (const Approaches::Pair& pair : approaches.pairs) {
            const double cutoff = approaches.terms[pair.term].table.cutoff();
            if (cutoff > 0) f(pair, static_cast<T>(cutoff));
        }
    }

    ActingPairs acting_;
};

}  // namespace steplab
