#include "app/commands/cluster_results.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "io/lammps/lammps_dump.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/output_file.hpp"
#include "io/trajectory.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace steplab {

namespace {

/// What frames of one run have in common.
Frame empty_frame(const RunDescription& run, const Plan& plan) {
    Frame frame;
    frame.shape = std::make_shared<const Shape>(model_of(run).shape(run.scene));
    frame.reference = plan.reference;
    frame.mass = plan.masses.empty() ? plan.mass : 0;
    return frame;
}

void take(LammpsMoment& moment, double dt, const FrameParts& needs, Frame& frame) {
    frame.step = moment.step;
    frame.time = static_cast<double>(moment.step) * dt;
    std::swap(frame.positions, moment.positions);
    std::swap(frame.velocities, moment.velocities);
    if (!needs.displacements) return;
    frame.displacements.resize(frame.positions.size());
    frame.reference.each(0, frame.positions.size(),
                         [&](std::size_t i, Vec3 at) { frame.displacements[i] = frame.positions[i] - at; });
}

}  // namespace

void write_cluster_rows(const RunDescription& run, const std::string& folder, std::size_t particles,
                        const std::string& out) {
    const RunDescription held = as_held(run);
    OutputFile file(out, compression_of(out));
    TrajectoryWriter writer(file, trajectory_format_of(out), run);
    Frame frame = empty_frame(held, plan_of(held));
    LammpsDump dump(folder + '/' + lammps_files::trajectory, particles);
    for (LammpsMoment moment; dump.next(moment);) {
        check_interruption();
        take(moment, held.dt, writer.needs(), frame);
        writer.add(frame);
    }
    writer.finish();
    file.commit();
}

RunSummary cluster_summary(const RunDescription& run, std::uint64_t steps, std::size_t particles,
                           const std::vector<LammpsEnergy>& energies, double wall_seconds) {
    RunSummary summary;
    summary.run = run;
    summary.wall_seconds = wall_seconds;
    RunResult& result = summary.result;
    result.dt = as_held(run).dt;
    result.steps = steps;
    result.time = static_cast<double>(steps) * result.dt;
    result.particles = particles;
    result.evaluations = steps + 1;
    result.energy_start = energies.front().total();
    result.energy_end = energies.back().total();
    for (const LammpsEnergy& energy : energies) {
        if (!std::isfinite(energy.total()))
            throw Error(ExitCode::diverged,
                        fmt::format("the energy is no number at step {}: the run diverged in LAMMPS, "
                                    "probably because dt is too large",
                                    energy.step));
        result.energy_error = std::max(result.energy_error, std::abs(energy.total() - result.energy_start));
    }
    result.hash = "none";
    return summary;
}

}  // namespace steplab
