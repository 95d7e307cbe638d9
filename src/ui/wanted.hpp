#pragma once

#include "sim/run/worker.hpp"

#include <optional>
#include <string>

namespace steplab::ui {

/// What the person wants computed. Between asking for a change and seeing the run that has it, the panel shows what was
/// asked for; every further change builds on that, so a dragged slider never jumps back and the newest value wins.
class Wanted {
public:
    /// Takes note of what the run is doing now. `is_new`: this view was not seen before.
    void follow(const RunView& view, bool is_new);

    const RunDescription& description() const { return asked_ ? *asked_ : running_; }
    /// Sends a change at once if it differs from what was asked for and can be run; else message() says why not.
    void ask(const RunDescription& description, Commands& commands);
    /// Whether the run plays, how fast, and with what ensemble; the same way.
    bool playing() const { return playing_.shown(); }
    Rate rate() const { return rate_.shown(); }
    const LiveEnsembleOptions& ensemble() const { return ensemble_.shown(); }
    void play(bool on, Commands& commands);
    void set_rate(Rate rate, Commands& commands);
    void show_ensemble(const LiveEnsembleOptions& ensemble, Commands& commands);
    /// Tells why something that was typed cannot be meant.
    void refuse(std::string message) { message_ = std::move(message); }

    /// Why the last change was refused, here or by the run; empty if it was not.
    const std::string& message() const { return message_; }
    void dismiss() { message_.clear(); }

private:
    /// A setting that was asked for, shown until the run has it. A run may have its reasons not to take it (it is
    /// over), so after some views what it does counts again.
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
    RunDescription running_;
    std::optional<RunDescription> asked_;
    std::string message_;
    std::string seen_error_;
};

}  // namespace steplab::ui
