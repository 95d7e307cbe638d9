#include "lab/crosscheck/neighbouring_run.hpp"

#include "models/scene/random_start.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace steplab {

namespace {

/// In parts of the scene: large beside rounding, so that the growth is that of the motion.
constexpr double relative_distance = 1e-10;

/// 1 along axes of motion, 0 along others.
Vec3 axes_of(const std::vector<Vec3>& velocities, const std::vector<Vec3>& forces) {
    Vec3 axes;
    for (const std::vector<Vec3>* const vectors : {&velocities, &forces}) {
        for (const Vec3 v : *vectors) {
            if (v.x != 0) axes.x = 1;
            if (v.y != 0) axes.y = 1;
            if (v.z != 0) axes.z = 1;
        }
    }
    return axes;
}

Vec3 along(Vec3 axes, Vec3 v) { return {axes.x * v.x, axes.y * v.y, axes.z * v.z}; }

RunDescription beside(RunDescription run, const Frame& start, Vec3 axes, double distance) {
    auto values = std::make_shared<StartingValues>();
    for (std::size_t i = 0; i < start.displacements.size(); ++i) {
        const bool fixed = start.shape->roles[i] == Role::fixed;
        const double scale = fixed ? 0 : distance;
        const Vec3 move = random_displacement({scale, 2008}, i),
                   kick = random_displacement({scale / (steps_of_a_kick * run.dt), 8002}, i);
        values->displacements.push_back(start.displacements[i] + along(axes, move));
        values->positions.push_back(start.reference.at(i) + values->displacements.back());
        values->velocities.push_back(start.velocities[i] + along(axes, kick));
    }
    run.start = {.from = std::move(values)};
    return run;
}

}  // namespace

NeighbouringRun::NeighbouringRun(const RunDescription& run, const Frame& start, const std::vector<Vec3>& forces,
                                 double size)
    : distance_(relative_distance * size),
      simulation_(beside(run, start, axes_of(start.velocities, forces), distance_)) {}

Amplification NeighbouringRun::at(const Frame& moment) {
    simulation_.advance(moment.step - simulation_.step());
    simulation_.frame(frame_);
    for (std::size_t i = 0; i < frame_.positions.size(); ++i) {
        largest_.position = std::max(largest_.position, length(frame_.positions[i] - moment.positions[i]) / distance_);
        largest_.velocity =
            std::max(largest_.velocity, length(frame_.velocities[i] - moment.velocities[i]) / distance_);
    }
    return largest_;
}

}  // namespace steplab
