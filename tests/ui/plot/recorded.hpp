#pragma once

#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>

namespace steplab::ui {

/// An empty working directory, removed at the end.
class OwnFolder {
public:
    OwnFolder() : before_(std::filesystem::current_path()) {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("steplab-") + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~OwnFolder() {
        std::filesystem::current_path(before_);
        std::filesystem::remove_all(folder_);
    }

private:
    std::filesystem::path before_;
    std::filesystem::path folder_;
};

/// A desk with the recorded steps of a run.
struct Recorded {
    explicit Recorded(const std::string& model) : Recorded(describe(model), 50) {}
    /// Of its last particle, or of these.
    Recorded(const RunDescription& description, int steps, TrackedParticles tracked = {}) : desk(description) {
        Simulation simulation(description);
        if (tracked.empty()) tracked = {simulation.particles() - 1};
        for (int i = 0; i < steps; ++i) {
            RunView view = view_of(simulation, tracked);
            view.series.samples = std::move(desk.view.series.samples);
            view.series.samples.push_back(sample_of(view));
            desk.view = std::move(view);
            desk.interface.record(desk.view);
            simulation.advance(1);
        }
        desk.frame();
    }
    Desk desk;
};

/// Another kind in place of the plot of this number, from 1.
inline void choose(Desk& desk, std::size_t number, std::string_view kind) {
    const std::string widget = "plot " + std::to_string(number);
    desk.click(widget);
    desk.frame();
    desk.click(widget + "/" + std::string(kind));
    desk.frame();
}

/// A file of the working directory.
inline std::string text_of_file(const std::string& name) {
    std::stringstream text;
    text << std::ifstream(name).rdbuf();
    return text.str();
}

/// The table of a plot that is shown, saved for the first time.
inline std::string saved_csv(Desk& desk, const std::string& kind) {
    desk.click(kind + ".save");
    desk.click(kind + ".csv");
    desk.frame();
    std::string words = kind;
    std::replace(words.begin(), words.end(), ' ', '-');
    return text_of_file("steplab-" + words + "-1.csv");
}

}  // namespace steplab::ui
