#include "viewer/gl/imgui_session.h"

#include <backends/imgui_impl_opengl3.h>

#include <stdexcept>

namespace drench::viewer {

namespace {

// ImGui makes a new context current if there is none; this restores the previous one.
ImGuiContext* newContext() {
    ImGuiContext* const former = ImGui::GetCurrentContext();
    ImGuiContext* const context = ImGui::CreateContext();
    ImGui::SetCurrentContext(former);
    return context;
}

}  // namespace

ImGuiSession::ImGuiSession() : context_(newContext()) {
    const Use use(*this);
    // No settings file beside the program.
    ImGui::GetIO().IniFilename = nullptr;
    if (!ImGui_ImplOpenGL3_Init("#version 330 core")) {
        ImGui::DestroyContext(context_);
        throw std::runtime_error(
            "viewer: ImGui cannot load the OpenGL library; install libGL.so.1 (Debian: libgl1)");
    }
}

ImGuiSession::~ImGuiSession() {
    ImGuiContext* const current = ImGui::GetCurrentContext();
    ImGui::SetCurrentContext(context_);
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
    ImGui::SetCurrentContext(current == context_ ? nullptr : current);
}

}  // namespace drench::viewer
