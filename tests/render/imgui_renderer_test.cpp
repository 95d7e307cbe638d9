#include "render/imgui_renderer.hpp"

#include "render/studio.hpp"

#include <imgui.h>

namespace steplab::render {
namespace {

using test::Image;

/// An ImGui context of its own for each test.
class ImguiDrawing : public test::Studio {
public:
    ImguiDrawing() : context_(ImGui::CreateContext()) {
        ImGui::GetIO().IniFilename = nullptr;
        ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
        renderer_.upload_fonts(*ImGui::GetIO().Fonts);
    }
    ~ImguiDrawing() override { ImGui::DestroyContext(context_); }

protected:
    /// One frame of 100 x 50 units with what `paint` adds to the list of the background.
    template <class Paint>
    Image frame(const Paint& paint, float scale = 1) const {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {100, 50};
        io.DisplayFramebufferScale = {scale, scale};
        ImGui::NewFrame();
        paint(*ImGui::GetBackgroundDrawList());
        ImGui::Render();
        const RenderTarget target({static_cast<int>(100 * scale), static_cast<int>(50 * scale)});
        target.bind();
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        target.resolve();
        renderer_.draw(*ImGui::GetDrawData());
        return {target.size(), target.read()};
    }

private:
    ImGuiContext* context_;
    ImguiRenderer renderer_;
};

constexpr Rgb black{0, 0, 0};
constexpr Rgb red{255, 0, 0};
constexpr ImU32 red_ink = IM_COL32(255, 0, 0, 255);

TEST_F(ImguiDrawing, box_is_where_it_was_put) {
    const Image image = frame([](ImDrawList& list) { list.AddRectFilled({10, 5}, {20, 15}, red_ink); });
    EXPECT_EQ(image.at(15, 10), red);
    EXPECT_EQ(image.at(5, 10), black);
    EXPECT_EQ(image.at(15, 20), black);
    EXPECT_EQ(image.at(15, 40), black);  // not upside down
}

TEST_F(ImguiDrawing, dense_displays_get_more_pixels) {
    const Image image = frame([](ImDrawList& list) { list.AddRectFilled({10, 5}, {20, 15}, red_ink); }, 2);
    EXPECT_EQ(image.at(30, 20), red);
    EXPECT_EQ(image.at(10, 20), black);
}

TEST_F(ImguiDrawing, clip_rectangle_cuts) {
    const Image image = frame([](ImDrawList& list) {
        list.PushClipRect({10, 5}, {15, 15});
        list.AddRectFilled({0, 0}, {100, 50}, red_ink);
        list.PopClipRect();
    });
    EXPECT_EQ(image.at(12, 10), red);
    EXPECT_EQ(image.at(17, 10), black);
    EXPECT_EQ(image.at(12, 20), black);
}

TEST_F(ImguiDrawing, text_leaves_ink) {
    const Image image = frame([](ImDrawList& list) { list.AddText({10, 10}, red_ink, "steplab"); });
    int ink = 0;
    for (int x = 10; x < 60; ++x) {
        for (int y = 10; y < 24; ++y) ink += image.at(x, y).red > 128;
    }
    EXPECT_GT(ink, 50);
}

TEST_F(ImguiDrawing, half_transparent_colours_are_mixed) {
    const Image image = frame([](ImDrawList& list) {
        list.AddRectFilled({0, 0}, {100, 50}, IM_COL32(255, 255, 255, 128));
    });
    EXPECT_NEAR(image.at(50, 25).green, 128, 1);
}

TEST_F(ImguiDrawing, more_vertices_than_16_bits_count_are_drawn) {
    const Image image = frame([](ImDrawList& list) {
        for (int i = 0; i < 20000; ++i) list.AddRectFilled({0, 0}, {1, 1}, IM_COL32(0, 0, 0, 255));
        list.AddRectFilled({10, 5}, {20, 15}, red_ink);
    });
    EXPECT_EQ(image.at(15, 10), red);
}

}  // namespace
}  // namespace steplab::render
