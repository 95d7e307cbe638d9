#pragma once

#include "lab/limits/blow_up.hpp"
#include "lab/limits/present_limit.hpp"
#include "session/time_line.hpp"

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace steplab {

/// Finds how the steps of a run stand to its scene as it is now, and why it diverged, on a thread of its own that takes
/// a small part of the time.
class LiveVerdict {
public:
    /// A moment of a run.
    struct Moment {
        RunDescription run;
        std::uint64_t step = 0, segment = 0;  ///< Simulation::segment(): an act at a step makes another moment of it
        double time = 0;                      ///< [s]
        State<double> state = {};
    };

    /// `ready` is called from the thread when there is more to see.
    explicit LiveVerdict(std::function<void()> ready);
    ~LiveVerdict();

    /// Of this moment, which takes the place of one that is still waiting.
    void ask(Moment moment);
    /// True if the moment asked about last is not this one.
    bool is_new(const Simulation& run) const;
    /// Why a run diverged so; goes on if that was asked before.
    void ask_why(const TimeLine& line, const Divergence& divergence);
    /// No run has diverged any more.
    void forget_why();

    /// The newest that is known: of the moment asked about last, or one before with the same description. Null if there
    /// is none; a first one is waited for so long.
    std::shared_ptr<const PresentLimit> limit(std::chrono::duration<double> most) const;
    /// Of the run asked about; null before its cause is known.
    std::shared_ptr<const BlowUp> blow_up() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
