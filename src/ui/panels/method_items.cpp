#include "ui/panels/method_items.hpp"

#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace steplab::ui {
namespace {

// In the order of the menu.
constexpr std::string_view groups[] = {"explicit, fixed step", "symplectic, explicit", "adaptive step size", "implicit",
                                       "as printed in 2008"};

/// The group of a method in the menu, by what its entry says of it.
std::string_view group_of(const MethodInfo& info) {
    if (info.curiosity) return groups[4];
    if (info.implicit) return groups[3];
    if (info.adaptive) return groups[2];
    return info.symplectic ? groups[1] : groups[0];
}

}  // namespace

std::vector<ComboItem> method_items(const RunView& view) {
    const auto refusal = [&](const MethodInfo& info) {
        if (!view.refusals) return std::string();
        const auto refused = view.refusals->find(info.id);
        return refused == view.refusals->end() ? std::string() : refused->second;
    };
    std::vector<ComboItem> items;
    for (const std::string_view group : groups) {
        for (const Method& entry : methods()) {
            if (group_of(entry.info) != group) continue;
            items.push_back({.id = entry.info.id,
                             .name = entry.info.name,
                             .remark = fmt::format("order {}", entry.info.order),
                             .tooltip = std::string(entry.info.what),
                             .group = group,
                             .refusal = refusal(entry.info)});
        }
    }
    return items;
}

}  // namespace steplab::ui
