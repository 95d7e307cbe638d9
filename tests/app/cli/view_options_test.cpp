#include "app/cli/view_options.hpp"

#include "core/error.hpp"

#include <CLI/CLI.hpp>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace steplab {
namespace {

/// What a window opens with, by these words of the command line, where a person chose something else before.
ui::ViewChoices opened_with(const std::vector<std::string>& words) {
    CLI::App app;
    ViewOptions options;
    options.declare(app);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    const std::vector<RunDescription> runs{describe("chain")};
    WindowRequest request = options.request(runs);
    ui::ViewChoices before;
    before.plots = {{ui::PlotKind::speeds}};
    options.put_remembered(before, runs.front(), request);
    EXPECT_EQ(request.remembered.plots, before.plots) << "what is asked for once is not remembered";
    EXPECT_EQ(request.remembered.picture, before.picture);
    return request.choices;
}

TEST(ViewOptions, take_plots_and_captions_as_pictures_do) {
    const ui::ViewChoices chosen =
        opened_with({"--plots", "phase-portrait,position-error", "--caption", "how it began"});
    ASSERT_EQ(chosen.plots.size(), 2u);
    EXPECT_EQ(chosen.plots[0], (ui::PlotChoice{ui::PlotKind::phase}));
    EXPECT_EQ(chosen.plots[1], (ui::PlotChoice{ui::PlotKind::error, plot::Scale::logarithmic}));
    EXPECT_TRUE(chosen.picture.caption);
    EXPECT_EQ(chosen.picture.caption_text, "how it began");
    EXPECT_EQ(opened_with({"--caption"}).picture.caption_text, "");
    EXPECT_TRUE(opened_with({"--caption"}).picture.caption);
}

TEST(ViewOptions, leave_what_was_chosen_before) {
    const ui::ViewChoices chosen = opened_with({});
    EXPECT_EQ(chosen.plots, std::vector<ui::PlotChoice>{{ui::PlotKind::speeds}});
    EXPECT_FALSE(chosen.picture.caption);
}

TEST(ViewOptions, take_a_trail) {
    EXPECT_TRUE(opened_with({"--trail", "on"}).trail);
    EXPECT_FALSE(opened_with({"--trail", "off"}).trail);
    EXPECT_FALSE(opened_with({}).trail);
    EXPECT_THROW(opened_with({"--trail", "long"}), UsageError);
}

TEST(ViewOptions, refuse_unknown_plots_and_take_any_number_of_others) {
    EXPECT_THROW(opened_with({"--plots", "energie-error"}), UsageError);
    EXPECT_THROW(opened_with({"--plots", "speeds,speeds"}), UsageError);
    EXPECT_NO_THROW(opened_with({"--plots", "energy-error,energies,displacement,velocity,momentum"}));
}

}  // namespace
}  // namespace steplab
