#pragma once

#include "core/cell.hpp"
#include "core/lattice.hpp"
#include "core/particle_values.hpp"
#include "core/precision.hpp"
#include "core/shape.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// The vectors that are wanted of a frame, beside velocities.
struct FrameParts {
    bool positions = true;
    bool displacements = false;
};

/// The state of a run at one step, as plain data: all that drawing, files and panels use.
struct Frame {
    std::uint64_t step = 0;
    double time = 0;
    Precision precision = Precision::double_;
    std::vector<Vec3> positions;   ///< absolute; numbers of the run's precision
    std::vector<Vec3> velocities;  ///< at the same time
    /// Positions in the runs of the ensemble at the same step, run after run; empty without an ensemble.
    std::vector<Vec3> ensemble;
    std::shared_ptr<const Shape> shape;
    /// From the reference positions, with all digits that the run has; empty unless they are asked for.
    std::vector<Vec3> displacements = {};
    std::vector<Vec3> forces = {};  ///< [N] on each particle; empty unless they are asked for
    /// Shape of the scene's fastest oscillation: displacements of which the longest is 1; empty unless it is asked for.
    std::vector<Vec3> oscillation = {};
    Lattice reference = {};  ///< position = reference + displacement, rounded to the run's precision
    double mass = 0;         ///< of each particle; 0: not known, or they differ
    /// What a file has of its particles besides; null: nothing.
    std::shared_ptr<const std::vector<ParticleValues>> values = {};
    std::optional<Cell> cell = {};  ///< the box of a file in which edges lean; the shape has none then
    double magnified = 1;           ///< factor by which displacements from the rest positions are drawn

    /// A position as drawn: its image in the box (Shape::seen, Cell::seen).
    Vec3 seen_at(Vec3 position) const { return cell ? cell->seen(position) : shape->seen(position); }
    /// The way from one particle to the nearest image of another (Shape::nearest, Cell::through).
    Vec3 nearest(Vec3 way) const { return cell ? way - cell->through(way) : shape->nearest(way); }
    /// Where a particle is drawn that is at this position, with its displacement magnified.
    Vec3 drawn_at(std::size_t particle, Vec3 position) const {
        if (magnified == 1) return position;
        const Vec3 rest = shape->rest[particle];
        return rest + magnified * (position - rest);
    }
    /// The position of a particle that is drawn there: the inverse of drawn_at().
    Vec3 position_drawn_at(std::size_t particle, Vec3 drawn) const {
        if (magnified == 1) return drawn;
        const Vec3 rest = shape->rest[particle];
        return rest + (1 / magnified) * (drawn - rest);
    }
    Vec3 drawn(std::size_t particle) const { return drawn_at(particle, positions[particle]); }
    /// The place in the picture of a particle: its image in the box, of where it is drawn.
    Vec3 seen(std::size_t particle) const { return seen_at(drawn(particle)); }
};

/// Where a particle is, as frames and files of this precision have it.
inline Vec3 position_of(Vec3 reference, Vec3 displacement, Precision precision) {
    const Vec3 sum = reference + displacement;
    if (precision == Precision::double_) return sum;
    return {rounded_to(precision, sum.x), rounded_to(precision, sum.y), rounded_to(precision, sum.z)};
}

}  // namespace steplab
