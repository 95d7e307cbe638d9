#pragma once

#include "io/child_program.hpp"
#include "io/lammps/lammps_output.hpp"

#include <cstdint>
#include <string>

namespace steplab {

/// Throws FileError, naming the package, where lmp, or the program that the variable LAMMPS names, or, for several
/// ranks, mpirun is not installed.
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
    /// Waits for its end. Throws Interrupted, and an error with LAMMPS' own message where it failed.
    void finish();
    const LammpsOutput& output() const { return output_; }

private:
    LammpsOutput output_;
    ChildProgram program_;
};

}  // namespace steplab
