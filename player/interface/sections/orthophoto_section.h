#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// The plane and the size of a pixel of an orthophoto, and a button to write it. `package`: has a mesh.
void orthophoto_section(Controls& controls, Session& session, const PackageReader& package);

/// The plane as the program's option --plane takes it; Plane::facing: toward a viewer at this camera.
std::string plane_option(OrthophotoRequest::Plane plane, const Navigation& camera);

}  // namespace vantage
