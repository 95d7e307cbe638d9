#include "render/imgui_renderer.hpp"

#include <glm/glm.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steplab::render {
namespace {

GLuint texture_name(ImTextureID id) { return static_cast<GLuint>(reinterpret_cast<std::intptr_t>(id)); }
ImTextureID texture_id(GLuint name) {
    const auto number = static_cast<std::intptr_t>(name);
    return reinterpret_cast<ImTextureID>(number);  // NOLINT(performance-no-int-to-ptr): ImGui wants it so
}

template <class T>
std::span<const T> items(const ImVector<T>& vector) {
    return {vector.Data, static_cast<std::size_t>(vector.Size)};
}

int pixels(float units, float scale) { return static_cast<int>(std::lround(units * scale)); }

}  // namespace

ImguiRenderer::ImguiRenderer() : program_("imgui") {
    glBindVertexArray(vertex_array_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    float_attribute(0, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, pos));
    float_attribute(1, 2, sizeof(ImDrawVert), offsetof(ImDrawVert, uv));
    colour_attribute(2, sizeof(ImDrawVert), offsetof(ImDrawVert, col));
}

void ImguiRenderer::upload_fonts(ImFontAtlas& fonts) {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
    font_texture_.upload({width, height},
                         {pixels, 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)});
    fonts.SetTexID(texture_id(font_texture_.name()));
}

void ImguiRenderer::draw(const ImDrawData& data) const {
    if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
    set_up(data);
    for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

void ImguiRenderer::set_up(const ImDrawData& data) const {
    glViewport(0, 0, pixels(data.DisplaySize.x, data.FramebufferScale.x),
               pixels(data.DisplaySize.y, data.FramebufferScale.y));
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    program_.use();
    program_.set("u_texture", 0);
    program_.set("u_origin", glm::vec2(data.DisplayPos.x, data.DisplayPos.y));
    program_.set("u_size", glm::vec2(data.DisplaySize.x, data.DisplaySize.y));
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(vertex_array_.id());
}

void ImguiRenderer::draw_list(const ImDrawList& list, const ImDrawData& data) const {
    upload(vertices_, GL_ARRAY_BUFFER, items(list.VtxBuffer));
    upload(indices_, GL_ELEMENT_ARRAY_BUFFER, items(list.IdxBuffer));
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback == ImDrawCallback_ResetRenderState) {
            set_up(data);
        } else if (command.UserCallback) {
            command.UserCallback(&list, &command);
        } else {
            draw_command(command, data);
        }
    }
}

void ImguiRenderer::draw_command(const ImDrawCmd& command, const ImDrawData& data) const {
    const ImVec2 scale = data.FramebufferScale;
    const int width = pixels(data.DisplaySize.x, scale.x);
    const int height = pixels(data.DisplaySize.y, scale.y);
    const int left = std::max(0, pixels(command.ClipRect.x - data.DisplayPos.x, scale.x));
    const int top = std::max(0, pixels(command.ClipRect.y - data.DisplayPos.y, scale.y));
    const int right = std::min(width, pixels(command.ClipRect.z - data.DisplayPos.x, scale.x));
    const int bottom = std::min(height, pixels(command.ClipRect.w - data.DisplayPos.y, scale.y));
    if (right <= left || bottom <= top) return;
    glScissor(left, height - bottom, right - left, bottom - top);
    glBindTexture(GL_TEXTURE_2D, texture_name(command.GetTexID()));
    constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    const void* first = byte_offset(command.IdxOffset * sizeof(ImDrawIdx));
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type, first,
                             static_cast<GLint>(command.VtxOffset));
}

}  // namespace steplab::render
