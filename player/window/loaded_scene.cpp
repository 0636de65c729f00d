#include "player/window/loaded_scene.h"

#include "base/text/translation.h"
#include "player/window/start_session.h"

namespace vantage {

LoadedScene::LoadedScene(const PackageReader& package, const std::vector<SceneObject>& all,
                         const ShowOptions& o, Session& session)
    : renderer(package, memory_budget(o.memory)),
      objects(renderer, all, memory_budget(o.memory)),
      measure(package),
      active(active_story(o.package.file, input_axes(package), session.window.language)),
      language(session.window.language) {
    use_language(active.language);
    hide_pieces();
    begin_in_scene(session, package, active, o);
}

/// Hides the story's pieces in the first object.
bool LoadedScene::hide_pieces() {
    if (hidden == active.story.hidden) return false;
    hidden = active.story.hidden;
    renderer.hide(hidden_balls(active.story, active.axes));
    return true;
}

bool LoadedScene::attend(const Session& session) {
    follow_language(active, language, session.window.language);
    note_picture.attend();
    return hide_pieces();
}

}  // namespace vantage
