#pragma once

#include "io/child_program.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// Energies as LAMMPS prints them.
struct LammpsEnergy {
    std::uint64_t step = 0;
    double potential = 0, kinetic = 0;
    double outside = 0;  ///< of the potential energy, that of what acts from outside

    double total() const { return potential + kinetic; }
};

/// Throws FileError, naming the package, where lmp or, for several ranks, mpirun is not installed.
void check_lammps_installed(std::uint64_t ranks);

/// LAMMPS at work on an exported folder (export_to_lammps()): started by its run.sh, on some MPI ranks. It ends with
/// this object at the latest.
class LammpsRun {
public:
    /// Throws FileError as check_lammps_installed() does.
    LammpsRun(std::string folder, std::uint64_t ranks);
    ~LammpsRun();
    LammpsRun(const LammpsRun&) = delete;
    LammpsRun& operator=(const LammpsRun&) = delete;

    /// False once it has ended.
    bool is_running() { return !program_.ended(); }
    /// The last step that it reported; none before the first.
    std::optional<std::uint64_t> step() const;
    /// Waits for its end. Throws Interrupted, and an error with LAMMPS' own message where it failed.
    void finish();
    /// All energies that it reported. Throws FileError.
    std::vector<LammpsEnergy> energies() const;
    /// "LAMMPS (29 Sep 2021 - Update 2)", as its log begins. Throws FileError.
    std::string version() const;

private:
    std::string message() const;

    std::string folder_;
    ChildProgram program_;
};

}  // namespace steplab
