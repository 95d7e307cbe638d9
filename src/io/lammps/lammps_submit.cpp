#include "io/lammps/lammps_submit.hpp"

#include "core/shell_word.hpp"
#include "core/shown.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace steplab {

std::string write_slurm_file(const std::string& folder, std::string_view title, std::uint64_t ranks) {
    const std::filesystem::path absolute = std::filesystem::absolute(folder);
    std::string name = (std::filesystem::path(folder) / "job.slurm").string();
    OutputFile file(name);
    file.write(
        fmt::format("#!/bin/bash\n# {}\n#SBATCH --job-name=steplab\n#SBATCH --ntasks={}\n"
                    "#SBATCH --output={}\n"
                    "# Add what your cluster asks for: --time, --partition, module load lammps.\n\n"
                    "cd {} || exit 1\nexport OMP_NUM_THREADS=1\n"
                    "exec srun \"${{LAMMPS:-lmp}}\" -in {} -log {}\n",
                    shown(title), ranks, (absolute / lammps_files::screen).string(), shell_word(absolute.string()),
                    lammps_files::input, lammps_files::log));
    file.commit();
    return name;
}

}  // namespace steplab
