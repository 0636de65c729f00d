#include "player/window/opening.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <future>
#include <string>

#include "base/gl/object.h"
#include "base/text/is_url.h"
#include "base/text/localized.h"
#include "base/text/translation.h"
#include "scene/remote/remote_package.h"

namespace vantage {
namespace {

struct Progress {
    double bytes = 0, of = 0, per_second = 0;  ///< `of` is 0 while waiting for the server's response
};

void draw_progress(GLFWwindow* window, const std::string& name, const Progress& p) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin(
        "##opening", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::Text(tr("Opening %s"), name.c_str());
    const std::string text =
        p.of > 0 ? localized(tr("%.1f of %.1f MB, %.0f kB/s"), p.bytes / 1e6, p.of / 1e6, p.per_second / 1e3)
                 : tr("waiting for the server");
    ImGui::ProgressBar(p.of > 0 ? float(std::min(1.0, p.bytes / p.of)) : 0, ImVec2(360, 0), text.c_str());
    ImGui::TextDisabled("%s", tr("Esc stops"));
    ImGui::End();
    ImGui::Render();
    glClearColor(0.05f, 0.05f, 0.06f, 1);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
}

/// Draws the progress until the result is available. The user may cancel.
template <class Result, class Ask>
Result await(GlfwWindow& window, std::future<Result> result, std::stop_source stop, const std::string& name,
             const Ask& progress) {
    while (result.wait_for(std::chrono::milliseconds(30)) != std::future_status::ready) {
        const auto is_escape = [](const KeyPress& p) { return p.key == GLFW_KEY_ESCAPE; };
        if (std::ranges::any_of(window.events().input.keys, is_escape) || glfwWindowShouldClose(window.get()))
            stop.request_stop();
        draw_progress(window.get(), name, progress());
    }
    return result.get();
}

}  // namespace

PackageReader open_in_window(GlfwWindow& window, const std::filesystem::path& package,
                             const MemoryOptions& options) {
    if (!is_url(package.native())) return PackageReader(package);
    const std::string name = package.filename().string();
    std::stop_source stop;
    const auto open = [&] {
        return open_package(package, {.cache_bytes = memory_budget(options).cache}, stop.get_token());
    };
    PackageReader out =
        await(window, std::async(std::launch::async, open), stop, name, [] { return Progress{}; });
    const auto fetch = [&] { out.fetch_scene(stop.get_token()); };
    const double all = double(out.scene_bytes());
    await(window, std::async(std::launch::async, fetch), stop, name, [&] {
        const SourceTraffic t = *out.traffic();
        return Progress{double(t.bytes_received + t.bytes_from_cache), all, t.bytes_per_second};
    });
    return out;
}

}  // namespace vantage
