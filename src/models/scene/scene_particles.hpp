#pragma once

#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "models/scene/random_start.hpp"
#include "models/scene/scene.hpp"

#include <cstddef>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace steplab {

/// Particles first ... first + count - 1.
struct IndexRange {
    std::size_t first = 0, count = 0;
    bool operator==(const IndexRange&) const = default;
};

/// A particle of a scene with all that its block and the fixes say. It starts at position + displacement. Its role is
/// Role::fixed if and only if it is fixed.
struct SceneParticle {
    Vec3 position, displacement, velocity;
    double mass = 1, charge = 0;
    bool fixed = false;
    Role role = Role::moving;
};

/// The particles of a scene one by one; nothing is stored for each. The scene must outlive it.
class SceneParticles {
public:
    /// Throws UsageError if a fix names particles that are none.
    explicit SceneParticles(const Scene& scene);

    std::size_t count() const { return count_; }
    SceneParticle operator[](std::size_t i) const;

    /// The particles that a text names: "rope", "rope[0]", "rope[-1]", "rope[2-5]", "cloth[3,0]", "all", "7", "4-9".
    /// Throws UsageError, naming the nearest group or the range.
    IndexRange named(std::string_view text) const;
    /// The block of a group and its particles. Throws UsageError.
    struct Group {
        const ParticleBlock& block;
        IndexRange particles;
    };
    Group group(std::string_view name) const;

private:
    struct Block {
        const ParticleBlock* block;
        std::size_t first, count;
        std::optional<ThermalVelocities> thermal;
    };

    void add(const Fix& fix, IndexRange range);
    SceneParticle of_block(const Block& block, std::size_t index) const;
    std::size_t index_in(std::string_view text, const Group& group) const;

    const Scene& scene_;
    std::vector<Block> blocks_;
    std::size_t count_ = 0;
    using Fixes = std::vector<const Fix*>;
    std::map<std::size_t, Fixes> fixes_;  ///< those of the particles from an index to the next of the map, in order
};

/// The mass of all particles; nothing where they differ.
std::optional<double> common_mass(const SceneParticles& particles);

}  // namespace steplab
