#pragma once

#include "models/potentials/coulomb.hpp"
#include "models/potentials/gravity.hpp"
#include "models/potentials/lennard-jones.hpp"
#include "models/potentials/morse.hpp"

#include <array>
#include <string_view>

namespace steplab {

template <template <class> class... Potentials>
struct PotentialList {
    static constexpr std::array infos{&Potentials<double>::info...};
};

/// The built-in pair potentials.
using BuiltInPotentials = PotentialList<MorsePotential, LennardJones, Gravity, Coulomb>;

/// None of that name: nullptr.
inline const PotentialInfo* built_in_potential(std::string_view name) {
    for (const PotentialInfo* info : BuiltInPotentials::infos) {
        if (info->name == name) return info;
    }
    return nullptr;
}

}  // namespace steplab
