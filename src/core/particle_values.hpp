#pragma once

#include <string>
#include <vector>

namespace steplab {

/// A number of each particle besides its position and velocity, which a file of another program has: a charge, an
/// energy, whatever it computed.
struct ParticleValues {
    std::string name;            ///< of the column
    std::vector<double> values;  ///< one per particle; NaN where it is missing

    friend bool operator==(const ParticleValues&, const ParticleValues&) = default;
};

}  // namespace steplab
