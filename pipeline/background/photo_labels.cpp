#include "pipeline/background/photo_labels.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>

#include "pipeline/background/view_sample.h"

namespace vantage {
namespace {

constexpr std::uint8_t none = BackdropPaint::none;
constexpr int cut_level = 5;  ///< level of the sphere on which the graph cuts run
constexpr int rounds_of_cuts = 2;
constexpr float invalid = 1e3f;  ///< cost of a view that does not show the point
// Costs; color differences are in square roots of light.
constexpr float from_median = 4, most_from_median = 0.4f;
constexpr float next_to_mesh = 1, mesh_reach = 3.25f;      ///< texels
constexpr float next_to_frame = 0.5f, frame_reach = 6.5f;  ///< texels
constexpr float coarser = 0.3f;                            ///< cost per halving of the resolution
/// Cost of a view without sky where another shows sky.
constexpr float not_sky = 0.5f;
constexpr float seam = 0.02f, seam_contrast = 3;

/// One view's sample of a direction, with the cost `invalid` if there is no sample.
struct Shown {
    float cost = invalid;
    /// Whether the photo contains the point, possibly behind the mesh.
    bool inside = false;
    Eigen::Array3f color = Eigen::Array3f::Zero();  ///< square root of light
};

class Photos {
  public:
    Photos(const Backdrop& backdrop, std::span<const CoarseView> views) : backdrop_(backdrop), views_(views) {
        for (const CoarseView& v : views) {
            cv::Mat1b open(v.k.height, v.k.width, uchar(0));
            for (std::size_t at = 0; at < v.ln.size(); ++at) open.ptr()[at] = v.is_open(at);
            cv::Mat1f distance;
            cv::distanceTransform(open, distance, cv::DIST_L2, 3, CV_32F);
            to_mesh_.push_back(distance);
        }
    }
    /// The samples of a direction in all views.
    void show(std::uint32_t d, std::vector<Shown>& out) const {
        out.assign(views_.size(), Shown{});
        thread_local std::vector<Eigen::Array3f> colors;
        thread_local std::vector<float> densities;
        thread_local std::vector<std::uint8_t> sky;
        colors.clear(), densities.assign(views_.size(), 0), sky.assign(views_.size(), 0);
        bool any_sky = false;
        float finest = 0;
        for (std::size_t i = 0; i < views_.size(); ++i) {
            const CoarseView& v = views_[i];
            const Eigen::Vector3f p = in_camera(v, backdrop_.positions[d]);
            const ViewSample s = sample(v, p, 1);
            out[i].inside = s.kind != ViewSample::nothing;
            if (s.kind != ViewSample::open) continue;
            const float x = s.pixel.x(), y = s.pixel.y(), mesh = to_mesh_[i](int(y), int(x)),
                        frame = std::min({x, y, float(v.k.width) - x, float(v.k.height) - y});
            out[i].color = root_of(s.ln);
            out[i].cost = next_to_mesh * std::max(0.0f, 1 - mesh / mesh_reach) +
                          next_to_frame * std::max(0.0f, 1 - frame / frame_reach);
            colors.push_back(out[i].color);
            densities[i] = float(v.k.fx) / p.z() / float(v.k.width);
            finest = std::max(finest, densities[i]);
            sky[i] = backdrop_.sky.at(i, v, s);
            any_sky |= sky[i];
        }
        if (colors.empty()) return;
        const Eigen::Array3f middle = median(colors);
        const bool high = -backdrop_.sphere.directions[d].dot(backdrop_.sky.down) > lowest_alone;
        for (std::size_t i = 0; i < out.size(); ++i) {
            if (out[i].cost >= invalid) continue;
            if (colors.size() >= 3)
                out[i].cost += from_median * std::min((out[i].color - middle).abs().mean(), most_from_median);
            out[i].cost += coarser * std::log2(std::max(finest / densities[i], 1.0f));
            if (any_sky && !sky[i]) out[i].cost += not_sky;
            if (backdrop_.sky.any() && high && colors.size() == 1 && !sky[i]) out[i].cost = invalid;
        }
    }

  private:
    const Backdrop& backdrop_;
    std::span<const CoarseView> views_;
    std::vector<cv::Mat1f> to_mesh_;
};

using Labels = std::vector<std::uint8_t>;

/// The color difference of two views at a point, for the cost of a seam; a constant if one of the colors is
/// unknown.
float contrast(const std::vector<Shown>& at, std::uint8_t a, std::uint8_t b) {
    if (at[a].cost >= invalid || at[b].cost >= invalid) return most_from_median / 2;
    return (at[a].color - at[b].color).abs().mean();
}
float seam_cost(const std::vector<Shown>& u, const std::vector<Shown>& v, std::uint8_t a, std::uint8_t b) {
    return a == b ? 0 : seam + seam_contrast * (contrast(u, a, b) + contrast(v, a, b));
}

std::uint8_t cheapest(const std::vector<Shown>& at) {
    const auto best = std::ranges::min_element(at, {}, &Shown::cost);
    return best == at.end() || best->cost >= invalid ? none : std::uint8_t(best - at.begin());
}

/// Computes the labels of the coarse sphere by alpha expansion.
class Cuts {
  public:
    Cuts(const DirectionSphere& sphere, const std::vector<std::vector<Shown>>& shown, Labels& labels)
        : sphere_(sphere), shown_(shown), labels_(labels), node_(labels.size(), -1) {
        for (std::uint32_t d = 0; d < labels.size(); ++d)
            if (labels[d] != none) node_[d] = int(directions_.size()), directions_.push_back(d);
    }

    void expand(std::uint8_t alpha) {
        const bool shows = std::ranges::any_of(
            directions_, [&](std::uint32_t d) { return shown_[d][alpha].cost < invalid; });
        if (!shows) return;
        Graph graph(unsigned(directions_.size()), unsigned(3 * directions_.size()));
        for (std::size_t i = 0; i < directions_.size(); ++i) graph.addVtx();
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            const std::uint32_t u = directions_[i];
            // Directions on the source's side keep their labels.
            graph.addTermWeights(int(i), units(shown_[u][alpha].cost), units(shown_[u][labels_[u]].cost));
            for (const std::uint32_t v : sphere_.neighbors[u])
                if (v != DirectionSphere::none && v > u && node_[v] >= 0) add_edge(graph, u, v, alpha);
        }
        graph.maxFlow();
        for (std::size_t i = 0; i < directions_.size(); ++i)
            if (!graph.inSourceSegment(int(i)) && shown_[directions_[i]][alpha].cost < invalid)
                labels_[directions_[i]] = alpha;
    }

  private:
    using Graph = cv::detail::GCGraph<int>;
    static int units(float cost) { return int(std::lround(1000 * cost)); }

    /// Adds the costs of a pair of directions as terminal weights and one edge (Kolmogorov and Zabih 2004).
    /// The cost is 0 if both directions take the label alpha.
    void add_edge(Graph& graph, std::uint32_t u, std::uint32_t v, std::uint8_t alpha) const {
        const int keep = units(cost(u, v, labels_[u], labels_[v])),
                  only_v = units(cost(u, v, labels_[u], alpha)),
                  only_u = units(cost(u, v, alpha, labels_[v]));
        graph.addTermWeights(node_[u], only_u, keep);
        graph.addTermWeights(node_[v], 0, only_u);
        graph.addEdges(node_[u], node_[v], std::max(only_v + only_u - keep, 0), 0);
    }
    float cost(std::uint32_t u, std::uint32_t v, std::uint8_t a, std::uint8_t b) const {
        return seam_cost(shown_[u], shown_[v], a, b);
    }

    const DirectionSphere& sphere_;
    const std::vector<std::vector<Shown>>& shown_;
    Labels& labels_;
    std::vector<int> node_;
    std::vector<std::uint32_t> directions_;
};

/// Labels of the next subdivision: the cheaper of the labels at the two ends of the bisected edge. At seams,
/// the cheapest of all neighbors' labels.
Labels refined(const Photos& photos, const DirectionSphere& sphere, const Labels& coarse, unsigned threads) {
    constexpr int rounds = 2;
    Labels out(sphere.directions.size(), none);
    std::ranges::copy(coarse, out.begin());
    for_each_direction(out.size(), threads, [&](std::size_t d) {
        if (d < coarse.size() && coarse[d] != none) return;
        thread_local std::vector<Shown> shown;
        photos.show(std::uint32_t(d), shown);
        const auto [a, b] = sphere.ends[d];
        const auto cost = [&](std::uint8_t l) { return l == none ? invalid : shown[l].cost; };
        const std::uint8_t l = cost(coarse[a]) <= cost(coarse[b]) ? coarse[a] : coarse[b];
        out[d] = cost(l) < invalid ? l : cheapest(shown);
    });
    std::vector<std::uint32_t> at_seams;
    for (std::uint32_t d = 0; d < out.size(); ++d)
        if (std::ranges::any_of(sphere.neighbors[d], [&](std::uint32_t n) {
                return n != DirectionSphere::none && out[n] != out[d] && out[d] != none && out[n] != none;
            }))
            at_seams.push_back(d);
    std::vector<std::vector<Shown>> shown(at_seams.size());
    for_each_direction(at_seams.size(), threads, [&](std::size_t i) { photos.show(at_seams[i], shown[i]); });
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < at_seams.size(); ++i) {
            const std::uint32_t d = at_seams[i];
            const auto cost = [&](std::uint8_t l) {
                float sum = shown[i][l].cost;
                for (const std::uint32_t n : sphere.neighbors[d])
                    if (n != DirectionSphere::none && out[n] != none)
                        sum += seam_cost(shown[i], shown[i], l, out[n]);
                return sum;
            };
            float best = cost(out[d]);
            for (const std::uint32_t n : sphere.neighbors[d])
                if (n != DirectionSphere::none && out[n] != none && shown[i][out[n]].cost < invalid)
                    if (const float c = cost(out[n]); c < best) best = c, out[d] = out[n];
        }
    return out;
}

/// Corrections on the coarse sphere: smooth within a label, and differing at seams by the difference of the
/// photos' colors. Minimizes the sum over edges of |x_u - x_v - (color_v - color_u)|^2, where the colors of
/// both labels are known, plus |x|^2 / reach^2, by successive overrelaxation.
std::vector<Eigen::Array3f> coarse_corrections(const DirectionSphere& sphere, const Labels& labels,
                                               const std::vector<std::vector<Shown>>& shown) {
    constexpr int rounds = 120;
    constexpr float reach = 10, relaxation = 1.6f, most = 0.2f, doubtful = 0.1f;
    struct Edge {
        std::uint32_t v;
        float weight;
        Eigen::Array3f step;  ///< x_u - x_v
    };
    std::vector<std::vector<Edge>> edges(labels.size());
    for (std::uint32_t u = 0; u < labels.size(); ++u)
        for (const std::uint32_t v : sphere.neighbors[u]) {
            if (labels[u] == none || v == DirectionSphere::none || labels[v] == none) continue;
            Edge e{v, 1, Eigen::Array3f::Zero()};
            if (const auto a = labels[u], b = labels[v]; a != b) {
                int known = 0;
                for (const std::uint32_t d : {u, v})
                    if (shown[d][a].cost < invalid && shown[d][b].cost < invalid)
                        e.step += shown[d][b].color - shown[d][a].color, ++known;
                if (known == 0) continue;
                e.step = (e.step / float(known)).max(-most).min(most);
                const float off = e.step.abs().mean() / doubtful;
                e.weight = 1 / (1 + off * off);
            }
            edges[u].push_back(e);
        }
    std::vector<Eigen::Array3f> x(labels.size(), Eigen::Array3f::Zero());
    for (int round = 0; round < rounds; ++round)
        for (std::uint32_t u = 0; u < x.size(); ++u) {
            if (edges[u].empty()) continue;
            Eigen::Array3f sum = Eigen::Array3f::Zero();
            float weights = 1 / (reach * reach);
            for (const Edge& e : edges[u]) sum += e.weight * (x[e.v] + e.step), weights += e.weight;
            x[u] += relaxation * (sum / weights - x[u]);
        }
    return x;
}

/// Interpolates corrections to the next subdivision, within a label or across the seam.
std::vector<Eigen::Array3f> refined(const std::vector<Eigen::Array3f>& coarse, const Labels& old_labels,
                                    const Photos& photos, const DirectionSphere& sphere, const Labels& labels,
                                    unsigned threads) {
    std::vector<Eigen::Array3f> out(labels.size(), Eigen::Array3f::Zero());
    for_each_direction(labels.size(), threads, [&](std::size_t d) {
        const std::uint8_t label = labels[d];
        if (label == none) return;
        if (d < coarse.size() && old_labels[d] == label) {
            out[d] = coarse[d];
            return;
        }
        Eigen::Array3f sum = Eigen::Array3f::Zero();
        float count = 0;
        for (const std::uint32_t e : sphere.ends[d])
            if (old_labels[e] == label) sum += coarse[e], ++count;
        thread_local std::vector<Shown> shown;
        if (count == 0) photos.show(std::uint32_t(d), shown);
        for (const std::uint32_t e : sphere.ends[d])
            if (count == 0 && old_labels[e] != none && shown[old_labels[e]].cost < invalid)
                sum += coarse[e] + shown[old_labels[e]].color - shown[label].color, ++count;
        if (count > 0) out[d] = sum / count;
    });
    return out;
}

/// 0 in directions that are in no photo, rising within a few steps to 1 in directions that are in at least
/// three photos.
std::vector<float> trust_of(const DirectionSphere& sphere, const std::vector<std::vector<Shown>>& shown) {
    constexpr float of_few[] = {0, 0.7f, 0.9f, 1};  // views
    constexpr int steps = 2;
    std::vector<int> away(shown.size(), steps + 1);
    std::vector<std::ptrdiff_t> inside;
    for (const auto& views : shown) inside.push_back(std::ranges::count_if(views, &Shown::inside));
    for (std::size_t d = 0; d < away.size(); ++d)
        if (inside[d] == 0) away[d] = 0;
    for (int step = 1; step <= steps; ++step)
        for (std::size_t d = 0; d < away.size(); ++d)
            if (away[d] > step && std::ranges::any_of(sphere.neighbors[d], [&](std::uint32_t n) {
                    return n != DirectionSphere::none && away[n] == step - 1;
                }))
                away[d] = step;
    std::vector<float> out;
    constexpr float of_steps[] = {0, 0.7f, 0.85f, 1};
    for (std::size_t d = 0; d < away.size(); ++d)
        out.push_back(std::min(of_steps[away[d]], of_few[std::min<std::ptrdiff_t>(inside[d], 3)]));
    return out;
}

}  // namespace

BackdropPaint paint_backdrop(const Backdrop& backdrop, std::span<const CoarseView> views, unsigned threads) {
    const Photos photos(backdrop, views);
    DirectionSphere sphere = direction_sphere(cut_level);
    std::vector<std::vector<Shown>> shown(sphere.directions.size());
    Labels labels(shown.size());
    for_each_direction(shown.size(), threads, [&](std::size_t d) {
        photos.show(std::uint32_t(d), shown[d]);
        labels[d] = cheapest(shown[d]);
    });
    Cuts cuts(sphere, shown, labels);
    for (int round = 0; round < rounds_of_cuts; ++round)
        for (std::size_t l = 0; l < views.size(); ++l) cuts.expand(std::uint8_t(l));
    BackdropPaint out{labels, coarse_corrections(sphere, labels, shown), trust_of(sphere, shown)};
    while (sphere.directions.size() < backdrop.positions.size()) {
        sphere = divided(sphere);
        Labels finer = refined(photos, sphere, out.view, threads);
        out.correction = refined(out.correction, out.view, photos, sphere, finer, threads);
        for (std::size_t d = out.trust.size(); d < finer.size(); ++d)
            out.trust.push_back((out.trust[sphere.ends[d][0]] + out.trust[sphere.ends[d][1]]) / 2);
        out.view = std::move(finer);
    }
    return out;
}

}  // namespace vantage
