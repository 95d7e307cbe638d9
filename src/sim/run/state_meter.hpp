#pragma once

#include "core/diagnostics.hpp"
#include "core/field.hpp"
#include "core/frame.hpp"
#include "models/conservation.hpp"
#include "models/model.hpp"
#include "sim/run/energy.hpp"
#include "sim/run/particle_forces.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// Measures states of a run that were computed before, with the bits with which the run itself measures them: frames of
/// a trajectory file.
class StateMeter {
public:
    /// Throws UsageError if the description cannot be run (see check()).
    explicit StateMeter(const RunDescription& description);

    std::size_t particles() const { return scene_.reference.count; }
    const std::shared_ptr<const Shape>& shape() const { return shape_; }
    const Conservation& conservation() const { return conservation_; }
    /// Where the particles are by their exact solution; null if none is known. A scene changed under way has another.
    const std::shared_ptr<const ExactSolution>& exact() const { return exact_; }

    /// Of a frame of all particles with displacements and velocities; its energy error is 0.
    Diagnostics measure(const Frame& frame);
    /// The forces in N on all particles of the frame that was measured last.
    void forces(std::vector<Vec3>& out);

private:
    Plan scene_;
    Conservation conservation_;
    std::shared_ptr<const Shape> shape_;
    std::shared_ptr<const ExactSolution> exact_;
    EnergyMeter meter_;
    std::optional<ParticleForces> forces_;
    State<double> state_;
};

}  // namespace steplab
