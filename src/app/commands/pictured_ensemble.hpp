#pragma once

#include "app/cli/ensemble_options.hpp"
#include "session/run_view.hpp"
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

    /// Computes the ensemble at the step of a view, of a run without changes. Throws Interrupted.
    void put_into(RunView& view);

private:
    void go_to(std::uint64_t step);

    std::vector<SegmentBegin> segments_;
    LiveEnsembleOptions ensemble_;
    LiveEnsemble live_ensemble_;
};

/// That of the options, of a run; none if they name none. Throws UsageError, Interrupted.
std::optional<PicturedEnsemble> pictured_ensemble(const EnsembleOptions& options, const RunDescription& description);

}  // namespace steplab
