#pragma once

#include "io/lammps/lammps_scene.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

class LammpsTable;

/// The pair forces of a scene as lines of an input script of LAMMPS, and the tables that these name.
class LammpsForces {
public:
    /// Throws UsageError where there would be too many tables.
    explicit LammpsForces(const LammpsScene& scene);
    ~LammpsForces();
    LammpsForces(const LammpsForces&) = delete;
    LammpsForces& operator=(const LammpsForces&) = delete;

    /// pair_style, pair_coeff and the pairs that do not act on each other; empty where there is no pair force.
    std::string lines() const;
    /// The largest error of a force by table, in parts of it; 0: there is none.
    double table_error() const { return table_error_; }
    /// The largest force between neighbours among tables.
    double neighbour_force() const;
    /// The same of the accelerations by these forces.
    double neighbour_acceleration() const;
    /// Writes the tables, if there are any. Throws FileError.
    void write_tables(const std::string& file) const;

private:
    struct Table {
        std::size_t force, one, other;  ///< the place of the force in the scene, and two types
    };

    bool act(std::size_t force, std::size_t one, std::size_t other) const;
    bool is_plain() const;
    double cutoff(const LammpsPairForce& force) const;
    void make_tables();
    std::string style_name(std::size_t force) const;
    std::string style(std::size_t force) const;
    std::string number_of(std::size_t force) const;
    std::string coefficients(std::size_t force, std::size_t one, std::size_t other) const;
    std::string plain_lines() const;
    std::string overlaid_lines() const;

    const LammpsScene& scene_;
    std::vector<Table> tables_;
    std::vector<LammpsTable> contents_;
    std::string table_style_;
    double table_error_ = 0;
};

}  // namespace steplab
