#pragma once

#include "models/forces/composition.hpp"
#include "models/forces/pair_potential.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace steplab {

class OutputFile;

/// A pair force as a table of LAMMPS' pair_style table: energy and force between two kinds of particles, at distances
/// that are chosen here and interpolated there.
class LammpsTable {
public:
    /// How LAMMPS interpolates.
    enum class Kind {
        spline,  ///< cubic, points at equal distances in r^2
        bitmap,  ///< linear, points at equal distances in each octave of r^2, read off the bits of a float
    };
    /// The distances it is valid for. A pair that comes closer ends LAMMPS with a message.
    struct Range {
        double low = 0, high = 0;
    };

    /// Of a force of pair_force_of(), in the scene's own unit of mass, between particles with these properties.
    /// `nearest`: about the distance of neighbours; `high`: the cut-off.
    LammpsTable(const ComposedPairs& force, const PairProperties<double>& pair, double nearest, double high);

    /// Sets kind and number of points. 2^bits points.
    void divide(Kind kind, int bits);
    /// An estimate of the largest error of the interpolated force, in parts of the force there or of that between
    /// neighbours, whichever is larger.
    double error() const;
    /// The force between neighbours.
    double neighbour_force() const { return scale_ * nearest_; }

    /// Writes it as the section of this name.
    void write(OutputFile& file, const std::string& name) const;

private:
    double force_over_distance(double distance2) const { return potential_.factor(distance2, pair_); }

    PairPotential<double> potential_;
    PairProperties<double> pair_;
    double nearest_;  ///< distance of neighbours
    Range range_;
    double scale_;  ///< |V'(r) / r| between neighbours, the largest of some distances
    Kind kind_ = Kind::spline;
    std::vector<double> squares_;  ///< of the distances of the points, in the order of the file
};

/// The fewest points, and the kind of interpolation, with which all tables are as accurate as they get.
struct LammpsTableSize {
    LammpsTable::Kind kind = LammpsTable::Kind::spline;
    int bits = 0;
    double error = 0;  ///< the largest of the tables
};
LammpsTableSize size_for(std::vector<LammpsTable>& tables);

}  // namespace steplab
