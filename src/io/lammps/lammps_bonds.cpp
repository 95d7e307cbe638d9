#include "io/lammps/lammps_bonds.hpp"

#include "io/lammps/lammps_export.hpp"
#include "io/number_append.hpp"
#include "io/output_file.hpp"
#include "models/scene/composer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

constexpr std::size_t fewest_points = std::size_t{1} << 12, most_points = std::size_t{1} << 16;
constexpr double wanted_bond_error = 1e-10;
constexpr double steepest = 1e4;  ///< times the force at the start: a table that reaches farther is less accurate
constexpr double longest = 3;     ///< times the length, which the lists of LAMMPS allow

std::string table_name(std::size_t type) { return fmt::format("BOND_{}", type + 1); }

}  // namespace

LammpsBondTable::LammpsBondTable(const LammpsBondType& type)
    : potential_(pair_force_of(*type.potential, 1), 1), pair_(type.pair), length_(type.length) {
    scale_ = std::numeric_limits<double>::min();
    for (const double part : {0.97, 1.0, 1.03}) {
        const double force = std::abs(force_at(part * length_));
        if (std::isfinite(force)) scale_ = std::max(scale_, force);
    }
    low_ = end(0.99, 1e-3);
    high_ = end(1.01, longest);
}

double LammpsBondTable::end(double factor, double most) const {
    // beyond a pole the force may be finite again, but the energy is not
    const auto reaches = [&](double r) {
        return std::abs(force_at(r)) <= steepest * scale_ && std::isfinite(potential_.energy(r * r, pair_));
    };
    double r = length_;
    while ((factor > 1 ? r < most * length_ : r > most * length_) && reaches(r * factor)) r *= factor;
    return r;
}

double LammpsBondTable::distance(std::size_t i) const {
    return low_ + (high_ - low_) * (static_cast<double>(i) / static_cast<double>(points_ - 1));
}

/// A cubic through the four points around, halfway between two of them, whose error is larger than that of a spline.
double LammpsBondTable::error() const {
    double largest = 0;
    for (std::size_t i = 1; i + 2 < points_; ++i) {
        const auto at = [&](std::size_t k) { return force_at(distance(k)); };
        const double interpolated = (9 * (at(i) + at(i + 1)) - (at(i - 1) + at(i + 2))) / 16;
        const double exact = force_at((distance(i) + distance(i + 1)) / 2);
        largest = std::max(largest, std::abs(interpolated - exact) / std::max(std::abs(exact), scale_));
    }
    return largest;
}

void LammpsBondTable::write(OutputFile& file, const std::string& name) const {
    std::string text = fmt::format("{}\nN {}\n\n", name, points_);
    for (std::size_t i = 0; i < points_; ++i) {
        const double r = distance(i);
        text += fmt::format("{}", i + 1);
        for (const double number : {r, potential_.energy(r * r, pair_), force_at(r)}) {
            text += ' ';
            append_number(text, number);
        }
        text += '\n';
    }
    file.write(text + "\n");
}

LammpsBonds::LammpsBonds(const LammpsScene& scene) : scene_(scene) {
    for (const LammpsBondType& type : scene.bond_types()) {
        if (type.potential) tables_.emplace_back(type);
    }
    if (tables_.empty()) return;
    for (points_ = fewest_points;; points_ *= 2) {
        table_error_ = 0;
        for (LammpsBondTable& table : tables_) {
            table.divide(points_);
            table_error_ = std::max(table_error_, table.error());
        }
        if (table_error_ <= wanted_bond_error || points_ == most_points) return;
    }
}

std::string LammpsBonds::style_lines() const {
    if (scene_.bonds() == 0) return {};
    const char* const usual = scene_.is_nonlinear() ? "class2" : "harmonic";
    const std::string table = fmt::format("table spline {}", points_);
    std::string style = usual;
    if (has_tables())
        style = tables_.size() == scene_.bond_types().size() ? table : fmt::format("hybrid {} {}", usual, table);
    return fmt::format("bond_style {}\nspecial_bonds lj/coul 1 1 1\n", style);
}

std::string LammpsBonds::coefficient_lines() const {
    if (!has_tables()) return {};
    const bool hybrid = tables_.size() < scene_.bond_types().size();
    std::string text;
    for (std::size_t i = 0; i < scene_.bond_types().size(); ++i) {
        const LammpsBondType& type = scene_.bond_types()[i];
        text += fmt::format("bond_coeff {}", i + 1);
        if (type.potential) {
            text += fmt::format("{} {} {}\n", hybrid ? " table" : "", lammps_files::bond_tables, table_name(i));
            continue;
        }
        text += scene_.is_nonlinear() ? " class2" : " harmonic";
        for (const double number : lammps_coefficients(type, scene_.is_nonlinear())) {
            text += ' ';
            append_number(text, number);
        }
        text += '\n';
    }
    return text;
}

double LammpsBonds::force() const {
    double largest = 0;
    for (const LammpsBondTable& table : tables_) largest = std::max(largest, table.force());
    return largest;
}

double LammpsBonds::acceleration() const {
    double lightest = std::numeric_limits<double>::infinity();
    for (const LammpsType& type : scene_.types()) {
        if (!type.fixed) lightest = std::min(lightest, type.mass);
    }
    return force() / lightest;
}

void LammpsBonds::write_tables(const std::string& name) const {
    if (!has_tables()) return;
    OutputFile file(name);
    file.write(fmt::format("# forces of springs for bond_style table spline {}, by steplab\n\n", points_));
    std::size_t table = 0;
    for (std::size_t i = 0; i < scene_.bond_types().size(); ++i) {
        if (scene_.bond_types()[i].potential) tables_[table++].write(file, table_name(i));
    }
    file.commit();
}

std::vector<double> lammps_coefficients(const LammpsBondType& type, bool class2) {
    if (class2) return {type.length, type.k / 2, type.quadratic / 3, type.cubic / 4};
    return {type.k / 2, type.length};
}

}  // namespace steplab
