#pragma once

#include "core/shape.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

/// The bonds of the LAMMPS data file that lies beside a text of frames, as springs between the rows of its first frame,
/// which are of these particles (ascending; empty: as the rows) at these positions: of one of the same name with the
/// ending .data, or, of a dump of an export (export_to_lammps()), of the export. None if there is no such file. Throws
/// FileError.
std::vector<Spring> springs_beside(const std::string& file, const std::vector<std::size_t>& particles,
                                   const std::vector<Vec3>& positions);

}  // namespace steplab
