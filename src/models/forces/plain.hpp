#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "models/forces/forces.hpp"

#include <vector>

namespace steplab {

/// The forces of any scene computed in the most straightforward way, on absolute positions, pair by pair, as in a first
/// program. Used by the 2008 variants, whose failures depend on this order of operations (docs/curiosities.md), and as
/// a check of the layouts. Springs: d = x(j) - x(i), s = k (|d| - L) / |d|, f = s d, a(i) += f / m, a(j) -= f / m.
template <class T>
class Plain {
public:
    static constexpr ForceCapabilities capabilities{};

    explicit Plain(const Forces& forces);

    /// `positions` are absolute.
    void accelerations(const Field<T>& positions, Field<T>& a) const;

private:
    struct PlainSpring {
        std::size_t i, j;
        T length;
    };

    void add(const ConstantForces& forces);
    void add(const LineForces& forces);
    void add(const GridForces& forces);
    void add(const PairForces& forces);
    void add(const NearPairForces& forces);
    void add(const ComposedForces& forces);

    void add_springs(const Field<T>& positions, Field<T>& a) const;
    void add_pairs(const Field<T>& positions, Field<T>& a) const;
    /// Without cut-off; positive if repulsive.
    T morse_force(T distance) const;

    std::vector<PlainSpring> springs_;
    std::vector<std::size_t> fixed_;
    T mass_ = T(1);
    T k_ = T(0);
    T constant_step_ = T(0);
    T gravity_ = T(0);
    bool morse_ = false;
    T depth_ = T(0), b_ = T(0), r0_ = T(0), cutoff_ = T(0), force_at_cutoff_ = T(0), period_ = T(0);
};

}  // namespace steplab
