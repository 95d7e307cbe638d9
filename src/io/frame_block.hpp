#pragma once

#include "core/frame.hpp"
#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The particles of a scene that are written, ascending; null: all.
using ParticleChoice = std::shared_ptr<const std::vector<std::size_t>>;

/// What a file knows of its scene beside the rows.
struct FileScene {
    Precision precision = Precision::double_;
    std::optional<Lattice> reference = {};  ///< position = reference + displacement; none: not known
    double mass = 0;                        ///< of each particle; 0: they differ, or are not known
    Vec3 box = {};                          ///< sides of the periodic box; 0: none along this axis
    Vec3 corner = {};                       ///< of the box, where its coordinates are smallest
    std::optional<Cell> cell = {};          ///< in place of the box: one whose edges lean
    std::string units = {};                 ///< by LAMMPS' name of them; empty: not said
};

FileScene scene_of(const Frame& frame);

inline constexpr std::array role_ids{id(Role::moving), id(Role::fixed), id(Role::kicked), id(Role::bullet)};
/// The role with this id.
std::optional<Role> parse_role(std::string_view name);

/// Rows of a trajectory, one per particle and frame, to be written by another thread: several whole frames, or a part
/// of one that is too large for a block.
struct FrameBlock {
    struct Moment {
        std::uint64_t step = 0;
        double time = 0;
    };

    FileScene scene = {};
    std::uint64_t first_frame = 0;            ///< the number of the first frame among those written, from 0
    std::size_t frame_rows = 0;               ///< rows of a whole frame
    std::size_t first_row = 0;                ///< within the frame; 0 unless this is a part of one
    std::size_t rows = 0;                     ///< of each frame in this block
    std::vector<std::size_t> particles = {};  ///< the number in its scene for each of these rows; empty: as the row
    std::vector<Role> roles = {};             ///< of these rows; empty: not known
    std::vector<double> masses = {};          ///< of these rows; empty: all that of the scene, or not known
    std::vector<std::uint64_t> types = {};    ///< of the atoms of a dump; empty: not known
    std::vector<ParticleValues> values = {};  ///< further columns of numbers of a file of any program
    std::vector<Moment> moments = {};
    // Frame by frame; a vector that is not wanted, or not known, is empty.
    std::vector<Vec3> positions = {};
    std::vector<Vec3> displacements = {};
    std::vector<Vec3> velocities = {};

    /// The number of rows of a frame: all its particles, or the chosen ones.
    static std::size_t rows_of(const Frame& frame, const ParticleChoice& particles);
    /// Appends these rows of the chosen particles of a frame, with the wanted vectors. All frames of a block have the
    /// same `first` and `count`.
    void append(const Frame& frame, const FrameParts& wanted, const ParticleChoice& chosen, std::size_t first,
                std::size_t count);
    /// Makes positions of displacements where they are wanted and missing. What cannot be made is an empty vector.
    void complete(const FrameParts& wanted);

    std::size_t all_rows() const { return rows * moments.size(); }
    /// The number in its scene of a row of this block.
    std::size_t particle(std::size_t row) const { return particles.empty() ? first_row + row : particles[row]; }
};

}  // namespace steplab
