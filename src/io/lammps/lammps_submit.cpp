#include "io/lammps/lammps_submit.hpp"

#include "core/error.hpp"
#include "core/shell_word.hpp"
#include "core/shown.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace steplab {

namespace {

/// The name of an output file as sbatch reads it in its own lines: a pattern in which %j would be the job's number, in
/// quotation marks that no shell sees. Older versions take # in them for the beginning of a comment.
std::string slurm_pattern(const std::string& name) {
    std::string pattern;
    for (const char c : name) {
        if (c == '%') pattern += '%';
        if (c == '"' || c == '#') pattern += '\\';
        pattern += c;
    }
    return '"' + pattern + '"';
}

}  // namespace

void check_slurm_folder(const std::string& folder) {
    const std::string name = std::filesystem::absolute(folder).string();
    // One ends the line of sbatch, the other is left out of names of output files, however often it is written.
    if (name.find_first_of("\n\\") == std::string::npos) return;
    throw UsageError(
        fmt::format("the folder '{}' has a {} in its full name, which Slurm cannot have in the name of an output file: "
                    "choose a folder without it",
                    shown(name), name.find('\n') == std::string::npos ? "backslash" : "line break"));
}

std::string write_slurm_file(const std::string& folder, std::string_view title, std::uint64_t ranks) {
    check_slurm_folder(folder);
    const std::filesystem::path absolute = std::filesystem::absolute(folder);
    std::string name = (std::filesystem::path(folder) / "job.slurm").string();
    OutputFile file(name);
    file.write(
        fmt::format("#!/bin/bash\n# {}\n#SBATCH --job-name=steplab\n#SBATCH --ntasks={}\n"
                    "#SBATCH --output={}\n"
                    "# Add what your cluster asks for: --time, --partition, module load lammps.\n\n"
                    "cd {} || exit 1\nexport OMP_NUM_THREADS=1\n"
                    "exec srun \"${{LAMMPS:-lmp}}\" -in {} -log {}\n",
                    shown(title), ranks, slurm_pattern((absolute / lammps_files::screen).string()),
                    shell_word(absolute.string()), lammps_files::input, lammps_files::log));
    file.commit();
    return name;
}

}  // namespace steplab
