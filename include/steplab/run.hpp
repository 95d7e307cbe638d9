#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <steplab/scene.hpp>
#include <steplab/visibility.hpp>
#include <string>
#include <vector>

namespace steplab::library {

/// How a scene is stepped. What is not given is as the scene file says it, else rk4, double, dt = 0.1 s.
struct Settings {
    std::string method = {};
    std::optional<double> dt = {};  ///< [s]; < 0: backward in time
    std::string precision = {};     ///< "float" or "double"
    Parameters parameters = {};     ///< of the method
    std::size_t threads = 0;        ///< largest number; 0: that of the processors
};

/// Where a run ends: after a number of steps, or at a time [s]. Neither: at the end that the scene file gives, else
/// after 1000 steps.
struct End {
    std::optional<std::uint64_t> steps = {};
    std::optional<double> until = {};
};

/// What a run recorded, in f rows of n particles. Vectors have three components: positions[3 (row n + particle) +
/// axis].
struct Recording {
    std::vector<std::uint64_t> steps;                ///< f
    std::vector<double> times;                       ///< f [s]
    std::vector<double> positions;                   ///< 3 n f [m]
    std::vector<double> velocities;                  ///< 3 n f [m/s]
    std::vector<double> kinetic, potential, energy;  ///< f [J]
    std::vector<double>
        energy_error;           ///< f [J]: energy less that at the start, the work of drag added where it is counted
    std::size_t particles = 0;  ///< n
};

/// How a run ended.
struct Result {
    Recording rows;
    std::string method, precision;
    double dt = 0;                   ///< [s], as the precision holds it
    std::uint64_t evaluations = 0;   ///< of the forces
    std::string status;              ///< "ok", "diverged" or "stopped"
    std::string reason;              ///< why, if it is not "ok": the rows then end with the last valid step
    std::string hash;                ///< of the final state, as `steplab run` prints it
    std::vector<std::string> notes;  ///< what rounding does to the run; none as a rule
    std::optional<double> error;     ///< largest distance from the exact solution at the end [m], where one is known
    double wall_seconds = 0;

    /// Throws Diverged with the reason unless the status is "ok".
    STEPLAB_PUBLIC void check() const;
};

/// What is recorded besides steps, times and energies.
struct Recorded {
    std::uint64_t every = 0;  ///< steps between two rows; 0: first and last step only
    bool positions = true, velocities = true;
};

/// Runs a scene, with the same bits as `steplab run`. Throws UsageError, also where the rows do not fit memory.
STEPLAB_PUBLIC Result run(const Scene& scene, const Settings& settings = {}, const End& end = {},
                          const Recorded& recorded = {});

/// The rows of a file of frames. Its steps are numbered in order where it has none; velocities that it does not have
/// are 0.
struct Trajectory {
    Recording rows;          ///< without energies
    std::string run;         ///< how it was made: options of the command line; empty of a file that does not say it
    bool complete = true;    ///< false: the file is damaged or cut off behind these rows
    std::string fault = {};  ///< what is wrong there
};

/// Reads frames first, first + every ... of a file that `steplab run --out` wrote, or another program as extended XYZ
/// or LAMMPS dump, also compressed. Throws FileError if there is none that can be read, UsageError if its rows do not
/// fit memory.
STEPLAB_PUBLIC Trajectory read(const std::string& file, std::uint64_t first = 0, std::uint64_t every = 1);

}  // namespace steplab::library
