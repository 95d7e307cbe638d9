#pragma once

#include "core/field.hpp"
#include "models/model.hpp"
#include "sim/run/act.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>

namespace steplab {

/// The motion of a scene from step 0 on, with what was done to it there, in closed form where that is known. It is
/// found when it is first asked for, also by several threads.
class MotionFromStart {
public:
    /// Particles up to which a closed form is looked for where something was done: finding one takes long, and a
    /// particle that is dragged asks often.
    static constexpr std::size_t most_particles = 64;

    /// `held`: as the precision holds it (as_held()).
    explicit MotionFromStart(RunDescription held);

    /// With this done at step 0 besides. Null for larger scenes.
    std::shared_ptr<const MotionFromStart> after(const Act& act) const;
    /// Of another description of the scene from step 0 on. Null for larger scenes that this one starts otherwise than
    /// they are described.
    std::shared_ptr<const MotionFromStart> in(RunDescription held) const;

    /// True if nothing was done: it is that of its description.
    bool is_as_described() const { return !start_; }
    /// Null if none is known.
    std::shared_ptr<const ExactSolution> solution() const;

private:
    MotionFromStart(RunDescription held, State<double> start);

    RunDescription held_;
    std::optional<State<double>> start_;  ///< none: that of the description
    mutable std::once_flag found_;
    mutable std::shared_ptr<const ExactSolution> solution_;
};

}  // namespace steplab
