#include "player/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <utility>

#include "gl/context.h"
#include "player/camera_path.h"
#include "player/interface/controls.h"
#include "player/interface/overlays.h"
#include "player/interface/panels.h"
#include "player/interface/photo_strip.h"
#include "player/navigation.h"
#include "player/offscreen.h"
#include "player/render/picture.h"
#include "player/render/renderer.h"
#include "player/session.h"
#include "player/settings_file.h"
#include "player/shots.h"
#include "scene/error.h"
#include "scene/package_shape.h"

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
        set_style();
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

/// Since the process was started, by the system's account of it.
double process_seconds() {
    std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
    std::string field;
    double ticks = 0, up = 0;
    for (int i = 1; i <= 22 && stat >> field; ++i)
        if (i == 22) ticks = std::stod(field);
    uptime >> up;
    return up - ticks / double(::sysconf(_SC_CLK_TCK));
}

/// Keys that were pressed in this frame and are meant for the scene.
bool pressed(int key) { return !ImGui::GetIO().WantTextInput && ImGui::IsKeyPressed(key, false); }

void move_by_mouse(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantCaptureMouse) return;
    const Navigation before = s.camera;
    const double radians = 0.005;
    if (io.MouseDown[0]) orbit(s.camera, io.MouseDelta.x * radians, -io.MouseDelta.y * radians);
    if (io.MouseDown[1]) look(s.camera, -io.MouseDelta.x * radians, io.MouseDelta.y * radians);
    const double pixel = (s.camera.eye - s.camera.target).norm() / std::max(1.0f, io.DisplaySize.y);
    if (io.MouseDown[2]) fly(s.camera, Eigen::Vector3d(-io.MouseDelta.x, -io.MouseDelta.y, 0) * pixel);
    if (io.MouseWheel != 0) approach(s.camera, std::pow(0.9, double(io.MouseWheel)));
    if (s.camera.eye != before.eye || s.camera.R != before.R) s.flight.reset();  // the hand has the last word
}

void move_by_keys(Session& s) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput) return;
    const auto down = [&](int key) { return double(ImGui::IsKeyDown(key)); };
    const Eigen::Vector3d step(down(GLFW_KEY_D) - down(GLFW_KEY_A), down(GLFW_KEY_Q) - down(GLFW_KEY_E),
                               down(GLFW_KEY_W) - down(GLFW_KEY_S));
    const double pace =
        (io.KeyShift ? 2.0 : 0.5) * (s.camera.eye - s.camera.target).norm() * std::min(io.DeltaTime, 0.1f);
    if (step.norm() > 0) {
        s.flight.reset();
        fly(s.camera, step * pace);
    }
}

template <class Enum>
void next(Enum& value, Enum last) {
    value = value == last ? Enum(0) : Enum(int(value) + 1);
}

void fly_on(Session& s, const PlanScene& scene, int by, double now) {
    const int count = int(scene.photos.size());
    for (int i = 1; i <= count; ++i) {
        const auto photo = std::uint32_t((int(s.standing_at) + by * i % count + count) % count);
        if (scene.photos[photo].levels) return fly_to(s, photo, scene.photos[photo], now);
    }
}

void obey_keys(Session& s, const PlanScene& scene, double now) {
    if (pressed(GLFW_KEY_N)) fly_on(s, scene, 1, now);
    if (pressed(GLFW_KEY_B)) fly_on(s, scene, -1, now);
    if (pressed(GLFW_KEY_C)) next(s.settings.compare, Compare::difference);
    if (pressed(GLFW_KEY_V)) next(s.settings.show, Show::coverage);
    if (pressed(GLFW_KEY_1)) s.settings.blend = Blend::lumigraph;
    if (pressed(GLFW_KEY_2)) s.settings.blend = Blend::average;
    if (pressed(GLFW_KEY_3)) s.settings.blend = Blend::best;
    if (pressed(GLFW_KEY_R)) {
        s.recording = !s.recording;
        if (s.recording) s.recorded.clear();
    }
    if (pressed(GLFW_KEY_T)) replay(s, now);
    if (pressed(GLFW_KEY_O)) s.open_asked = true;
    if (pressed(GLFW_KEY_P)) s.screenshot = true;
    if (pressed(GLFW_KEY_ESCAPE)) s.quit = true;
    bool* const panels[] = {&s.panels.help,   &s.panels.blending, &s.panels.status,
                            &s.panels.photos, &s.panels.frusta,   &s.panels.radar};
    for (int i = 0; i < 6; ++i)
        if (pressed(GLFW_KEY_F1 + i)) *panels[i] = !*panels[i];
}

/// The first of STEM-0001, STEM-0002, ... that no file is called.
std::string free_name(const std::string& stem, const char* extension) {
    for (int n = 1;; ++n) {
        char number[16];
        std::snprintf(number, sizeof number, "-%04d", n);
        const std::string name = stem + number + extension;
        if (!std::filesystem::exists(name)) return name;
    }
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

/// One package in the window, from frame to frame.
class Scene {
  public:
    Scene(const PackageReader& package, const Options& o, Session& session)
        : renderer_(package, memory_budget(o)), session_(session) {
        session_.photos = photos_in_use(package, o);
    }

    /// Draws what has changed, and the interface over it.
    void frame(int width, int height, double now, bool keys) {
        Session& s = session_;
        continue_flight(s, now);
        const View view = view_of(s.camera, width, height);
        interface(view, now);
        record(now);
        ImGui::Render();
        const bool still = !keys && unchanged(view);
        if (!still) samples_ = 0;
        draw(view, still, now);
        renderer_.show(view, s.settings, 0, true);
        ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
        last_ = view;
    }
    /// The picture is as good as it gets; nothing will change by itself.
    bool idle() const { return samples_ >= rest_side * rest_side && !session_.flight; }
    Renderer& renderer() { return renderer_; }

  private:
    static constexpr int rest_side = 2;
    static constexpr double look_again_seconds = Residency::retry_seconds + 1;

    void interface(const View& view, double now) {
        Session& s = session_;
        menu_bar(s, renderer_, now);
        if (s.panels.frusta) draw_frusta(s, renderer_, view);
        if (!drawn_) return;  // the first picture does not wait for panels
        if (s.panels.blending) blending_panel(s, renderer_);
        if (s.panels.status) status_panel(s, renderer_);
        if (s.panels.radar) radar_panel(s, renderer_, view, now);
        if (s.panels.photos) strip_.show(s, renderer_, view, now);
        if (s.panels.help) help_panel(s);
        open_dialog(s, renderer_);
        message_line(s, now);
    }

    void record(double now) {
        Session& s = session_;
        if (s.recording && now >= record_at_) {
            s.recorded.push_back(s.camera);
            record_at_ = now + 1.0 / 30;
        }
        if (was_recording_ && !s.recording && !s.recorded.empty()) {
            const std::string file = free_name(renderer_.package().path().stem().string(), ".path");
            write_path(file, s.recorded, renderer_.package());
            say(s, std::to_string(s.recorded.size()) + " positions written to " + file, now);
        }
        was_recording_ = s.recording;
    }

    bool unchanged(const View& view) const {
        const ImGuiIO& io = ImGui::GetIO();
        const bool touched =
            ImGui::IsAnyItemActive() || io.MouseClicked[0] || io.MouseReleased[0] || io.MouseWheel != 0;
        return drawn_ && !touched && last_ && last_->cam_from_origin.R == view.cam_from_origin.R &&
               last_->cam_from_origin.t == view.cam_from_origin.t &&
               last_->intrinsics.width == view.intrinsics.width &&
               last_->intrinsics.height == view.intrinsics.height;
    }

    /// While something moves or is still to come, one sample a pixel and a little sharper; then all of them,
    /// one a frame; then nothing.
    void draw(const View& view, bool still, double now) {
        Session& s = session_;
        // A package may be restored while it is shown.
        if (s.report.tiles_damaged > 0 && now > drawn_at_ + look_again_seconds) samples_ = 0;
        if (still && idle()) return;
        drawn_at_ = now;
        const bool rests = still && s.report.settled;
        RenderSettings settings = s.settings;
        settings.lod_bias = rests ? 0 : -0.5;
        const Navigation ahead = before_ ? between(*before_, s.camera, 4) : s.camera;
        before_ = s.camera;
        const View next = view_of(ahead, view.intrinsics.width, view.intrinsics.height);
        const PixelSample sample = rests ? PixelSample{samples_, rest_side} : PixelSample{};
        const auto begun = std::chrono::steady_clock::now();
        s.report = renderer_.draw(view, settings, s.photos, sample, now, &next);
        if (rests && s.report.settled)
            ++samples_;
        else
            samples_ = 0;
        drawn_ = true;
        if (gl::current_device().software) glFinish();
        remember_time(
            std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - begun).count());
    }

    void remember_time(float ms) {
        auto& times = session_.frame_ms;
        std::rotate(times.begin(), times.begin() + 1, times.end());
        times.back() = ms;
        std::vector<double> drawn;
        for (const float t : times)
            if (t > 0) drawn.push_back(double(t));
        session_.statistics = frame_statistics(std::move(drawn));
    }

    Renderer renderer_;
    Session& session_;
    PhotoStrip strip_;
    std::optional<View> last_;
    std::optional<Navigation> before_;
    int samples_ = 0;
    bool drawn_ = false, was_recording_ = false;
    double record_at_ = 0, drawn_at_ = 0;
};

void expect_photo(const PackageReader& package) {
    if (package.photos().empty()) throw Error(Exit::damaged, package.path().string() + ": holds no photo");
}

Session start(const PackageReader& package, const Options& o, const Remembered& remembered) {
    Session s;
    s.settings = remembered.settings;
    s.panels = remembered.panels;
    s.settings.upload_bytes = std::size_t(o.upload_kib) << 10;
    s.settings.complete = false;
    const auto named = o.photos.empty()
                           ? std::vector<std::uint32_t>{std::uint32_t(package.photos().size() / 2)}
                           : named_photos(package, o.photos);
    s.standing_at = s.settings.compare_photo = named.front();
    s.camera = stand_at(package.photos()[s.standing_at], mean_up(package.photos()));
    return s;
}

bool any_key_down() {
    const auto& down = ImGui::GetIO().KeysDown;
    return std::any_of(std::begin(down), std::end(down), [](bool d) { return d; });
}

/// A package, and the second at which it was asked for.
struct Asked {
    PackageReader package;
    double at;
};

/// What the session asks to open; where that cannot be shown, nothing, and why is said.
std::optional<Asked> asked_for(Session& session, double now) {
    const std::string file = std::exchange(session.open, "");
    if (file.empty()) return {};
    try {
        PackageReader package(file);
        expect_shape(package);
        expect_photo(package);
        return Asked{std::move(package), now};
    } catch (const Error& e) {
        say(session, e.what(), now);
        return {};
    }
}

/// Shows one package, asked for at that second, until the window closes or another is asked for: that one.
std::optional<Asked> show_package(GLFWwindow* window, Session& session, Scene& scene, const Options& o,
                                  double asked_at) {
    std::string saved;
    for (int frame = 1; !glfwWindowShouldClose(window); ++frame) {
        // Something to look at does not change by itself once it is complete.
        if (scene.idle() && !any_key_down() && o.frames == 0 && o.controls.empty())
            glfwWaitEventsTimeout(0.2);
        else
            glfwPollEvents();
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width == 0 || height == 0) {  // minimised
            glfwWaitEventsTimeout(0.1);
            continue;
        }
        const double now = glfwGetTime();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        ImGui::NewFrame();
        controls::begin_frame();
        move_by_mouse(session);
        move_by_keys(session);
        obey_keys(session, scene.renderer().scene(), now);
        scene.frame(width, height, now, any_key_down());
        const bool ends = frame == o.frames;
        if (ends && !o.screenshot.empty()) save_frame(o.screenshot, width, height);
        if (session.screenshot) {
            saved = free_name(scene.renderer().package().path().stem().string(), ".png");
            save_frame(saved, width, height);
            say(session, "screenshot written to " + saved, now);
        }
        session.screenshot = false;
        glfwSwapBuffers(window);
        if (!o.controls.empty()) controls::write_places(o.controls);
        if (frame == 1 && !o.quiet)
            std::fprintf(stderr, "first picture after %.0f ms\n", 1000 * (glfwGetTime() - asked_at));
        if (auto other = asked_for(session, now)) return other;
        if (ends || session.quit) break;
    }
    return {};
}

}  // namespace

int run_window(const PackageReader& first, const Options& o) {
    expect_photo(first);
    Remembered remembered;
    remembered.settings = render_settings(first, o);
    const std::filesystem::path folder = o.fresh ? std::filesystem::path() : settings_folder();
    if (!o.fresh) {
        const RenderSettings given = remembered.settings;
        remembered = read_settings(folder, remembered);
        if (o.blending_given) remembered.settings = given;
    }
    const Window window(o.size.empty() ? remembered.window : parse_size(o.size), "Vantage");
    Session session = start(first, o, remembered);
    glfwSetWindowUserPointer(window.get(), &session);
    glfwSetDropCallback(window.get(), [](GLFWwindow* w, int count, const char** files) {
        if (count > 0) static_cast<Session*>(glfwGetWindowUserPointer(w))->open = files[0];
    });
    std::optional<Asked> other, next;
    const PackageReader* package = &first;
    bool damaged = false;
    double asked_at = glfwGetTime() - process_seconds();
    for (;;) {
        glfwSetWindowTitle(window.get(), (package->path().filename().string() + " - Vantage").c_str());
        {
            Scene scene(*package, o, session);
            next = show_package(window.get(), session, scene, o, asked_at);
        }
        damaged |= session.report.tiles_damaged > 0;
        if (!next) break;
        other = std::move(next);
        package = &other->package;
        asked_at = other->at;
        remembered.settings = session.settings;
        remembered.panels = session.panels;
        remembered.settings.exposure.reset();  // of a photo of the other package
        Options plain = o;
        plain.photos.clear();
        plain.exposure.clear();
        session = start(*package, plain, remembered);
    }
    glfwGetWindowSize(window.get(), &remembered.window.width, &remembered.window.height);
    remembered.settings = session.settings;
    remembered.panels = session.panels;
    write_settings(folder, remembered);
    return damaged ? int(Exit::damaged) : int(Exit::ok);
}

}  // namespace vantage
