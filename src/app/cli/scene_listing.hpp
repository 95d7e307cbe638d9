#pragma once

#include "sim/run/run_description.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// What a scene consists of, and how it is stepped.
struct SceneListing {
    struct PairForce {
        std::string potential;
        double pairs = 0;  ///< as a double because there may be many
        std::optional<double> cutoff = {};
        bool along_springs = false;  ///< between the ends of springs alone
    };

    RunDescription run;
    std::string_view layout;      ///< of its forces: "line"
    std::string_view recognised;  ///< in words: "a line of equal springs"
    std::string_view instructions;
    std::size_t threads = 1;
    bool reordered = false;  ///< stepped along a Z-order curve, not in the order of the scene
    std::size_t particles = 0, fixed = 0;
    std::size_t springs = 0;
    std::vector<PairForce> pair_forces = {};
    std::size_t fields = 0;
    double lightest = 0, heaviest = 0;  ///< mass of a particle
    double drag = 0;                    ///< rate gamma = c / m
    Vec3 box = {};                      ///< sides; 0: not periodic along this axis
};

/// Takes the time of making the scene. Throws UsageError if it cannot be run.
SceneListing scene_listing(const RunDescription& run);
/// Aligned lines for people.
std::string scene_text(const SceneListing& scene);
/// One object.
std::string scene_json(const SceneListing& scene);

}  // namespace steplab
