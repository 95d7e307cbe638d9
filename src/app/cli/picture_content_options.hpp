#pragma once

#include "ui/caption_text.hpp"
#include "ui/plot/choice.hpp"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// The options of what stands below a scene, the same for pictures and the window: --plots and --caption.
class PictureContentOptions {
public:
    /// The heading in the help, and what the options do there.
    struct Help {
        std::string group;
        std::string plots;
        std::string caption;
    };
    void declare(CLI::App& app, const Help& help);

    /// The plots that are named; none if none are. Throws UsageError for unknown ones and too many.
    std::optional<std::vector<ui::PlotKind>> plots() const;
    /// The caption that was asked for.
    std::optional<ui::Caption> caption() const;

private:
    std::string plots_;
    std::string caption_;
};

}  // namespace steplab
