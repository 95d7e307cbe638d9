#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace steplab::ui {
namespace {

ImVec2 text_size(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()); }

void draw_text(ImVec2 place, std::string_view text, ImU32 ink) {
    ImGui::GetWindowDrawList()->AddText(place, ink, text.data(), text.data() + text.size());
}

ImU32 control_colour() {
    if (ImGui::IsItemActive()) return colour::control_active;
    return ImGui::IsItemHovered() ? colour::control_hover : colour::control;
}

void draw_tick(ImVec2 from, float size, float thickness) {
    const ImVec2 points[] = {{from.x + 0.24f * size, from.y + 0.52f * size},
                             {from.x + 0.43f * size, from.y + 0.70f * size},
                             {from.x + 0.77f * size, from.y + 0.31f * size}};
    ImGui::GetWindowDrawList()->AddPolyline(points, 3, colour::on_accent, 0, thickness);
}

}  // namespace

ImTextureID texture_id(std::uint32_t name) {
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}

RowPlaces row_places(const Context& context, std::string_view value) {
    const float left = ImGui::GetStyle().WindowPadding.x;
    const float right = left + ImGui::GetContentRegionAvail().x;
    const float room = std::max(context.px(72), text_size(value).x + context.px(12));
    return {left + context.px(76), right - room, right};
}

float row_height(const Context& context) { return context.px(20); }

void text_right(float right, float y, std::string_view text, ImU32 ink) {
    const ImVec2 size = text_size(text);
    draw_text({right - size.x, std::round(y - 0.5f * size.y)}, text, ink);
}

void text_left(float left, float y, std::string_view text, ImU32 ink) {
    draw_text({left, std::round(y - 0.5f * text_size(text).y)}, text, ink);
}

void heading(const Context& context, std::string_view text) {
    ImGui::Dummy({0, context.px(4)});
    const WithFont font(context.theme.fonts().heading);
    ImGui::PushStyleColor(ImGuiCol_Text, colour::text_dim);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

std::string in_lines(const std::string& text, float width) {
    constexpr std::string_view separator = " · ";
    std::string lines, line;
    for (std::size_t from = 0, end = 0; end != std::string::npos; from = end + separator.size()) {
        end = text.find(separator, from);
        const std::string part = text.substr(from, end - from);
        std::string longer = line;
        if (!line.empty()) longer += separator;
        longer += part;
        const bool fits = line.empty() || ImGui::CalcTextSize(longer.c_str()).x <= width;
        if (!fits) lines.append(line).append("\n");
        line = fits ? longer : part;
    }
    return lines + line;
}

std::string in_words(std::string_view text, float width) {
    const auto width_of = [](std::string_view part) {
        return ImGui::CalcTextSize(part.data(), part.data() + part.size()).x;
    };
    std::string lines;
    float used = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", from), text.size());
        const std::string_view word = text.substr(from, end - from);
        const float wide = width_of(word), blank = used > 0 ? width_of(" ") : 0;
        const bool fits = used == 0 || used + blank + wide <= width;
        if (used > 0) lines += fits ? ' ' : '\n';
        lines += word;
        used = fits ? used + blank + wide : wide;
        if (end < text.size() && text[end] == '\n') {
            lines += '\n';
            used = 0;
        }
        from = end + 1;
    }
    return lines;
}

void draw_tab_name(const Context& context, std::string_view name, bool chosen) {
    const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    text_left(0.5f * (from.x + to.x - text_size(name).x), 0.5f * (from.y + to.y), name,
              chosen || ImGui::IsItemHovered() ? colour::text : colour::text_dim);
    if (chosen)
        ImGui::GetWindowDrawList()->AddRectFilled({from.x, to.y - context.px(3)}, {to.x, to.y}, colour::accent,
                                                  context.px(1));
}

std::string shortened(std::string_view text, float width) {
    if (text_size(text).x <= width) return std::string(text);
    const auto inside = [](char c) { return (static_cast<unsigned char>(c) & 0xc0) == 0x80; };  // of a character
    std::string shorter(text);
    std::string cut;
    do {
        while (!shorter.empty() && inside(shorter.back())) shorter.pop_back();
        if (!shorter.empty()) shorter.pop_back();
        cut = shorter.substr(0, shorter.find_last_not_of(" ,") + 1) + "…";
    } while (!shorter.empty() && text_size(cut).x > width);
    return cut;
}

namespace {

/// As explanation() breaks it into lines, at its separators where it has some.
std::string explained(std::string_view text) {
    const float width = ImGui::GetContentRegionAvail().x;
    return in_words(in_lines(std::string(text), width), width);
}

}  // namespace

void explanation(const Context& context, std::string_view text, ImU32 ink) {
    const WithFont font(context.theme.fonts().small);
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    ImGui::TextUnformatted(in_words(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
}

int lines_of_explanation(const Context& context, std::string_view text) {
    if (text.empty()) return 0;
    const WithFont font(context.theme.fonts().small);
    const std::string lines = explained(text);
    return 1 + static_cast<int>(std::count(lines.begin(), lines.end(), '\n'));
}

void changing_explanation(const Context& context, std::string_view text, int lines, ImU32 ink) {
    std::string padded;
    {
        const WithFont font(context.theme.fonts().small);
        padded = explained(text);
    }
    for (int missing = lines - lines_of_explanation(context, text); missing > 0; --missing)
        padded += padded.empty() ? "\u00a0" : "\n\u00a0";
    if (!padded.empty()) explanation(context, padded, ink);
}

ImFont* font_with_room(const Context& context, std::string_view text, float width) {
    const Fonts& fonts = context.theme.fonts();
    for (ImFont* const font : {fonts.body, fonts.small}) {
        if (font->CalcTextSizeA(font->FontSize, FLT_MAX, 0, text.data(), text.data() + text.size()).x <= width)
            return font;
    }
    return fonts.tiny;
}

void row_label(const Context& context, std::string_view label, std::string_view what, float height) {
    const float width = row_places(context).control - ImGui::GetStyle().WindowPadding.x - context.px(6);
    ImGui::Dummy({width, height > 0 ? height : row_height(context)});
    tooltip(context, what);
    const ImVec2 from = ImGui::GetItemRectMin();
    const WithFont font(font_with_room(context, label, width));
    text_left(from.x, 0.5f * (from.y + ImGui::GetItemRectMax().y), label, colour::text);
}

void reading_row(const Context& context, std::string_view label, std::string_view value, std::string_view what) {
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
    tooltip(context, what);
    const ImVec2 from = ImGui::GetItemRectMin();
    const float y = 0.5f * (from.y + ImGui::GetItemRectMax().y);
    text_left(from.x, y, label, colour::text_dim);
    text_right(from.x + width, y, value, colour::text);
}

bool check_row(const Context& context, std::string_view widget, std::string_view label, bool& on, bool mixed) {
    const WithId id(widget);
    const float box = context.px(14);
    const float gap = context.px(8);
    const float height = std::max(box, ImGui::GetTextLineHeight()) + context.px(2);
    const bool clicked = ImGui::InvisibleButton("box", {box + gap + text_size(label).x, height});
    context.mark(widget);
    if (clicked) on = mixed || !on;
    const ImVec2 from = ImGui::GetItemRectMin();
    const float y = 0.5f * (from.y + ImGui::GetItemRectMax().y);
    const ImVec2 corner{from.x, std::round(y - 0.5f * box)};
    const bool filled = on || mixed;
    const ImU32 fill = filled ? (ImGui::IsItemHovered() ? colour::accent_hover : colour::accent) : control_colour();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + box, corner.y + box}, fill, context.px(3));
    if (!filled) list.AddRect(corner, {corner.x + box, corner.y + box}, colour::track, context.px(3));
    const float thickness = context.theme.scale() * 1.8f;
    if (mixed)
        list.AddLine({corner.x + 0.25f * box, corner.y + 0.5f * box}, {corner.x + 0.75f * box, corner.y + 0.5f * box},
                     colour::on_accent, thickness);
    else if (on)
        draw_tick(corner, box, thickness);
    text_left(from.x + box + gap, y, label, colour::text);
    return clicked;
}

bool segmented(const Context& context, std::string_view widget, std::span<const std::string_view> choices,
               std::size_t& chosen, float width, float height, std::string_view help) {
    const WithId id(widget);
    const float part = std::max(1.0f, width / static_cast<float>(choices.size()));
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, {corner.x + width, corner.y + height}, colour::control, ImGui::GetStyle().FrameRounding);
    bool changed = false;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        const WithId item(choices[i]);
        if (i > 0) ImGui::SameLine(0, 0);
        if (ImGui::InvisibleButton("choice", {part, height}) && chosen != i) {
            chosen = i;
            changed = true;
        }
        context.mark(std::string(widget) + "/" + std::string(choices[i]));
        if (!help.empty()) term_tooltip(context, help, choices[i]);
        const ImVec2 from = ImGui::GetItemRectMin();
        const ImVec2 to = ImGui::GetItemRectMax();
        if (i == chosen) list.AddRectFilled(from, to, colour::accent, ImGui::GetStyle().FrameRounding);
        const WithFont font(i == chosen ? context.theme.fonts().strong : context.theme.fonts().body);
        const ImU32 ink = i == chosen ? colour::on_accent : ImGui::IsItemHovered() ? colour::text : colour::text_dim;
        text_left(0.5f * (from.x + to.x - text_size(choices[i]).x), 0.5f * (from.y + to.y), choices[i], ink);
    }
    return changed;
}

StripWindow::StripWindow(const Context& context, const char* name, const Area& area) {
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    const float above = std::max(0.0f, std::floor(0.5f * (area.height - ImGui::GetFrameHeight())));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(14), above});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
}

StripWindow::~StripWindow() {
    ImGui::End();
    ImGui::PopStyleVar();
}

bool cross_button(const Context& context, std::string_view widget) {
    const float side = context.px(18);
    const WithId id(widget);
    const bool clicked = ImGui::InvisibleButton("close", {side, side});
    context.mark(widget);
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 centre{from.x + 0.5f * side, from.y + 0.5f * side};
    const float reach = 0.25f * side;
    const ImU32 ink = ImGui::IsItemHovered() ? colour::text : colour::text_faint;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float thickness = context.theme.scale() * 1.6f;
    list.AddLine({centre.x - reach, centre.y - reach}, {centre.x + reach, centre.y + reach}, ink, thickness);
    list.AddLine({centre.x - reach, centre.y + reach}, {centre.x + reach, centre.y - reach}, ink, thickness);
    return clicked;
}

bool text_button(const Context& context, std::string_view widget, std::string_view text, bool accent, float width) {
    const WithId id(widget);
    const ImVec2 inside = text_size(text);
    const ImVec2 size{width > 0 ? width : inside.x + 2 * context.px(12), ImGui::GetFrameHeight()};
    const bool clicked = ImGui::InvisibleButton("button", size);
    context.mark(widget);
    const ImU32 fill = accent ? (ImGui::IsItemHovered() ? colour::accent_hover : colour::accent) : control_colour();
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    ImGui::GetWindowDrawList()->AddRectFilled(from, to, fill, ImGui::GetStyle().FrameRounding);
    text_left(0.5f * (from.x + to.x - inside.x), 0.5f * (from.y + to.y), text,
              accent ? colour::on_accent : colour::text);
    return clicked;
}

}  // namespace steplab::ui
