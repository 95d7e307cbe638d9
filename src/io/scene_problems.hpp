#pragma once

#include "core/error.hpp"
#include "io/scene_toml.hpp"

#include <optional>

namespace steplab {

/// Of several problems, the one that comes first in the file.
class SceneProblems {
public:
    template <class Work>
    void attempt(const Work& work) {
        try {
            work();
        } catch (const SceneProblem& problem) {
            add(problem);
        }
    }
    /// The same for what is wrong with the meaning of a node.
    template <class Work>
    void attempt_at(const toml::node& place, const Work& work) {
        attempt([&] {
            try {
                work();
            } catch (const UsageError& error) {
                fail_at(place, error.what());
            }
        });
    }
    void add(const SceneProblem& problem) {
        if (!first_ || problem.place() < first_->place()) first_ = problem;
    }
    bool any() const { return first_.has_value(); }
    void report() const {
        if (first_) throw SceneProblem(*first_);
    }

private:
    std::optional<SceneProblem> first_;
};

}  // namespace steplab
