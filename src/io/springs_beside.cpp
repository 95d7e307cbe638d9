#include "io/springs_beside.hpp"

#include "io/compression.hpp"
#include "io/data_bonds.hpp"
#include "io/lammps/lammps_export.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace steplab {

namespace {

/// Bonds as springs between rows.
std::vector<Spring> springs_of(const std::vector<DataBond>& bonds, const std::vector<std::size_t>& particles,
                               const std::vector<Vec3>& positions) {
    const auto row_of = [&](std::uint64_t particle) {
        if (particles.empty()) return particle < positions.size() ? static_cast<std::ptrdiff_t>(particle) : -1;
        const auto found = std::lower_bound(particles.begin(), particles.end(), particle);
        return found != particles.end() && *found == particle ? found - particles.begin() : -1;
    };
    std::vector<Spring> springs;
    for (const DataBond& bond : bonds) {
        const auto first = row_of(bond.first), second = row_of(bond.second);
        if (first < 0 || second < 0) continue;
        const double apart =
            length(positions[static_cast<std::size_t>(second)] - positions[static_cast<std::size_t>(first)]);
        springs.push_back({static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(second), apart});
    }
    return springs;
}

/// None if there is none.
std::optional<std::string> data_beside(const std::string& file) {
    const std::filesystem::path dump(without_compression(file));
    std::filesystem::path data = dump;
    data.replace_extension(".data");
    if (std::filesystem::is_regular_file(data)) return data.string();
    data.replace_filename(lammps_files::data);
    const bool exported = dump.filename() == lammps_files::trajectory && std::filesystem::is_regular_file(data);
    return exported ? std::optional(data.string()) : std::nullopt;
}

}  // namespace

std::vector<Spring> springs_beside(const std::string& file, const std::vector<std::size_t>& particles,
                                   const std::vector<Vec3>& positions) {
    const auto data = data_beside(file);
    return data ? springs_of(read_data_bonds(*data), particles, positions) : std::vector<Spring>();
}

}  // namespace steplab
