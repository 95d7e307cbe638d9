#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/typed_moment.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/slider.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace steplab::ui {
namespace {

constexpr std::string_view time_line_help =
    "drag to go back and forth in time; what lies ahead is kept until something else is done\n"
    "click on the time to type one, or \"step 120\"";
constexpr std::string_view film_help =
    "a recorded session is played; the label says how much of its steps is done\n"
    "Space pauses it; what you do yourself ends it, and the run goes on from here";
constexpr std::string_view playback_help =
    "drag to go back and forth in the file\n"
    "click on the time to type one, or \"step 120\"";

/// Places on the track of the slider, in pixels.
class Track {
public:
    Track(const Context& context, const WidgetRect& slider, double end)
        : radius_(context.theme.scale() * 6.3f), slider_(slider), end_(end) {}

    float x(double time) const {
        const double part = !(end_ > 0 && time > 0) ? 0 : time < end_ ? time / end_ : 1;  // both may be infinite
        return slider_.left + radius_ + static_cast<float>(part) * (slider_.right - slider_.left - 2 * radius_);
    }
    float y() const { return 0.5f * (slider_.top + slider_.bottom); }
    const WidgetRect& area() const { return slider_; }

private:
    float radius_;
    WidgetRect slider_;
    double end_;
};

/// What was done: a tick below the track for each change, with what it was.
bool draw_changes(const Context& context, const Track& track) {
    bool pointed = false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    for (const Mark& change : context.session.line.changes) {
        const float x = track.x(change.time), from = track.y() + context.px(4), to = track.y() + context.px(9);
        list.AddLine({x, from}, {x, to}, colour::caution, context.px(2));
        const bool near = std::abs(pointer.x - x) < context.px(4) && pointer.y > from - context.px(2) &&
                          pointer.y < to + context.px(3);
        if (!near || context.is_saved()) continue;
        tooltip_beside(context, {x, from, x, to}, fmt::format("step {}: {}", change.step, change.text));
        pointed = true;
    }
    return pointed;
}

/// Marked moments: a diamond above the track; a click goes there.
bool draw_bookmarks(const Context& context, const Track& track) {
    bool pointed = false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float half = context.px(4), y = track.y() - context.px(8);
    std::size_t number = 0;
    for (const Mark& mark : context.session.line.bookmarks) {
        const float x = track.x(mark.time);
        const std::string widget = fmt::format("bookmark {}", number++);
        const WithId id(widget);
        ImGui::SetCursorScreenPos({x - half, y - half});
        if (ImGui::InvisibleButton("mark", {2 * half, 2 * half})) context.events.send(event::Seek{mark.step});
        context.mark(widget);
        tooltip(context, fmt::format("step {}{}{}", mark.step, mark.text.empty() ? "" : ": ", mark.text));
        list.AddQuadFilled({x, y - half}, {x + half, y}, {x, y + half}, {x - half, y},
                           ImGui::IsItemHovered() ? colour::bright : colour::accent);
        pointed = pointed || ImGui::IsItemHovered();
    }
    return pointed;
}

/// Ways that were left: lines below the track from where they leave it; a click takes one.
bool draw_branches(const Context& context, const Track& track) {
    bool pointed = false;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto& branches = context.session.line.branches;
    float y = track.y() + context.px(12);
    for (std::size_t i = branches.size(); i-- > 0 && y < track.area().bottom + context.px(8); y += context.px(4)) {
        const float from = track.x(branches[i].from), to = std::max(from + context.px(6), track.x(branches[i].to));
        const std::string widget = fmt::format("branch {}", i);
        const WithId id(widget);
        ImGui::SetCursorScreenPos({from, y - context.px(2)});
        if (ImGui::InvisibleButton("branch", {to - from, context.px(4)})) context.events.send(event::TakeBranch{i});
        context.mark(widget);
        tooltip(context, fmt::format("a way that was left at t = {} s, to t = {} s; click to go over to it",
                                     typed(branches[i].from, 4), typed(branches[i].to, 4)));
        const ImU32 ink = ImGui::IsItemHovered() ? colour::bright : colour::text_faint;
        list.AddLine({from, track.y() + context.px(3)}, {from, y}, ink, context.theme.scale());
        list.AddLine({from, y}, {to, y}, ink, context.px(2));
        pointed = pointed || ImGui::IsItemHovered();
    }
    return pointed;
}

/// The part that is repeated: a line above the track.
void draw_loop(const Context& context, const Track& track) {
    const auto& loop = context.session.line.loop;
    if (!loop) return;
    const float from = track.x(loop->from), to = track.x(loop->to), y = track.y() - context.px(12);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddLine({from, y}, {to, y}, colour::accent, context.px(2));
    for (const float x : {from, to}) list.AddLine({x, y}, {x, y + context.px(5)}, colour::accent, context.px(2));
}

/// Before the slider, as what is drawn first is what the pointer is over. True if it is over a mark.
bool draw_moments(const Context& context, double end, std::string_view end_text) {
    const RowPlaces places = row_places(context, end_text);
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x;
    const Track track(context, {left + places.control, cursor.y, left + places.value, cursor.y + row_height(context)},
                      end);
    draw_loop(context, track);
    const bool change = draw_changes(context, track), branch = draw_branches(context, track),
               bookmark = draw_bookmarks(context, track);
    ImGui::SetCursorScreenPos(cursor);
    return change || branch || bookmark;
}

/// Where ways that were left go on, there is room for their lines behind what was reached.
double end_of_track(const TimeLineView& line, double reached) {
    constexpr double most_room = 0.25;  // in what was reached
    double end = reached;
    for (const TimeLineView::Branch& branch : line.branches)
        end = std::max(end, std::min(branch.to, (1 + most_room) * reached));
    return end;
}

/// A drag takes the session along; it plays on where the button is released if it played before.
void seek(const Context& context, double time) {
    auto& resume = context.state.plays_after_scrubbing;
    if (!resume) resume = event::Play{context.state.wanted.playing(), context.session.line.backwards};
    if (context.state.wanted.playing()) context.state.wanted.play(false, context.events);
    context.events.send(event::SeekTime{time});
}

void end_scrubbing(const Context& context) {
    auto& resume = context.state.plays_after_scrubbing;
    if (!resume || ImGui::GetIO().MouseDown[0]) return;
    if (resume->on) context.state.wanted.play(true, context.events, resume->backwards);
    resume.reset();
}

}  // namespace

void draw_time_line(const Context& context) {
    const Area& area = context.layout.time_line;
    if (area.empty()) return;
    const StripWindow strip(context, "time line", area);
    const double now = context.view.frame.time, reached = std::max(now, context.session.line.reached_time);
    const double end = end_of_track(context.session.line, reached);
    const auto& film = context.session.film;
    const std::string label = film ? fmt::format("film {:.0f} %", std::floor(100 * film->done)) : "time line";
    const std::string end_text = with_unit(time_text(end, context.view.dt), "s");
    const bool over_mark = draw_moments(context, end, end_text);
    slider_row(context, {.widget = "time",
                         .label = label,
                         .tooltip = over_mark                  ? ""
                                    : film                     ? film_help
                                    : context.session.playback ? playback_help
                                                               : time_line_help,
                         .value_text = with_unit(time_text(now, context.view.dt), "s"),
                         .entry_text = typed(now),
                         .value = now,
                         .default_value = reached,
                         .range = {0, end, false, false},
                         .style = {},
                         .set = [&](double time) { seek(context, std::min(time, reached)); },
                         .set_text = [&](std::string_view typed) { context.events.send(typed_moment(typed)); },
                         .longest_text = end_text});
    end_scrubbing(context);
}

}  // namespace steplab::ui
