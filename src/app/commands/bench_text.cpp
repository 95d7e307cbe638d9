#include "app/commands/bench_text.hpp"

#include "app/cli/text_table.hpp"
#include "lab/report/readable_number.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

/// "12.3 ns", "4.56 ms": three significant digits.
std::string time_text(double seconds) {
    std::string_view unit = "s";
    double value = seconds;
    for (const std::string_view smaller : {"ms", "µs", "ns"}) {
        if (value >= 1) break;
        value *= 1000;
        unit = smaller;
    }
    return fmt::format("{:.3g} {}", value, unit);
}

std::string rate_text(double per_second) {
    if (per_second >= 1e6) return fmt::format("{:.3g} million", per_second / 1e6);
    if (per_second >= 1000) return fmt::format("{:.3g} thousand", per_second / 1e3);
    return fmt::format("{:.3g}", per_second);
}

std::string scenes_text(const std::vector<Speed>& scenes) {
    std::vector<Row> rows{
        {"SCENE", "PARTICLES", "PRECISION", "TIME PER STEP", "PER PARTICLE", "STEPS PER SECOND", "BOUND BY"}};
    for (const Speed& speed : scenes) {
        rows.push_back({speed.run.model, grouped(speed.particles), std::string(id(speed.run.precision)),
                        time_text(speed.seconds), time_text(speed.seconds / static_cast<double>(speed.particles)),
                        rate_text(1 / speed.seconds), std::string(text(speed.bound))});
    }
    return aligned(rows, 0);
}

std::string comparison_text(std::string_view by, const Comparison& comparison) {
    std::vector<Row> rows{{std::string(by), "TIME PER STEP", "SPEEDUP"}};
    for (const auto& [way, seconds] : comparison.seconds)
        rows.push_back({way, time_text(seconds), fmt::format("{:.2f}", comparison.seconds.front().second / seconds)});
    return fmt::format("{} of {} particles:\n{}", comparison.run.model, grouped(comparison.particles),
                       aligned(rows, 2));
}

Json json_of(const Comparison& comparison) {
    Json seconds = Json::object();
    for (const auto& [way, time] : comparison.seconds) seconds[way] = time;
    return {{"model", comparison.run.model}, {"particles", comparison.particles}, {"seconds_per_step", seconds}};
}

}  // namespace

std::string bench_text(const MachineSpeed& speed) {
    return fmt::format(
        "{} on one thread:\n\n{}\n"
        "latency: few particles, each step waits for the previous one; arithmetic: square roots, divisions,\n"
        "exponentials; memory: positions and velocities do not fit into the caches.\n\n{}\n{}",
        speed.scenes.front().run.method, scenes_text(speed.scenes),
        comparison_text("INSTRUCTION SET", speed.instructions), comparison_text("THREADS", speed.threads));
}

std::string bench_json(const MachineSpeed& speed) {
    Json scenes = Json::array();
    for (const Speed& scene : speed.scenes) {
        scenes.push_back({{"model", scene.run.model},
                          {"method", scene.run.method},
                          {"precision", id(scene.run.precision)},
                          {"particles", scene.particles},
                          {"seconds_per_step", scene.seconds},
                          {"bound", text(scene.bound)}});
    }
    const Json json{
        {"scenes", scenes}, {"instructions", json_of(speed.instructions)}, {"threads", json_of(speed.threads)}};
    return json.dump(2) + "\n";
}

}  // namespace steplab
