#include "player/window/loaded_scene.h"

#include "player/window/start_session.h"

namespace vantage {

LoadedScene::LoadedScene(const PackageReader& package, const std::vector<SceneObject>& all,
                         const ShowOptions& o, Session& session)
    : renderer(package, memory_budget(o.memory)),
      objects(renderer, all, memory_budget(o.memory)),
      measure(package),
      active(active_story(o.package.file, input_axes(package), session.window.language)),
      language(session.window.language) {
    begin_in_scene(session, package, active, o);
}

void LoadedScene::attend(const Session& session) {
    follow_language(active, language, session.window.language);
    note_picture.attend();
}

}  // namespace vantage
