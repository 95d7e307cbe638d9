#pragma once

#include "core/frame.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// A number of a particle in a row of a file: a component of its position, its velocity, or its displacement from the
/// reference position.
enum class Column : std::uint8_t { x, y, z, vx, vy, vz, ux, uy, uz };

std::string_view id(Column column);

/// Those of a row in their order, each once.
using Columns = std::vector<Column>;

/// Of an option that chooses them.
inline constexpr const char* columns_help =
    "Columns of --out: x, y, z (position), vx, vy, vz (velocity), ux, uy, uz (displacement from the reference "
    "position); default x,y,z,vx,vy,vz";

/// x, y, z, vx, vy, vz.
const Columns& usual_columns();
/// From a list such as "ux,uy,uz". Throws UsageError naming the known ones.
Columns parse_columns(std::string_view list);
/// The vectors that hold these columns; velocities besides.
FrameParts parts_of(const Columns& columns);
bool contains(const Columns& columns, Column column);
/// "x,y,z"
std::string names_of(const Columns& columns);

}  // namespace steplab
