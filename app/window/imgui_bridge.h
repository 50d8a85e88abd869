// Dear ImGui as Debian 12 has it (1.86), Debian 13 (1.90) and unstable (1.92): what is written differently in each.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>

namespace shadowlab::window {

/// The number under which ImGui knows a texture of GL, and back. It is a pointer up to 1.91 and a number since: a cast of C makes both.
inline ImTextureID imguiTexture(unsigned int name) { return (ImTextureID)(std::uintptr_t)name; }
inline unsigned int nameOf(ImTextureID texture) { return static_cast<unsigned int>((std::uintptr_t)texture); }

/// Down, or let go in this frame: where the mouse went until then was still a part of it. Since 1.87 the way of a quick hand and its
/// end come in one frame.
inline bool wasDown(ImGuiMouseButton button) { return ImGui::IsMouseDown(button) || ImGui::IsMouseReleased(button); }

/// Where window coordinates are not pixels. Up to 1.86 ImGui is told in every frame where the mouse is, and that is put right
/// after its NewFrame of GLFW; since then it is told when the mouse moves, and keeps it.
#if IMGUI_VERSION_NUM < 18700
inline void tellMouse(GLFWwindow*, double, double) {}
inline void scaleMouse(float pixelsPerPoint) {
    ImVec2& mouse = ImGui::GetIO().MousePos;
    constexpr float kNowhere = -1e30f; // what ImGui writes for a mouse that is outside is lower
    if (mouse.x > kNowhere) mouse = {mouse.x * pixelsPerPoint, mouse.y * pixelsPerPoint};
}
#else
inline void tellMouse(GLFWwindow* window, double xPixels, double yPixels) {
    ImGui_ImplGlfw_CursorPosCallback(window, xPixels, yPixels);
}
inline void scaleMouse(float) {}
#endif

} // namespace shadowlab::window
