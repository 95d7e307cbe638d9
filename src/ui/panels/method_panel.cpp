#include "sim/catalogue.hpp"
#include "ui/panels/method_items.hpp"
#include "ui/panels/method_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/parameter_rows.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace steplab::ui {
void draw_method_panel(const Context& context) {
    const RunDescription description = context.description();
    heading(context, "METHOD");
    const auto items = method_items(context.view);
    const auto shown =
        std::find_if(items.begin(), items.end(), [&](const ComboItem& item) { return item.id == description.method; });
    auto chosen = static_cast<std::size_t>(shown - items.begin());
    if (combo(context, "method", items, chosen, ImGui::GetContentRegionAvail().x)) {
        context.ask(with_method(description, items[chosen].id));
    }
    const MethodInfo& info = method(description.method).info;
    const std::string text =
        method_text(info, description.method_parameters, context.view.facts, context.view.conservation);
    explanation(context, text);
    term_tooltip(context, fmt::format("{}\n{}", info.what, info.source), text);
    parameter_rows(context, "method", description.method_parameters, [&](const ParameterValues& values) {
        RunDescription changed = description;
        changed.method_parameters = values;
        context.ask(changed);
    });
}

}  // namespace steplab::ui
