#pragma once

#include <cstdint>
#include <optional>
#include <steplab/run.hpp>
#include <steplab/scene.hpp>
#include <steplab/visibility.hpp>
#include <string>
#include <vector>

namespace steplab::library {

/// The stability limit of a method on a scene. Time steps [s]; 0: unstable at any dt, infinity: stable at any dt.
struct Limit {
    std::string method, precision;
    double omega_max = 0;            ///< largest angular frequency of the scene at its start [rad/s]
    std::optional<double> theory;    ///< none: not known, and the note says why
    std::optional<double> measured;  ///< none: not measured, and the note says why
    std::string note;
};

/// The limits of these methods, or of all if none is named, from linear theory and measured on runs. Throws UsageError,
/// Interrupted.
STEPLAB_PUBLIC std::vector<Limit> limits(const Scene& scene, const std::vector<std::string>& methods = {},
                                         const std::string& precision = "double");

/// The errors of a run over time, beside the motion of its scene as accurately as it can be known. All have a number
/// for each time; not a number where it is not known.
struct Comparison {
    std::string method, precision;
    double dt = 0;
    std::vector<double> times = {};            ///< [s]; ends where the run diverged
    std::vector<double> error = {};            ///< largest distance of a particle from the reference [m]
    std::vector<double> rms_error = {};        ///< root of the mean squared distance of the moving particles [m]
    std::vector<double> energy_error = {};     ///< [J]
    std::vector<double> momentum_error = {};   ///< [kg m/s]
    std::vector<double> reference_error = {};  ///< estimated [m]
    std::vector<std::uint64_t> evaluations = {};
    std::string reference = {};  ///< in words
    std::string reason = {};     ///< empty unless it diverged
};

/// Runs of one scene, one to four, compared at `samples` (1 to 1e12) equal parts of the time `until` > 0. Throws
/// UsageError, also where the samples do not fit memory, Interrupted.
STEPLAB_PUBLIC std::vector<Comparison> compare(const Scene& scene, const std::vector<Settings>& runs, double until,
                                               std::uint64_t samples = 100);

/// One run from the start of a scene over a time, its errors and its cost.
struct Measurement {
    std::string method, precision;
    double dt = 0;               ///< [s]
    Parameters parameters = {};  ///< of the method
    std::uint64_t steps = 0, evaluations = 0;
    double error = 0;                    ///< largest distance of a particle from the reference at the end [m]
    double energy_error = 0;             ///< largest on the way [J]
    std::optional<double> wall_seconds;  ///< of the stepping alone; none of a run that was not timed
    std::string status, hash;
};

/// What is measured: all methods and both precisions unless some are named.
struct Studied {
    std::vector<std::string> methods = {}, precisions = {};
    bool quick = true;  ///< shorter series and runs
};

/// Every method and precision over a series of decreasing dt, or tolerance: what `steplab report` measures of a scene.
/// Throws UsageError, Interrupted.
STEPLAB_PUBLIC std::vector<Measurement> report(const Scene& scene, double until, const Studied& studied = {});

/// The fastest run that keeps an error, and the best run of every other method that does.
struct Advice {
    Measurement best;
    std::vector<Measurement> others;  ///< fastest first
    std::string command;              ///< options of `steplab run` that repeat the best run
    std::string reference;            ///< in words
};

/// Finds method, precision and dt for an error [m] > 0 at the time `until`. Throws UsageError, naming the smallest
/// error that was reached, if none keeps it, Interrupted.
STEPLAB_PUBLIC Advice advise(const Scene& scene, double error, double until, const Studied& studied = {});

/// The order of a method as its errors on a scene at time `until` show it: the slope of log error against log dt. None
/// where no two runs are between rounding and coarse steps. Throws UsageError, Interrupted.
STEPLAB_PUBLIC std::optional<double> order(const Scene& scene, const std::string& method, double until);

}  // namespace steplab::library
