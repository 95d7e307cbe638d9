#include "ui/widgets/slider.hpp"

#include "core/error.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// Track, filled part, mark and knob of a slider in the rectangle of the last item.
void draw_slider(const Context& context, double part, const SliderStyle& style, std::optional<double> mark) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    const float radius = context.theme.scale() * (ImGui::IsItemActive() ? 7.0f : 6.3f);
    const float y = 0.5f * (from.y + to.y);
    const float half = context.theme.scale() * 2.2f;
    const auto place = [&](double p) { return from.x + radius + static_cast<float>(p) * (to.x - from.x - 2 * radius); };
    const float x = place(part);
    list.AddRectFilled({from.x, y - half}, {to.x, y + half}, colour::track, half);
    list.AddRectFilled({from.x, y - half}, {x, y + half}, style.fill, half);
    if (mark) {
        const float reach = context.px(8);
        list.AddLine({place(*mark), y - reach}, {place(*mark), y + reach}, colour::bad, context.px(2));
    }
    list.AddCircleFilled({x, y}, radius, ImGui::IsItemHovered() ? colour::bright : colour::knob);
}

double part_under_pointer(const Context& context) {
    const float radius = context.theme.scale() * 6.3f;
    const float from = ImGui::GetItemRectMin().x + radius;
    const float to = ImGui::GetItemRectMax().x - radius;
    if (!(to > from)) return 0;
    return std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / (to - from)), 0.0, 1.0);
}

void open_entry(const Context& context, const SliderRow& row) {
    Entry entry{.widget = std::string(row.widget), .just_opened = true};
    const std::size_t length = std::min(row.entry_text.size(), entry.text.size() - 1);
    std::copy_n(row.entry_text.begin(), length, entry.text.begin());
    context.state.entry = entry;
}

/// The text entry that replaces slider and value while a number is typed.
void draw_entry(const Context& context, const SliderRow& row, float width) {
    Entry& entry = *context.state.entry;
    if (entry.just_opened) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(width);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {context.px(6), 0.5f * (row_height(context) - ImGui::GetFontSize())});
    const bool entered = ImGui::InputText("##entry", entry.text.data(), entry.text.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleVar();
    if (ImGui::IsItemActive()) context.mark(std::string(row.widget) + ".entry");
    const bool left = ImGui::IsItemDeactivated();
    entry.just_opened = false;
    if (!entered && !left) return;
    const std::string text = entry.text.data();
    context.state.entry.reset();
    if (!entered) return;
    try {
        row.set_text(text);
    } catch (const UsageError& error) {
        context.state.wanted.refuse(error.what());
    }
}

/// The value at the right end of the row; a click on it opens the text entry.
void draw_value(const Context& context, const SliderRow& row, float width) {
    const float height = row_height(context);
    if (ImGui::InvisibleButton("value", {std::max(1.0f, width), height})) open_entry(context, row);
    context.mark(std::string(row.widget) + ".value");
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
    tooltip(context, row.tooltip);
    const ImU32 ink = ImGui::IsItemHovered() ? colour::bright : colour::text;
    const WithFont font(font_with_room(context, row.value_text, width - context.px(10)));  // off the slider
    text_right(ImGui::GetItemRectMax().x, ImGui::GetItemRectMin().y + 0.5f * height, row.value_text, ink);
}

}  // namespace

double SliderRange::part(double value) const {
    if (!(high > low) || !(value > low)) return 0;  // not a number: the lower end
    if (!(value < high)) return 1;
    if (logarithmic) return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
    return part_between(low, high, value);
}

double SliderRange::value(double part) const {
    if (!(high > low)) return low;
    const double exact =
        logarithmic ? std::exp(std::lerp(std::log(low), std::log(high), part)) : std::lerp(low, high, part);
    const double rounded = whole ? std::round(exact) : rounded_for_slider(exact, low, high, logarithmic);
    return std::clamp(rounded, low, high);
}

std::optional<double> slider(const Context& context, std::string_view widget, double value, const SliderRange& range,
                             const SliderStyle& style, float width, float height) {
    ImGui::InvisibleButton("slider", {std::max(1.0f, width), height});
    context.mark(widget);
    const bool mark_shown = style.mark && *style.mark >= range.low && *style.mark <= range.high;
    draw_slider(context, range.part(value), style, mark_shown ? std::optional(range.part(*style.mark)) : std::nullopt);
    // The press of a double click or a Ctrl + click is not a drag: the value changes on a plain press, or when the
    // pointer moves.
    if (context.state.steering || !ImGui::IsItemActive() || ImGui::GetIO().KeyCtrl ||
        ImGui::GetIO().MouseDoubleClicked[0])
        return std::nullopt;
    const bool moved = ImGui::GetIO().MouseDelta.x != 0;
    if (!ImGui::IsItemActivated() && !moved) return std::nullopt;
    const double wanted = range.value(part_under_pointer(context));
    return wanted == value ? std::nullopt : std::optional(wanted);
}

void slider_row(const Context& context, const SliderRow& row) {
    const WithId id(row.widget);
    const RowPlaces places = row_places(context, row.longest_text);
    row_label(context, row.label, row.tooltip);
    ImGui::SameLine(places.control);
    if (context.state.entry && context.state.entry->widget == row.widget) {
        draw_entry(context, row, places.right - places.control);
        return;
    }
    const auto dragged = slider(context, row.widget, row.value, row.range, row.style, places.value - places.control,
                                row_height(context));
    tooltip(context, row.tooltip);
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && ImGui::GetIO().MouseDoubleClicked[0]) {
        row.set(row.default_value);
    } else if (hovered && (ImGui::GetIO().KeyCtrl || context.state.steering) && ImGui::IsItemActivated()) {
        open_entry(context, row);
    } else if (dragged) {
        row.set(*dragged);
    }
    ImGui::SameLine(places.value);
    draw_value(context, row, places.right - places.value);
}

}  // namespace steplab::ui
