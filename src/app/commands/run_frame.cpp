#include "app/commands/run_frame.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <memory>
#include <utility>

namespace steplab {

RunFrame::RunFrame(const RunDescription& run) {
    const Plan plan = plan_of(run);
    frame_.shape = std::make_shared<const Shape>(model_of(run).shape(run.scene));
    frame_.reference = plan.reference;
    frame_.mass = plan.masses.empty() ? plan.mass : 0;
}

const Frame& RunFrame::at(std::uint64_t step, double time, std::vector<Vec3>& positions, std::vector<Vec3>& velocities,
                          const FrameParts& wanted) {
    frame_.step = step;
    frame_.time = time;
    std::swap(frame_.positions, positions);
    std::swap(frame_.velocities, velocities);
    if (!wanted.displacements) return frame_;
    frame_.displacements.resize(frame_.positions.size());
    frame_.reference.each(0, frame_.positions.size(),
                          [&](std::size_t i, Vec3 at) { frame_.displacements[i] = frame_.positions[i] - at; });
    return frame_;
}

}  // namespace steplab
