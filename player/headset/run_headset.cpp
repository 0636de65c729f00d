#include "player/headset/run_headset.h"

#include <chrono>
#include <cstdio>
#include <optional>
#include <thread>

#include "base/cli/standard_output.h"
#include "base/text/translation.h"
#include "player/headset/headset.h"
#include "player/headset/headset_scene.h"
#include "player/headset/mirror.h"
#include "player/headset/runtime/xr_result.h"
#include "player/options/shown/opened_package.h"
#include "player/window/start_session.h"

namespace vantage {
namespace {

constexpr auto idle = std::chrono::milliseconds(10);  ///< polling interval while no frames are needed

void tell(const std::string& text) {
    if (output_form() != OutputForm::none) std::fprintf(stderr, "%s\n", text.c_str());
}

/// One iteration with a session: handles its events, and draws a frame if needed. Returns false once the
/// session has ended.
bool go_on(HeadsetSession& session, HeadsetScene& scene, Mirror& mirror, bool& asked_to_end, bool ends,
           int& frames) {
    session.take_events();
    if (ends && !asked_to_end) {
        asked_to_end = true;
        session.ask_to_end();
    }
    if (session.ended()) return false;
    if (!session.runs()) {
        std::this_thread::sleep_for(idle);
        return true;
    }
    HeadsetFrame frame = session.begin_frame();
    const auto [select, menu] = mirror.buttons();
    frame.hands[right_hand].menu |= menu;
    frame.gazes = frame.shown && frame.focused && !any_points(frame.hands);
    if (frame.gazes) frame.hands = with_gaze(frame.hands, frame.head, select, menu);
    scene.frame(session, frame, [&](GLuint picture, FrameSize size) { mirror.show(picture, size); });
    ++frames;
    return true;
}

void show_in(Headset& headset, HeadsetScene& scene, UserCommands& commands, Mirror& mirror,
             const ShowOptions& o) {
    bool asked_to_end = false, quits = false;
    for (int frames = 0;;) {
        mirror.attend();
        quits |= take_all<Quit>(commands);
        const bool ends = quits || mirror.closed() || (o.window.frames > 0 && frames >= o.window.frames);
        HeadsetSession* const session = headset.session();
        if (!session) {
            if (ends) return;
            std::this_thread::sleep_for(idle);
            continue;
        }
        try {
            if (!go_on(*session, scene, mirror, asked_to_end, ends, frames)) return;
        } catch (const XrLost& lost) {
            tell(std::string(lost.what()) + "; waiting for it");
            headset.lose(lost.runtime);
            asked_to_end = false;
        }
    }
}

}  // namespace

int run_headset(const ShowOptions& o, const std::vector<SceneObject>& objects) {
    const PackageReader package = opened_package(objects.front().package, o.memory);
    expect_content(package);
    std::optional<Mirror> mirror;  // its context ends after the session
    Headset headset;
    tell("OpenXR: " + headset.name());
    mirror.emplace(o);
    Remembered settings =
        start_settings(package, o, o.window.fresh ? std::filesystem::path() : settings_folder());
    WindowState state;
    state.panels = settings.panels;
    state.language = chosen_language(o, settings);
    use_language(state.language);
    Session session = start_session(package, o, settings, state);
    HeadsetScene scene(package, objects, o, session);
    show_in(headset, scene, state.commands, *mirror, o);
    return session.drawn.report.tiles_damaged > 0 ? int(Exit::damaged) : int(Exit::ok);
}

}  // namespace vantage
