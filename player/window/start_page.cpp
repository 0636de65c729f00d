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
#include "player/interface/recent_packages.h"
#include "player/interface/sections/open_dialog.h"
#include "player/window/input/system_chooser.h"
#include "player/window/new_frame.h"

namespace vantage {
namespace {

/// Shows an error message: the reason on one line, and the error itself, in English, below it.
void show_trouble(Controls& c, const std::string& trouble, float width) {
    if (trouble.empty()) return;
    const std::size_t end = std::min(trouble.find('\n'), trouble.size());
    ImGui::PushTextWrapPos(width);
    ImGui::TextColored(ImVec4(1, 0.5f, 0.4f, 1), "%s", trouble.substr(0, end).c_str());
    c.note("Message");
    if (end < trouble.size()) ImGui::TextDisabled("%s", trouble.c_str() + end + 1);
    ImGui::PopTextWrapPos();
    ImGui::Spacing();
}

void page(Controls& c, UserCommands& commands, const RecentPackages& recent, const std::string& trouble) {
    const float em = ImGui::GetFontSize();
    const ImVec2 screen = ImGui::GetIO().DisplaySize, room(screen.x - 4 * em, screen.y - 14 * em);
    ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::Begin("##start", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::SetWindowFontScale(1.6f);
    ImGui::TextUnformatted("Vantage");
    ImGui::SetWindowFontScale(1);
    ImGui::TextUnformatted(tr("Shows a scanned object through its own photographs."));
    ImGui::Spacing();
    show_trouble(c, trouble, std::min(60 * em, room.x));
    recent.show(c, commands, room);
    if (c.button("Open a package...")) commands.push_back(ChooseFile{});
    ImGui::SameLine();
    ImGui::TextUnformatted(tr("or drop one here"));
    ImGui::TextDisabled("%s", tr("Packages are made by: vantage prepare SCAN -o NAME.vantage"));
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
                       std::span<const std::string> files, const std::string& trouble,
                       const std::string& places) {
    constexpr double blink_seconds = 0.3;  // blinking interval of a text field's cursor
    Message message;
    OpenDialog dialog(".");
    SystemChooser chooser;
    RecentPackages recent(files);
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
        if (recent.load_next()) lively = std::max(lively, 1);
        if (!places.empty()) c.write_places(places);
        if (const auto command = take_one_of<OpenFile, Quit>(state.commands)) {
            const OpenFile* const open = std::get_if<OpenFile>(&*command);
            return open ? open->file : "";
        }
    }
    return "";
}

}  // namespace vantage
