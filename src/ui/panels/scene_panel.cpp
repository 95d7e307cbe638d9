#include "sim/run/run_description.hpp"
#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {

void draw_scene_panel(const Context& context) {
    const RunDescription description = context.description();
    const ModelInfo& info = model_of(description).info;
    heading(context, "SCENE");
    const std::string_view name = info.name.empty() ? std::string_view(description.model) : info.name;
    if (choice_box(context, "model", name, ImGui::GetContentRegionAvail().x)) open_scenes_page(context);
    tooltip(context, "choose another scene, or open a file");
    explanation(context, info.what);
    if (context.session.playback) return;  // they are those of the run that wrote the file
    parameter_rows(context, "scene", description.scene, [&](const ParameterValues& values) {
        RunDescription changed = description;
        changed.scene = values;
        context.ask(changed);
    });
}

}  // namespace steplab::ui
