#pragma once

#include "app/cli/progress.hpp"
#include "app/commands/pictured_ensemble.hpp"
#include "app/commands/pictured_errors.hpp"
#include "app/offscreen/module.hpp"
#include "sim/run/plausible_steps.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// The runs of a picture, or of the pictures of a film one after the other, and what is drawn of them. They only go
/// forward, and no step is taken twice (PlausibleSteps); what is kept does not grow with the number of pictures.
class PicturedRuns {
public:
    /// The leading run first; `end` is its end. `request`: the picture without its runs. Progress is shown on standard
    /// error, as lines of this program where that is no terminal and one is named. Throws UsageError, Interrupted.
    PicturedRuns(const std::vector<RunDescription>& runs, const RunEnd& end, PictureRequest request,
                 std::optional<PicturedEnsemble> ensemble, std::string program = {});
    PicturedRuns(const PicturedRuns&) = delete;
    PicturedRuns& operator=(const PicturedRuns&) = delete;

    /// Takes the leading run to this step, not below that before, or to its last good step if it diverges; the others
    /// to its time, each to its step there (step_at()). False if that is where all of them stood. Throws Interrupted.
    bool go_to(std::uint64_t step);
    /// True once the leading run has diverged: it goes no further.
    bool is_over() const { return runs_.front().simulation.divergence().has_value(); }

    /// The picture of the moment.
    const PictureRequest& request() const { return request_; }
    /// Draws all pictures from now on with this camera.
    void keep_camera(std::string camera) { request_.camera = std::move(camera); }
    /// Clears what is shown of the progress.
    void end_progress() { progress_->clear(); }
    /// Of rounding (sim/run/notes.hpp), of several runs with their numbers; the leading one is number 0.
    std::vector<std::string> notes() const;
    /// Throws an error with code `diverged` that names the runs that did, if any; the leading one is number 0.
    void check_ends() const;

private:
    struct Run {
        Simulation simulation;
        PlausibleSteps steps;
    };
    struct Place {
        std::uint64_t step;
        bool diverged;
        friend bool operator==(const Place&, const Place&) = default;
    };

    void add(const RunDescription& description, std::uint64_t end);
    void take_samples(std::uint64_t step);
    PastMoment moment();
    void follow_leading();
    std::vector<const Simulation*> simulations() const;
    std::uint64_t step_of_sample(std::uint64_t sample) const;
    std::vector<Place> places() const;
    void look();
    void judge_steps();

    PictureRequest request_;
    RunEnd end_;
    std::optional<PicturedEnsemble> ensemble_;
    std::vector<Run> runs_;
    PicturedErrors errors_;
    PresentLimits limits_;
    TrackedParticles tracked_;
    std::uint64_t samples_ = 0, sampled_ = 0;
    std::optional<Progress> progress_;
    std::vector<Place> shown_;
};

}  // namespace steplab
