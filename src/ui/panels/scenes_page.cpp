#include "sim/run/run_description.hpp"
#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/steering.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace steplab::ui {
namespace {

// Of a tile, in units of the layout; pictures have the same proportions.
constexpr float picture_width = 176, picture_height = 110, name_height = 36, gap = 16;

constexpr ImGuiWindowFlags page_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                         ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                         ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string in_capitals(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// In front of the background: the picture, or an empty field until it is there.
void draw_picture(const Context& context, const Exhibit& exhibit, const WidgetRect& place, ImU32 edge) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 from{place.left, place.top}, to{place.right, place.bottom};
    const float round = context.px(6);
    list.AddRectFilled(from, to, colour::backdrop, round);
    if (exhibit.picture != 0)
        list.AddImageRounded(texture_id(exhibit.picture), from, to, {0, 0}, {1, 1}, IM_COL32_WHITE, round);
    list.AddRect(from, to, edge, round, 0, std::max(1.0f, context.px(edge == colour::line ? 1.0f : 2.0f)));
}

/// The name in up to two lines below the picture.
void draw_name(const Context& context, const Exhibit& exhibit, ImVec2 corner, float width, ImU32 ink) {
    const ImFont* font = context.theme.fonts().body;
    const ImVec4 clip{corner.x, corner.y, corner.x + width, corner.y + context.px(name_height)};
    ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {corner.x + context.px(2), corner.y + context.px(5)}, ink,
                                        exhibit.name.data(), exhibit.name.data() + exhibit.name.size(),
                                        width - context.px(4), &clip);
}

void draw_tile(const Context& context, const Exhibit& exhibit) {
    const WithId id(exhibit.id);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = context.px(picture_width), height = context.px(picture_height);
    const bool clicked = ImGui::InvisibleButton("tile", {width, height + context.px(name_height)});
    if (ImGui::IsItemVisible()) context.mark("model/" + exhibit.id);
    const bool hovered = ImGui::IsItemHovered(), shown = exhibit.id == id_of(context.description());
    const WidgetRect picture{corner.x, corner.y, corner.x + width, corner.y + height};
    tooltip_beside(context, {corner.x, corner.y, corner.x + width, corner.y + height + context.px(name_height)},
                   exhibit.what);
    const ImU32 edge = hovered ? ImU32{colour::accent_hover} : shown ? ImU32{colour::accent} : ImU32{colour::line};
    draw_picture(context, exhibit, picture, edge);
    draw_name(context, exhibit, {picture.left, picture.bottom}, width,
              hovered ? ImU32{colour::bright} : ImU32{colour::text});
    if (clicked) open_exhibit(context, exhibit);
}

/// All tiles, a heading above each topic.
void draw_tiles(const Context& context, const Gallery& gallery) {
    const float step = context.px(picture_width) + context.px(gap);
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>((room + context.px(gap)) / step));
    const float left = ImGui::GetCursorPosX();
    int column = 0;
    for (std::size_t i = 0; i < gallery.size(); ++i) {
        if (i == 0 || gallery[i].topic != gallery[i - 1].topic) {
            column = 0;
            heading(context, in_capitals(gallery[i].topic.empty() ? "more" : gallery[i].topic));
        }
        if (column > 0) ImGui::SameLine();
        ImGui::SetCursorPosX(left + static_cast<float>(column) * step);
        draw_tile(context, gallery[i]);
        column = (column + 1) % columns;
    }
}

/// The path of a file, typed or pasted.
void draw_path(const Context& context, ScenesPage& page) {
    const float button = ImGui::CalcTextSize("Open").x + 2 * context.px(12);
    const float width = std::min(context.px(520), ImGui::GetContentRegionAvail().x - button - context.px(8));
    if (std::exchange(page.to_type, false)) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(width);
    const bool entered =
        ImGui::InputTextWithHint("##path", "path of a scene, session or trajectory file", page.path.data(),
                                 page.path.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    context.mark("scenes.path");
    ImGui::SameLine(0, context.px(8));
    const bool clicked = text_button(context, "scenes.open", "Open", true);
    const std::string path = page.path.data();
    if ((entered || clicked) && !path.empty()) open_file(context, path);
}

/// The page has two sheets: the scenes, and the lessons.
void draw_sheets(const Context& context, ScenesPage& page) {
    static constexpr std::array<std::string_view, 2> sheets{"scenes", "lessons"};
    std::size_t chosen = page.lessons ? 1 : 0;
    if (segmented(context, "sheet", sheets, chosen, context.px(180), ImGui::GetFrameHeight()))
        page.lessons = chosen == 1;
    ImGui::Dummy({0, context.px(4)});
}

void draw_title(const Context& context, const char* title, std::string_view text) {
    {
        const WithFont font(context.theme.fonts().strong);
        ImGui::TextUnformatted(title);
    }
    explanation(context, text);
    ImGui::Dummy({0, context.px(2)});
}

void draw_scenes(const Context& context, ScenesPage& page) {
    draw_title(context, "Choose a scene",
               "Click a picture, type the path of a scene, session or trajectory file, or drop one onto this window.");
    draw_path(context, page);
    draw_tiles(context, page.gallery);
}

void draw_lessons(const Context& context) {
    draw_title(context, "Try",
               "Guided experiments: each takes a few minutes, and every number in them is measured in the window.");
    draw_lesson_list(context);
}

}  // namespace

void draw_scenes_page(const Context& context) {
    ScenesPage& page = context.state.scenes;
    const float top = context.layout.bar.bottom();
    ImGui::SetNextWindowPos({0, top});
    ImGui::SetNextWindowSize(
        {static_cast<float>(context.display.width), static_cast<float>(context.display.height) - top});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(28), context.px(20)});
    ImGui::Begin("scenes", nullptr, page_window);
    scroll_by_keys(context, "scenes", true);
    ImGui::PopStyleVar();
    if (close_cross(context, "scenes.close")) page.open = false;
    draw_sheets(context, page);
    page.lessons ? draw_lessons(context) : draw_scenes(context, page);
    ImGui::Dummy({0, context.px(12)});
    ImGui::End();
}

}  // namespace steplab::ui
