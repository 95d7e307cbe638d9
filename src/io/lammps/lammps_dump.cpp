#include "io/lammps/lammps_dump.hpp"

#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace steplab {

LammpsDump::LammpsDump(const std::string& file, std::size_t particles)
    : dump_(TextInput(InputFile(file))), particles_(particles) {}

bool LammpsDump::next(LammpsMoment& moment) {
    FrameBlock frame;
    if (!dump_.next(frame)) return false;
    // numbers are sorted and different: all are there if the last one is
    const bool whole = frame.positions.size() == particles_ && frame.velocities.size() == particles_ &&
                       frame.particles.size() == particles_ && frame.particles.back() == particles_ - 1;
    if (!whole)
        throw FileError(fmt::format("the dump of LAMMPS has {} particles, the exported scene {} with velocities",
                                    frame.positions.size(), particles_));
    moment.step = frame.moments.front().step;
    moment.positions = std::move(frame.positions);
    moment.velocities = std::move(frame.velocities);
    moment.forces = dump_.forces();
    return true;
}

}  // namespace steplab
