#pragma once

#include "session/compared.hpp"
#include "session/error_samples.hpp"
#include "session/session_view.hpp"
#include "sim/ensemble/live_ensemble.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// Compares the runs of a session with the motion of their scene, on a thread of its own, as a reference takes longer
/// than the runs. What it says of a moment depends on that moment alone.
class LiveErrors {
public:
    /// A run as it was shown.
    struct Shown {
        RunMoment moment;
        std::vector<SegmentBegin> changes;  ///< that had taken effect
        bool over = false;                  ///< it stands at its last good step, before this time
        /// All that was done to it, also ahead, and the last step that it was at.
        struct Way {
            std::vector<SegmentBegin> changes;
            std::uint64_t reached = 0;
        };
        std::optional<Way> way = {};  ///< if errors at the steps of a grid are wanted
    };

    /// `ready` is called from the thread when there is an answer.
    explicit LiveErrors(std::function<void()> ready);
    ~LiveErrors();

    /// The runs of one moment, the leading one first; a question that still waits is forgotten.
    void ask(double time, std::vector<Shown> runs);
    /// Waits for the answer to the last question as long as that is no more than this; the newest answer, if there is
    /// any that was not forgotten.
    std::optional<SessionErrors> newest(std::chrono::duration<double> most);
    /// The errors at the steps of a grid of each run of the last question that was answered, as far as they are known;
    /// empty where they were not wanted.
    void put_into(std::vector<ErrorSeries>& series) const;
    /// There are other runs from here on: no answer yet.
    void forget();

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

class Session;

/// The runs of a session where they stand.
std::vector<LiveErrors::Shown> shown_runs(const Session& session);

}  // namespace steplab
