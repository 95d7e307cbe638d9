#pragma once

#include "io/lammps/lammps_export.hpp"
#include "sim/run/run_description.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// How far steplab and LAMMPS are apart at one moment of the same run.
struct CrosscheckMoment {
    std::uint64_t step = 0;
    double time = 0;
    double position = 0, velocity = 0;  ///< the largest difference of a particle
    double energy = 0;                  ///< |difference|
    /// What rounding explains at most: that of every step so far, grown as two neighbouring motions diverge.
    double allowed_position = 0, allowed_velocity = 0;

    bool agrees() const { return position <= allowed_position && velocity <= allowed_velocity; }
};

/// The same scene computed by velocity Verlet here and by fix nve of LAMMPS there.
struct Crosscheck {
    enum class Verdict {
        rounding,   ///< they agree within rounding, or within the accuracy of tables
        sensitive,  ///< the same until rounding has grown to the size of the scene
        drag,       ///< they differ by LAMMPS' drag of first order: the difference halves with dt
        undecided,  ///< rounding grows so fast that no moment tells anything
        different,  ///< they do not agree
    };

    std::vector<CrosscheckMoment> moments;  ///< from the start on
    std::size_t decided = 0;                ///< the first so many, in which rounding is small beside the scene
    Verdict verdict = Verdict::different;
    double growth = 1;             ///< of the distance of two neighbouring motions, the largest
    double start_energy = 0;       ///< difference at the start, in parts of the scale of energies
    double table_error = 0;        ///< of the export
    std::optional<double> halved;  ///< with drag: the largest difference by that with half dt
    std::string lammps;            ///< its version

    bool agrees() const { return verdict != Verdict::different && verdict != Verdict::undecided; }
    /// The rate at which neighbouring motions diverge, in 1 / unit of time.
    double exponent() const;
    /// One sentence.
    std::string verdict_text() const;
};

struct CrosscheckOptions {
    std::uint64_t steps = 1000;
    std::uint64_t samples = 20;
    std::uint64_t ranks = 1;
    std::string folder;                                       ///< for the files of LAMMPS
    std::function<void(const std::string& folder)> exported;  ///< called before LAMMPS reads them; may be empty
    std::function<void(double fraction)> progress;            ///< may be empty
};

/// Throws UsageError for a scene that LAMMPS has nothing for, FileError where LAMMPS is not installed, Interrupted.
Crosscheck crosscheck(const RunDescription& run, const CrosscheckOptions& options);

}  // namespace steplab
