#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace steplab {

/// Two particles that passed through each other, where the force between them jumps.
struct Collision {
    double time = 0;  ///< since the start of the segment
    std::uint32_t first = 0;
    std::uint32_t second = 0;

    friend bool operator==(const Collision&, const Collision&) = default;
};

/// The collisions of a segment: how many there were, and the first hundred of them. Plain data.
class CollisionRecord {
public:
    void add(const Collision& collision) {
        if (count_ < kept_.size()) kept_[count_] = collision;
        ++count_;
    }
    /// The same with each particle i called names[i].
    CollisionRecord with_particles(std::span<const std::uint32_t> names) const {
        CollisionRecord renamed = *this;
        for (Collision& collision : std::span(renamed.kept_).first(kept().size())) {
            collision.first = names[collision.first];
            collision.second = names[collision.second];
        }
        return renamed;
    }
    std::uint64_t count() const { return count_; }
    std::span<const Collision> kept() const { return {kept_.data(), count_ < kept_.size() ? count_ : kept_.size()}; }

private:
    std::uint64_t count_ = 0;
    std::array<Collision, 100> kept_{};
};

}  // namespace steplab
