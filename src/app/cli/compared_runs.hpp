#pragma once

#include "sim/run/run_description.hpp"
#include "sim/run/run_variant.hpp"

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace steplab {

/// The option --run, the same for every command that compares runs of one scene.
class ComparedRuns {
public:
    static constexpr std::size_t most = 4;

    void declare(CLI::App& app);
    bool are_given() const { return !texts_.empty(); }
    /// The runs of --run, in their order, then those that the scene file lists beside its own, which begins them where
    /// none is given. Two to four, checked. Throws UsageError.
    std::vector<RunDescription> runs(const RunDescription& scene) const;

private:
    std::vector<std::string> texts_;
};

}  // namespace steplab
