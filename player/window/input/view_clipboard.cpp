#include "player/window/input/view_clipboard.h"

#include <imgui.h>

#include "base/files/shell_word.h"
#include "base/text/error.h"
#include "base/text/translation.h"
#include "player/interface/state/failure_text.h"
#include "player/view/camera_path.h"
#include "player/view/shots.h"

namespace vantage {
namespace {

void copy(Session& s, const PackageReader& package, double now) {
    const std::string command = "vantage-player " + shell_word(package.path().string()) + " --view " +
                                view_text(s.viewpoint.camera, package);
    ImGui::SetClipboardText(command.c_str());
    say(s.message, tr("The view is copied as a command line"), now);
}

/// The numbers after --view if the text is a command line, otherwise the whole text.
std::string view_in(const std::string& text) {
    const std::string option = "--view";
    const std::size_t at = text.find(option);
    if (at == std::string::npos) return text;
    const std::size_t from = text.find_first_not_of(" =", at + option.size());
    return from == std::string::npos ? "" : text.substr(from, text.find_first_of(" \n", from) - from);
}

void paste(Session& s, const std::string& text, const PackageReader& package, double now) {
    if (text.empty()) return;
    try {
        const auto [view, distance] = parse_view_and_distance(view_in(text), package, {1280, 720});
        Navigation to = stand_at(view, s.viewpoint.camera.up, distance);
        to.aspect = s.viewpoint.camera.aspect;
        start_flight(s.viewpoint, to, now, 0.7);
    } catch (const Error& e) {
        say(s.message, failure_text(tr("The clipboard has no view of this scene."), e), now);
    }
}

}  // namespace

void use_clipboard(Session& s, const PackageReader& package, double now) {
    while (const auto command = take_one_of<CopyView, PasteView>(s.window.commands)) {
        if (const auto* const pasted = std::get_if<PasteView>(&*command))
            paste(s, pasted->text, package, now);
        else
            copy(s, package, now);
    }
}

}  // namespace vantage
