#pragma once

#include "session/session_view.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab::ui {

/// Values that views told of, by the steps of the run, in bounded memory.
class Course {
public:
    static constexpr std::size_t most = 8192;

    /// At a step; what was known of it and of later ones is forgotten.
    void put(std::uint64_t step, double time, double value);
    std::span<const double> times() const { return times_; }
    std::span<const double> values() const { return values_; }

private:
    void keep(std::size_t count);
    void thin_out();

    std::vector<std::uint64_t> steps_;
    std::vector<double> times_, values_;
};

/// Where the followed particle is in the runs of an ensemble: its lowest and highest displacement along the direction
/// in which it moves most.
struct EnsembleReach {
    Course low, high;
};

/// What the interface remembers of the views of a run: what is not in the samples that they hold.
class History {
public:
    /// Records a view of the leading run. A new run clears all; a step back what is no longer valid.
    void record(const RunView& view);
    /// Records the errors of all runs and the spread of the ensemble.
    void record_beside(const SessionView& view);

    /// The axis of the followed particle's largest displacement: 0 x, 1 y, 2 z.
    int direction() const { return direction_; }
    /// Largest displacement and position error of all particles in the run so far, 0 if none is known.
    double largest_displacement() const { return reached_.empty() ? 0 : reached_.back().farthest; }
    double largest_error() const { return reached_.empty() ? 0 : reached_.back().worst; }
    /// Position errors of the runs, the leading one first, as far as they were compared.
    std::span<const Course> errors() const { return errors_; }
    const Course& spread() const { return spread_; }
    /// Estimated error of the reference that the runs were compared with, at their times.
    const Course& reference_error() const { return reference_error_; }
    const EnsembleReach& ensemble() const { return ensemble_; }

private:
    /// In the run up to a step.
    struct Reached {
        std::uint64_t step = 0;
        double farthest = 0;  ///< largest displacement of a particle
        double worst = 0;     ///< largest position error, where one is known
    };

    void begin(const RunView& view);
    void follow(const std::optional<Tracked>& tracked);
    void record_ensemble(const RunView& view);

    std::optional<std::uint64_t> run_;
    std::optional<std::size_t> particle_;
    Vec3 reach_;
    int direction_ = 1;
    std::vector<Reached> reached_;
    std::vector<Course> errors_;
    Course spread_, reference_error_;
    EnsembleReach ensemble_;
};

/// The component of a vector along an axis: 0 x, 1 y, 2 z.
double component(Vec3 vector, int axis);

}  // namespace steplab::ui
