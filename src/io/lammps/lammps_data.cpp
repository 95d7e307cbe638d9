#include "io/lammps/lammps_data.hpp"

#include "core/interruption.hpp"
#include "io/commit.hpp"
#include "io/lammps/lammps_bonds.hpp"
#include "io/number_append.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace steplab {

namespace {

/// Lines of numbers, given to the file in pieces.
class Lines {
public:
    explicit Lines(OutputFile& file) : file_(file) {}

    void text(const std::string& text) { text_ += text; }
    template <class... Numbers>
    void numbers(Numbers... values) {
        const char* separator = "";
        ((text_ += separator, append_number(text_, values), separator = " "), ...);
        text_ += '\n';
        if (text_.size() < piece) return;
        check_interruption();
        flush();
    }
    void flush() {
        file_.write(text_);
        text_.clear();
    }

private:
    static constexpr std::size_t piece = 1 << 20;
    OutputFile& file_;
    std::string text_;
};

/// Ends of the box along an axis: those of its period, or around the particles, with some room where they are in a
/// plane.
std::array<double, 2> ends(double side, double corner, double low, double high, double extent) {
    if (side > 0) return {corner, corner + side};
    const double margin = std::max(0.1 * extent, 1e-3);
    return {low - margin, high + margin};
}

void write_box(const LammpsScene& scene, Lines& lines) {
    const Vec3 box = scene.box(), low = scene.low(), high = scene.high();
    const Vec3 corner = scene.corner();
    const double extent = length(high - low);
    const auto axis = [&](const char* name, std::array<double, 2> ends) {
        lines.text(fmt::format("{} {} {}lo {}hi\n", ends[0], ends[1], name, name));
    };
    axis("x", ends(box.x, corner.x, low.x, high.x, extent));
    axis("y", ends(box.y, corner.y, low.y, high.y, extent));
    axis("z", ends(box.z, corner.z, low.z, high.z, extent));
}

void write_head(const LammpsScene& scene, const std::string& title, Lines& lines) {
    lines.text(fmt::format("{}: LAMMPS data in units lj, atom_style {}, by steplab {}\n\n", title, atom_style(scene),
                           STEPLAB_VERSION));
    lines.text(fmt::format("{} atoms\n{} atom types\n", scene.count(), scene.types().size()));
    if (scene.bonds() > 0)
        lines.text(fmt::format("{} bonds\n{} bond types\n", scene.bonds(), scene.bond_types().size()));
    lines.text("\n");
    write_box(scene, lines);
    lines.text("\nMasses\n\n");
    for (std::size_t i = 0; i < scene.types().size(); ++i) lines.numbers(i + 1, scene.types()[i].mass);
}

void write_bond_types(const LammpsScene& scene, Lines& lines) {
    lines.text("\nBond Coeffs\n\n");
    std::size_t number = 0;
    for (const LammpsBondType& type : scene.bond_types()) {
        const std::vector<double> numbers = lammps_coefficients(type, scene.is_nonlinear());
        ++number;
        if (scene.is_nonlinear())
            lines.numbers(number, numbers[0], numbers[1], numbers[2], numbers[3]);
        else
            lines.numbers(number, numbers[0], numbers[1]);
    }
}

void write_atoms(const LammpsScene& scene, Lines& lines) {
    const std::string style = atom_style(scene);
    lines.text(fmt::format("\nAtoms # {}\n\n", style));
    for (std::size_t i = 0; i < scene.count(); ++i) {
        const auto [type, charge, at] = scene.atom(i);
        if (style == "atomic") lines.numbers(i + 1, type + 1, at.x, at.y, at.z);
        if (style == "charge") lines.numbers(i + 1, type + 1, charge, at.x, at.y, at.z);
        if (style == "bond") lines.numbers(i + 1, 1, type + 1, at.x, at.y, at.z);
        if (style == "full") lines.numbers(i + 1, 1, type + 1, charge, at.x, at.y, at.z);
    }
    lines.text("\nVelocities\n\n");
    for (std::size_t i = 0; i < scene.count(); ++i) {
        const Vec3 v = scene.velocity(i);
        lines.numbers(i + 1, v.x, v.y, v.z);
    }
}

void write_bonds(const LammpsScene& scene, Lines& lines) {
    lines.text("\nBonds\n\n");
    std::uint64_t number = 0;
    scene.each_bond([&](std::size_t type, const ScenePair& pair) {
        lines.numbers(++number, type + 1, pair.first + 1, pair.second + 1);
    });
}

}  // namespace

std::string atom_style(const LammpsScene& scene) {
    if (scene.bonds() == 0) return scene.is_charged() ? "charge" : "atomic";
    return scene.is_charged() ? "full" : "bond";
}

void write_lammps_data(const LammpsScene& scene, const std::string& title, const std::string& name) {
    OutputFile file(name);
    Lines lines(file);
    write_head(scene, title, lines);
    if (scene.bonds() > 0 && !scene.has_bond_tables()) write_bond_types(scene, lines);
    write_atoms(scene, lines);
    if (scene.bonds() > 0) write_bonds(scene, lines);
    lines.flush();
    file.commit();
}

}  // namespace steplab
