#pragma once

#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

/// Moments of a run to come back to: any other is reached by stepping again from the nearest one. They grow sparser
/// when the memory allowed is full, the first after each change of the run always being kept (of a hold: after its
/// first tug). None is of a moment whose energy is impossible: from there, another step would be found to be the last
/// good one.
class Moments {
public:
    struct Moment {
        std::uint64_t step = 0;
        std::size_t changes = 0;  ///< that had taken effect
        std::size_t since = 0;    ///< the first of them that belongs to what was done last
        Simulation::Snapshot state;
    };

    /// `bytes`: memory that the kept states may take; two moments are kept however large they are.
    explicit Moments(std::size_t bytes) : allowed_(bytes) {}

    /// From now on they may take so much memory.
    void allow(std::size_t bytes);
    /// Keeps the present moment of the run, up to which so many changes have taken effect, those from `since` on as
    /// one, unless one is near.
    void offer(const Simulation& simulation, std::size_t changes, std::size_t since);
    /// Keeps it unless that same one is kept.
    void keep(const Simulation& simulation, std::size_t changes, std::size_t since);
    /// The last one up to this step with so many changes at most; null if there is none.
    const Moment* before(std::uint64_t step, std::size_t changes) const;
    /// Takes away those with more changes, and those that lie after this step.
    std::vector<Moment> cut(std::uint64_t step, std::size_t changes);
    /// Puts such back, behind all that are here.
    void append(std::vector<Moment> moments);
    void clear();
    std::span<const Moment> all() const { return moments_; }
    /// Memory that the kept states take.
    std::size_t bytes() const { return used_; }

private:
    void keep_within(const Simulation& simulation, const Moment& moment, std::uint64_t spacing);
    void keep_to_memory();
    void thin_out();

    std::size_t allowed_;
    std::size_t used_ = 0;
    std::uint64_t spacing_ = 16;   ///< steps between two moments
    std::vector<Moment> moments_;  ///< in the order of steps and changes
};

}  // namespace steplab
