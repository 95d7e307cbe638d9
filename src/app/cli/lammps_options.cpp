#include "app/cli/lammps_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shell_word.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

namespace steplab {

namespace {

constexpr std::string_view method_of_lammps = "velocity-verlet";

}  // namespace

void LammpsOptions::declare(CLI::App& app) {
    text_option(app, "--every", every_, "K", "Trajectory of every K-th step (default: first and last step only)");
}

RunDescription lammps_method_checked(const SceneOptions& scene) {
    RunDescription run = scene.description();
    if (scene.names_method() && run.method != method_of_lammps)
        throw UsageError(
            fmt::format("LAMMPS does not have the method {}: its fix nve is {}", run.method, method_of_lammps));
    return run;
}

LammpsTime LammpsOptions::time(std::uint64_t steps) const {
    LammpsTime time{.steps = steps};
    if (!every_.empty()) time.every = whole_number("--every", every_, 9007199254740992.0, "steps between two moments");
    return time;
}

std::uint64_t ranks_of(const std::string& text) {
    return whole_number("--ranks", text, 1048576, "number of MPI ranks");
}

std::uint64_t samples_of(const std::string& text) { return whole_number("--samples", text, 1e6, "number of moments"); }

std::string export_text(const LammpsExport& what, const std::string& folder) {
    std::string text = fmt::format("{} particles and {} springs, for LAMMPS\n", what.particles, what.bonds);
    const auto line = [&text](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", name, value);
    };
    if (what.table_error > 0)
        line("tables", fmt::format("each force is within {} of the scene's, or of {} N where that is less",
                                   rounded_text(what.table_error), short_number(what.neighbour_force)));
    if (what.reach > 0)
        line("no cut-off",
             fmt::format("LAMMPS ends if two particles are more than {} apart", short_number(what.reach)));
    for (const std::string& note : what.notes) line("note", note);
    line("written", shown(folder));
    line("run", fmt::format("{} RANKS", shell_file(folder + "/run.sh")));
    return text;
}

}  // namespace steplab
