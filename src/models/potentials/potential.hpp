#pragma once

#include "core/number.hpp"

#include <span>
#include <string_view>

namespace steplab {

/// How a pair potential describes itself. One is a class template over the type of its constants, in a file of this
/// folder, and its name in list.hpp; it is constructed from the values of its parameters and has, in any number type
/// made of that type,
///   energy(at)   V(r)
///   factor(at)   -V'(r) / r: the force on a particle is this times its distance vector from the other
/// and, if it has a weight, factor(at, weight): the same times that; and, if the force may go to zero smoothly where
/// two particles meet, jumps_at_contact(): whether it does not.
struct PotentialInfo {
    struct Parameter {
        std::string_view name;
        bool required = true;   ///< else 0 by default
        bool positive = false;  ///< must be > 0
    };
    /// What the potential is multiplied by.
    enum class Weight { none, masses, charges };

    std::string_view name;                  ///< in scene files: letters and hyphens
    std::span<const Parameter> parameters;  ///< first an energy, where there is no weight
    Weight weight = Weight::none;
};

/// The distance of two particles; its root is taken where a formula needs it, and divided by once.
template <class N>
struct PairDistance {
    N squared;
    N length() const { return square_root(squared); }
    N inverse_squared() const { return N(1) / squared; }
    N inverse() const { return length() * inverse_squared(); }
};

}  // namespace steplab
