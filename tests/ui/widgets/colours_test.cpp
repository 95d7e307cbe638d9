#include "ui/widgets/colours.hpp"

#include "render/palette.hpp"
#include "support/contrast.hpp"
#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab::ui {
namespace {

using test::of_shapes;
using test::of_text;

double luminance(ImU32 colour) {
    const auto channel = [colour](int shift) { return static_cast<std::uint8_t>(colour >> shift); };
    return test::luminance(channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT), channel(IM_COL32_B_SHIFT));
}

double contrast(ImU32 a, ImU32 b) { return test::contrast(luminance(a), luminance(b)); }

class EveryTheme : public testing::TestWithParam<render::Background> {
protected:
    const Colours& c = colours_of(GetParam());
};

TEST_P(EveryTheme, text_is_readable_on_all_that_it_is_written_on) {
    for (const ImU32 ground : {c.panel, c.backdrop, c.card, c.window, c.popup, c.control, c.control_hover}) {
        for (const ImU32 ink : {c.text, c.text_dim, c.bright}) EXPECT_GE(contrast(ink, ground), of_text);
    }
    for (const ImU32 ground : {c.panel, c.card, c.window, c.popup}) {
        for (const ImU32 ink : {c.text_faint, c.good, c.caution, c.bad, c.accent_hover})
            EXPECT_GE(contrast(ink, ground), of_text);
    }
    EXPECT_GE(contrast(c.on_accent, c.accent), of_text);
    EXPECT_GE(contrast(c.on_accent, c.accent_hover), of_text);
}

TEST_P(EveryTheme, curves_sliders_and_buttons_stand_out) {
    for (const ImU32 ink : {c.accent, c.exact, c.good, c.caution, c.bad, c.knob})
        EXPECT_GE(contrast(ink, c.panel), of_shapes);
    for (const ImU32 ink : {c.accent, c.good, c.caution, c.bad, c.knob}) EXPECT_GE(contrast(ink, c.track), of_shapes);
}

ImU32 imgui_colour(render::Rgb colour) { return IM_COL32(colour.red, colour.green, colour.blue, 255); }

/// A colour of this opacity, or less of its own, over another one.
ImU32 over(ImU32 ground, ImU32 colour, double opacity = 1) {
    const ImVec4 a = ImGui::ColorConvertU32ToFloat4(ground), b = ImGui::ColorConvertU32ToFloat4(colour);
    const float part = b.w * static_cast<float>(opacity);
    return ImGui::ColorConvertFloat4ToU32(
        {std::lerp(a.x, b.x, part), std::lerp(a.y, b.y, part), std::lerp(a.z, b.z, part), 1});
}

// Numbers of the axes and of the scale of colours, names of runs: they have a rim or a ground of the background's
// colour, through which a little of what is behind is seen.
TEST_P(EveryTheme, text_over_the_scene_is_readable_whatever_is_behind_it) {
    const render::Palette& scene = render::palette(GetParam());
    std::vector<render::Rgb> behind{render::rgb(0xffffff), render::rgb(0x000000), scene.grid, scene.spring};
    behind.insert(behind.end(), scene.roles.begin(), scene.roles.end());
    for (const double height : {0.0, 0.5, 1.0}) {
        const ImU32 ground = imgui_colour(render::backdrop_at(scene, height));
        for (const render::Rgb thing : behind) {
            const ImU32 rim = over(imgui_colour(thing), ground, render::veil);
            EXPECT_GE(contrast(imgui_colour(scene.text), rim), of_text) << height;
        }
    }
    for (const render::Rgb letter : scene.axes)  // of the small cross, on which nothing else is drawn
        EXPECT_GE(contrast(imgui_colour(letter), imgui_colour(scene.bottom)), of_text);
}

// Readings, cards and messages let a little of the scene through.
TEST_P(EveryTheme, cards_over_the_scene_are_readable_whatever_is_behind_them) {
    for (const ImU32 behind : {IM_COL32_WHITE, IM_COL32_BLACK}) {
        for (const ImU32 card : {c.card, c.window, c.popup}) {
            const ImU32 ground = over(behind, card);
            for (const ImU32 ink : {c.text, c.text_dim}) EXPECT_GE(contrast(ink, ground), of_text);
            for (const ImU32 ink : {c.good, c.caution, c.bad}) EXPECT_GE(contrast(ink, ground), of_text);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Colours, EveryTheme, testing::Values(render::Background::dark, render::Background::light),
                         [](const auto& test) { return std::string(id(test.param)); });

/// Luminances of all that is drawn in one colour, with the colours of the glyphs.
std::vector<double> luminances(Desk& desk) {
    std::vector<double> found;
    const ImDrawData& data = desk.interface.draw_data();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer) found.push_back(luminance(vertex.col));
    }
    return found;
}

TEST(theme, light_is_light_everywhere_and_dark_is_back_again) {
    Desk desk(describe("chain"));
    for (int i = 0; i < 2; ++i) desk.frame();
    const std::vector<double> dark = luminances(desk);
    desk.style.background = render::Background::light;
    for (int i = 0; i < 2; ++i) desk.frame();
    const std::vector<double> light = luminances(desk);
    ASSERT_EQ(light.size(), dark.size()) << "the same things in other colours";
    // Grounds and texts change places. White text on the accent, and icons, are the few that stay.
    std::size_t same = 0;
    for (std::size_t i = 0; i < light.size(); ++i) same += light[i] == dark[i];
    EXPECT_LT(same, light.size() / 20);
    desk.style.background = render::Background::dark;
    for (int i = 0; i < 2; ++i) desk.frame();
    EXPECT_EQ(luminances(desk), dark);
}

TEST(theme, each_interface_has_its_own) {
    Desk dark(describe("chain")), light(describe("chain"));
    light.style.background = render::Background::light;
    light.frame();
    dark.frame();
    EXPECT_EQ(ImU32{colour::panel}, colours_of(render::Background::dark).panel);
    light.frame();
    EXPECT_EQ(ImU32{colour::panel}, colours_of(render::Background::light).panel);
}

}  // namespace
}  // namespace steplab::ui
