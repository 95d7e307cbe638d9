#include "ui/caption.hpp"

#include "session/run_name.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/run_marks.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace steplab::ui {
namespace {

// Lengths in units of the layout.
constexpr float line_height = 22;
constexpr float margin = 8;
constexpr float side = 14;
constexpr float mark_width = 26;

void append_text(std::vector<CaptionLine>& lines, std::string_view text) {
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back({std::string(text.substr(from, end - from))});
        from = end + 1;
    }
}

std::string run_text(const RunView& run, const RunView& leading) {
    return run_name(run.description, leading.description) + (run.divergence ? ", diverged" : "");
}

void draw_line(const Context& context, const CaptionLine& line, ImVec2 middle, float room) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (line.swatch) {
        const float width = context.px(mark_width);
        draw_run_line(list, middle, width, *line.swatch, run_ink(context.stage.style.background, *line.swatch),
                      context.px(2));
        middle.x += width + context.px(8);
        room -= width + context.px(8);
    }
    ImFont* const font = context.theme.fonts().body;
    const float size = font->FontSize;
    const float width = font->CalcTextSizeA(size, FLT_MAX, 0, line.text.c_str()).x;
    const float drawn = width > room ? size * room / width : size;
    list.AddText(font, drawn, {middle.x, std::round(middle.y - 0.5f * drawn)}, colour::text, line.text.c_str());
}

}  // namespace

std::vector<CaptionLine> caption_lines(const Caption& caption, const SessionView& session) {
    std::vector<CaptionLine> lines;
    if (!caption.text.empty()) {
        append_text(lines, caption.text);
        return lines;
    }
    const RunView& leading = session.leading;
    const auto scene = model_of(leading.description).info.name;
    const std::string time = fmt::format("t = {} s", time_text(leading.frame.time, leading.dt));
    if (session.followers.empty()) {
        lines.push_back({fmt::format("{}, {}, {}", scene, run_text(leading, leading), time)});
        return lines;
    }
    lines.push_back({fmt::format("{}, {}", scene, time)});
    lines.push_back({run_text(leading, leading), leading.swatch});
    for (const RunView& run : session.followers) lines.push_back({run_text(run, leading), run.swatch});
    return lines;
}

float caption_height(const Theme& theme, const Caption& caption, const SessionView& session) {
    const auto lines = static_cast<float>(caption_lines(caption, session).size());
    return theme.px(2 * margin) + lines * theme.px(line_height);
}

void draw_caption(const Context& context, const Caption& caption, const Area& strip) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::SetNextWindowPos({strip.x, strip.y});
    ImGui::SetNextWindowSize({strip.width, strip.height});
    ImGui::Begin("caption", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs);
    context.mark("caption", {strip.x, strip.y, strip.right(), strip.bottom()});
    ImGui::GetWindowDrawList()->AddLine({strip.x, strip.y}, {strip.right(), strip.y}, colour::line);
    ImVec2 middle{strip.x + context.px(side), strip.y + context.px(margin) + 0.5f * context.px(line_height)};
    for (const CaptionLine& line : caption_lines(caption, context.session)) {
        draw_line(context, line, middle, strip.width - 2 * context.px(side));
        middle.y += context.px(line_height);
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace steplab::ui
