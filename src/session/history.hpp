#pragma once

#include "sim/run/simulation.hpp"

#include <cstdint>
#include <vector>

namespace steplab {

/// Moments of a run to come back to: a step back steps again from the nearest one. It holds the start of every segment,
/// and within them moments that grow sparser when the memory allowed is full.
class History {
public:
    /// `bytes`: memory that the kept states may take; two moments are kept however large they are.
    explicit History(std::size_t bytes = std::size_t{512} << 20) : allowed_(bytes) {}

    /// Keeps the present moment of the run if it lies far enough from the last kept one, or begins a segment.
    void offer(const Simulation& simulation);

    /// True if there is a moment before this step.
    bool reaches_before(std::uint64_t step) const;

    /// Takes the run back to `step`, which lies before where it stands, and forgets what came after.
    /// Without effect if nothing so early is kept.
    void go_back(Simulation& simulation, std::uint64_t step);

    void clear();
    /// Memory that the kept states take.
    std::size_t bytes() const { return used_; }

private:
    void thin_out();
    void drop_oldest();

    std::size_t allowed_;
    std::size_t used_ = 0;
    std::uint64_t spacing_ = 16;  ///< steps between two moments of a segment
    std::vector<Simulation::Snapshot> moments_;
};

}  // namespace steplab
