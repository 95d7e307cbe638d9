#include "ui/wanted.hpp"

#include "core/error.hpp"

namespace steplab::ui {

void Wanted::follow(const RunView& view, bool is_new) {
    playing_.follow(view.playing, is_new);
    rate_.follow(view.rate, is_new);
    ensemble_.follow(view.ensemble, is_new);
    running_ = view.description;
    if (asked_ == running_) asked_.reset();
    if (view.failures == seen_failures_) return;
    seen_failures_ = view.failures;
    ensemble_.refused();
    message_ = view.error;
    asked_.reset();
}

void Wanted::ask(const RunDescription& description, Commands& commands) {
    if (description == this->description()) return;
    try {
        check_values(description);
    } catch (const UsageError& error) {
        message_ = error.what();
        return;
    }
    message_.clear();
    asked_ = description;
    commands.change(description);
}

void Wanted::play(bool on, Commands& commands) {
    playing_.ask(on);
    commands.play(on);
}

void Wanted::set_rate(Rate rate, Commands& commands) {
    rate_.ask(rate);
    commands.set_rate(rate);
}

void Wanted::show_ensemble(const LiveEnsembleOptions& ensemble, Commands& commands) {
    if (ensemble == ensemble_.shown()) return;
    ensemble_.ask(ensemble);
    commands.show_ensemble(ensemble);
}

}  // namespace steplab::ui
