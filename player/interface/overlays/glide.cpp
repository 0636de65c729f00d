#include "player/interface/overlays/glide.h"

#include <algorithm>
#include <cmath>

namespace vantage {
namespace {

constexpr double seconds = 0.25;         // time constant of the speed's decay
constexpr double looked_back = 0.1;      // seconds of movement considered
constexpr double longest_pause = 0.04;   // maximum time in seconds without movement before the release
constexpr std::size_t least_frames = 4;  // minimum number considered, for low frame rates
constexpr double least_speed = 50;       // pixels per second

double length(const Drag& d) { return std::hypot(d.right, d.down); }

double longest(const Drags& drags) {
    return std::max({length(drags[0]), length(drags[1]), length(drags[2])});
}

void add(Drags& to, const Drags& drags, double factor) {
    for (std::size_t b = 0; b < to.size(); ++b) {
        to[b].right += factor * drags[b].right;
        to[b].down += factor * drags[b].down;
    }
}

void note(Glide& g, const Drags& drags, double now) {
    g.recent.push_back({now, drags});
    while (g.recent.size() > least_frames && g.recent[1].at < now - looked_back)
        g.recent.erase(g.recent.begin());
}

/// The distance that a drag covers after its release.
Drags let_go(const std::vector<Glide::Movement>& recent) {
    Drags moved{};
    int frames = 0;
    std::size_t last = 0;
    for (std::size_t i = 1; i < recent.size(); ++i) {
        if (longest(recent[i].drags) > 0) ++frames, last = i;
        add(moved, recent[i].drags, 1);
    }
    if (frames < 2) return {};
    const double took = recent.back().at - recent.front().at;
    const bool paused = last + 2 < recent.size() && recent.back().at - recent[last].at > longest_pause;
    if (paused || !(longest(moved) > least_speed * took) || !(took > 0)) return {};
    Drags ahead{};
    add(ahead, moved, seconds / took);
    return ahead;
}

}  // namespace

Drags move_on(Glide& g, const Drags& drags, bool held, double now) {
    if (held || longest(drags) > 0) {
        if (!g.held) g = {}, g.held = true;
        note(g, drags, now);
        g.at = now;
        return drags;
    }
    if (g.held) g.ahead = let_go(g.recent), g.held = false;
    Drags by{};
    if (longest(g.ahead) == 0) return by;
    const double share = 1 - std::exp(-std::max(0.0, now - g.at) / seconds);
    g.at = now;
    add(by, g.ahead, share);
    add(g.ahead, by, -1);
    if (longest(g.ahead) < 0.5) g.ahead = {};
    return by;
}

}  // namespace vantage
