#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "player/render/picture.h"

namespace vantage {

/// Waves of several lengths in all directions, shifted by (dx, dy) px: a picture with detail everywhere and
/// no repetition within the frame.
inline Picture waves(int width, int height, double dx = 0, double dy = 0) {
    Picture p{width, height, {}, {}};
    std::mt19937 random(5);
    struct Wave {
        double x, y, phase, size;
    };
    std::vector<Wave> waves;
    for (int i = 0; i < 24; ++i) {
        const double turn = double(random()) * 1e-9, length = 5 + 2.0 * i;
        waves.push_back(
            {6.28 / length * std::cos(turn), 6.28 / length * std::sin(turn), double(random()) * 1e-8, 10.0});
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double v = 128;
            for (const Wave& w : waves) v += w.size * std::sin(w.x * (x - dx) + w.y * (y - dy) + w.phase);
            for (const double tint : {1.0, 0.9, 0.8})
                p.rgba.push_back(std::uint8_t(std::clamp(tint * v, 0.0, 255.0)));
            p.rgba.push_back(255);
        }
    return p;
}

}  // namespace vantage
