// A lesson that is open: its page, and the buttons that do the page's part and turn the pages.

#include "core/terms.hpp"
#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/steering.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace steplab::ui {
namespace {

constexpr ImGuiWindowFlags lesson_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                           ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

void paragraph(std::string_view text, ImU32 ink = colour::text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ink);
    ImGui::TextUnformatted(in_words(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopStyleColor();
}

/// A heading and what stands under it; nothing if that is empty.
void draw_part(const Context& context, std::string_view name, std::string_view text) {
    if (text.empty()) return;
    heading(context, name);
    paragraph(text);
}

/// The words that the page uses; the pointer over one shows what it means.
void draw_terms(const Context& context, const LessonPage& page) {
    if (page.terms.empty()) return;
    heading(context, "WORDS");
    const WithFont font(context.theme.fonts().small);
    const float right = ImGui::GetContentRegionMax().x, gap = context.px(12);
    for (const std::string& id : page.terms) {
        const float width = ImGui::CalcTextSize(id.c_str()).x;
        if (&id != &page.terms.front() && ImGui::GetItemRectMax().x - ImGui::GetWindowPos().x + gap + width <= right)
            ImGui::SameLine(0, gap);
        paragraph(id, colour::accent_hover);
        context.mark("lesson.term/" + id);
        const ImVec2 from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
        ImGui::GetWindowDrawList()->AddLine({from.x, to.y}, to, colour::accent);
        tooltip(context, find_term(id)->text);
    }
}

void draw_head(const Context& context, const Lesson& lesson, const LessonPage& page) {
    LessonsState& lessons = context.state.lessons;
    {
        const WithFont font(context.theme.fonts().strong);
        ImGui::PushTextWrapPos(ImGui::GetContentRegionMax().x - context.px(20));
        ImGui::TextUnformatted(lesson.title.c_str());
        ImGui::PopTextWrapPos();
    }
    const WithFont font(context.theme.fonts().small);
    paragraph(fmt::format("{} / {}   {}", lessons.page + 1, lesson.pages.size(), page.title), colour::text_dim);
    ImGui::Dummy({0, context.px(2)});
}

void draw_page(const Context& context, const LessonPage& page) {
    paragraph(page.text);
    draw_part(context, "DO", page.act);
    draw_part(context, "WATCH", page.watch);
    draw_part(context, "WHAT IT SHOWS", page.shows);
    draw_terms(context, page);
}

/// As many of them as can be read where there is little room: the first ones say most.
void show_plots(const Context& context, const std::vector<std::string>& wanted) {
    constexpr float readable = 310;  // units of the layout, with the legend of several runs
    PlotsState& plots = context.state.plots;
    const auto room = static_cast<std::size_t>(std::max(1.0f, context.layout.plots.width / context.px(readable)));
    const std::vector<PlotChoice> before = plots.shown;
    if (!wanted.empty()) plots.shown.clear();
    for (const std::string& id : wanted) {
        const auto info =
            std::find_if(plot_kinds.begin(), plot_kinds.end(), [&](const auto& each) { return each.id == id; });
        if (info != plot_kinds.end() && plots.shown.size() < room) plots.shown.push_back(default_choice(info->kind));
    }
    plots.window.reset();
    context.state.lessons.plots.put(before, plots.shown);
}

void set_speed(const Context& context, double speed) {
    Wanted& wanted = context.state.wanted;
    const Rate rate{false, speed};
    context.state.lessons.rate.put(wanted.rate(), rate);
    wanted.set_rate(rate, context.events);
}

void do_page(const Context& context, const Lesson& lesson, const LessonPage& page) {
    show_plots(context, page.plots);
    if (page.speed) set_speed(context, *page.speed);
    context.state.wanted.dismiss();
    context.events.play_part({lesson.session, page.from, page.to});
    context.state.lessons.begun = context.state.lessons.page;
}

void end_lesson(const Context& context) {
    close_lesson(context);
    open_scenes_page(context, true);
}

/// At the bottom, whatever the length of the page.
void draw_buttons(const Context& context, const Lesson& lesson) {
    LessonsState& lessons = context.state.lessons;
    const LessonPage& page = lesson.pages[lessons.page];
    const float room = ImGui::GetContentRegionAvail().x, gap = context.px(6), width = std::round((room - 2 * gap) / 3);
    const bool last = lessons.page + 1 == lesson.pages.size(), begun = lessons.begun == lessons.page;
    const bool first = lessons.page == 0;
    if (first ? text_button(context, "lesson.list", "Lessons", false, width)
              : text_button(context, "lesson.back", "Back", false, width)) {
        first ? open_scenes_page(context, true) : void(--lessons.page);
        return;
    }
    ImGui::SameLine(0, gap);
    if (!page.has_part()) {
        ImGui::Dummy({width, ImGui::GetFrameHeight()});
    } else if (text_button(context, "lesson.do", begun ? "Do it again" : "Do it", !begun, width)) {
        do_page(context, lesson, page);
    }
    if (page.has_part()) tooltip(context, "play this in the window; undo (Ctrl+Z) leads back to what was there before");
    ImGui::SameLine(0, gap);
    if (text_button(context, last ? "lesson.end" : "lesson.next", last ? "Lessons" : "Next", begun, width))
        last ? end_lesson(context) : void(++lessons.page);
}

}  // namespace

void draw_lesson_panel(const Context& context) {
    LessonsState& lessons = context.state.lessons;
    const Area& area = context.layout.lesson;
    if (area.empty() || !lessons.open) return;
    const Lesson& lesson = *lessons.open;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(14), context.px(12)});
    ImGui::Begin("lesson", nullptr, lesson_window);
    const bool closed = close_cross(context, "lesson.close");
    draw_head(context, lesson, lesson.pages[lessons.page]);
    const float foot = ImGui::GetFrameHeight() + context.px(10);
    ImGui::BeginChild(fmt::format("page {}", lessons.page).c_str(), {0, ImGui::GetContentRegionAvail().y - foot});
    scroll_by_keys(context, "lesson", true);
    draw_page(context, lesson.pages[lessons.page]);
    ImGui::EndChild();
    ImGui::Dummy({0, context.px(2)});
    draw_buttons(context, lesson);
    ImGui::GetWindowDrawList()->AddLine({area.x, area.y}, {area.x, area.bottom()}, colour::line);
    context.mark("lesson", {area.x, area.y, area.right(), area.bottom()});
    ImGui::End();
    ImGui::PopStyleVar();
    if (closed) close_lesson(context);
}

}  // namespace steplab::ui
