#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {
namespace {

/// All models as items of a menu; `chosen` becomes the index of the shown one.
std::vector<ComboItem> model_items(std::string_view shown, std::size_t& chosen) {
    std::vector<ComboItem> items;
    for (const Model& entry : models()) {
        if (entry.info.id == shown) chosen = items.size();
        items.push_back({.id = entry.info.id, .name = entry.info.name, .tooltip = std::string(entry.info.what)});
    }
    return items;
}

}  // namespace

void draw_scene_panel(const Context& context) {
    const RunDescription description = context.description();
    heading(context, "SCENE");
    std::size_t chosen = 0;
    const auto items = model_items(description.model, chosen);
    if (combo(context, "model", items, chosen, ImGui::GetContentRegionAvail().x)) {
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
