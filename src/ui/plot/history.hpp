#pragma once

#include "sim/run/worker.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace steplab::ui {

/// One moment of a run as the plots keep it.
struct Sample {
    double time = 0;
    double energy_error = 0;                 ///< |E - E0|
    double max_displacement = 0;             ///< of any particle
    std::optional<Vec3> displacement;        ///< of the followed particle from rest
    std::optional<Vec3> exact_displacement;  ///< the same in the exact solution
};

/// What the plots show: moments of one run in the order of time, in bounded memory.
class History {
public:
    /// Takes a moment of the run. A new run begins anew; a step back, or another followed particle, drops what no
    /// longer holds.
    void record(const RunView& view);

    /// Samples that span the whole run; when they become too many, every second one goes.
    std::span<const Sample> whole() const { return whole_; }
    /// The latest samples, every one that was seen.
    std::span<const Sample> recent() const;
    /// The particle whose displacement is kept, if one is followed.
    std::optional<std::size_t> particle() const { return particle_; }
    /// The axis along which it moves most: 0 x, 1 y, 2 z.
    int direction() const { return direction_; }
    /// Of any particle, in the whole run.
    double largest_displacement() const;

private:
    void begin(const RunView& view);
    void forget_from(double time);
    void follow(const std::optional<Tracked>& tracked);
    void append(const Sample& sample);

    std::optional<std::uint64_t> run_;
    std::optional<std::size_t> particle_;
    Vec3 reach_;
    int direction_ = 1;
    std::vector<Sample> whole_;
    std::size_t stride_ = 1;
    std::size_t skipped_ = 0;
    std::vector<Sample> recent_;
};

/// The part of a vector along an axis: 0 x, 1 y, 2 z.
double component(Vec3 vector, int axis);

}  // namespace steplab::ui
