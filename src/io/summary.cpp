#include "io/summary.hpp"

#include "core/duration.hpp"
#include "core/text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// dt as a float run prints it, 0.1 and not 0.10000000149: the shortest text that stands for the same float.
double shortest(Precision precision, double dt) {
    if (precision == Precision::double_) return dt;
    return parse_number(number_text(static_cast<float>(dt))).value_or(dt);
}

nlohmann::ordered_json collisions_json(const CollisionRecord& collisions) {
    nlohmann::ordered_json kept = nlohmann::ordered_json::array();
    for (const Collision& collision : collisions.kept())
        kept.push_back({{"time", collision.time}, {"particles", {collision.first, collision.second}}});
    return {{"count", collisions.count()}, {"first", kept}};
}

/// "6: particles 6 and 18 at t = 0.937855, 8 and 20 at 0.938226, ..."
std::string collisions_text(const CollisionRecord& collisions) {
    constexpr std::size_t most = 4;
    std::string text = fmt::format("{}", collisions.count());
    for (std::size_t i = 0; i < std::min(most, collisions.kept().size()); ++i) {
        const Collision& collision = collisions.kept()[i];
        text += fmt::format("{}{} and {} at {}{:.6g}", i == 0 ? ": particles " : ", ", collision.first,
                            collision.second, i == 0 ? "t = " : "", collision.time);
    }
    return text + (collisions.count() > most ? ", ..." : "");
}

}  // namespace

std::string summary_json(const RunSummary& summary) {
    nlohmann::ordered_json json{{"model", summary.model},
                                {"method", summary.method},
                                {"precision", id(summary.precision)},
                                {"dt", shortest(summary.precision, summary.dt)},
                                {"steps", summary.steps},
                                {"time", summary.time},
                                {"particles", summary.particles},
                                {"evaluations", summary.evaluations},
                                {"energy_start", summary.energy_start},
                                {"energy_end", summary.energy_end},
                                {"energy_error", summary.energy_error},
                                {"wall_seconds", summary.wall_seconds},
                                {"hash", summary.hash},
                                {"status", summary.diverged_step ? "diverged" : "ok"}};
    if (summary.diverged_step) json["diverged_step"] = *summary.diverged_step;
    if (summary.collisions.count() > 0) json["collisions"] = collisions_json(summary.collisions);
    return json.dump(2) + "\n";
}

std::string summary_text(const RunSummary& s) {
    const std::string dt = number_text(shortest(s.precision, s.dt));
    const std::string status = s.diverged_step ? fmt::format("diverged in step {}", *s.diverged_step) : "ok";
    std::string text = fmt::format("{} with {}, {}, dt {}\n", s.model, s.method, id(s.precision), dt);
    const auto line = [&text](std::string_view what, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", what, value);
    };
    line("particles", fmt::format("{}", s.particles));
    line("steps", fmt::format("{}", s.steps));
    line("time", number_text(s.time));
    line("evaluations", fmt::format("{}", s.evaluations));
    line("energy", fmt::format("{:.10g} at the start, {:.10g} at the end", s.energy_start, s.energy_end));
    line(s.drag ? "energy change" : "energy error",
         fmt::format("{:.3g} at most, over the steps looked at (--every)", s.energy_error));
    if (s.collisions.count() > 0) line("collisions", collisions_text(s.collisions));
    line("wall time", duration_text(s.wall_seconds));
    line("hash", s.hash);
    line("status", status);
    return text;
}

}  // namespace steplab
