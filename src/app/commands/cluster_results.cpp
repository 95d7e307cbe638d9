#include "app/commands/cluster_results.hpp"

#include "app/commands/run_frame.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/input_file.hpp"
#include "io/lammps/lammps_dump.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/output_file.hpp"
#include "io/temporary_folder.hpp"
#include "io/trajectory.hpp"
#include "sim/run/divergence.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// The moments that a dump of a run is to have.
class ExpectedMoments {
public:
    explicit ExpectedMoments(const LammpsTime& time)
        : last_(time.steps), every_(time.every > 0 ? time.every : std::max<std::uint64_t>(1, time.steps)) {}

    void take(std::uint64_t step) {
        if (step != next_)
            throw FileError(fmt::format("the dump of LAMMPS has step {} where step {} belongs", step, next_));
        next_ = step < last_ ? std::min(step + every_, last_) : last_ + 1;
    }
    void check_reached(std::uint64_t step) const {
        if (next_ <= step)
            throw FileError(fmt::format("the dump of LAMMPS ends before step {}, it is to reach {}", next_, step));
    }

private:
    std::uint64_t last_, every_, next_ = 0;
};

/// Of two files, a piece at a time. Throws FileError.
bool same_content(const std::string& a, const std::string& b) {
    const InputFile first(a), second(b);
    constexpr std::uint64_t piece = 1 << 20;
    if (first.size() != second.size()) return false;
    for (std::uint64_t place = 0; place < first.size(); place += piece) {
        check_interruption();
        if (first.read(place, piece) != second.read(place, piece)) return false;
    }
    return true;
}

/// Judges energies as those of steplab's own runs are.
class EnergyJudge {
public:
    EnergyJudge(const RunDescription& run, const LammpsEnergy& start) : run_(run), start_(start) {}

    bool is_possible(const LammpsEnergy& now) {
        const double gain = now.total() - start_.total();
        if (!std::isfinite(gain)) return false;
        // the scale is no less than this, and takes a scene to be known
        if (gain_is_possible(gain, start_.kinetic + std::abs(start_.potential))) return true;
        if (scale_ < 0) scale_ = Simulation(run_).energy_scale();
        return gain_is_possible(gain, scale_ + std::abs(now.outside - start_.outside));
    }

private:
    const RunDescription& run_;
    const LammpsEnergy& start_;
    double scale_ = -1;  ///< not known yet
};

/// `energy`: the first that is impossible.
Divergence divergence_at(const LammpsEnergy& energy, double dt) {
    Divergence divergence;
    divergence.step = std::max<std::uint64_t>(energy.step, 1) - 1;
    divergence.time = static_cast<double>(divergence.step) * dt;
    divergence.dt = dt;
    divergence.message = fmt::format(
        "The run diverged in LAMMPS: its energy is {} at step {}, probably because dt = {} is "
        "too large.",
        std::isfinite(energy.total()) ? significant(energy.total(), 4) + " J" : "no number", energy.step,
        significant(dt, 4));
    return divergence;
}

}  // namespace

void write_cluster_rows(const RunDescription& run, const LammpsTime& time, const std::string& folder,
                        const RunResult& until, const std::string& out) {
    const RunDescription held = as_held(run);
    OutputFile file(out, compression_of(out));
    TrajectoryWriter writer(file, trajectory_format_of(out), run);
    RunFrame frame(held);
    LammpsDump dump(folder + '/' + lammps_files::trajectory, until.particles);
    ExpectedMoments expected(time);
    for (LammpsMoment moment; dump.next(moment) && moment.step <= until.steps;) {
        check_interruption();
        expected.take(moment.step);
        const double time = static_cast<double>(moment.step) * held.dt;
        writer.add(frame.at(moment.step, time, moment.positions, moment.velocities, writer.needs()));
    }
    expected.check_reached(until.steps);
    writer.finish();
    file.commit();
}

LammpsExport check_is_export(const RunDescription& run, const LammpsTime& time, const std::string& folder) {
    const TemporaryFolder again;
    LammpsExport written = export_to_lammps(run, time, again.path());
    for (const char* const name : {lammps_files::input, lammps_files::data}) {
        if (!same_content(folder + '/' + name, again.file(name)))
            throw UsageError(
                fmt::format("the files in '{}' are those of another scene or time: give SCENE, TIME and "
                            "--every as they were with --submit",
                            shown(folder)));
    }
    return written;
}

RunSummary cluster_summary(const RunDescription& run, std::uint64_t steps, std::size_t particles,
                           const std::vector<LammpsEnergy>& energies, double wall_seconds) {
    RunSummary summary;
    summary.run = run;
    summary.wall_seconds = wall_seconds;
    RunResult& result = summary.result;
    result.dt = as_held(run).dt;
    result.steps = steps;
    result.particles = particles;
    result.evaluations = steps + 1;
    result.energy_start = energies.front().total();
    EnergyJudge judge(run, energies.front());
    for (const LammpsEnergy& energy : energies) {
        if (!judge.is_possible(energy)) {
            result.divergence = divergence_at(energy, result.dt);
            result.steps = result.divergence->step;
            break;
        }
        result.energy_end = energy.total();
        result.energy_error = std::max(result.energy_error, std::abs(energy.total() - result.energy_start));
    }
    result.time = static_cast<double>(result.steps) * result.dt;
    result.hash = "none";
    return summary;
}

}  // namespace steplab
