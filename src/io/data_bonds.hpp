#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace steplab {

/// A bond between two atoms, which are counted from 0: ids less 1.
struct DataBond {
    std::uint64_t first = 0, second = 0;
    friend bool operator==(const DataBond&, const DataBond&) = default;
};

/// The bonds of a LAMMPS data file, also compressed; none if it has no section `Bonds`. Throws FileError naming the
/// line, also where they are not as many as its head says.
std::vector<DataBond> read_data_bonds(const std::string& file);

}  // namespace steplab
