#pragma once
#include <filesystem>

namespace vantage {

/// The specification of a synthetic scene, as in data/*.toml. Lengths are in meters, angles in degrees.
struct SynthSpec {
    unsigned seed = 1;
    bool height_field = false;  ///< the mesh has the height above the ground as a scalar field
    struct Building {
        double width = 12, height = 7.5, depth = 6, recess = 0.7;
        int bays = 5, floors = 2;
        double max_edge = 0;  ///< longest side of the walls' quads; 0: not subdivided
        bool chapel = false;  ///< a chapel with an urn instead; recess, bays and floors are ignored
    } building;
    struct Object {
        double size = 1.3;  ///< radius of the torus knot, or 2/3 of the urn's height
        int triangles = 40000;
        double distance = 3;  ///< from the facade
    } object;
    struct Garden {
        double radius = 0;   ///< radius of the lawn or meadow; 0: no garden, and a sky without clouds
        double hill = 8;     ///< height of the hill at twice the radius or, with a chapel, of hills 4 km away
        double railing = 0;  ///< thickness of the bars in front of the upper windows; 0: none
    } garden;                ///< in the photos, but not in the mesh
    struct Glass {
        double alpha = 0;     ///< alpha of a glass case around the object; 0: none
        double max_edge = 0;  ///< as in Building
    } glass;                  ///< in the mesh, but not in the photos
    struct Photos {
        int count = 12, width = 1200, height = 900;
        double fov = 55;             ///< horizontal field of view
        double radius = 13;          ///< radius of the arc in front of the facade
        double arc = 100;            ///< angle of the arc
        double low = 1.7, high = 5;  ///< camera heights, alternating
        int samples = 3;             ///< rays per pixel along x, and along y
    } photos;
    struct Infrared {
        int count = 0;  ///< number of infrared photos, in a separate image set; 0: none
        int width = 800, height = 600;
        double fov = 50;   ///< horizontal field of view
        double stops = 0;  ///< exposure of all infrared photos
    } infrared;            ///< shows an underdrawing on plaster that cannot be seen in visible light
    struct Lens {
        double k1 = 0, k2 = 0;  ///< radial, OpenCV
    } lens;
    struct Exposure {
        double stops = 0;          ///< random exposure of each photo, at most +/- this many stops
        double white_balance = 0;  ///< additional random variation per channel, at most +/- this many stops
        double vignetting = 0;     ///< fraction of the light lost at the corners
    } exposure;
    struct Error {
        double pixels = 0;  ///< error of each camera in the input, in px at the facade
    } error;
};

/// Throws an Error(input) that names the file and the key if a key is unknown or its value has the wrong type
/// or is out of range.
SynthSpec read_spec(const std::filesystem::path& file);

}  // namespace vantage
