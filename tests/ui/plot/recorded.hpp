#pragma once

#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
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

/// A desk with 50 recorded steps of a run.
struct Recorded {
    explicit Recorded(const std::string& model) : desk(describe(model)) {
        Simulation simulation(describe(model));
        for (int i = 0; i < 50; ++i) {
            RunView view = view_of(simulation, simulation.particles() - 1);
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

/// A file of the working directory.
inline std::string text_of_file(const std::string& name) {
    std::stringstream text;
    text << std::ifstream(name).rdbuf();
    return text.str();
}

}  // namespace steplab::ui
