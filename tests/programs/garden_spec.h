#pragma once
#include "tests/made_scenes.h"

namespace vantage {

/// A small building surrounded by a lawn and a hill, in wide-angle photos of the given size.
inline SynthSpec garden_spec(int triangles, int width, int height) {
    SynthSpec spec = spec_named("small");
    spec.building.width = 7, spec.building.height = 4.5, spec.building.bays = 3;
    spec.garden = {.radius = 30, .hill = 8, .railing = 0.04};
    spec.object.triangles = triangles;
    spec.photos.width = width, spec.photos.height = height, spec.photos.fov = 75;
    spec.photos.samples = 1;
    return spec;
}

}  // namespace vantage
