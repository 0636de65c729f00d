#pragma once
#include "player/interface/sections/controls.h"
#include "player/interface/state/session.h"

namespace vantage {

/// Plane and pixel size of an orthophoto, and a button to write it. `package` must have a mesh.
void orthophoto_section(Controls& controls, Session& session, const PackageReader& package);

/// The plane as a value for the option --plane; Plane::facing is a plane that faces this camera.
std::string plane_option(OrthophotoRequest::Plane plane, const Navigation& camera);

}  // namespace vantage
