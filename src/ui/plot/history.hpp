#pragma once

#include "session/worker.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace steplab::ui {

/// The quantities of one step that the plots show.
struct Sample {
    double time = 0;
    double energy_error = 0;                 ///< |E - E0|
    double farthest = 0;                     ///< largest displacement of a particle in the run so far
    double worst = 0;                        ///< largest position error in the run so far, where one is known
    std::optional<Vec3> displacement;        ///< of the followed particle from its rest position
    std::optional<Vec3> exact_displacement;  ///< the same in the exact solution
};

/// The time series of one run for the plots, in bounded memory.
class History {
public:
    /// Records a view of the run. A new run clears the series; a step back or another followed particle removes what
    /// is no longer valid.
    void record(const RunView& view);

    /// Samples over the whole run. If there are too many, every second one is dropped.
    std::span<const Sample> whole() const { return whole_; }
    /// The latest samples, none left out.
    std::span<const Sample> recent() const;
    /// The followed particle, whose displacement is recorded.
    std::optional<std::size_t> particle() const { return particle_; }
    /// The axis of its largest displacement: 0 x, 1 y, 2 z.
    int direction() const { return direction_; }
    /// Largest displacement and position error of all particles in the run so far, 0 if none is known.
    double largest_displacement() const { return recent_.empty() ? 0 : recent_.back().farthest; }
    double largest_error() const { return recent_.empty() ? 0 : recent_.back().worst; }

private:
    void begin(const RunView& view);
    void forget_from(double time);
    void follow(const std::optional<Tracked>& tracked);
    void append(const Sample& sample);
    Sample last() const;

    std::optional<std::uint64_t> run_;
    std::optional<std::size_t> particle_;
    Vec3 reach_;
    int direction_ = 1;
    std::vector<Sample> whole_;
    std::size_t stride_ = 1;
    std::size_t skipped_ = 0;
    std::vector<Sample> recent_;
};

/// The component of a vector along an axis: 0 x, 1 y, 2 z.
double component(Vec3 vector, int axis);

}  // namespace steplab::ui
