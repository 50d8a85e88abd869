// Dear ImGui as Debian 12 has it (1.86), Debian 13 (1.90) and unstable (1.92): what is written differently in each.
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include <imgui.h>

#include <backends/imgui_impl_glfw.h>
#include <imgui_internal.h>

namespace shadowlab::window {

/// The number under which ImGui knows a texture of GL, and back. It is a pointer up to 1.91 and a number since; a C cast converts to both.
inline ImTextureID imguiTexture(unsigned int name) { return (ImTextureID)(std::uintptr_t)name; }
inline unsigned int nameOf(ImTextureID texture) { return static_cast<unsigned int>((std::uintptr_t)texture); }

/// Down, or released in this frame: the motion before the release still belongs to the drag. Since 1.87 a short drag and its end may
/// arrive in one frame.
inline bool wasDown(ImGuiMouseButton button) { return ImGui::IsMouseDown(button) || ImGui::IsMouseReleased(button); }

/// A drop-down list or a menu is open: keys are its own.
inline bool isPopupOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }
inline void closePopups() { ImGui::ClosePopupToLevel(0, true); }

/// The mouse in pixels, where these differ from window coordinates. Up to 1.86 ImGui's backend sets the position in every frame, and
/// it is scaled after the backend's NewFrame; since then the position is passed on when the mouse moves.
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
