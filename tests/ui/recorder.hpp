#pragma once

#include "session/worker.hpp"

#include <optional>
#include <string>
#include <vector>

namespace steplab::ui {

/// Takes the events of the interface down, in the order in which they came.
class Recorder final : public EventSink {
public:
    void send(const Event& event) override {
        events.push_back(event);
        std::visit(Take{*this}, event);
    }

    void begin(const RunDescription& description) override {
        calls.emplace_back("begin");
        changes.push_back(description);
    }

    void play_part(const FilmPart& part) override {
        calls.emplace_back("part");
        parts.push_back(part);
    }

    std::vector<Event> events;
    std::vector<FilmPart> parts;
    std::vector<std::string> calls;
    std::vector<RunDescription> changes;
    std::vector<Rate> rates;
    std::optional<std::size_t> tracked;
    bool with_forces = false;
    std::optional<Pull> pulled;
    std::vector<LiveEnsembleOptions> ensembles;

private:
    struct Take {
        Recorder& to;

        void operator()(const event::Seek&) const { to.calls.emplace_back("seek"); }
        void operator()(const event::Play& play) const { to.calls.emplace_back(play.on ? "play" : "pause"); }
        void operator()(const event::Step& step) const {
            to.calls.emplace_back(step.steps > 0 ? "step forward" : "step back");
        }
        void operator()(const event::Restart&) const { to.calls.emplace_back("restart"); }
        void operator()(const event::Change& change) const {
            to.calls.emplace_back("change");
            to.changes.push_back(change.description);
        }
        void operator()(const event::SetRate& set) const {
            to.calls.emplace_back("rate");
            to.rates.push_back(set.rate);
        }
        void operator()(const event::Track& track) const {
            to.calls.emplace_back("track");
            to.tracked = track.particle;
        }
        void operator()(const event::AlsoTrack& track) const {
            std::string call = "also track";
            for (const std::size_t particle : track.particles) call += " " + std::to_string(particle);
            to.calls.push_back(call);
        }
        void operator()(const event::Do& act) const {
            to.calls.emplace_back(std::holds_alternative<Pull>(act.act) ? "pull" : "act");
            if (const auto* const pull = std::get_if<Pull>(&act.act)) to.pulled = *pull;
        }
        void operator()(const event::ShowEnsemble& show) const {
            to.calls.emplace_back("ensemble");
            to.ensembles.push_back(show.ensemble);
        }
        void operator()(const event::ShowForces& show) const {
            to.calls.emplace_back("forces");
            to.with_forces = show.on;
        }
        void operator()(const event::ShowSamples& show) const {
            to.calls.emplace_back(show.on ? "samples on" : "samples off");
        }
        void operator()(const event::ShowCosts& show) const {
            to.calls.emplace_back(show.on ? "costs on" : "costs off");
        }
        template <class Other>
        void operator()(const Other&) const {
            to.calls.emplace_back("other");
        }
    };
};

}  // namespace steplab::ui
