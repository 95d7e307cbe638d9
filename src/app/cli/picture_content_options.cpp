#include "app/cli/picture_content_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace steplab {
namespace {

constexpr const char* automatic_caption = "auto";

/// "energy-error,phase-portrait".
std::vector<ui::PlotKind> parse_plots(std::string_view text) {
    std::array<std::string, ui::plot_kinds.size()> words;
    std::array<std::string_view, ui::plot_kinds.size()> known;
    for (std::size_t i = 0; i < words.size(); ++i) known[i] = words[i] = ui::plot_word(ui::plot_kinds[i]);
    std::vector<ui::PlotKind> kinds;
    for (std::size_t from = 0, end = 0; end < text.size(); from = end + 1) {
        end = std::min(text.find(',', from), text.size());
        const std::string_view word = text.substr(from, end - from);
        const auto found = std::find(known.begin(), known.end(), word);
        if (found == known.end()) throw UsageError(unknown_word("plot (--plots)", word, known));
        const ui::PlotKind kind = ui::plot_kinds[static_cast<std::size_t>(found - known.begin())].kind;
        if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end())
            throw UsageError(fmt::format("--plots: {} is named twice", word));
        kinds.push_back(kind);
    }
    return kinds;
}

}  // namespace

void PictureContentOptions::declare(CLI::App& app, const Help& help) {
    text_option(app, "--plots", plots_, "KIND,...",
                help.plots + ": energy-error, phase-portrait ... (default energy-error,displacement)", help.group);
    optional_text_option(app, "--caption", caption_, "[TEXT]", automatic_caption,
                         help.caption + " (default auto: scene, method, dt and time of each run)", help.group);
}

std::optional<std::vector<ui::PlotKind>> PictureContentOptions::plots() const {
    return plots_.empty() ? std::nullopt : std::optional(parse_plots(plots_));
}

std::optional<ui::Caption> PictureContentOptions::caption() const {
    if (caption_.empty()) return std::nullopt;
    return ui::Caption{caption_ == automatic_caption ? "" : caption_};
}

}  // namespace steplab
