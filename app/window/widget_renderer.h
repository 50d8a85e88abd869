// Draws what Dear ImGui has laid out, through the project's own GL layer: the same bytes on every context, OSMesa among
// them, whose functions the packaged GL backend cannot find.
// SPDX-License-Identifier: MIT
#pragma once
#include "app/window/imgui_bridge.h"
#include "app/window/pane_frames.h"
#include "techniques/foundation/gl/framebuffer.h"
#include "techniques/foundation/gl/program.h"

namespace shadowlab::window {

/// The number under which ImGui knows a texture of ours.
inline ImTextureID imguiTexture(const gl::Texture2D& texture) { return imguiTexture(texture.id()); }

/// A place in pixels, as ImGui takes it.
inline ImVec2 imVec(ivec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

/// Draws a picture without blending. Where its texels lie on pixels one to one it is copied: a software renderer copies a picture in
/// a fifth of the time in which it draws one.
void addOpaqueImage(ImDrawList& list, const gl::Texture2D& texture, ImVec2 low, ImVec2 high);

class WidgetRenderer {
public:
    /// Needs a current GL context and a current ImGui context, for their whole life.
    WidgetRenderer();

    /// Puts the letters of all fonts into a texture; call again when fonts have changed.
    void uploadFonts();

    /// Draws into `target`, which is as large as the draw data's display: one unit of ImGui is one pixel.
    void draw(const ImDrawData& data, const gl::Framebuffer& target) const;

private:
    void bindState(const ImDrawData& data, const gl::Framebuffer& target) const;
    /// Copies the picture of an opaque image within `clip`, in pixels from the upper left corner. False where it has to be drawn: its
    /// texels are larger or smaller than pixels, or lie between them.
    bool copyTexels(const ImDrawList& list, const ImDrawCmd& command, const Area& clip, const gl::Framebuffer& target) const;
    gl::Program program_;
    gl::VertexArrayHandle vertexArray_;
    gl::BufferHandle vertices_, indices_;
    gl::TextureHandle letters_;
    gl::FramebufferHandle copied_; ///< a picture is attached to it while it is copied
};

} // namespace shadowlab::window
