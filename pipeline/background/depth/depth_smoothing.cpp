#include "pipeline/background/depth/depth_smoothing.h"

#include <algorithm>
#include <cmath>

#include "base/values/simd.h"

namespace vantage {
namespace {

constexpr float jump = 0.1f;        ///< the largest cost of a step between neighbors
constexpr float unit = jump / 255;  ///< unit of the stored messages, which are at most `jump`
constexpr float slope = 0.6f;       ///< cost of a step per unit of inverse distance times the reach
constexpr int sweeps = 4;           ///< passes through all directions, alternately forward and backward

/// In each lane, replaces the cost of each label with the minimum, over all labels l, of the cost of l plus
/// the cost of the step from l, and subtracts the lane's smallest cost. `cost` contains all lanes of the
/// first label, then those of the second, and so on.
VANTAGE_SIMD void allow_steps(float* cost, std::size_t labels, float penalty) {
    Floats smallest, last, at;
    load(last, cost);
    smallest = last;
    for (std::size_t l = 1; l < labels; ++l) {
        load(at, cost + l * lanes);
        smallest = least(smallest, at);
        last = least<Floats>(at, last + penalty);
        store(last, cost + l * lanes);
    }
    for (std::size_t l = labels; l-- > 0;) {
        load(at, cost + l * lanes);
        last = least<Floats>(at, last + penalty);
        store(least<Floats>(last - smallest, Floats{} + jump), cost + l * lanes);
    }
}

/// Messages from each direction's neighbors about its labels. Updating the messages in place carries
/// information across the sphere in one sweep.
class Beliefs {
  public:
    Beliefs(const SweptDepths& d, const DirectionSphere& sphere)
        : d_(d), n_(std::size_t(d.labels)), messages_(d.shown.size() * n_ * lanes, 0), scratch_(n_ * lanes) {
        const std::vector<std::uint32_t> at = positions_of(d);
        links_.resize(d.shown.size());
        for (std::size_t i = 0; i < d.shown.size(); ++i) {
            int used = 0;
            for (const std::uint32_t u : sphere.neighbors[d.shown[i]]) {
                if (u == DirectionSphere::none || at[u] == DirectionSphere::none) continue;
                links_[i].to[used++] = at[u];
            }
            links_[i].count = used;
        }
        for (auto& links : links_)
            for (int s = 0; s < links.count; ++s) {
                const Links& other = links_[links.to[s]];
                const auto self = std::uint32_t(&links - links_.data());
                links.slot[s] = int(std::find(other.to, other.to + other.count, self) - other.to);
            }
        penalty_ = slope * d.step * float(d.reach);
    }

    void sweep(bool forth) {
        const std::size_t count = links_.size();
        for (std::size_t i = 0; i < count; ++i) send(forth ? i : count - 1 - i);
    }

    float best(std::size_t i) const {
        std::vector<float> belief(n_);
        for (std::size_t l = 0; l < n_; ++l) belief[l] = sum(i, l);
        const auto at = std::size_t(std::ranges::min_element(belief) - belief.begin());
        if (at == 0 || at + 1 == n_) return float(at);
        const float bend = belief[at - 1] - 2 * belief[at] + belief[at + 1];
        return float(at) +
               (bend > 0 ? std::clamp((belief[at - 1] - belief[at + 1]) / (2 * bend), -0.5f, 0.5f) : 0);
    }

  private:
    struct Links {
        std::uint32_t to[6];
        int slot[6];  ///< this direction's index among that neighbor's neighbors
        int count = 0;
    };
    float sum(std::size_t i, std::size_t l) const {
        const std::uint8_t* m = &messages_[(i * n_ + l) * lanes];
        return d_.cost[i * n_ + l] + unit * float(m[0] + m[1] + m[2] + m[3] + m[4] + m[5]);
    }
    /// Sends the messages of direction i to all its neighbors: its belief without the neighbor's own message,
    /// plus the cost of the step.
    void send(std::size_t i) {
        for (std::size_t l = 0; l < n_; ++l) {
            const float belief = sum(i, l);
            const std::uint8_t* m = &messages_[(i * n_ + l) * lanes];
            for (std::size_t s = 0; s < lanes; ++s) scratch_[l * lanes + s] = belief - unit * float(m[s]);
        }
        allow_steps(scratch_.data(), n_, penalty_);
        for (int s = 0; s < links_[i].count; ++s) {
            std::uint8_t* to = &messages_[links_[i].to[s] * n_ * lanes + std::size_t(links_[i].slot[s])];
            for (std::size_t l = 0; l < n_; ++l)
                to[l * lanes] = std::uint8_t(scratch_[l * lanes + std::size_t(s)] / unit + 0.5f);
        }
    }

    const SweptDepths& d_;
    std::size_t n_;
    std::vector<std::uint8_t> messages_;  ///< messages by direction and label, one lane per neighbor
    std::vector<float> scratch_;
    std::vector<Links> links_;
    float penalty_ = 0;
};

}  // namespace

float step_cost(float difference, double reach) {
    return std::min(slope * float(reach) * std::abs(difference), jump);
}

std::vector<float> inverse_distances(const SweptDepths& d, const DirectionSphere& sphere) {
    Beliefs beliefs(d, sphere);
    for (int s = 0; s < sweeps; ++s) beliefs.sweep(s % 2 == 0);
    std::vector<float> out = d.base;
    std::vector<std::uint8_t> unknown(out.size(), 1);
    std::vector<float> over(out.size(), 0);
    for (std::size_t i = 0; i < d.shown.size(); ++i) {
        const std::uint32_t v = d.shown[i];
        over[v] = beliefs.best(i) * d.step;
        for (const std::vector<float>& plane : d.planes)
            if (plane[i] > 0 && std::abs(plane[i] - d.base[v] - over[v]) < 2 * d.step)
                over[v] = plane[i] - d.base[v];
        unknown[v] = 0;
    }
    relax(sphere, unknown, 64, over);
    for (std::size_t v = 0; v < out.size(); ++v) out[v] = std::min(out[v] + over[v], d.most[v]);
    return out;
}

}  // namespace vantage
