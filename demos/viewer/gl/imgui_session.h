// An ImGui context that draws through its OpenGL 3 backend.
#pragma once

#include <imgui.h>

namespace drench::viewer {

// Owns an ImGui context and its OpenGL 3 backend; several can live side by side on one OpenGL context.
class ImGuiSession {
  public:
    // Makes a session current, and restores the previous context at the end of the scope.
    class Use {
      public:
        explicit Use(const ImGuiSession& session) : former_(ImGui::GetCurrentContext()) {
            ImGui::SetCurrentContext(session.context_);
        }
        ~Use() { ImGui::SetCurrentContext(former_); }
        Use(const Use&) = delete;
        Use& operator=(const Use&) = delete;

      private:
        ImGuiContext* former_;
    };

    // Needs a current OpenGL context; leaves the current ImGui context as it was. Throws std::runtime_error
    // when the OpenGL library cannot be loaded.
    ImGuiSession();
    ~ImGuiSession();
    ImGuiSession(const ImGuiSession&) = delete;
    ImGuiSession& operator=(const ImGuiSession&) = delete;

    // Makes this the current ImGui context.
    void makeCurrent() const { ImGui::SetCurrentContext(context_); }

  private:
    ImGuiContext* context_;
};

}  // namespace drench::viewer
