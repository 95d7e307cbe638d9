#pragma once

#include "core/vec3.hpp"
#include "session/run_samples.hpp"
#include "sim/run/exact_motion.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace steplab::ui {

/// The exact motion of a tracked particle at one time. Values that are not known are not numbers.
struct ExactPoint {
    double time = 0;    ///< [s]
    Vec3 displacement;  ///< from its rest position [m]
    Vec3 velocity;      ///< [m/s]
};

/// The exact motion of a tracked particle on a grid of its own: at the samples of the run, and between two of them
/// where it is not straight, as where a step is a good part of a period. Its points depend on the samples alone.
class ExactCurve {
public:
    /// Of scenes of more particles, all of which are summed up for each point, there are fewer points between samples,
    /// and none between many.
    static constexpr std::size_t most_particles_in_full = 256;

    /// Of the particle in this place of the samples. None where no exact solution was known at any of them. `motion`:
    /// as it is known now; what was found stays when it is not known any more.
    std::span<const ExactPoint> of(const SampleSeries& series, std::size_t place,
                                   const std::optional<ExactMotion>& motion, std::size_t particles);

private:
    bool is_of(const SampleSeries& series, const std::optional<ExactMotion>& motion, std::size_t parts) const;
    void add(double time, const Sample::Particle* known);
    void fill(const ExactPoint& to);
    ExactPoint point_at(double time) const;

    std::shared_ptr<const int> stretch_;
    std::optional<ExactMotion> motion_;
    std::size_t parts_ = 1;  ///< of the time between two samples where the motion is not straight
    std::size_t used_ = 0;
    bool known_ = false;
    double farthest_ = 0, fastest_ = 0;  ///< at the samples
    std::vector<ExactPoint> points_;
};

}  // namespace steplab::ui
