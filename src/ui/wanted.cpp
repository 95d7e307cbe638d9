#include "ui/wanted.hpp"

#include "core/error.hpp"

#include <imgui_internal.h>

namespace steplab::ui {

void Wanted::follow(const RunView& view, bool is_new, bool played_back) {
    played_back_ = played_back;
    playing_.follow(view.playing, is_new);
    if (view.divergence && !diverged_) playing_.refused();  // it may have played too shortly for a view of that
    diverged_ = view.divergence.has_value();
    at_start_ = view.frame.step == 0;
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

void Wanted::ask(const RunDescription& asked, EventSink& events) {
    RunDescription description;
    try {
        description = without_missing_alterations(asked);
        if (!played_back_ && description == this->description()) return;
        check_values(description);
    } catch (const UsageError& error) {
        message_ = error.what();
        return;
    }
    message_.clear();
    asked_ = description;
    if (played_back_) return events.begin(description);
    const unsigned held = ImGui::GetCurrentContext() ? ImGui::GetActiveID() : 0;
    events.send(event::Change{description, held != 0 && held == asked_by_});
    asked_by_ = held;
}

void Wanted::play(bool on, EventSink& events, bool backwards) {
    const bool possible = played_back_ || !(backwards ? at_start_ : diverged_);
    if (possible || !on) playing_.ask(on);
    events.send(event::Play{on, backwards});
}

void Wanted::set_rate(Rate rate, EventSink& events) {
    rate_.ask(rate);
    events.send(event::SetRate{rate});
}

void Wanted::show_ensemble(const LiveEnsembleOptions& ensemble, EventSink& events) {
    if (ensemble == ensemble_.shown()) return;
    ensemble_.ask(ensemble);
    events.send(event::ShowEnsemble{ensemble});
}

}  // namespace steplab::ui
