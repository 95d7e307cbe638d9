#pragma once

#include "app/cli/ensemble_options.hpp"
#include "session/run_view.hpp"
#include "session/spread_samples.hpp"
#include "sim/ensemble/live_ensemble.hpp"
#include "sim/ensemble/parameter_range.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace steplab {

/// The ensemble shown in a picture.
class PicturedEnsemble {
public:
    /// Throws UsageError if a run is not possible, Interrupted.
    PicturedEnsemble(const RunDescription& description, std::size_t runs, const std::vector<ParameterRange>& ranges);

    /// For plots: the largest distance there, and how far this particle reaches in its runs.
    void follow(std::size_t particle) { spread_.follow(particle); }
    /// Takes a sample where the run stands, which only goes forward. Throws Interrupted.
    void sample(const Simulation& run);
    /// Computes the ensemble at the step of a view, of a run without changes. Throws Interrupted.
    void put_into(RunView& view);

private:
    void go_to(std::uint64_t step);

    std::vector<SegmentBegin> segments_;
    LiveEnsembleOptions ensemble_;
    LiveEnsemble live_ensemble_;
    SpreadSamples spread_{1};  // at every step that is asked for
};

/// That of the options, of a run; none if they name none. Throws UsageError, Interrupted.
std::optional<PicturedEnsemble> pictured_ensemble(const EnsembleOptions& options, const RunDescription& description);

}  // namespace steplab
