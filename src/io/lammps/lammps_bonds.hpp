#pragma once

#include "io/lammps/lammps_scene.hpp"
#include "models/forces/pair_potential.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

class OutputFile;

/// The force of a spring with a potential of its own as a table of LAMMPS' bond_style table: a cubic spline through
/// points at equal distances.
class LammpsBondTable {
public:
    explicit LammpsBondTable(const LammpsBondType& type);

    void divide(std::size_t points) { points_ = points; }
    /// An estimate of the largest error of the interpolated force, in parts of the force there or of that of a spring
    /// some per cent longer or shorter than at the start, whichever is larger.
    double error() const;
    /// That force.
    double force() const { return scale_; }

    void write(OutputFile& file, const std::string& name) const;

private:
    double force_at(double r) const { return r * potential_.factor(r * r, pair_); }
    double distance(std::size_t i) const;
    /// As far as the force is finite and not many times that of the start, at most to so many times the length.
    double end(double factor, double most) const;

    PairPotential<double> potential_;
    PairProperties<double> pair_;
    double length_, scale_, low_, high_;
    std::size_t points_ = 0;
};

/// The springs of a scene as lines of an input script of LAMMPS, and the tables that these name. A spring that has a
/// table may not become shorter or longer than that reaches: LAMMPS ends with a message.
class LammpsBonds {
public:
    explicit LammpsBonds(const LammpsScene& scene);

    /// bond_style and special_bonds; empty where there is no spring.
    std::string style_lines() const;
    /// bond_coeff, which comes behind the particles; empty where scene.data has the coefficients.
    std::string coefficient_lines() const;
    /// Whether some springs have tables: then scene.data has no coefficients.
    bool has_tables() const { return !tables_.empty(); }
    /// The largest error of a force by table, in parts of it; 0: there is none.
    double table_error() const { return table_error_; }
    /// The largest force of a spring at about the start, and acceleration by it, among tables.
    double force() const;
    double acceleration() const;
    /// Writes the tables, if there are any. Throws FileError.
    void write_tables(const std::string& file) const;

private:
    const LammpsScene& scene_;
    std::vector<LammpsBondTable> tables_;
    std::size_t points_ = 0;
    double table_error_ = 0;
};

/// The coefficients of a spring that has no table, K r0 or r0 K2 K3 K4: energies are K (r - r0)^2, and with class2
/// K2 (r - r0)^2 + K3 (r - r0)^3 + K4 (r - r0)^4.
std::vector<double> lammps_coefficients(const LammpsBondType& type, bool class2);

}  // namespace steplab
