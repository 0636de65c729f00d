#include "player/window/run_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/cli/standard_output.h"
#include "base/files/process_time.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/is_url.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"
#include "player/window/glfw_window.h"
#include "player/window/input/input.h"
#include "player/window/new_frame.h"
#include "player/window/opening.h"
#include "player/window/remembered.h"
#include "player/window/screenshot.h"
#include "player/window/shown_scene.h"
#include "player/window/start_page.h"
#include "player/window/start_session.h"
#include "scene/package/contents/image_sets.h"
#include "scene/package/package_shape.h"

namespace vantage {
namespace {

/// Saves settings for the next session. The names of image sets that were saved earlier are kept if the
/// package has fewer than two image sets. Omits the exposure, since it refers to a photo of this package, and
/// the background if the story hides it.
void remember(const Session& session, const PackageReader& package, Remembered& r) {
    const ShowBackground background = r.settings.background;
    r.settings = session.settings;
    r.settings.exposure.reset();
    if (session.defaults.settings.background == ShowBackground::off) r.settings.background = background;
    const std::vector<ImageSet> image_sets = read_image_sets(package);
    if (image_sets.size() < 2) return;
    const ImageSetSettings& shown = session.settings.image_sets;
    r.image_set = image_sets[shown.shown].name;
    r.other_image_set = shown.other ? image_sets[*shown.other].name : "";
}

/// Options for another package, without those that name parts of the first package or more packages.
ShowOptions options_for(ShowOptions o, const std::string& file) {
    o.package.file = file;
    o.objects.added.clear();
    o.package.photos.clear();
    o.pictures.view.clear();
    o.field.name.clear();
    o.blending.image_sets = {};
    return o;
}

/// The folder of saved settings; empty if they are neither read nor written.
std::filesystem::path folder_of(const ShowOptions& o) {
    return o.window.fresh ? std::filesystem::path() : settings_folder();
}

/// Settings of the window, independent of the package.
Remembered remembered_window(const std::filesystem::path& folder) {
    return folder.empty() ? Remembered{} : read_settings(folder, {});
}

/// Runs a function that saves settings. The window works without saved settings, so errors are only reported.
template <class Save>
void try_to_save(const Save& save) {
    try {
        save();
    } catch (const Error& e) {
        std::fprintf(stderr, "settings cannot be saved: %s\n", e.what());
    }
}

float text_scale(const ShowOptions& o, const Remembered& remembered, const GlfwWindow& window) {
    if (o.window.text_scale > 0) return float(o.window.text_scale);
    return remembered.text_scale > 0 ? float(remembered.text_scale) : window.fitting_text_scale();
}

/// A package to show, and when it was requested.
struct Requested {
    ShowOptions options;
    std::vector<SceneObject> objects;
    PackageReader package;   ///< package of the first object
    double at = 0;           ///< seconds
    bool in_window = false;  ///< opened in the window, which reports errors
};

/// Opens the package or the scene file of the options in the window. Throws Error.
Requested open_requested(GlfwWindow& window, const ShowOptions& o, double now) {
    std::vector<SceneObject> objects = named_objects(o.package, o.objects);
    PackageReader package = open_in_window(window, objects.front().package, o.memory);
    expect_shape(package);
    expect_content(package);
    for (std::size_t i = 1; i < objects.size(); ++i) open_in_window(window, objects[i].package, o.memory);
    return {o, std::move(objects), std::move(package), now, true};
}

std::string cannot_open(const std::string& file, const Error& error) {
    return failure_text(formatted(tr("%s cannot be opened."), std::filesystem::path(file).filename().c_str()),
                        error);
}

/// Opens a package; empty, with a message, if it cannot be shown.
std::optional<Requested> requested(GlfwWindow& window, Session& session, const ShowOptions& o, double now) {
    try {
        return open_requested(window, o, now);
    } catch (const Error& e) {
        say(session.message, cannot_open(o.package.file, e),
            glfwGetTime());  // opening may take long, e.g. from a server
        return {};
    }
}

/// Asks the user to choose a package; empty if the window was closed. `o`: options for the package, without
/// its file. `trouble`: the reason why the last one cannot be opened, or empty.
std::optional<Requested> ask_for_package(GlfwWindow& window, WindowState& state, Controls& controls,
                                         ShowOptions o, std::string trouble) {
    glfwSetWindowTitle(window.get(), "Vantage");
    for (std::string& file = o.package.file;;) try {
            file = start_page(window, state, controls, remembered_window(folder_of(o)).recent, trouble,
                              o.window.controls);
            if (file.empty()) return {};
            return open_requested(window, o, glfwGetTime());
        } catch (const Error& e) {
            trouble = cannot_open(file, e);
        }
}

/// Opens the package of the options in the window, or asks for one if the options name none or it cannot be
/// opened.
std::optional<Requested> open_or_ask(GlfwWindow& window, WindowState& state, Controls& controls,
                                     const ShowOptions& o, double started) {
    if (o.package.file.empty()) return ask_for_package(window, state, controls, o, "");
    std::string trouble;
    try {
        return open_requested(window, o, started);
    } catch (const Error& e) {
        trouble = cannot_open(o.package.file, e);
    }
    return ask_for_package(window, state, controls, options_for(o, ""), trouble);
}

/// Sends a heartbeat to the kiosk's supervisor.
void beat(int heartbeat_fd) {
    const char byte = '.';
    [[maybe_unused]] const auto written = ::write(heartbeat_fd, &byte, 1);  // a full pipe is no error
}

/// ImGui needs a few frames to react to events.
constexpr int frames_after_event = 3;

/// Whether the next frame would equal the last one. `lively`: the frames that remain to be drawn after the
/// last event.
bool is_idle(const WindowState& state, const ShownScene& scene, int lively) {
    return scene.rests() && !keys_in_use(state.input) && lively == 0;
}

/// Takes events, and returns whether to draw a frame. If the window `may_rest`, a scene at rest waits for an
/// event or for its next frame. Otherwise, every frame is drawn, because frames are counted, but at a lower
/// rate while the scene is at rest.
bool take_events(GlfwWindow& window, WindowState& state, const ShownScene& scene, bool may_rest,
                 int& lively) {
    constexpr double longest_rest = 1, between_counted = 0.03;  // seconds
    const bool idle = is_idle(state, scene, lively), rests = idle && may_rest;
    const double until = std::clamp(scene.wakes_at() - glfwGetTime(), 0.001, longest_rest);
    WindowEvents events = window.events(rests ? until : idle ? std::min(until, between_counted) : 0);
    state.input = std::move(events.input);
    for (const std::string& file : events.dropped)
        if (!state.kiosk)
            state.commands.push_back(is_scene_file(file) ? UserCommand(OpenFile{file}) : PlaceDropped{file});
    if (glfwWindowShouldClose(window.get()) && !state.kiosk) state.commands.push_back(Quit{});
    glfwSetWindowShouldClose(window.get(), GLFW_FALSE);
    state.touched = events.any;
    // Newer versions of ImGui take one key per frame.
    lively = events.any ? frames_after_event * int(1 + state.input.keys.size()) : std::max(0, lively - 1);
    return !rests || events.any || glfwGetTime() >= scene.wakes_at();
}

/// A package in the window.
struct ShownPackage {
    ShownPackage(const Requested& r, const Remembered& remembered, WindowState& state, Controls& controls)
        : session(start_session(r.package, r.options, remembered, state)),
          scene(r.package, r.objects, r.options, session, controls) {}
    Session session;
    ShownScene scene;
};

/// Shows a package until the window closes or another package is requested. Returns that other package, if
/// any.
std::optional<Requested> show_package(GlfwWindow& shown_in, ShownPackage& shown, Controls& controls,
                                      const Requested& package) {
    GLFWwindow* window = shown_in.get();
    auto& [session, scene] = shown;
    WindowState& state = session.window;
    const ShowOptions& o = package.options;
    const bool may_rest = o.window.frames == 0 && o.window.controls.empty();  // otherwise frames are counted
    int lively = frames_after_event;
    for (int frame = 0;;) {
        if (o.window.heartbeat_fd >= 0) beat(o.window.heartbeat_fd);
        if (!take_events(shown_in, state, scene, may_rest, lively)) continue;
        shown_in.fill_screen(state.full_screen);
        shown_in.set_text_scale(state.text_scale);
        int width = 0, height = 0;
        glfwGetFramebufferSize(window, &width, &height);
        if (width == 0 || height == 0) {  // minimized
            if (holds<Quit>(state.commands)) glfwRestoreWindow(window);
            glfwWaitEventsTimeout(0.1);
            continue;
        }
        ++frame;
        const double now = glfwGetTime();
        ImGui_ImplOpenGL3_NewFrame();
        ImGui_ImplGlfw_NewFrame();
        const bool control_held = ImGui::GetIO().KeyCtrl;
        new_frame(mouse_of(window), state.input);
        controls.begin_frame();
        apply_input(session, scene.scene(), now);
        scene.frame(width, height, now);
        ImGui::GetIO().KeyCtrl = control_held;
        const bool ends = frame == o.window.frames;
        if (ends && !o.window.screenshot.empty()) save_frame(o.window.screenshot, width, height);
        glfwSwapBuffers(window);
        if (!o.window.controls.empty())
            controls.write_places(o.window.controls, is_idle(state, scene, lively));
        if (frame == 1 && output_form() != OutputForm::none)
            std::fprintf(stderr, "first picture after %.0f ms\n", 1000 * (glfwGetTime() - package.at));
        if (frame == 1) try_to_save([&] { remember_opened(folder_of(o), o.package.file); });
        while (const auto command = take_one_of<OpenFile, Quit>(state.commands)) {
            const OpenFile* const open = std::get_if<OpenFile>(&*command);
            if (!open) return {};
            if (auto other = requested(shown_in, session, options_for(o, open->file), now)) return other;
        }
        if (ends) break;
    }
    return {};
}

/// Shows packages, one after the other, until the window closes. Returns whether a damaged tile was found.
bool show_packages(GlfwWindow& window, WindowState& state, Controls& controls, Requested package,
                   Remembered& remembered) {
    for (bool damaged = false;;) {
        std::optional<Requested> next;
        std::optional<ShownPackage> shown;
        glfwSetWindowTitle(window.get(), (package.package.path().filename().string() + " - Vantage").c_str());
        std::string trouble;
        try {
            shown.emplace(package, remembered, state, controls);
        } catch (const Error& e) {
            if (!package.in_window) throw;
            trouble = cannot_open(package.options.package.file, e);
        }
        if (!shown) {
            next = ask_for_package(window, state, controls, options_for(package.options, ""), trouble);
        } else {
            next = show_package(window, *shown, controls, package);
            shown->scene.stop_recording(glfwGetTime());
            damaged |= shown->session.drawn.report.tiles_damaged > 0;
            remember(shown->session, package.package, remembered);
        }
        if (!next) return damaged;
        shown.reset();
        package = std::move(*next);
    }
}

}  // namespace

int run_window(const ShowOptions& o, const std::vector<SceneObject>& objects) {
    const std::filesystem::path folder = folder_of(o);
    Remembered remembered = remembered_window(folder);
    const std::string language = chosen_language(o, remembered);
    use_language(language);
    std::optional<Requested> first;
    const auto start = [&](PackageReader package) {
        first = Requested{o, objects, std::move(package)};
        expect_content(first->package);
        remembered = start_settings(first->package, o, folder);
    };
    // Errors in a file or an option are reported without a window.
    if (!objects.empty() && !is_url(objects.front().package.native()))
        start(PackageReader(objects.front().package));
    GlfwWindow window(o.output.size.empty() ? remembered.window : parse_size(o.output.size), "Vantage",
                      gl::debug_from_environment() == gl::Debug::on);
    WindowState state;
    state.language = language;
    state.text_scale = text_scale(o, remembered, window);
    Controls controls;
    const double started = glfwGetTime() - seconds_since_start();
    if (objects.empty()) {
        window.set_text_scale(state.text_scale);
        first = open_or_ask(window, state, controls, o, started);
        if (!first) return int(Exit::ok);
        remembered = start_settings(first->package, o, folder);
    } else {
        if (!first) start(open_in_window(window, objects.front().package, o.memory));
        first->at = started;
    }
    state.panels = remembered.panels;
    const bool damaged = show_packages(window, state, controls, std::move(*first), remembered);
    window.fill_screen(false);
    glfwGetWindowSize(window.get(), &remembered.window.width, &remembered.window.height);
    remembered.panels = state.panels;
    if (state.text_scale != window.fitting_text_scale()) remembered.text_scale = double(state.text_scale);
    if (state.language != language && !o.window.kiosk) remembered.language = state.language;
    remembered.recent = remembered_window(folder).recent;
    try_to_save([&] { write_settings(folder, remembered); });
    return damaged ? int(Exit::damaged) : int(Exit::ok);
}

}  // namespace vantage
