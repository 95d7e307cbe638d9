#include "ui/widgets/parameter_rows.hpp"

#include "core/number_text.hpp"
#include "core/terms.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

namespace steplab::ui {
namespace {

using Set = std::function<void(const ParameterValues&)>;

bool is_switch(const ParameterInfo& info) {
    return info.kind == ParameterInfo::Kind::integer && info.minimum == 0 && info.maximum == 1;
}

/// Sets one value from a slider, whose range may have an end that the parameter excludes.
void set_value(const ParameterValues& values, const ParameterInfo& info, double value, const Set& set) {
    if (!info.minimum_included && value <= info.minimum) return;
    ParameterValues changed = values;
    changed.set(info.name, value);
    set(changed);
}

void slider_parameter(const Context& context, const std::string& widget, const ParameterValues& values,
                      const ParameterInfo& info, const Set& set) {
    const bool whole = info.kind == ParameterInfo::Kind::integer;
    const double value = values[info.name];
    const std::string help = with_explanations(parameter_help(info), info.name);
    slider_row(context,
               {
                   .widget = widget,
                   .label = info.name,
                   .tooltip = help,
                   .value_text =
                       with_unit(whole && value < 1e7 ? fmt::format("{:.0f}", value) : setting_text(value), info.unit),
                   .entry_text = format_value(info, value),
                   .value = value,
                   .default_value = info.default_value,
                   .range = {info.slider_low, info.slider_high, info.slider_logarithmic, whole},
                   .style = {},
                   .set = [&](double dragged) { set_value(values, info, dragged, set); },
                   .set_text = [&](std::string_view typed) { set_value(values, info, parse_value(info, typed), set); },
               });
}

void switch_parameter(const Context& context, const std::string& widget, const ParameterValues& values,
                      const ParameterInfo& info, const Set& set) {
    bool on = values[info.name] != 0;
    if (check_row(context, widget, info.name, on)) set_value(values, info, on ? 1 : 0, set);
    term_tooltip(context, parameter_help(info), info.name);
}

void choice_parameter(const Context& context, const std::string& widget, const ParameterValues& values,
                      const ParameterInfo& info, const Set& set) {
    const RowPlaces places = row_places(context);
    row_label(context, info.name, parameter_help(info));
    ImGui::SameLine(places.control);
    auto chosen = static_cast<std::size_t>(values[info.name]);
    if (segmented(context, widget, info.choices, chosen, places.right - places.control, row_height(context))) {
        set_value(values, info, static_cast<double>(chosen), set);
    }
}

}  // namespace

std::string parameter_help(const ParameterInfo& info) {
    return fmt::format(
        "{}\n{} · default {}\na change {}", info.what, range_text(info),
        with_unit(format_value(info, info.default_value), info.unit),
        info.on_change == OnChange::restarts ? "restarts the scene" : "takes effect at once; the run continues");
}

void parameter_rows(const Context& context, std::string_view owner, const ParameterValues& values, const Set& set) {
    for (const ParameterInfo& info : values.infos()) {
        const std::string widget = fmt::format("{}.{}", owner, info.name);
        if (info.kind == ParameterInfo::Kind::choice) {
            choice_parameter(context, widget, values, info, set);
        } else if (is_switch(info)) {
            switch_parameter(context, widget, values, info, set);
        } else {
            slider_parameter(context, widget, values, info, set);
        }
    }
}

}  // namespace steplab::ui
