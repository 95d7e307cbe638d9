#pragma once

#include "session/compared.hpp"
#include "session/session_view.hpp"
#include "sim/ensemble/live_ensemble.hpp"

#include <chrono>
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
    };

    /// `ready` is called from the thread when there is an answer.
    explicit LiveErrors(std::function<void()> ready);
    ~LiveErrors();

    /// The runs of one moment, the leading one first; a question that still waits is forgotten.
    void ask(double time, std::vector<Shown> runs);
    /// Waits for the answer to the last question as long as that is no more than this; the newest answer, if there is
    /// any that was not forgotten.
    std::optional<SessionErrors> newest(std::chrono::duration<double> most);
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
