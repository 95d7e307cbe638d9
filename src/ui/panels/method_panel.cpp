#include "sim/catalogue.hpp"
#include "ui/panels/method_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

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

/// All methods as items of a menu, group after group; `chosen` becomes the index of the shown one.
std::vector<ComboItem> method_items(std::string_view shown, std::size_t& chosen) {
    std::vector<ComboItem> items;
    for (const std::string_view group : groups) {
        for (const Method& entry : methods()) {
            if (group_of(entry.info) != group) continue;
            if (entry.info.id == shown) chosen = items.size();
            items.push_back({.id = entry.info.id,
                             .name = entry.info.name,
                             .remark = fmt::format("order {}", entry.info.order),
                             .tooltip = std::string(entry.info.what),
                             .group = group});
        }
    }
    return items;
}

}  // namespace

void draw_method_panel(const Context& context) {
    const RunDescription description = context.description();
    heading(context, "METHOD");
    std::size_t chosen = 0;
    const auto items = method_items(description.method, chosen);
    if (combo(context, "method", items, chosen, ImGui::GetContentRegionAvail().x)) {
        context.ask(with_method(description, items[chosen].id));
    }
    const MethodInfo& info = method(description.method).info;
    explanation(context, method_text(info, description, context.view.conservation));
    tooltip(context, fmt::format("{}\n{}", info.what, info.source));
    parameter_rows(context, "method", description.method_parameters, [&](const ParameterValues& values) {
        RunDescription changed = description;
        changed.method_parameters = values;
        context.ask(changed);
    });
}

}  // namespace steplab::ui
