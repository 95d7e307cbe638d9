#include "ui/panels/method_text.hpp"

#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace steplab::ui {
namespace {

/// What a method is said to conserve ("momentum, angular momentum; bounded energy error") as single phrases.
std::vector<std::string> phrases(std::string_view conserves) {
    std::vector<std::string> found;
    while (!conserves.empty()) {
        const std::size_t end = std::min(conserves.find_first_of(",;"), conserves.size());
        found.emplace_back(conserves.substr(0, end));
        conserves.remove_prefix(std::min(conserves.size(), end + 2));
    }
    return found;
}

/// False for a sum that changes in the exact motion of the scene, too.
bool can_be_kept(std::string_view phrase, const Conservation& scene) {
    if (phrase == "momentum") return scene.momentum;
    if (phrase == "angular momentum") return scene.angular_momentum;
    return scene.energy || phrase.find("energy") == phrase.npos;
}

/// " · conserves angular momentum · bounded energy error · momentum changes in this scene (a fixed particle)"
std::string conservation_text(const MethodInfo& info, const Conservation& scene) {
    std::string kept, bounded, changing;
    const auto append = [](std::string& list, const std::string& phrase, const char* between = ", ") {
        list.append(list.empty() ? "" : between).append(phrase);
    };
    for (const std::string& phrase : phrases(info.conserves)) {
        const bool keeps = can_be_kept(phrase, scene);
        if (keeps) append(phrase.starts_with("bounded") ? bounded : kept, phrase);
        if (!keeps && phrase.ends_with("momentum")) append(changing, phrase, " and ");
    }
    std::string text;
    if (!kept.empty()) text.append(" · conserves ").append(kept);
    if (!bounded.empty()) text.append(" · ").append(bounded);
    const char* change = changing.find(" and ") == changing.npos ? "changes" : "change";
    if (!changing.empty()) text += fmt::format(" · {} {} in this scene ({})", changing, change, scene.cause);
    return text;
}

}  // namespace

std::string method_text(const MethodInfo& info, const ParameterValues& parameters, const SceneFacts& scene,
                        const Conservation& kept) {
    const int order = order_of(info, scene);
    const double evaluations = evaluations_per_step(info, parameters);
    std::string line =
        fmt::format("order {} · {} per step", order, counted(evaluations, "force evaluation", "force evaluations"));
    if (info.symplectic) line.append(" · symplectic");
    if (info.reversible) line.append(" · time-reversible");
    return line + conservation_text(info, kept);
}

}  // namespace steplab::ui
