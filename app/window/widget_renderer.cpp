// SPDX-License-Identifier: MIT
#include "app/window/widget_renderer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "techniques/foundation/gl/baseline.h"
#include "techniques/foundation/gl/debug.h"

namespace shadowlab::window {

namespace {

// Marks around an opaque picture in a draw list, which WidgetRenderer::draw knows by their addresses.
void beginOpaque(const ImDrawList*, const ImDrawCmd*) { glDisable(GL_BLEND); }
void endOpaque(const ImDrawList*, const ImDrawCmd*) { glEnable(GL_BLEND); }

/// Where a picture stands that addOpaqueImage has put into a list, in pixels from the upper left corner, if its texels lie on
/// pixels one to one.
std::optional<Area> placeOfTexels(const ImDrawList& list, const ImDrawCmd& command, ivec2 texels) {
    const auto cornerOf = [&](unsigned int index) {
        const ImDrawIdx vertex = list.IdxBuffer[static_cast<int>(command.IdxOffset + index)];
        return list.VtxBuffer[static_cast<int>(command.VtxOffset + vertex)].pos;
    };
    const ImVec2 low = cornerOf(0), high = cornerOf(2); // AddImage: the upper left corner and, across, the lower right one
    const bool isOneToOne = low.x == std::floor(low.x) && low.y == std::floor(low.y) &&
                            high.x - low.x == static_cast<float>(texels.x) && high.y - low.y == static_cast<float>(texels.y);
    if (!isOneToOne) return std::nullopt;
    return Area{{static_cast<int>(low.x), static_cast<int>(low.y)}, texels};
}

} // namespace

void addOpaqueImage(ImDrawList& list, const gl::Texture2D& texture, ImVec2 low, ImVec2 high) {
    list.AddCallback(beginOpaque, nullptr);
    list.AddImage(imguiTexture(texture), low, high, {0, 1}, {1, 0});
    list.AddCallback(endOpaque, nullptr);
}

WidgetRenderer::WidgetRenderer()
    : program_("window/widgets.vert", "window/widgets.frag"), vertexArray_(gl::VertexArrayHandle::create()),
      vertices_(gl::BufferHandle::create()), indices_(gl::BufferHandle::create()), copied_(gl::FramebufferHandle::create()) {
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    const auto at = [](std::size_t offset) { return reinterpret_cast<const void*>(offset); };
    for (const GLuint attribute : {0u, 1u, 2u}) // those of shaders/window/widgets.vert
        glEnableVertexAttribArray(attribute);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, pos)));
    glVertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, uv)));
    glVertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ImDrawVert), at(offsetof(ImDrawVert, col)));
    glBindVertexArray(0);
    ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

void WidgetRenderer::uploadFonts() {
    unsigned char* texels = nullptr;
    ivec2 size(0);
    ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
    fonts.GetTexDataAsRGBA32(&texels, &size.x, &size.y);
    letters_ = gl::TextureHandle::create();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, letters_.id());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
    gl::label(GL_TEXTURE, letters_.id(), "letters");
    fonts.SetTexID(imguiTexture(letters_.id()));
    gl::check("fonts");
}

void WidgetRenderer::bindState(const ImDrawData& data, const gl::Framebuffer& target) const {
    gl::setBaselineState();
    target.bind();
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_SCISSOR_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    // The window itself stays opaque, whatever is drawn over it.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    program_.use();
    program_.set("windowPixels", vec2(data.DisplaySize.x, data.DisplaySize.y));
    program_.set("picture", 0);
    glActiveTexture(GL_TEXTURE0);
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
}

bool WidgetRenderer::copyTexels(const ImDrawList& list, const ImDrawCmd& command, const Area& clip,
                                const gl::Framebuffer& target) const {
    const GLuint texture = nameOf(command.GetTexID());
    ivec2 size(0);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &size.x);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &size.y);
    const std::optional<Area> place = placeOfTexels(list, command, size);
    if (!place) return false;
    const ivec2 low = glm::max(clip.corner, place->corner);
    const ivec2 high = glm::min(glm::min(clip.corner + clip.size, place->corner + size), target.size());
    if (low.x >= high.x || low.y >= high.y) return true;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, copied_.id());
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glDisable(GL_SCISSOR_TEST); // where it is on, llvmpipe draws the copy
    const ivec2 from = low - place->corner, to = high - place->corner;
    const int height = target.size().y; // GL counts rows from below
    glBlitFramebuffer(from.x, size.y - to.y, to.x, size.y - from.y, low.x, height - high.y, high.x, height - low.y,
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glEnable(GL_SCISSOR_TEST);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0); // it would keep the texture
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.id());
    return true;
}

void WidgetRenderer::draw(const ImDrawData& data, const gl::Framebuffer& target) const {
    const gl::DebugGroup group("widgets");
    bindState(data, target);
    const auto height = static_cast<GLint>(data.DisplaySize.y);
    for (int l = 0; l < data.CmdListsCount; ++l) {
        const ImDrawList& list = *data.CmdLists[l];
        glBufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
        bool isOpaque = false;
        for (const ImDrawCmd& command : list.CmdBuffer) {
            if (command.UserCallback) {
                isOpaque = command.UserCallback == beginOpaque;
                if (command.UserCallback == ImDrawCallback_ResetRenderState)
                    bindState(data, target);
                else
                    command.UserCallback(&list, &command);
                continue;
            }
            const ImVec4& clip = command.ClipRect; // left, top, right, bottom; GL counts rows from below
            const auto left = static_cast<GLint>(clip.x), top = static_cast<GLint>(clip.y),
                       right = static_cast<GLint>(clip.z), bottom = static_cast<GLint>(clip.w);
            if (right <= left || bottom <= top) continue;
            if (isOpaque && copyTexels(list, command, {{left, top}, {right - left, bottom - top}}, target)) continue;
            glScissor(left, height - bottom, right - left, bottom - top);
            glBindTexture(GL_TEXTURE_2D, nameOf(command.GetTexID()));
            const std::uintptr_t first = command.IdxOffset * sizeof(ImDrawIdx);
            glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                     sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                     reinterpret_cast<const void*>(first), static_cast<GLint>(command.VtxOffset));
        }
    }
    glBindVertexArray(0);
    gl::check("widgets");
}

} // namespace shadowlab::window
