#include "io/lammps/lammps_dump.hpp"

#include <array>
#include <charconv>

namespace steplab {

namespace {

constexpr std::string_view usual_columns = "ITEM: ATOMS id type xu yu zu vx vy vz";
constexpr std::string_view with_forces = " fx fy fz";

/// The next number of a line, which is shortened by it.
template <class Number>
bool take(std::string_view& line, Number& number) {
    while (line.starts_with(' ')) line.remove_prefix(1);
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return error == std::errc{};
}

bool take(std::string_view& line, Vec3& vector) {
    return take(line, vector.x) && take(line, vector.y) && take(line, vector.z);
}

}  // namespace

LammpsDump::LammpsDump(const std::string& file, std::size_t particles)
    : input_(InputFile(file)), particles_(particles) {}

std::string_view LammpsDump::expect_line() {
    const auto line = input_.line();
    if (!line) input_.fail("the dump of LAMMPS ends within a moment");
    return *line;
}

std::uint64_t LammpsDump::whole_number(std::string_view text) const {
    std::uint64_t number = 0;
    if (!take(text, number)) input_.fail("a whole number belongs here");
    return number;
}

void LammpsDump::read_atom(std::string_view line, LammpsMoment& moment) const {
    std::size_t id = 0, type = 0;
    Vec3 position, velocity, force;
    bool good = take(line, id) && take(line, type) && take(line, position) && take(line, velocity);
    good = good && (moment.forces.empty() || take(line, force)) && id >= 1 && id <= particles_;
    if (!good) input_.fail("this is no particle of the exported scene");
    moment.positions[id - 1] = position;
    moment.velocities[id - 1] = velocity;
    if (!moment.forces.empty()) moment.forces[id - 1] = force;
}

bool LammpsDump::next(LammpsMoment& moment) {
    const auto first = input_.line();
    if (!first) return false;
    if (*first != "ITEM: TIMESTEP") input_.fail("a moment of a dump of LAMMPS begins with ITEM: TIMESTEP");
    moment.step = whole_number(expect_line());
    expect_line();
    if (whole_number(expect_line()) != particles_) input_.fail("the scene has another number of particles");
    for (int line = 0; line < 4; ++line) expect_line();  // the box
    const std::string columns(expect_line());
    const bool forces = columns == std::string(usual_columns) + std::string(with_forces);
    if (!forces && !columns.starts_with(usual_columns)) input_.fail("these are not the columns of an exported script");
    moment.positions.assign(particles_, {});
    moment.velocities.assign(particles_, {});
    moment.forces.assign(forces ? particles_ : 0, {});
    for (std::size_t i = 0; i < particles_; ++i) read_atom(expect_line(), moment);
    return true;
}

}  // namespace steplab
