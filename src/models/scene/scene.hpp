#pragma once

#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "models/scene/starting_values.hpp"
#include "models/scene/written_number.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace steplab {

// A scene is a value: everything that moves and acts, as data. A model of the catalogue makes one from its parameters,
// a scene file writes one out (docs/scene-files.md). Particles are numbered on, block after block, from 0.

/// At position + i step.
struct LineArrangement {
    std::size_t count = 1;
    WrittenVector step;
    bool operator==(const LineArrangement&) const = default;
};

/// The first index runs fastest: particle j * columns + i is at position + i steps[0] + j steps[1].
struct GridArrangement {
    std::size_t columns = 1, rows = 1;
    std::array<WrittenVector, 2> steps;
    bool operator==(const GridArrangement&) const = default;
};

/// Cells along x fastest, then y, then z; the first particle at position.
struct CrystalArrangement {
    enum class Kind { cubic, bcc, fcc };
    Kind kind = Kind::cubic;
    std::array<std::size_t, 3> cells{1, 1, 1};
    WrittenNumber constant = 1;
    bool operator==(const CrystalArrangement&) const = default;
};

/// Read from a file. Position and velocity of the block are added to those of each.
struct ListedParticles {
    struct Particle {
        Vec3 position, velocity;
        double mass = 1;
        Role role = Role::moving;
        bool operator==(const Particle&) const = default;
    };
    std::string file;
    bool masses = false, roles = false;  ///< each has its own; else they are those of the block
    std::shared_ptr<const std::vector<Particle>> particles = {};

    bool operator==(const ListedParticles& other) const {
        return file == other.file && masses == other.masses && roles == other.roles &&
               (particles == other.particles || *particles == *other.particles);
    }
};

using Arrangement = std::variant<std::monostate, LineArrangement, GridArrangement, CrystalArrangement, ListedParticles>;

/// Uniform within +-width along each axis, drawn by seed and index in the block.
struct RandomDisplacement {
    WrittenNumber width;
    std::uint64_t seed = 1;
    bool operator==(const RandomDisplacement&) const = default;
};

/// Each component of a velocity has the variance kT / m; the block's mean velocity is subtracted.
struct Temperature {
    WrittenNumber kT;
    std::uint64_t seed = 1;
    bool exact = true;  ///< scaled to sum m v^2 = (3 n - 3) kT
    bool operator==(const Temperature&) const = default;
};

/// One particle or many that differ in their places.
struct ParticleBlock {
    std::string group = {};  ///< empty: none
    WrittenVector position = {}, velocity = {};
    WrittenNumber mass = 1, charge = 0;
    bool fixed = false;
    Role role = Role::moving;
    Arrangement arrangement = {};
    std::variant<std::monostate, WrittenVector, RandomDisplacement> displacement = {};
    std::optional<Temperature> temperature = {};

    std::size_t count() const;
    bool operator==(const ParticleBlock&) const = default;
};

/// Sets what is given of single particles, after all blocks.
struct Fix {
    std::vector<std::string> particles;  ///< "cloth[0,0]", "rope", "4-9" (selection.hpp)
    std::optional<bool> fixed = {};
    std::optional<WrittenVector> velocity = {}, displacement = {};
    std::optional<WrittenNumber> mass = {}, charge = {};
    std::optional<Role> role = {};
    bool operator==(const Fix&) const = default;
};

/// A force between all pairs of one group, or across two.
struct PairTerm {
    std::vector<std::string> between = {};  ///< none: all particles
    std::string potential;                  ///< the name of a built-in one, or an expression
    std::map<std::string, WrittenNumber> values = {};
    std::map<std::string, double> parameters = {};  ///< of the scene, that the expression uses
    std::optional<WrittenNumber> cutoff = {};
    bool operator==(const PairTerm&) const = default;
};

/// Springs of one kind: F = -(k e + quadratic e^2 + cubic e^3) of the extension e, and -damping times the relative
/// velocity along the spring.
struct SpringTerm {
    enum class Along { axes, diagonals, both };
    std::string between = {};  ///< a group: neighbours of its line or grid; empty: none
    Along along = Along::axes;
    std::vector<std::pair<std::string, std::string>> pairs = {};
    WrittenNumber k = 0;
    std::optional<WrittenNumber> length = {};  ///< none: the distance in the reference positions
    WrittenNumber damping = 0, quadratic = 0, cubic = 0;
    std::optional<PairTerm> potential = {};  ///< in place of k, length, quadratic, cubic: V(r), between the ends alone
    bool operator==(const SpringTerm&) const = default;
};

/// What acts on each particle from outside.
struct FieldTerm {
    std::vector<std::string> particles = {};  ///< none: all
    std::optional<WrittenVector> gravity = {};
    std::optional<WrittenNumber> drag = {};
    std::string potential = {};  ///< an expression; empty: none
    std::map<std::string, WrittenNumber> values = {};
    std::map<std::string, double> parameters = {};  ///< of the scene, that the expression uses
    bool operator==(const FieldTerm&) const = default;
};

/// Changes the start of the whole scene: values of a file first, then a vibration in a normal mode, then a reversal.
struct SceneStart {
    std::string file = {};  ///< FILE or FILE:STEP, relative to the scene file; empty: none
    StartChange change = {};
    std::size_t mode = 0;         ///< from 1 by ascending frequency, zero modes left out; 0: none
    WrittenNumber amplitude = 0;  ///< largest displacement of a particle
    bool operator==(const SceneStart&) const = default;
};

/// What a file says of how its scene opens; options of the command line go before it.
struct SceneDefaults {
    std::string method = {}, precision = {}, camera = {}, colour = {}, background = {};
    std::optional<double> dt = {}, until = {};
    std::map<std::string, std::string> method_parameters = {};  ///< as text: "tolerance" -> "1e-9"
    std::vector<std::string> compare = {};
    bool operator==(const SceneDefaults&) const = default;
};

struct Scene {
    std::vector<ParticleBlock> particles;
    std::vector<Fix> fixes;
    std::vector<SpringTerm> springs;
    std::vector<PairTerm> pairs;
    std::vector<FieldTerm> fields;
    WrittenVector box;                                  ///< sides of space that repeats itself; 0: not along this axis
    std::map<std::string, std::string> followers = {};  ///< names in expressions that are expressions themselves
    std::optional<WrittenVector> corner = {};           ///< of the box, for pictures and files
    SceneStart start = {};

    std::size_t count() const;
    /// Forces that follow from distances alone, of pairs or along springs.
    bool has_potentials() const {
        return !pairs.empty() || std::any_of(springs.begin(), springs.end(),
                                             [](const SpringTerm& term) { return term.potential.has_value(); });
    }
    bool operator==(const Scene&) const = default;
};

}  // namespace steplab
