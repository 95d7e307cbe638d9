#pragma once

#include "lab/study/reference_motion.hpp"
#include "session/session_view.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace steplab {

/// How far runs are from the motion of their scene, for the panel of a picture: at one time after the other.
class PicturedErrors {
public:
    /// Adds a run, which stands at its start; the leading one first. Throws UsageError.
    void add(const Simulation& run);

    /// Of all runs as they stand now, in the order in which they were added. Throws Interrupted.
    SessionErrors of(const std::vector<const Simulation*>& runs);

private:
    struct Reference {
        ReferenceMotion motion;  ///< of the run's own parameters
        Vec3 start_momentum;
    };

    static std::optional<Compared> compared_with(Reference& reference, const Simulation& run);

    std::vector<Reference> references_;
};

}  // namespace steplab
