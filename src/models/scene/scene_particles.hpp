#pragma once

#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "models/scene/random_start.hpp"
#include "models/scene/scene.hpp"

#include <cstddef>
#include <iterator>
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

/// What was given last to each of the numbers 0, 1, 2 ...: ranges cost what they cover of others, not of particles.
template <class Value>
class LastGiven {
public:
    void give(IndexRange range, const Value& value) {
        if (range.count == 0) return;
        const std::size_t end = range.first + range.count;
        const Value* const behind = at(end);
        values_.erase(values_.lower_bound(range.first), values_.upper_bound(end));
        values_[range.first] = &value;
        values_[end] = behind;
    }
    /// Null: nothing.
    const Value* at(std::size_t i) const {
        const auto after = values_.upper_bound(i);
        return after == values_.begin() ? nullptr : std::prev(after)->second;
    }

private:
    std::map<std::size_t, const Value*> values_;  ///< from a number to the next of the map
};

/// The particles of a scene one by one; nothing is stored for each. The scene must outlive it.
class SceneParticles {
public:
    /// What is asked of them: which there are alone, where they are, or all that operator[] tells; thermal velocities
    /// take a while.
    enum class Ask { names, places, all };

    /// Throws UsageError if a fix names particles that are none.
    explicit SceneParticles(const Scene& scene, Ask ask = Ask::all);

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
    void apply_fixes(std::size_t i, SceneParticle& particle) const;
    SceneParticle of_block(const Block& block, std::size_t index) const;
    std::size_t index_in(std::string_view text, const Group& group) const;

    std::vector<Block> blocks_;
    std::size_t count_ = 0;
    std::map<std::string_view, std::size_t> groups_;  ///< which block has this name
    LastGiven<bool> fixed_;
    LastGiven<WrittenVector> velocities_, displacements_;
    LastGiven<WrittenNumber> masses_, charges_;
    LastGiven<Role> roles_;
};

/// The mass of all particles; nothing where they differ.
std::optional<double> common_mass(const SceneParticles& particles);

}  // namespace steplab
