#pragma once

#include "core/vec3.hpp"
#include "sim/run/run_description.hpp"

#include <span>
#include <steplab/error.hpp>
#include <steplab/run.hpp>
#include <steplab/scene.hpp>
#include <utility>
#include <vector>

// What the sources of the library share.

namespace steplab::library {

/// A scene as the rooms below know it: a run of it, as it opens.
struct SceneState {
    RunDescription run;
};

inline const RunDescription& run_of(const Scene& scene) { return scene.state().run; }

/// The run of a scene with these settings. Throws steplab::UsageError.
RunDescription described(const Scene& scene, const Settings& settings);
/// The precision of this name; empty: that of the run. Throws steplab::UsageError.
Precision precision_named(const std::string& name, const RunDescription& run);
/// The parameters of a method.
Parameters parameters_of(const ParameterValues& values);

/// x y z of each particle after each other.
std::span<const double> numbers(std::span<const Vec3> vectors);
/// Three of them to a vector. Throws steplab::UsageError if their number is not 3 n, or one is not finite.
std::vector<Vec3> vectors(std::span<const double> numbers, std::size_t particles, std::string_view what);

/// Throws steplab::UsageError, naming the bytes, unless so many are available: "WHAT need 5 TB of memory, ...".
void check_memory(double bytes, std::string_view what, std::string_view instead);

/// Throws the exception that is being handled as one of the library's family.
[[noreturn]] void rethrow_as_own();

/// Does the work; what it throws comes out as an exception of the library.
template <class Work>
auto translated(const Work& work) {
    try {
        return work();
    } catch (...) {
        rethrow_as_own();
    }
}

}  // namespace steplab::library
