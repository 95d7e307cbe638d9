#pragma once

#include "core/field.hpp"
#include "core/instructions.hpp"
#include "models/forces/forces.hpp"

#include <cstddef>

namespace steplab {

/// Sums over a piece of a scene in double, compiled for an instruction set; all of them compute the same bits.
struct EnergySums {
    /// Energy of what pulls at the first `own` of `held` particles from one another and from those behind them. Scenes
    /// that are no chain or grid are taken in one piece.
    PotentialEnergy (*potential)(const Forces& forces, const Field<double>& u, std::size_t held, std::size_t own);
    /// Of the first `count` vectors.
    double (*squares)(const Field<double>& v, std::size_t count);
};

/// Those of an instruction set that this program was compiled for.
const EnergySums& energy_sums(Instructions instructions);

}  // namespace steplab
