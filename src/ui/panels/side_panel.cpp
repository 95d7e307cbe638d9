#include "core/number_text.hpp"
#include "ui/panels/panels.hpp"
#include "ui/steering.hpp"
#include "ui/widgets/format.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace steplab::ui {
namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Three digits at most, as the others change with every frame: "42", "12300", "1.93e6".
std::string steady_rate(double rate) {
    const double last = std::pow(10, std::floor(std::log10(rate)) - 2);
    return frequency_text(std::round(rate / last) * last);
}

/// "12300 steps/s · 1.93e6 force evaluations/s · 4.1 ms per frame"; values that are not known are left out. Lines break
/// between them only: the blanks within are such that do not break.
std::string footer_text(const RunView& view, const Measured& measured) {
    std::string text;
    const auto add = [&](const std::string& value, const char* unit) {
        text.append(text.empty() ? "" : " · ").append(value).append("\u00a0").append(unit);
    };
    if (view.steps_per_second.value_or(0) > 0) add(steady_rate(*view.steps_per_second), "steps/s");
    if (view.evaluations_per_second.value_or(0) > 0)
        add(steady_rate(*view.evaluations_per_second), "force\u00a0evaluations/s");
    if (measured.frame_seconds) add(setting_text(1e3 * *measured.frame_seconds, 2), "ms\u00a0per\u00a0frame");
    return text;
}

/// Measured rates at the bottom of the side panel, in as many lines as they need.
class Footer {
public:
    explicit Footer(const Context& context)
        : context_(context),
          text_(context.is_saved() ? "" : footer_text(context.view, context.measured)),
          width_(context.layout.panel.width - 2 * context.px(14)) {
        const WithFont font(context.theme.fonts().tiny);
        text_ = in_lines(text_, width_);
        const bool changes = context.purpose != Purpose::still;
        height_ = std::max(height_of(text_), changes ? height_of(in_lines(longest_text, width_)) : 0);
    }

    /// With the margins; of one line if nothing is known, and will not be.
    float height() const { return std::max(height_, context_.theme.fonts().tiny->FontSize) + context_.px(15); }

    void draw() const {
        const Area& area = context_.layout.panel;
        const ImFont* font = context_.theme.fonts().tiny;
        const ImVec2 corner{area.x + context_.px(14), area.bottom() - height() + context_.px(6)};
        ImGui::GetWindowDrawList()->AddText(font, font->FontSize, corner, colour::text_faint, text_.c_str(), nullptr,
                                            width_);
        context_.mark("footer", {area.x, area.bottom() - height(), area.right(), area.bottom()});
    }

private:
    /// What is above stays where it is while rates come and go.
    static constexpr const char* longest_text =
        "888888\u00a0steps/s · 888888\u00a0force\u00a0evaluations/s · 888\u00a0ms\u00a0per\u00a0frame";

    float height_of(const std::string& text) const {
        return std::round(ImGui::CalcTextSize(text.c_str(), nullptr, false, width_).y);
    }

    const Context& context_;
    std::string text_;
    float width_;
    float height_ = 0;
};

}  // namespace

std::span<const Section> sections_of(const Context& context) {
    if (context.session.playback) return playback_sections;
    return sections;
}

void draw_side_panel(const Context& context) {
    const Area& area = context.layout.panel;
    if (area.empty()) return;
    ImGui::SetNextWindowPos({area.x, area.y});
    ImGui::SetNextWindowSize({area.width, area.height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin("side panel", nullptr, fixed_window);
    const Footer footer(context);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(14), context.px(6)});
    const bool all = context.layout.panel_tabs.empty();
    ImGui::PushID(all ? -1 : static_cast<int>(context.state.tab));  // each tab has a place of its own to be scrolled to
    ImGui::BeginChild("sections", {0, area.height - footer.height()}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding | ImGuiWindowFlags_NavFlattened);
    scroll_by_keys(context, "side panel", context.layout.lesson.empty());
    for (const Section& section : sections_of(context)) {
        if (all || section.tab == context.state.tab) section.draw(context);
    }
    ImGui::EndChild();
    ImGui::PopID();
    ImGui::PopStyleVar(2);
    footer.draw();
    ImGui::GetWindowDrawList()->AddLine({area.right() - 1, area.y}, {area.right() - 1, area.bottom()}, colour::line);
    ImGui::End();
}

}  // namespace steplab::ui
