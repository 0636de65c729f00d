#include "player/interface/side_views.h"

#include "player/survey/picture_plane.h"
#include "player/survey/survey.h"

namespace vantage {

void side_views_menu(Controls& c, Session& s, const PackageReader& package, double now) {
    struct Side {
        const char *label, *plane;
    };
    constexpr Side sides[] = {{"From the front", "front"},
                              {"From the back", "back"},
                              {"From the left", "left"},
                              {"From the right", "right"},
                              {"From the top", "top"}};
    for (const auto& [label, plane] : sides) {
        if (!c.menu_item(label, "")) continue;
        const PicturePlane side = parse_plane(plane, survey_up(package.photos()));
        s.flight = Session::Flight{
            {s.camera, stand_beside(package.scene(), side.right, side.up, s.camera.up)}, now, 0.7};
    }
}

}  // namespace vantage
