#include "player/interface/sections/orthophoto_section.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "base/values/round_up.h"
#include "player/interface/sections/choice.h"
#include "player/survey/picture_plane.h"
#include "player/survey/survey.h"

namespace vantage {
namespace {

constexpr double longest_side = 30000;  // pixels: about a gigapixel in total

/// A pixel size of 1, 2 or 5 times a power of ten, for which a side has 2000 to 5000 pixels.
double fitting_pixel(double longer_side) { return round_up(std::max(longer_side / 5000, 1e-12)); }

/// The size of the model's extent on the plane, in input units.
Eigen::Vector2d size_on(const std::string& plane, const PackageReader& package) {
    return extent_on(parse_plane(plane, up_of(package.scene())), package.scene()).sizes();
}

}  // namespace

std::string plane_option(OrthophotoRequest::Plane plane, const Navigation& camera) {
    static const char* const names[] = {"top", "front", "back", "left", "right"};
    if (plane != OrthophotoRequest::Plane::facing) return names[int(plane)];
    const Eigen::Vector3d normal = -camera.R.row(2).transpose(), up = -camera.R.row(1).transpose();
    return formatted("0,0,0,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g", normal.x(), normal.y(), normal.z(), up.x(),
                     up.y(), up.z());
}

void orthophoto_section(Controls& c, Session& s, const PackageReader& package) {
    OrthophotoRequest& o = s.orthophoto;
    static const char* const planes[] = {marked("top"),  marked("front"), marked("back"),
                                         marked("left"), marked("right"), marked("my view")};
    const auto before = o.plane;
    choice(c, "Seen from", o.plane, planes);
    c.explain("The side from which the model is projected, true to scale.");
    const Eigen::Vector2d size = size_on(plane_option(o.plane, s.viewpoint.camera), package);
    if (o.pixel <= 0 || o.plane != before) o.pixel = fitting_pixel(size.maxCoeff());
    c.number("Size of a pixel", &o.pixel, "%.6g");
    c.explain("In the model's unit.");
    const double least = std::max(size.maxCoeff() / longest_side, 1e-12);
    o.pixel = std::isfinite(o.pixel) ? std::clamp(o.pixel, least, std::max(least, size.maxCoeff())) : least;
    const Eigen::Vector2d pixels = (size / o.pixel).array().ceil().max(1);
    ImGui::Text(tr("%.0f × %.0f pixels"), pixels.x(), pixels.y());
    static const char* const files[] = {marked("PNG and world file"), marked("GeoTIFF")};
    choice(c, "Written as", o.file, files);
    c.explain("Both formats store the position of the picture on the plane.");
    ImGui::BeginDisabled(o.writing);
    if (c.button("Write the orthophoto")) s.window.commands.push_back(SaveOrthophoto{});
    ImGui::EndDisabled();
    c.explain("Writes the picture next to the package; the window remains usable.");
    if (o.writing) ImGui::TextUnformatted(tr("being written..."));
}

}  // namespace vantage
