#pragma once

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

/// How long LAMMPS took, as it says itself.
struct LammpsLoop {
    double seconds = 0;
    std::uint64_t ranks = 0;
};

/// Throws FileError if a folder holds results of LAMMPS: files of another scene beside them would make them look as if
/// they were of that.
void refuse_results(const std::string& folder);
/// Removes them. Throws FileError.
void remove_results(const std::string& folder);

/// What LAMMPS writes beside the files of an export (export_to_lammps()), while it runs and afterwards.
class LammpsOutput {
public:
    explicit LammpsOutput(std::string folder) : folder_(std::move(folder)) {}

    const std::string& folder() const { return folder_; }
    /// The last step that it reported; none before the first.
    std::optional<std::uint64_t> step() const;
    /// All energies that it reported. Throws FileError.
    std::vector<LammpsEnergy> energies() const;
    /// "LAMMPS (29 Sep 2021 - Update 2)", as its log begins. Throws FileError.
    std::string version() const;
    /// None until it has gone all steps. Throws FileError.
    std::optional<LammpsLoop> loop() const;
    /// What LAMMPS says itself about an error, else what it printed last, with the cause where a scene of steplab can
    /// be one; that it printed nothing, if so.
    std::string message() const;

private:
    std::string folder_;
};

}  // namespace steplab
