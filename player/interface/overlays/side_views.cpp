#include "player/interface/overlays/side_views.h"

#include "base/text/translation.h"
#include "player/survey/picture_plane.h"
#include "player/survey/survey.h"

namespace vantage {

void side_views_menu(Controls& c, Viewpoint& viewpoint, const PackageReader& package, double now) {
    struct Side {
        const char *label, *plane;
    };
    constexpr Side sides[] = {{marked("From the front"), "front"},
                              {marked("From the back"), "back"},
                              {marked("From the left"), "left"},
                              {marked("From the right"), "right"},
                              {marked("From the top"), "top"}};
    for (const auto& [label, plane] : sides) {
        if (!c.menu_item(label, "")) continue;
        const PicturePlane side = parse_plane(plane, up_of(package.scene()));
        start_flight(viewpoint, stand_beside(package.scene(), side.right, side.up, viewpoint.camera.up), now,
                     0.7);
    }
}

}  // namespace vantage
