#include "player/interface/overlays/side_views.h"

#include <imgui.h>

#include <Eigen/Geometry>

#include "base/text/translation.h"
#include "player/survey/picture_plane.h"
#include "player/survey/survey.h"
#include "player/view/photo_directions.h"

namespace vantage {

/// Angle in radians from the photos' directions beyond which hardly any photo shows the side.
constexpr double most_angle = 1.2;

void side_views_menu(Controls& c, Session& s, const PackageReader& package, double now) {
    struct Side {
        const char *label, *plane;
    };
    constexpr Side sides[] = {{marked("From the front"), "front"},
                              {marked("From the back"), "back"},
                              {marked("From the left"), "left"},
                              {marked("From the right"), "right"},
                              {marked("From the top"), "top"}};
    for (const auto& [label, plane] : sides) {
        const PicturePlane side = parse_plane(plane, up_of(package.scene()));
        const double angle = angle_from_photos(package.photos(), side.up.cross(side.right));
        ImGui::BeginDisabled(s.movement.near_photos && !s.viewpoint.orthographic && angle > most_angle);
        const bool chosen = c.menu_item(label, "");
        ImGui::EndDisabled();
        if (!chosen) continue;
        start_flight(s.viewpoint, stand_beside(package.scene(), side.right, side.up, s.viewpoint.camera.up),
                     now, 0.7);
    }
}

}  // namespace vantage
