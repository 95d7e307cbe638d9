#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

/// All models as items of a menu, behind a scene of a file; `chosen` becomes the index of the shown one.
std::vector<ComboItem> model_items(const RunDescription& shown, std::size_t& chosen) {
    std::vector<ComboItem> items;
    if (shown.origin) {
        const ModelInfo& file = model_of(shown).info;
        items.push_back({.id = shown.model,
                         .name = file.name.empty() ? std::string_view(shown.model) : file.name,
                         .tooltip = std::string(file.what)});
    }
    for (const Model& entry : models()) {
        if (!shown.origin && entry.info.id == shown.model) chosen = items.size();
        items.push_back({.id = entry.info.id, .name = entry.info.name, .tooltip = std::string(entry.info.what)});
    }
    return items;
}

}  // namespace

void draw_scene_panel(const Context& context) {
    const RunDescription description = context.description();
    heading(context, "SCENE");
    std::size_t chosen = 0;
    const auto items = model_items(description, chosen);
    const bool asked = combo(context, "model", items, chosen, ImGui::GetContentRegionAvail().x);
    if (asked && !(description.origin && chosen == 0)) {
        context.ask(opening(with_model(description, items[chosen].id)));
    }
    explanation(context, model_of(description).info.what);
    parameter_rows(context, "scene", description.scene, [&](const ParameterValues& values) {
        RunDescription changed = description;
        changed.scene = values;
        context.ask(changed);
    });
}

}  // namespace steplab::ui
