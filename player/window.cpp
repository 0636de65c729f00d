#include "player/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <numeric>

#include "gl/context.h"
#include "player/navigation.h"
#include "player/offscreen.h"
#include "player/picture.h"
#include "player/shots.h"
#include "scene/error.h"

namespace vantage {
namespace {

/// GLFW, a window and ImGui, gone in the opposite order.
class Window {
  public:
    Window(FrameSize size, const std::string& title) {
        if (!glfwInit()) fail();
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
        window_ = glfwCreateWindow(size.width, size.height, title.c_str(), nullptr, nullptr);
        if (!window_) fail();
        glfwMakeContextCurrent(window_);
        glfwSwapInterval(1);
        gl::watch_errors();
        ImGui::CreateContext();
        ImGui::GetIO().IniFilename = nullptr;
        ImGui_ImplGlfw_InitForOpenGL(window_, true);
        ImGui_ImplOpenGL3_Init("#version 450");
    }
    ~Window() {
        ImGui_ImplOpenGL3_Shutdown();
        ImGui_ImplGlfw_Shutdown();
        ImGui::DestroyContext();
        glfwDestroyWindow(window_);
        glfwTerminate();
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    GLFWwindow* get() const { return window_; }

  private:
    [[noreturn]] static void fail() {
        const char* why = nullptr;
        glfwGetError(&why);
        const std::string text = why ? why : "unknown reason";
        glfwTerminate();
        throw Error(Exit::graphics,
                    "no window with OpenGL 4.5: " + text + " (--offscreen renders without a display)");
    }
    GLFWwindow* window_ = nullptr;
};

/// What the window's user changes.
struct Session {
    RenderSettings settings;
    Navigation camera;
    std::vector<std::uint32_t> photos;  ///< not excluded
    int nearest;
    int standing_at;  ///< photo last flown to
    FrameReport report;
    std::vector<float> frame_ms = std::vector<float>(120, 0.0f);
};

void move_by_mouse(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return;
    const double radians = 0.005;
    if (io.MouseDown[0]) orbit(s.camera, io.MouseDelta.x * radians, -io.MouseDelta.y * radians);
    if (io.MouseDown[1]) look(s.camera, -io.MouseDelta.x * radians, io.MouseDelta.y * radians);
    const double pixel = (s.camera.eye - s.camera.target).norm() / std::max(1.0f, io.DisplaySize.y);
    if (io.MouseDown[2]) fly(s.camera, Eigen::Vector3d(-io.MouseDelta.x, -io.MouseDelta.y, 0) * pixel);
    if (io.MouseWheel != 0) approach(s.camera, std::pow(0.9, double(io.MouseWheel)));
}

void move_by_keys(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureKeyboard) return;
    const auto down = [&](int key) { return double(ImGui::IsKeyDown(key)); };
    const Eigen::Vector3d step(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_Q) - down(GLFW_KEY_E),
                               down(GLFW_KEY_W) - down(GLFW_KEY_S));
    const double pace =
        (io.KeyShift ? 2.0 : 0.5) * (s.camera.eye - s.camera.target).norm() * std::min(io.DeltaTime, 0.1f);
    if (step.norm() > 0) fly(s.camera, step * pace);
}

void photo_panel(Session& s, std::span<const package::PhotoRecord> records) {
    if (!ImGui::CollapsingHeader("Photos", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::SliderInt("nearest", &s.nearest, 1, std::max(1, int(records.size())));
    for (int i = 0; i < int(records.size()); ++i) {
        if (ImGui::Selectable(records[std::size_t(i)].name, s.standing_at == i)) {
            s.standing_at = i;
            s.camera = stand_at(records[std::size_t(i)], s.camera.up);
        }
    }
}

void blending_panel(Session& s) {
    if (!ImGui::CollapsingHeader("Blending", ImGuiTreeNodeFlags_DefaultOpen)) return;
    WeightSettings& w = s.settings.weights;
    int blend = int(s.settings.blend);
    ImGui::RadioButton("average", &blend, int(Blend::average));
    ImGui::SameLine();
    ImGui::RadioButton("lumigraph", &blend, int(Blend::lumigraph));
    ImGui::SameLine();
    ImGui::RadioButton("best photo", &blend, int(Blend::best));
    s.settings.blend = Blend(blend);
    const char* const modes[] = {"as the scene asks", "per vertex", "per fragment"};
    int coordinates = int(s.settings.coordinates);
    ImGui::Combo("coordinates", &coordinates, modes, 3);
    s.settings.coordinates = Coordinates(coordinates);
    auto exponent = float(w.exponent);
    if (ImGui::SliderFloat("exponent", &exponent, 0, 32)) w.exponent = double(exponent);
    ImGui::SliderInt("per pass", &s.settings.photos_per_pass, 1, most_photos_per_pass);
    ImGui::Checkbox("distance", &w.distance);
    ImGui::SameLine();
    ImGui::Checkbox("angle", &w.angle);
    ImGui::SameLine();
    ImGui::Checkbox("field of view", &w.fov_normalisation);
    ImGui::Text("masks");
    ImGui::SameLine();
    ImGui::Checkbox("angle##mask", &w.angle_mask);
    ImGui::SameLine();
    ImGui::Checkbox("depth##mask", &w.depth_mask);
    ImGui::SameLine();
    ImGui::Checkbox("border##mask", &w.border_mask);
    ImGui::Checkbox("shade what no photo shows", &s.settings.fill_holes);
}

void status_panel(const Session& s) {
    ImGui::PlotLines("##frames", s.frame_ms.data(), int(s.frame_ms.size()), 0, "frame time, ms", 0, 100,
                     ImVec2(-1, 48));
    ImGui::Text("%.1f ms, %zu photos in %zu passes", double(s.frame_ms.back()), s.report.photos,
                s.report.passes);
    ImGui::Text("%zu tiles in view, %zu to come", s.report.tiles, s.report.tiles_missing);
    if (s.report.tiles_damaged)
        ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), "%zu damaged tiles left out", s.report.tiles_damaged);
    ImGui::TextDisabled("drag: orbit, right: look, middle: pan\nwheel: approach, WASD QE: fly");
}

void panels(Session& s, const PackageReader& package) {
    ImGui::SetNextWindowPos(ImVec2(12, 12), ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSize(ImVec2(330, 520), ImGuiCond_FirstUseEver);
    ImGui::Begin("Vantage");
    status_panel(s);
    blending_panel(s);
    photo_panel(s, package.photos());
    ImGui::End();
}

/// The photos that weigh most from here.
std::vector<std::uint32_t> nearest_photos(const Session& s, const View& view,
                                          std::span<const package::PhotoRecord> records) {
    WeightSettings near = s.settings.weights;
    near.distance = near.angle = near.angle_per_photo = true;
    const std::vector<double> weights = dynamic_weights(view, records, near);
    std::vector<std::uint32_t> photos = s.photos;
    std::erase_if(photos, [&](std::uint32_t p) { return records[p].levels == 0; });
    std::stable_sort(photos.begin(), photos.end(), [&](auto a, auto b) { return weights[a] > weights[b]; });
    photos.resize(std::min(photos.size(), std::size_t(s.nearest)));
    return photos;
}

void save_frame(const std::string& file, int width, int height) {
    Picture p{width, height, std::vector<std::uint8_t>(std::size_t(width) * std::size_t(height) * 4), {}};
    std::vector<std::uint8_t> rows(p.rgba.size());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rows.data());
    const auto stride = std::ptrdiff_t(width) * 4;
    for (int y = 0; y < height; ++y)
        std::copy_n(rows.begin() + (height - 1 - y) * stride, stride, p.rgba.begin() + y * stride);
    for (std::size_t i = 3; i < p.rgba.size(); i += 4) p.rgba[i] = 255;
    write_png(file, p);
}

void draw_frame(Session& s, Renderer& renderer, int width, int height) {
    const View view = view_of(s.camera, width, height);
    const auto photos = nearest_photos(s, view, renderer.package().photos());
    s.report = renderer.draw(view, s.settings, photos, {}, glfwGetTime());
    renderer.show(view, s.settings, 0, true);
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

Session start(const PackageReader& package, const Options& o) {
    Session s{render_settings(package, o), {}, photos_in_use(package, o), 8, 0, {}};
    s.settings.upload_bytes = std::size_t(o.upload_kib) << 10;
    s.settings.complete = false;
    if (!o.photos.empty()) s.standing_at = int(named_photos(package, o.photos).front());
    if (package.photos().empty()) throw Error(Exit::damaged, package.path().string() + ": holds no photo");
    s.camera = stand_at(package.photos()[std::size_t(s.standing_at)], mean_up(package.photos()));
    return s;
}

}  // namespace

int run_window(const PackageReader& package, const Options& o) {
    Session session = start(package, o);
    const Window window(o.size.empty() ? FrameSize{1280, 720} : parse_size(o.size),
                        package.path().filename().string() + " - Vantage");
    Renderer renderer(package, memory_budget(o));
    auto last = std::chrono::steady_clock::now();
    for (int frame = 1; !glfwWindowShouldClose(window.get()); ++frame) {
        glfwPollEvents();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window.get(), &width, &height);
        if (width == 0 || height == 0) {  // minimised
            glfwWaitEventsTimeout(0.1);
            continue;
        }
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        move_by_mouse(session);
        move_by_keys(session);
        panels(session, package);
        draw_frame(session, renderer, width, height);
        const bool ends = frame == o.frames;
        if (ends && !o.screenshot.empty()) save_frame(o.screenshot, width, height);
        glfwSwapBuffers(window.get());
        const auto now = std::chrono::steady_clock::now();
        std::rotate(session.frame_ms.begin(), session.frame_ms.begin() + 1, session.frame_ms.end());
        session.frame_ms.back() = std::chrono::duration<float, std::milli>(now - last).count();
        last = now;
        if (ends) break;
    }
    return session.report.tiles_damaged ? int(Exit::damaged) : int(Exit::ok);
}

}  // namespace vantage
