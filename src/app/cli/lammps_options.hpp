#pragma once

#include "app/cli/scene_options.hpp"
#include "io/lammps/lammps_export.hpp"

#include <cstdint>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace steplab {

/// The options that commands share which hand a scene to LAMMPS.
class LammpsOptions {
public:
    void declare(CLI::App& app);
    LammpsTime time(std::uint64_t steps) const;

private:
    std::string every_;
};

/// The run of the options of a scene. Throws UsageError for a --method that LAMMPS does not have.
RunDescription lammps_method_checked(const SceneOptions& scene);
/// The --ranks and --samples of a command. Throw UsageError.
std::uint64_t ranks_of(const std::string& text);
std::uint64_t samples_of(const std::string& text);

/// What was exported into a folder, for people.
std::string export_text(const LammpsExport& what, const std::string& folder);

}  // namespace steplab
