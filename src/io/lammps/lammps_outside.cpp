#include "io/lammps/lammps_outside.hpp"

#include "core/error.hpp"
#include "io/lammps/lammps_formula.hpp"
#include "models/scene/potential_expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace steplab {

namespace {

/// LAMMPS has 32 groups; three are taken.
constexpr std::size_t most_potentials = 9, most_groups = 29 - most_potentials;

[[noreturn]] void refuse_outside(const std::string& what) {
    throw UsageError(fmt::format("the scene cannot be expressed in LAMMPS: {}", what));
}

/// A coefficient for each type.
std::string drag_lines(const std::vector<LammpsType>& types) {
    if (std::none_of(types.begin(), types.end(), [](const auto& type) { return type.drag != 0; })) return {};
    std::string line = "fix drag moving viscous 1";
    for (std::size_t i = 0; i < types.size(); ++i) line += fmt::format(" scale {} {}", i + 1, types[i].drag);
    return line + '\n';
}

std::string acceleration_lines(const std::vector<LammpsType>& types) {
    std::map<std::array<double, 3>, std::string> groups;
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (types[i].acceleration != std::array<double, 3>{})
            groups[types[i].acceleration] += fmt::format(" {}", i + 1);
    }
    if (groups.size() > most_groups)
        refuse_outside(fmt::format("{} different accelerations act from outside, and it has groups for {}",
                                   groups.size(), most_groups));
    std::string text;
    std::size_t number = 0;
    for (const auto& [acceleration, of_types] : groups) {
        const auto [x, y, z] = acceleration;
        text += fmt::format(
            "group pulled{0} type{1}\nfix pull{0} pulled{0} gravity {2} vector {3} {4} {5}\n"
            "fix_modify pull{0} energy yes\n",
            ++number, of_types, length({x, y, z}), x, y, z);
    }
    return text;
}

/// A potential as the force that follows from it and its energy, of the types on which it acts.
std::string potential_lines(const LammpsScene& scene, std::size_t index) {
    const std::array<std::string, 5> variables{"x", "y", "z", "mass", "q"};
    const ComposedField field = expression_of(*scene.potentials()[index], 1);
    if (scene.box() != Vec3{}) refuse_outside("a potential that acts from outside, in a periodic box");
    if (reads(field.expression->energy, 4)) refuse_outside("a potential that acts from outside on charges");
    std::string of_types;
    for (std::size_t i = 0; i < scene.types().size(); ++i) {
        if (scene.types()[i].fields[index]) of_types += fmt::format(" {}", i + 1);
    }
    if (of_types.empty()) return {};
    const std::string name = fmt::format("potential{}", index + 1);
    const LammpsFormula force = formula_of(field.expression->force, variables, name + "_force"),
                        energy = formula_of(field.expression->energy, variables, name + "_energy");
    std::string text = force.lines + energy.lines;
    for (std::size_t axis = 0; axis < 3; ++axis)
        text += fmt::format("variable {}_{} atom {}\n", name, "xyz"[axis], force.results[axis]);
    return text + fmt::format(
                      "variable {0}_all atom {1}\ngroup {0} type{2}\n"
                      "fix {0} {0} addforce v_{0}_x v_{0}_y v_{0}_z energy v_{0}_all\nfix_modify {0} energy yes\n",
                      name, energy.results[0], of_types);
}

}  // namespace

std::string outside_lines(const LammpsScene& scene) {
    std::string text = drag_lines(scene.types()) + acceleration_lines(scene.types());
    for (std::size_t index = 0; index < scene.potentials().size(); ++index) text += potential_lines(scene, index);
    if (scene.potentials().size() > most_potentials)
        refuse_outside(fmt::format("more than {} potentials that act from outside", most_potentials));
    return text;
}

std::string outside_energy(const std::string& lines) {
    std::istringstream text(lines);
    std::string sum;
    for (std::string line; std::getline(text, line);) {
        std::istringstream words(line);
        std::string command, fix;
        if (words >> command >> fix && command == "fix_modify") sum += (sum.empty() ? "f_" : "+f_") + fix;
    }
    return sum.empty() ? "0" : sum;
}

}  // namespace steplab
