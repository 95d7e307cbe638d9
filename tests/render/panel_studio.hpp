#pragma once

#include "render/imgui_renderer.hpp"
#include "render/studio.hpp"

#include <imgui.h>

#include <functional>
#include <string>

namespace steplab::test {

using Paint = std::function<void(ImDrawList&)>;

inline constexpr render::PictureSize panel_picture{200, 100};

/// Draw data of panels in a picture of that size, with an ImGui context of its own for each test.
class PanelStudio : public Studio {
public:
    PanelStudio() : context_(ImGui::CreateContext()) {
        ImGui::GetIO().IniFilename = nullptr;
        renderer_.upload_fonts(*ImGui::GetIO().Fonts);
    }
    ~PanelStudio() override { ImGui::DestroyContext(context_); }

protected:
    static const ImDrawData& data_of(const Paint& paint) {
        ImGui::GetIO().DisplaySize = {static_cast<float>(panel_picture.width),
                                      static_cast<float>(panel_picture.height)};
        ImGui::NewFrame();
        paint(*ImGui::GetBackgroundDrawList());
        ImGui::Render();
        return *ImGui::GetDrawData();
    }
    const render::ImguiRenderer& renderer() const { return renderer_; }

private:
    ImGuiContext* context_;
    render::ImguiRenderer renderer_;
};

/// A panel with a text on it.
inline Paint panel(const std::string& text, float left = 10, ImU32 ink = IM_COL32_WHITE) {
    return [=](ImDrawList& list) {
        list.AddRectFilled({left, 10}, {left + 150, 90}, IM_COL32(40, 40, 40, 255), 4);
        list.AddText({left + 5, 20}, ink, text.c_str());
        list.AddRectFilled({left + 20, 50}, {left + 60, 70}, IM_COL32(0, 0, 255, 128));
    };
}

}  // namespace steplab::test
