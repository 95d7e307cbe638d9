#include "render/imgui_renderer.hpp"

#include <glm/glm.hpp>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

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

PictureSize size_of(const ImDrawData& data) {
    return {pixels(data.DisplaySize.x, data.FramebufferScale.x), pixels(data.DisplaySize.y, data.FramebufferScale.y)};
}

/// Where in an area of the picture a command draws.
std::optional<PictureArea> seen_of(const ImDrawCmd& command, const ImDrawData& data, const PictureArea& area) {
    const auto [x_scale, y_scale] = data.FramebufferScale;
    const int left = pixels(command.ClipRect.x - data.DisplayPos.x, x_scale);
    const int top = pixels(command.ClipRect.y - data.DisplayPos.y, y_scale);
    const int right = pixels(command.ClipRect.z - data.DisplayPos.x, x_scale);
    const int bottom = pixels(command.ClipRect.w - data.DisplayPos.y, y_scale);
    return shared_part(area, {left, top, {right - left, bottom - top}});
}

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
    const PictureArea all{0, 0, size_of(data)};
    draw(data, std::span(&all, 1));
}

void ImguiRenderer::draw(const ImDrawData& data, std::span<const PictureArea> areas) const {
    if (data.DisplaySize.x <= 0 || data.DisplaySize.y <= 0) return;
    set_up(data);
    for (int i = 0; i < data.CmdListsCount; ++i) draw_list(*data.CmdLists[i], data, areas);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
}

void ImguiRenderer::set_up(const ImDrawData& data) const {
    const PictureSize size = size_of(data);
    glViewport(0, 0, size.width, size.height);
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

void ImguiRenderer::draw_list(const ImDrawList& list, const ImDrawData& data,
                              std::span<const PictureArea> areas) const {
    const bool seen = std::any_of(list.CmdBuffer.begin(), list.CmdBuffer.end(), [&](const ImDrawCmd& command) {
        return command.UserCallback || std::any_of(areas.begin(), areas.end(), [&](const PictureArea& area) {
                   return seen_of(command, data, area).has_value();
               });
    });
    if (!seen) return;
    upload(vertices_, GL_ARRAY_BUFFER, items(list.VtxBuffer));
    upload(indices_, GL_ELEMENT_ARRAY_BUFFER, items(list.IdxBuffer));
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback == ImDrawCallback_ResetRenderState) {
            set_up(data);
        } else if (command.UserCallback) {
            command.UserCallback(&list, &command);
        } else {
            for (const PictureArea& area : areas) {
                if (const auto part = seen_of(command, data, area)) draw_command(command, *part, size_of(data).height);
            }
        }
    }
}

void ImguiRenderer::draw_command(const ImDrawCmd& command, const PictureArea& seen, int height) {
    glScissor(seen.left, height - seen.top - seen.size.height, seen.size.width, seen.size.height);
    glBindTexture(GL_TEXTURE_2D, texture_name(command.GetTexID()));
    constexpr GLenum index_type = sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
    const void* first = byte_offset(command.IdxOffset * sizeof(ImDrawIdx));
    glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), index_type, first,
                             static_cast<GLint>(command.VtxOffset));
}

}  // namespace steplab::render
