#pragma once

#include "render/shader_program.hpp"

struct ImDrawCmd;
struct ImDrawData;
struct ImDrawList;
struct ImFontAtlas;

namespace steplab::render {

/// Draws what Dear ImGui made, into the framebuffer that is bound, the same everywhere. (The library's own backend
/// opens libGL by itself and so cannot draw off-screen.) A texture id of ImGui is the OpenGL name of a texture.
class ImguiRenderer {
public:
    ImguiRenderer();

    /// Takes the glyphs; to be called once the atlas is built and whenever it was built anew. Sets the atlas' TexID.
    void upload_fonts(ImFontAtlas& fonts);
    /// Over a picture whose top left corner is data.DisplayPos, of data.DisplaySize units with data.FramebufferScale
    /// pixels each. Lists with an offset of their vertices are drawn too: set ImGuiBackendFlags_RendererHasVtxOffset.
    void draw(const ImDrawData& data) const;

private:
    void set_up(const ImDrawData& data) const;
    void draw_list(const ImDrawList& list, const ImDrawData& data) const;
    void draw_command(const ImDrawCmd& command, const ImDrawData& data) const;

    ShaderProgram program_;
    VertexArray vertex_array_;
    Buffer vertices_, indices_;
    Texture font_texture_;
};

}  // namespace steplab::render
