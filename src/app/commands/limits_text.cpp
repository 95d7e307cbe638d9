#include "app/commands/limits_text.hpp"

#include "app/cli/text_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace steplab {

namespace {

using Json = nlohmann::ordered_json;

std::string step_text(const std::optional<double>& dt) {
    if (!dt) return "-";
    if (*dt == 0) return "unstable";
    return std::isinf(*dt) ? "no limit" : fmt::format("{:.6g}", *dt);
}

/// "0.0986: stable": the dt of the scene over the measured limit, or that of theory if none was measured.
std::string verdict(const Limit& limit, double dt) {
    const std::optional<double> bound = limit.measured ? limit.measured : limit.theory;
    if (!bound) return "-";
    if (*bound == 0) return "unstable";
    if (std::isinf(*bound)) return "stable";
    return fmt::format("{:.3g}: {}", dt / *bound, dt < *bound ? "stable" : "unstable");
}

Json step_json(const std::optional<double>& dt) { return dt && std::isfinite(*dt) ? Json(*dt) : Json(nullptr); }

}  // namespace

std::string limits_table(const std::vector<Limit>& limits, double dt) {
    std::vector<Row> rows{{"METHOD", "THEORY", "MEASURED", "RATIO", fmt::format("dt {:g} / LIMIT", dt), "NOTE"}};
    for (const Limit& limit : limits) {
        const auto ratio = limit.ratio();
        rows.push_back({limit.description.method, step_text(limit.theory), step_text(limit.measured),
                        ratio ? fmt::format("{:.5f}", *ratio) : "-", verdict(limit, dt), limit.note});
    }
    return aligned(rows, 0);
}

std::string limits_json(const std::vector<Limit>& limits) {
    Json list = Json::array();
    for (const Limit& limit : limits) {
        list.push_back({{"method", limit.description.method},
                        {"precision", id(limit.description.precision)},
                        {"omega_max", limit.omega_max},
                        {"theory", step_json(limit.theory)},
                        {"measured", step_json(limit.measured)},
                        {"note", limit.note}});
    }
    return list.dump(2) + "\n";
}

}  // namespace steplab
