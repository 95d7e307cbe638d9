#include "app/commands/bench_text.hpp"

#include "app/cli/text_table.hpp"
#include "core/duration.hpp"
#include "core/number_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string_view>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

std::string rate_text(double per_second) {
    if (per_second >= 1e6) return typed(per_second / 1e6, 3) + " million";
    if (per_second >= 1000) return typed(per_second / 1e3, 3) + " thousand";
    return typed(per_second, 3);
}

std::string scenes_text(const std::vector<Speed>& scenes) {
    std::vector<Row> rows{
        {"SCENE", "PARTICLES", "PRECISION", "TIME PER STEP", "PER PARTICLE", "STEPS PER SECOND", "BOUND BY"}};
    for (const Speed& speed : scenes) {
        rows.push_back({speed.run.model, grouped(speed.particles), std::string(id(speed.run.precision)),
                        duration_text(speed.seconds),
                        duration_text(speed.seconds / static_cast<double>(speed.particles)),
                        rate_text(1 / speed.seconds), std::string(text(speed.bound))});
    }
    return aligned(rows, 0);
}

std::string comparison_text(std::string_view by, const Comparison& comparison) {
    std::vector<Row> rows{{std::string(by), "TIME PER STEP", "SPEEDUP"}};
    for (const auto& [way, seconds] : comparison.seconds)
        rows.push_back(
            {way, duration_text(seconds), fmt::format("{:.2f}", comparison.seconds.front().second / seconds)});
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
