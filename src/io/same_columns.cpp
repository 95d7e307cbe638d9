#include "io/same_columns.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

void SameColumns::check(const std::string& file, const FrameBlock& frame) {
    const std::string names = names_in(frame);
    if (!first_) first_ = names;
    if (names == *first_) return;
    throw FileError(
        fmt::format("'{}', frame {}: its columns are {}, those of the frames before it {}: --columns selects what all "
                    "frames have, --format dump or pvd keeps what each has",
                    shown(file), frame.first_frame, names, *first_));
}

std::string SameColumns::names_in(const FrameBlock& frame) const {
    std::string names;
    const auto add = [&](std::string_view name) { names.append(names.empty() ? "" : ",").append(name); };
    const auto add_three = [&](const std::vector<Vec3>& vectors, Column first) {
        for (int i = 0; i < 3; ++i) {
            const auto column = static_cast<Column>(static_cast<int>(first) + i);
            if (!vectors.empty() && (values_ || contains(wanted_, column))) add(id(column));
        }
    };
    add_three(frame.positions, Column::x);
    add_three(frame.velocities, Column::vx);
    add_three(frame.displacements, Column::ux);
    if (!values_) return names;
    for (const ParticleValues& column : frame.values) add(column.name);
    return names;
}

}  // namespace steplab
