#include "pipeline/background/depth/refine_depths.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "pipeline/background/depth/depth_smoothing.h"
#include "pipeline/background/depth/place_cost.h"

namespace vantage {
namespace {

constexpr int rounds = 3;
constexpr float edge_steps = 2;  ///< between neighbors

struct Candidate {
    float over;  ///< inverse distance minus the base's
    float cost;
};

class Refinement {
  public:
    Refinement(std::span<const CoarseView> views, const ScenePlanes& planes, const SweptDepths& coarse,
               const DirectionSphere& fine, unsigned threads)
        : coarse_(coarse),
          planes_(planes),
          fine_(fine),
          threads_(threads),
          cost_(views, coarse.center),
          base_(base_depths(fine, coarse.center, coarse.reach, planes.ground)),
          most_(base_.size()),
          over_(base_.size()) {
        for_each_direction(most_.size(), threads_,
                           [&](std::size_t v) { most_[v] = cost_.innermost(fine.directions[v]); });
    }

    /// The directions of the coarse sphere come first; each further direction bisects an edge between two of
    /// these.
    void interpolate(const std::vector<float>& inverse) {
        for (std::size_t v = 0; v < inverse.size(); ++v) over_[v] = std::max(0.0f, inverse[v] - base_[v]);
        for (std::size_t v = inverse.size(); v < base_.size(); ++v) {
            const float a = over_[fine_.ends[v][0]], b = over_[fine_.ends[v][1]];
            over_[v] = std::abs(a - b) <= edge_steps * coarse_.step ? (a + b) / 2 : b;
        }
    }

    void improve() {
        std::vector<std::uint8_t> edge(over_.size());
        for_each_direction(edge.size(), threads_,
                           [&](std::size_t v) { edge[v] = at_edge(std::uint32_t(v)); });
        std::vector<std::uint32_t> open;
        for (std::uint32_t v = 0; v < edge.size(); ++v)
            if (edge[v]) open.push_back(v);
        std::vector<std::vector<Candidate>> candidates(open.size());
        for_each_direction(open.size(), threads_,
                           [&](std::size_t i) { candidates[i] = candidates_of(open[i]); });
        for (std::size_t i = 0; i < open.size(); ++i)
            over_[open[i]] = std::ranges::min(candidates[i], {}, [&](const Candidate& c) {
                                 return c.cost + steps(open[i], c.over);
                             }).over;
    }

    std::vector<float> result() const {
        std::vector<float> out(base_.size());
        for_each_direction(out.size(), threads_, [&](std::size_t v) {
            float w = base_[v] + over_[v];
            for (const Plane& plane : planes_.walls) {
                const float on = inverse_distance(plane, coarse_.center, fine_.directions[v]);
                if (on > base_[v] && std::abs(on - w) < 2 * coarse_.step) w = on;
            }
            out[v] = std::min(w, most_[v]);
        });
        return out;
    }

  private:
    template <class Visit>
    void each_neighbor(std::uint32_t v, const Visit& visit) const {
        for (const std::uint32_t u : fine_.neighbors[v])
            if (u != DirectionSphere::none) visit(u);
    }
    bool at_edge(std::uint32_t v) const {
        float low = over_[v], high = over_[v];
        each_neighbor(
            v, [&](std::uint32_t u) { low = std::min(low, over_[u]), high = std::max(high, over_[u]); });
        return high - low > edge_steps * coarse_.step;
    }
    std::vector<Candidate> candidates_of(std::uint32_t v) const {
        std::vector<Candidate> out{{over_[v], 0}};
        each_neighbor(v, [&](std::uint32_t u) {
            const bool known = std::ranges::any_of(
                out, [&](const Candidate& c) { return std::abs(c.over - over_[u]) < coarse_.step / 2; });
            if (!known) out.push_back({over_[u], 0});
        });
        for (Candidate& c : out) c.cost = data(v, c.over);
        return out;
    }
    float alone(std::uint32_t v, float over) const {
        thread_local PlaceCost::Sights sights;
        const float w = base_[v] + over;
        cost_.aim(fine_.directions[v], w, w, sights);
        return cost_(sights, w) + (w > most_[v] ? DepthPriors::inside : 0);
    }
    float data(std::uint32_t v, float over) const {
        float sum = 2 * alone(v, over), weights = 2;
        each_neighbor(v, [&](std::uint32_t u) { sum += alone(u, over), ++weights; });
        float prior = DepthPriors::of_label(over / coarse_.step, coarse_.labels);
        for (const Plane& plane : planes_.walls) {
            const float on = inverse_distance(plane, coarse_.center, fine_.directions[v]);
            if (on > base_[v] && std::abs(on - base_[v] - over) < coarse_.step)
                prior -= DepthPriors::on_a_plane;
        }
        return sum / weights + prior;
    }
    float steps(std::uint32_t v, float over) const {
        float sum = 0;
        each_neighbor(v, [&](std::uint32_t u) { sum += step_cost(over - over_[u], coarse_.reach); });
        return sum;
    }

    const SweptDepths& coarse_;
    const ScenePlanes& planes_;
    const DirectionSphere& fine_;
    unsigned threads_;
    PlaceCost cost_;
    std::vector<float> base_, most_, over_;
};

}  // namespace

std::vector<float> refine_depths(std::span<const CoarseView> views, const ScenePlanes& planes,
                                 const SweptDepths& coarse, const std::vector<float>& inverse,
                                 const DirectionSphere& fine, unsigned threads) {
    Refinement refinement(views, planes, coarse, fine, threads);
    refinement.interpolate(inverse);
    for (int round = 0; round < rounds; ++round) refinement.improve();
    return refinement.result();
}

}  // namespace vantage
