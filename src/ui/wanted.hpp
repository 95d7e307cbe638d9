#pragma once

#include "session/worker.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace steplab::ui {

/// The settings that the user has requested. From a request until the run has taken it, the panel shows the requested
/// values and further changes build on them, so that a dragged slider never jumps back and the newest value wins.
class Wanted {
public:
    /// Updates to the state of the run. `is_new`: the first call with this view. `played_back`: it is that of a
    /// trajectory.
    void follow(const RunView& view, bool is_new, bool played_back = false);

    const RunDescription& description() const { return asked_ ? *asked_ : running_; }
    /// Sends a change at once if it differs from the last request; if its values are refused, message() gives the
    /// reason. What can be said only of the scene itself, which is not made here, the run refuses. In place of a
    /// trajectory a run of the description begins. Alterations of particles that the scene has no more are left out.
    void ask(const RunDescription& asked, EventSink& events);
    /// The same for playing or pausing, the speed and the ensemble.
    bool playing() const { return playing_.shown(); }
    Rate rate() const { return rate_.shown(); }
    const LiveEnsembleOptions& ensemble() const { return ensemble_.shown(); }
    /// What cannot be played, a run that is over or the part before its start, is not shown as if it were: no view
    /// would come that says otherwise.
    void play(bool on, EventSink& events, bool backwards = false);
    void set_rate(Rate rate, EventSink& events);
    void show_ensemble(const LiveEnsembleOptions& ensemble, EventSink& events);
    /// Shows why an entry was refused.
    void refuse(std::string message) { message_ = std::move(message); }

    /// The reason why the last change was refused, here or by the run; empty if it was not.
    const std::string& message() const { return message_; }
    void dismiss() { message_.clear(); }

private:
    /// A requested setting, shown until the run has taken it. A run that has ended does not take it: after some views
    /// the setting of the run is shown again.
    template <class T>
    class Setting {
    public:
        const T& shown() const { return asked_ ? *asked_ : running_; }
        void ask(const T& value) {
            asked_ = value;
            views_ = 0;
        }
        void follow(const T& running, bool is_new) {
            running_ = running;
            if (is_new) ++views_;
            if (asked_ == running_ || views_ > patience) asked_.reset();
        }
        void refused() { asked_.reset(); }

    private:
        static constexpr int patience = 3;
        T running_{};
        std::optional<T> asked_;
        int views_ = 0;
    };

    Setting<bool> playing_;
    Setting<Rate> rate_;
    Setting<LiveEnsembleOptions> ensemble_;
    bool played_back_ = false;
    bool diverged_ = false;
    bool at_start_ = false;
    RunDescription running_;
    std::optional<RunDescription> asked_;
    unsigned asked_by_ = 0;  ///< the widget that was held when a change was asked for last; 0: none
    std::string message_;
    std::uint64_t seen_failures_ = 0;
};

}  // namespace steplab::ui
