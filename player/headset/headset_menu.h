#pragma once
#include "player/composition/object_set.h"
#include "player/headset/locomotion/walk.h"
#include "player/interface/sections/measure_panel.h"
#include "player/interface/state/session.h"
#include "player/interface/tour/note_picture.h"
#include "player/interface/tour/told_story.h"

namespace vantage {

/// The pages of the menu.
enum class MenuPage {
    move,
    photos,
    picture,
    blending,
    layers,
    points,
    image_sets,
    objects,
    cut,
    measure,
    story,
    status,
    count
};

/// What the menu shows and changes, beside the session.
struct MenuContent {
    Renderer& renderer;
    ObjectSet& objects;
    MeasurePanel& measure;
    ToldStory& told;
    NotePicture& note_picture;
    Walk& walk;
    double& unit_meters;  ///< 0: unknown
    bool& vignette;       ///< while flying, the edges of the picture are dark
};

/// The menu in a headset, on a panel of this size, with large controls: the same settings as the window's.
void headset_menu(Controls& controls, Session& session, MenuPage& page, const MenuContent& content, int width,
                  int height, double now);

}  // namespace vantage
