#pragma once

#include "core/field.hpp"
#include "core/vec3.hpp"
#include "models/plan.hpp"
#include "sim/run/resolution.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// The fastest oscillation of a scene as its particles are at one moment.
struct FastestOscillation {
    double omega = 0;             ///< angular frequency [rad/s]; 0 if nothing is driven back
    std::vector<Vec3> shape;      ///< displacements in it of all particles, of which the longest is 1
    std::vector<double> weights;  ///< share of each particle in its kinetic energy; their sum is 1
};

/// How the steps of a run stand to it.
struct PresentLimit {
    std::uint64_t step = 0;  ///< of the run, at that moment
    double time = 0;         ///< [s]
    FastestOscillation oscillation = {};
    /// The largest stable dt by linear theory, drag included: 0 = unstable at any dt, infinity = stable at any. None of
    /// a method that chooses its own steps.
    std::optional<double> limit = {};
    std::optional<Resolution> resolution = {};  ///< of the oscillation by the steps of the run
};

/// Finds it for one moment of runs after the other, by the method of Lanczos on the exact Jacobian of the forces.
/// Keeps the scene between two questions about the same one.
class PresentLimits {
public:
    PresentLimits();
    ~PresentLimits();
    PresentLimits(PresentLimits&&) noexcept;
    PresentLimits& operator=(PresentLimits&&) noexcept;

    /// Beyond so many particles an answer takes longer than a person waits for a read-out.
    static constexpr std::size_t most_particles = 20'000;

    /// Of the scene of a description in this state. Of oscillations of one frequency, that which has most of the
    /// motion. Throws UsageError, Interrupted.
    FastestOscillation oscillation(const RunDescription& description, const State<double>& state);
    /// The same with what it means for the run; `step` and `time` are those of the moment.
    PresentLimit at(const RunDescription& description, const State<double>& state, std::uint64_t step, double time);
    /// The scene as it is stepped.
    const Plan& plan(const RunDescription& description);

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
