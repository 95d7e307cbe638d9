// The lessons on the page of scenes: the picture of the scene, the title, what it teaches.

#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

// Of an entry, in units of the layout; pictures have the proportions of those of scenes.
constexpr float narrowest = 360, height = 78, small_width = 112, small_height = 70, between_entries = 14;

void open_lesson(const Context& context, const std::string& id) {
    LessonsState& lessons = context.state.lessons;
    if (!lessons.open || lessons.open->id != id)
        return context.request({.kind = Request::Kind::open_lesson, .text = id});
    context.state.scenes.open = false;
}

void draw_picture(const Context& context, const std::string& scene, ImVec2 corner, bool hovered) {
    const Gallery& gallery = context.state.scenes.gallery;
    const std::size_t place = place_in(gallery, scene);
    const ImVec2 to{corner.x + context.px(small_width), corner.y + context.px(small_height)};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, to, colour::backdrop, context.px(5));
    if (place < gallery.size() && gallery[place].picture != 0)
        list.AddImageRounded(texture_id(gallery[place].picture), corner, to, {0, 0}, {1, 1}, IM_COL32_WHITE,
                             context.px(5));
    list.AddRect(corner, to, hovered ? colour::accent_hover : colour::line, context.px(5), 0,
                 std::max(1.0f, context.px(hovered ? 2.0f : 1.0f)));
}

void draw_text(const Context& context, const LessonTitle& lesson, ImVec2 corner, float width, bool hovered) {
    const Fonts& fonts = context.theme.fonts();
    const ImVec4 clip{corner.x, corner.y, corner.x + width, corner.y + context.px(height)};
    const auto draw = [&](const ImFont* font, float down, ImU32 ink, const std::string& text) {
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, {corner.x, corner.y + down}, ink, text.data(),
                                            text.data() + text.size(), width, &clip);
    };
    draw(fonts.body, 0, hovered ? colour::bright : colour::text, lesson.title);
    draw(fonts.small, fonts.body->FontSize + context.px(4), colour::text_dim, lesson.teaches);
}

void draw_entry(const Context& context, const LessonTitle& lesson, float width) {
    const WithId id(lesson.id);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool clicked = ImGui::InvisibleButton("entry", {width, context.px(height)});
    if (ImGui::IsItemVisible()) context.mark("lesson/" + lesson.id);
    const bool hovered = ImGui::IsItemHovered();
    draw_picture(context, lesson.scene, corner, hovered);
    const float text = context.px(small_width + 12);
    draw_text(context, lesson, {corner.x + text, corner.y + context.px(2)}, width - text, hovered);
    if (clicked) open_lesson(context, lesson.id);
}

}  // namespace

void draw_lesson_list(const Context& context) {
    const float room = ImGui::GetContentRegionAvail().x, between = context.px(between_entries);
    const int columns = std::max(1, static_cast<int>((room + between) / (context.px(narrowest) + between)));
    const float width = std::floor((room - between * static_cast<float>(columns - 1)) / static_cast<float>(columns));
    int column = 0;
    for (const LessonTitle& lesson : context.state.lessons.titles) {
        if (column > 0) ImGui::SameLine(0, between);
        draw_entry(context, lesson, width);
        column = (column + 1) % columns;
    }
}

}  // namespace steplab::ui
