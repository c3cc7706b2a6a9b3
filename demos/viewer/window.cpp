#include "viewer/window.h"

// Included before glfw_window.h, so that all OpenGL functions come from libepoxy.
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <thread>

#include "viewer/gl/glfw_window.h"
#include "viewer/gl/imgui_session.h"
#include "viewer/picture/orbit.h"
#include "viewer/text/fonts.h"

namespace drench::viewer {

namespace {

std::optional<Key> meaning(int key) {
    switch (key) {
        case GLFW_KEY_SPACE:
        case GLFW_KEY_P:
            return Key::pause;
        case GLFW_KEY_PERIOD:
        case GLFW_KEY_RIGHT:
            return Key::step;
        case GLFW_KEY_R:
            return Key::reset;
        case GLFW_KEY_UP:
            return Key::wetter;
        case GLFW_KEY_DOWN:
            return Key::drier;
        case GLFW_KEY_PAGE_DOWN:
            return Key::nextScene;
        case GLFW_KEY_PAGE_UP:
            return Key::formerScene;
        case GLFW_KEY_V:
            return Key::nextView;
        case GLFW_KEY_S:
            return Key::split;
        case GLFW_KEY_TAB:
            return Key::panel;
        case GLFW_KEY_F1:
            return Key::help;
        case GLFW_KEY_F9:
            return Key::record;
        case GLFW_KEY_ESCAPE:
            return Key::close;
        case GLFW_KEY_F12:
            return Key::screenshot;
        default:
            return std::nullopt;
    }
}

void collectKey(GLFWwindow* window, int code, int, int action, int) {
    const std::optional<Key> key = meaning(code);
    // A held step key repeats; other keys do not.
    const bool counts = action == GLFW_PRESS || (action == GLFW_REPEAT && key == Key::step);
    if (key && counts) static_cast<std::vector<Key>*>(glfwGetWindowUserPointer(window))->push_back(*key);
}

// On screens of twice the usual density letters have twice as many pixels, so that they are not blurred.
void scaleInterface(GLFWwindow* window) {
    float density = 1.0f;
    glfwGetWindowContentScale(window, &density, nullptr);
    int width = 0;
    int pixels = 0;
    glfwGetWindowSize(window, &width, nullptr);
    glfwGetFramebufferSize(window, &pixels, nullptr);
    const float pixelsPerUnit =
        width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0f;
    ImGuiIO& io = ImGui::GetIO();
    addReadableFont(*io.Fonts, 14.0f * std::max(1.0f, density));
    io.FontGlobalScale = 1.0f / pixelsPerUnit;
    ImGui::GetStyle().ScaleAllSizes(std::max(1.0f, density) / pixelsPerUnit);
}

void followMouse(Camera& camera, bool leftOrbits) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse || !(io.DisplaySize.y > 0.0f)) return;
    const float right = io.MouseDelta.x / io.DisplaySize.y;
    const float down = io.MouseDelta.y / io.DisplaySize.y;
    if (leftOrbits && io.MouseDown[ImGuiMouseButton_Left])
        orbit(camera, right, down);
    else if (io.MouseDown[ImGuiMouseButton_Right] || io.MouseDown[ImGuiMouseButton_Middle])
        pan(camera, right, down);
    if (io.MouseWheel != 0.0f) zoom(camera, io.MouseWheel);
}

}  // namespace

class Window::Contents {
  public:
    Contents(int width, int height, const std::string& title)
        : window_(width, height, title, GlfwWindow::Visibility::shown) {
        glfwMakeContextCurrent(window_.handle());
        glfwSwapInterval(1);
        glfwSetWindowUserPointer(window_.handle(), &arriving_);
        // Installed before the backend's callback, which forwards every key to the previous one.
        glfwSetKeyCallback(window_.handle(), collectKey);
        session_.emplace();
        backend_.emplace(*session_, window_.handle());
        session_->makeCurrent();
        scaleInterface(window_.handle());
    }

    GLFWwindow* handle() const { return window_.handle(); }
    const std::vector<Key>& keys() const { return keys_; }
    Camera& camera() { return camera_; }

    std::array<int, 2> framebufferSize() const {
        std::array<int, 2> size{};
        glfwGetFramebufferSize(handle(), &size[0], &size[1]);
        return size;
    }

    void beginFrame() {
        glfwMakeContextCurrent(handle());
        session_->makeCurrent();
        arriving_.clear();
        glfwPollEvents();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        keys_ = arriving_;
        if (ImGui::GetIO().WantTextInput) keys_.clear();
    }

    void moveCamera(bool leftOrbits) { followMouse(camera_, leftOrbits); }

    bool isHeld(HeldKey key) const {
        return hasFocus() && !ImGui::GetIO().WantTextInput &&
               glfwGetKey(handle(), key == HeldKey::h ? GLFW_KEY_H : GLFW_KEY_D) == GLFW_PRESS;
    }

    std::optional<Mouse> mouse(int columns) const {
        const ImGuiIO& io = ImGui::GetIO();
        if (io.WantCaptureMouse || !hasFocus() || !(io.DisplaySize.x > 0.0f && io.DisplaySize.y > 0.0f) ||
            !ImGui::IsMousePosValid())
            return std::nullopt;
        Mouse mouse;
        const float across = static_cast<float>(columns) * io.MousePos.x / io.DisplaySize.x;
        mouse.column = std::clamp(static_cast<int>(std::floor(across)), 0, columns - 1);
        mouse.ray = rayThrough(camera_, io.DisplaySize.x / io.DisplaySize.y / static_cast<float>(columns),
                               across - static_cast<float>(mouse.column), io.MousePos.y / io.DisplaySize.y);
        mouse.left = io.MouseDown[ImGuiMouseButton_Left];
        mouse.leftWentDown = ImGui::IsMouseClicked(ImGuiMouseButton_Left);
        return mouse;
    }

    void endFrame() {
        session_->makeCurrent();
        ImGui::Render();
        const auto [width, height] = framebufferSize();
        if (width < 1 || height < 1) {
            // A minimised window is not visible, and does not wait for the screen.
            std::this_thread::sleep_for(std::chrono::milliseconds(16));
            return;
        }
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        glViewport(0, 0, width, height);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        glfwSwapBuffers(handle());
    }

  private:
    // ImGui's backend for GLFW on a window, inside a session.
    class GlfwBackend {
      public:
        GlfwBackend(const ImGuiSession& session, GLFWwindow* window) : session_(session) {
            const ImGuiSession::Use use(session_);
            ImGui_ImplGlfw_InitForOpenGL(window, true);
        }
        ~GlfwBackend() {
            const ImGuiSession::Use use(session_);
            ImGui_ImplGlfw_Shutdown();
        }
        GlfwBackend(const GlfwBackend&) = delete;
        GlfwBackend& operator=(const GlfwBackend&) = delete;

      private:
        const ImGuiSession& session_;
    };

    bool hasFocus() const { return glfwGetWindowAttrib(handle(), GLFW_FOCUSED) == GLFW_TRUE; }

    // Filled by GLFW while it polls.
    std::vector<Key> arriving_;
    std::vector<Key> keys_;
    Camera camera_;
    GlfwWindow window_;
    std::optional<ImGuiSession> session_;
    std::optional<GlfwBackend> backend_;
};

Window::Window(int width, int height, const std::string& title)
    : contents_(std::make_unique<Contents>(width, height, title)) {}

Window::~Window() {
    glfwMakeContextCurrent(contents_->handle());
}

bool Window::displayAvailable() {
    return glfwStarted();
}

bool Window::isOpen() const {
    return glfwWindowShouldClose(contents_->handle()) == GLFW_FALSE;
}

void Window::requestClose() {
    glfwSetWindowShouldClose(contents_->handle(), GLFW_TRUE);
}

void Window::beginFrame() {
    contents_->beginFrame();
}

void Window::moveCamera(bool leftOrbits) {
    contents_->moveCamera(leftOrbits);
}

void Window::endFrame() {
    contents_->endFrame();
}

const std::vector<Key>& Window::keys() const {
    return contents_->keys();
}

bool Window::isHeld(HeldKey key) const {
    return contents_->isHeld(key);
}

std::optional<Mouse> Window::mouse(int columns) const {
    return contents_->mouse(columns);
}

std::string Window::rendererName() const {
    const GLubyte* const name = glGetString(GL_RENDERER);
    return name == nullptr ? "unknown" : reinterpret_cast<const char*>(name);
}

Camera& Window::camera() {
    return contents_->camera();
}

int Window::framebufferWidth() const {
    return contents_->framebufferSize()[0];
}

int Window::framebufferHeight() const {
    return contents_->framebufferSize()[1];
}

}  // namespace drench::viewer
