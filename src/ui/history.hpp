#pragma once

#include "sim/worker.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace steplab::ui {

/// One moment of a run as the plots keep it.
struct Sample {
    double time = 0;
    double energy_error = 0;                   ///< |E - E0|
    std::optional<double> displacement;        ///< of the followed particle along the plotted direction
    std::optional<double> exact_displacement;  ///< the same of the exact solution
};

/// What the plots show: samples of one run in the order of time. It keeps a bounded number; when it is full every
/// second one goes, so that it always spans the whole run.
class History {
public:
    explicit History(std::size_t capacity = 8192);

    /// Takes a moment of the run; a restarted run, another followed particle or a step back drop what no longer holds.
    void record(const RunView& view);
    void clear();

    const std::vector<Sample>& samples() const { return samples_; }
    /// The particle whose displacement is kept, if one is followed.
    std::optional<std::size_t> particle() const { return particle_; }
    /// The direction the displacement is measured along: 0 x, 1 y, 2 z; the one in which the particle moves most.
    int direction() const { return direction_; }

private:
    struct Moment {
        double time = 0;
        double energy_error = 0;
        std::optional<Tracked> tracked;
    };
    void append(const Moment& moment);
    void choose_direction(const Moment& moment);
    void rebuild();

    std::size_t capacity_;
    std::size_t stride_ = 1;
    std::size_t skipped_ = 0;
    std::optional<std::uint64_t> run_;
    std::optional<std::size_t> particle_;
    int direction_ = 1;
    Vec3 reach_;
    std::vector<Moment> moments_;
    std::vector<Sample> samples_;
};

}  // namespace steplab::ui
