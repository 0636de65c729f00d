#pragma once
#include <filesystem>

namespace vantage {

/// A synthetic scene as data/*.toml describes it. Lengths in metres, angles in degrees.
struct SynthSpec {
    unsigned seed = 1;
    struct Building {
        double width = 12, height = 7.5, depth = 6, recess = 0.7;
        int bays = 5, floors = 2;
        double max_edge = 0;  ///< longest edge of a wall's triangles; 0: two triangles a wall piece
    } building;
    struct Object {
        double size = 1.3;  ///< radius of the torus knot
        int triangles = 40000;
        double distance = 3;  ///< in front of the facade
    } object;
    struct Photos {
        int count = 12, width = 1200, height = 900;
        double fov = 55;             ///< horizontal
        double radius = 13;          ///< of the arc in front of the facade
        double arc = 100;            ///< its angle
        double low = 1.7, high = 5;  ///< camera heights, alternating
        int samples = 3;             ///< along a pixel's side
    } photos;
    struct Lens {
        double k1 = 0, k2 = 0;  ///< radial, OpenCV
    } lens;
    struct Exposure {
        double stops = 0;          ///< photos differ by up to this much to either side
        double white_balance = 0;  ///< stops, a channel, on top of it
        double falloff = 0;        ///< share of the light that the lens loses in the corner
    } exposure;
    struct Error {
        double pixels = 0;  ///< by how much each written camera is off, at the facade
    } error;
};

/// Throws Error(input) naming the file and the key that is unknown, of the wrong type or out of range.
SynthSpec read_spec(const std::filesystem::path& file);

}  // namespace vantage
