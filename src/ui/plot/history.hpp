#pragma once

#include "session/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace steplab::ui {

/// What the interface remembers of the views of a run: what is not in the samples that they hold.
class History {
public:
    /// Records a view of the leading run. A new run clears all; a step back what is no longer valid.
    void record(const RunView& view);

    /// The axis of the largest displacement of a tracked particle: 0 x, 1 y, 2 z.
    int direction() const { return direction_; }
    /// Largest displacement and position error of all particles in the run so far, 0 if none is known: in the samples
    /// of the run where it has some, which do not depend on how fast it is played, else in the views.
    double largest_displacement() const { return reached_.empty() ? 0 : reached_.back().farthest; }
    double largest_error() const { return reached_.empty() ? 0 : reached_.back().worst; }

private:
    /// In the run up to a step.
    struct Reached {
        std::uint64_t step = 0;
        double farthest = 0;  ///< largest displacement of a particle
        double worst = 0;     ///< largest position error, where one is known

        void reach_to(double displacement, std::optional<double> error);
    };

    void begin(const RunView& view);
    void follow(const RunView& view);
    void reach_to(Vec3 displacement);
    void lean_to(Vec3 velocity);

    std::optional<std::uint64_t> run_;
    std::optional<std::size_t> particle_;
    Vec3 reach_;
    int direction_ = 1;
    std::vector<Reached> reached_;
};

/// The component of a vector along an axis: 0 x, 1 y, 2 z.
double component(Vec3 vector, int axis);

}  // namespace steplab::ui
