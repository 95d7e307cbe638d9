#pragma once

#include "session/worker.hpp"

#include <optional>
#include <string>
#include <vector>

namespace steplab::ui {

/// Takes the commands of the interface down, in the order in which they came.
class Recorder final : public Commands {
public:
    void play(bool on) override { calls.push_back(on ? "play" : "pause"); }
    void step_forward() override { calls.push_back("step forward"); }
    void step_back() override { calls.push_back("step back"); }
    void restart() override { calls.push_back("restart"); }
    void change(const RunDescription& description) override {
        calls.push_back("change");
        changes.push_back(description);
    }
    void set_rate(Rate rate) override {
        calls.push_back("rate");
        rates.push_back(rate);
    }
    void track(std::optional<std::size_t> particle) override {
        calls.push_back("track");
        tracked = particle;
    }
    void pull(std::size_t particle, Vec3 position) override {
        calls.push_back("pull");
        pulled = {particle, position};
    }
    void show_ensemble(const LiveEnsembleOptions& ensemble) override {
        calls.push_back("ensemble");
        ensembles.push_back(ensemble);
    }
    void show_forces(bool on) override {
        calls.push_back("forces");
        with_forces = on;
    }

    struct Pull {
        std::size_t particle = 0;
        Vec3 position;
    };
    std::vector<std::string> calls;
    std::vector<RunDescription> changes;
    std::vector<Rate> rates;
    std::optional<std::size_t> tracked;
    bool with_forces = false;
    std::optional<Pull> pulled;
    std::vector<LiveEnsembleOptions> ensembles;
};

}  // namespace steplab::ui
