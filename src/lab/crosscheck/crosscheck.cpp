#include "lab/crosscheck/crosscheck.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "io/lammps/lammps_dump.hpp"
#include "io/lammps/lammps_run.hpp"
#include "lab/crosscheck/neighbouring_run.hpp"
#include "models/scene/scene_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unistd.h>

namespace steplab {

namespace {

/// Both programs round a position and a force in every step, each a few times.
constexpr double roundings_of_a_step = 8;
/// From this part of the scene's spacing on rounding hides what is compared.
constexpr double resolvable = 1e-3;
/// Of energies at the start, which are sums.
constexpr double allowed_start_energy = 1e-9;
constexpr unsigned microseconds_of_waiting = 20'000;

double size_of(const Frame& frame) {
    double size = frame.shape->spacing;
    for (const Vec3 at : frame.positions) size = std::max(size, length(at));
    return size;
}

/// LAMMPS and steplab on one scene at the same times.
class CrosscheckRun {
public:
    CrosscheckRun(const RunDescription& run, const LammpsExport& written, const CrosscheckOptions& options)
        : written_(written), scene_(model_of(run).scene(run.scene)), particles_(scene_), simulation_(run) {
        compute(options);
        compare(run, options);
    }
    Crosscheck result;

private:
    /// LAMMPS takes its time while nothing is computed here.
    void compute(const CrosscheckOptions& options) {
        LammpsRun lammps(options.folder, options.ranks);
        while (lammps.is_running()) {
            check_interruption();
            const double done = static_cast<double>(lammps.output().step().value_or(0));
            if (options.progress)
                options.progress(done / static_cast<double>(std::max<std::uint64_t>(1, options.steps)));
            usleep(microseconds_of_waiting);
        }
        lammps.finish();
        energies_ = lammps.output().energies();
        result.lammps = lammps.output().version();
    }

    void compare(const RunDescription& run, const CrosscheckOptions& options) {
        LammpsDump dump(options.folder + '/' + lammps_files::trajectory, written_.particles);
        simulation_.frame(frame_, {.displacements = true});
        simulation_.forces(forces_);
        NeighbouringRun neighbour(run, frame_, forces_, size_of(frame_));
        for (LammpsMoment moment; dump.next(moment);) {
            simulation_.advance(moment.step - simulation_.step());
            if (simulation_.divergence())
                throw Error(ExitCode::diverged,
                            simulation_.divergence()->message + "; LAMMPS was not compared further");
            simulation_.frame(frame_);
            add(moment, neighbour.at(frame_), run.dt);
        }
        judge();
    }

    void add(const LammpsMoment& theirs, const Amplification& growth, double dt) {
        CrosscheckMoment moment{.step = theirs.step, .time = frame_.time};
        for (std::size_t i = 0; i < theirs.positions.size(); ++i) {
            moment.position = std::max(moment.position, length(theirs.positions[i] - frame_.positions[i]));
            moment.velocity = std::max(moment.velocity, length(theirs.velocities[i] - frame_.velocities[i]));
        }
        compare_energies(moment);
        const double moves = static_cast<double>(1 + theirs.step) * rounding_of_a_step(dt);
        moment.allowed_position = moves * growth.position;
        moment.allowed_velocity = moves * std::max(growth.velocity, 1 / (steps_of_a_kick * dt));
        result.growth = growth.position;
        result.moments.push_back(moment);
    }

    /// What a step adds to the difference of positions.
    double rounding_of_a_step(double dt) {
        size_ = std::max(size_, size_of(frame_));
        double by_tables = 0;
        if (written_.table_error > 0) {
            simulation_.forces(forces_);
            acceleration_ = std::max(acceleration_, written_.neighbour_acceleration);
            for (std::size_t i = 0; i < forces_.size(); ++i)
                acceleration_ = std::max(acceleration_, length(forces_[i]) / particles_[i].mass);
            by_tables = written_.table_error * acceleration_ * dt * dt * steps_of_a_kick;
        }
        constexpr double epsilon = std::numeric_limits<double>::epsilon();
        return roundings_of_a_step * (epsilon * size_ + by_tables);
    }

    void compare_energies(CrosscheckMoment& moment) {
        const auto theirs = std::find_if(energies_.begin(), energies_.end(),
                                         [&](const LammpsEnergy& energy) { return energy.step == moment.step; });
        if (theirs == energies_.end()) return;
        const Diagnostics ours = simulation_.diagnostics();
        moment.energy = std::abs(theirs->total() - ours.energy);
        energy_scale_ = std::max(
            {energy_scale_, ours.kinetic + std::abs(ours.potential), theirs->kinetic + std::abs(theirs->potential)});
    }

    void judge() {
        using Verdict = Crosscheck::Verdict;
        if (result.moments.empty()) throw FileError("LAMMPS wrote no moment of the run");
        result.table_error = written_.table_error;
        const double start = result.moments.front().energy;
        result.start_energy = start > 0 ? start / energy_scale_ : 0;
        const double most = resolvable * frame_.shape->spacing;
        const auto blurred = std::find_if(result.moments.begin(), result.moments.end(),
                                          [&](const CrosscheckMoment& m) { return m.allowed_position > most; });
        result.decided = static_cast<std::size_t>(blurred - result.moments.begin());
        const bool same = std::all_of(result.moments.begin(), blurred, [](const auto& m) { return m.agrees(); });
        const double energy = std::max(allowed_start_energy, 10 * written_.table_error);
        if (result.moments.size() > 1 && result.decided <= 1)
            result.verdict = Verdict::undecided;
        else if (!same || result.start_energy > energy)
            result.verdict = Verdict::different;
        else
            result.verdict = blurred == result.moments.end() ? Verdict::rounding : Verdict::sensitive;
    }

    const LammpsExport& written_;
    Scene scene_;
    SceneParticles particles_;  ///< of the scene
    Simulation simulation_;
    Frame frame_;
    std::vector<Vec3> forces_;
    std::vector<LammpsEnergy> energies_;
    double size_ = 0, acceleration_ = 0, energy_scale_ = 0;
};

Crosscheck compared(const RunDescription& run, const CrosscheckOptions& options) {
    const std::uint64_t every = std::max<std::uint64_t>(1, options.steps / std::max<std::uint64_t>(1, options.samples));
    const LammpsExport written = export_to_lammps(run, {.steps = options.steps, .every = every}, options.folder);
    if (options.exported) options.exported(options.folder);
    return CrosscheckRun(run, written, options).result;
}

double largest_difference(const Crosscheck& check) {
    double largest = 0;
    for (const CrosscheckMoment& moment : check.moments) largest = std::max(largest, moment.position);
    return largest;
}

/// Errors of first order are halved, within a quarter for those of higher order.
bool is_halved(double factor) { return factor > 1.6 && factor < 2.5; }

}  // namespace

double Crosscheck::exponent() const {
    const double time = moments.empty() ? 0 : moments.back().time;
    return time > 0 ? std::log(growth) / time : 0;
}

std::string Crosscheck::verdict_text() const {
    const std::string within = table_error > 0 ? "within the accuracy of the tables" : "within rounding";
    switch (verdict) {
        case Verdict::rounding:
            return fmt::format("steplab and LAMMPS agree {}", within);
        case Verdict::sensitive:
            return fmt::format(
                "steplab and LAMMPS agree {} up to t = {}; later the motion has amplified it to the size of the scene "
                "(by {} in all, a rate of {} per unit of time)",
                within, significant(moments[decided - 1].time, 4), rounded_text(growth), rounded_text(exponent()));
        case Verdict::drag:
            return fmt::format(
                "steplab and LAMMPS differ as LAMMPS takes drag explicitly: the difference becomes {} times smaller "
                "with "
                "half the time step, as an error of first order does",
                significant(*halved, 3));
        case Verdict::undecided:
            return "undecided: the motion amplifies rounding to the size of the scene before the first moment; compare "
                   "a "
                   "shorter run";
        case Verdict::different:
            break;
    }
    const std::string drag =
        halved ? fmt::format(", and becomes {} times smaller with half the time step", significant(*halved, 3)) : "";
    return fmt::format("steplab and LAMMPS do not agree: the difference is larger than rounding explains{}", drag);
}

Crosscheck crosscheck(const RunDescription& given, const CrosscheckOptions& options) {
    const RunDescription run = with_method(given, "velocity-verlet");
    Crosscheck first = compared(run, options);
    if (!has_drag(run) || first.verdict != Crosscheck::Verdict::different) return first;
    RunDescription finer = run;
    finer.dt /= 2;
    CrosscheckOptions twice = options;
    twice.steps *= 2;
    first.halved = largest_difference(first) / largest_difference(compared(finer, twice));
    const bool start_agrees = first.start_energy <= std::max(allowed_start_energy, 10 * first.table_error);
    if (is_halved(*first.halved) && start_agrees) first.verdict = Crosscheck::Verdict::drag;
    return first;
}

}  // namespace steplab
