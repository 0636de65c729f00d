#include "player/window/start_page.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <epoxy/gl.h>
#include <imgui.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text/translation.h"
#include "player/interface/sections/open_dialog.h"
#include "player/window/input/system_chooser.h"
#include "player/window/new_frame.h"

namespace vantage {
namespace {

/// Lists packages by name, with their folders; a click opens one of them.
void recent_packages(Controls& c, UserCommands& commands, std::span<const std::string> recent) {
    if (recent.empty()) return;
    ImGui::TextDisabled("%s", tr("Recent"));
    for (const std::string& file : recent) {
        const std::filesystem::path path = file;
        if (c.button((path.filename().string() + "##" + file).c_str())) commands.push_back(OpenFile{file});
        ImGui::SameLine();
        ImGui::TextDisabled("%s", path.parent_path().c_str());
    }
    ImGui::Spacing();
}

void page(Controls& c, UserCommands& commands, std::span<const std::string> recent,
          const std::string& trouble) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin("##start", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::SetWindowFontScale(1.6f);
    ImGui::TextUnformatted("Vantage");
    ImGui::SetWindowFontScale(1);
    ImGui::TextUnformatted(tr("Shows a scanned object through its own photographs."));
    ImGui::Spacing();
    recent_packages(c, commands, recent);
    if (c.button("Open a package...")) commands.push_back(ChooseFile{});
    ImGui::SameLine();
    ImGui::TextUnformatted(tr("or drop one here"));
    ImGui::TextDisabled("%s", tr("Packages are made by: vantage prepare SCAN -o NAME.vantage"));
    if (!trouble.empty()) {
        ImGui::PushTextWrapPos(40 * ImGui::GetFontSize());
        ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), "%s", trouble.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

/// O opens a file and Ctrl+Q quits, but not while a dialog has the focus.
void take_keys(WindowState& state) {
    for (const KeyPress& p : state.input.keys)
        if (p.key == GLFW_KEY_Q && p.with == KeyPress::With::control) state.commands.push_back(Quit{});
    if (!ImGui::GetIO().WantTextInput && take_key(state.input, GLFW_KEY_O))
        state.commands.push_back(ChooseFile{});
}

void draw(GLFWwindow* window) {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glClearColor(0.05f, 0.05f, 0.06f, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window);
}

}  // namespace

std::string start_page(GlfwWindow& window, WindowState& state, Controls& c,
                       std::span<const std::string> recent, const std::string& trouble,
                       const std::string& places) {
    constexpr double blink_seconds = 0.3;  // blinking interval of a text field's cursor
    Message message;
    OpenDialog dialog(".");
    SystemChooser chooser;
    for (int lively = 3; !glfwWindowShouldClose(window.get());) {
        WindowEvents events = window.events(lively > 0 ? 0 : blink_seconds);
        lively = events.any || !places.empty() ? 3 : std::max(0, lively - 1);
        state.input = std::move(events.input);
        for (const std::string& file : events.dropped) state.commands.push_back(OpenFile{file});
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        new_frame(mouse_of(window.get()), state.input);
        c.begin_frame();
        take_keys(state);
        page(c, state.commands, recent, message.text.empty() ? trouble : message.text);
        chooser.attend(state.commands, message, std::filesystem::current_path(), glfwGetTime());
        dialog.show(c, state);
        draw(window.get());
        if (!places.empty()) c.write_places(places);
        if (const auto command = take_one_of<OpenFile, Quit>(state.commands)) {
            const OpenFile* const open = std::get_if<OpenFile>(&*command);
            return open ? open->file : "";
        }
    }
    return "";
}

}  // namespace vantage
