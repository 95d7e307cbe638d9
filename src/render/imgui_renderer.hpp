#pragma once

#include "render/picture_texture.hpp"
#include "render/shader_program.hpp"
#include "render/split.hpp"

#include <span>

struct ImDrawCmd;
struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace steplab::render {

/// Draws the draw data of Dear ImGui into the bound framebuffer, in a window and off-screen. (The backend of the
/// library opens libGL itself and so cannot draw off-screen.) A texture id of ImGui is the OpenGL name of a texture.
class ImguiRenderer {
public:
    ImguiRenderer();

    /// Uploads the glyphs and sets the TexID of the atlas. To be called whenever the atlas was built.
    void upload_fonts(ImFontAtlas& fonts);
    /// Draws over a picture with its top left corner at data.DisplayPos, of data.DisplaySize units with
    /// data.FramebufferScale pixels each. Supports vertex offsets: set ImGuiBackendFlags_RendererHasVtxOffset.
    void draw(const ImDrawData& data) const;
    /// The same in parts of the picture alone, which share no pixel.
    void draw(const ImDrawData& data, std::span<const PictureArea> areas) const;

private:
    void set_up(const ImDrawData& data) const;
    void draw_list(const ImDrawList& list, const ImDrawData& data, std::span<const PictureArea> areas) const;
    static void draw_command(const ImDrawCmd& command, const PictureArea& seen, int height);

    ShaderProgram program_;
    VertexArray vertex_array_;
    Buffer vertices_, indices_;
    PictureTexture font_texture_;
};

}  // namespace steplab::render
