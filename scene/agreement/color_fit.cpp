#include "scene/agreement/color_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "base/values/quantile.h"

namespace vantage {
namespace {

constexpr double scale = 0.12;         ///< scale of the robust weights, in ln of linear light
constexpr double initial_scale = 0.6;  ///< halved in every iteration until it reaches `scale`
constexpr int iterations = 5;
constexpr int min_photos = 3;  ///< photos per lens that are needed to separate vignetting from the subject
constexpr double max_gain = 4;
constexpr double min_corner = 0.05, max_corner = 0.6;  ///< fraction of light lost in the corner
constexpr double min_improvement = 0.02;  ///< the relative amount by which vignetting must reduce the cost

/// The unknowns of the fit, and the number of vignetting terms per lens.
struct Model {
    Eigen::MatrixXd gain;        ///< photos x 3
    Eigen::VectorXd vignetting;  ///< 3 per lens
    std::vector<int> terms;
    std::span<const std::uint32_t> lens;

    Vignetting of_lens(std::size_t l) const {
        const auto at = 3 * Eigen::Index(l);
        return {vignetting[at], vignetting[at + 1], vignetting[at + 2]};
    }
    Eigen::Vector3d corrected(const Observation& o) const {
        const double lost = log_vignetting_at_square(of_lens(lens[o.photo]), double(o.radius2));
        Eigen::Vector3d out;
        for (int c = 0; c < 3; ++c) out[c] = double(o.ln[c]) + gain(o.photo, c) + lost;
        return out;
    }
};

/// Calls visit(observation, e^2), where e^2 is the squared residual from the disc's weighted mean color,
/// averaged over the channels.
template <class Visit>
void each_residual(const SharedDiscs& obs, const Model& m, const std::vector<double>& weights,
                   const Visit& visit) {
    std::vector<Eigen::Vector3d> colors;  // of one disc
    obs.each_disc([&](std::span<const Observation> disc, std::size_t at) {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        double sum = 0;
        colors.clear();
        for (std::size_t i = 0; i < disc.size(); ++i) {
            const double w = weights[at + i];
            colors.push_back(m.corrected(disc[i]));
            mean += w * colors.back();
            sum += w;
        }
        mean /= sum;
        for (std::size_t i = 0; i < disc.size(); ++i) visit(at + i, (colors[i] - mean).squaredNorm() / 3);
    });
}

/// The Cauchy cost of a model at the final scale.
double cost(const SharedDiscs& obs, const Model& m, const std::vector<double>& weights) {
    double sum = 0;
    each_residual(obs, m, weights, [&](std::size_t, double e2) { sum += std::log1p(e2 / (scale * scale)); });
    return sum;
}

/// The weighted normal equations after the discs' colors have been eliminated. A, B and C are the same for
/// all channels.
struct Normal {
    Eigen::MatrixXd A;  ///< photos x photos; only the lower triangle is set
    Eigen::MatrixXd B;  ///< photos x vignetting
    Eigen::MatrixXd C;  ///< vignetting x vignetting
    Eigen::MatrixXd b;  ///< photos x 3
    Eigen::MatrixXd d;  ///< vignetting x 3
};

/// An observation's contribution to the normal equations: its weight, and its weighted features and values.
struct WeightedObservation {
    Eigen::Index photo, lens;  ///< row of the gain, first row of the vignetting
    double weight;
    Eigen::Vector3d features;  ///< r^2, r^4, r^6; 0 beyond the lens's terms
    Eigen::RowVector3d ln;
};

WeightedObservation weighted(const Observation& o, double weight, const Model& m) {
    const std::uint32_t lens = m.lens[o.photo];
    WeightedObservation w{o.photo, 3 * Eigen::Index(lens), weight, Eigen::Vector3d::Zero(), {}};
    double power = 1;
    for (int t = 0; t < m.terms[lens]; ++t) w.features[t] = power *= double(o.radius2);
    w.features *= weight;
    for (int c = 0; c < 3; ++c) w.ln[c] = weight * double(o.ln[c]);
    return w;
}

/// The sum of a disc's weighted features over the photos taken with one lens.
struct LensSum {
    Eigen::Index lens;
    Eigen::Vector3d features;
};

void add(std::vector<LensSum>& lenses, const WeightedObservation& w) {
    const auto it = std::ranges::find(lenses, w.lens, &LensSum::lens);
    if (it == lenses.end())
        lenses.push_back({w.lens, w.features});
    else
        it->features += w.features;
}

Normal normal_equations(const SharedDiscs& obs, const Model& m, const std::vector<double>& weights) {
    const Eigen::Index photos = m.gain.rows(), terms = m.vignetting.size();
    Normal n{Eigen::MatrixXd::Zero(photos, photos), Eigen::MatrixXd::Zero(photos, terms),
             Eigen::MatrixXd::Zero(terms, terms), Eigen::MatrixXd::Zero(photos, 3),
             Eigen::MatrixXd::Zero(terms, 3)};
    std::vector<WeightedObservation> ws;
    std::vector<LensSum> lenses;
    const bool with_vignetting = std::ranges::any_of(m.terms, [](int t) { return t > 0; });
    obs.each_disc([&](std::span<const Observation> disc, std::size_t at) {
        ws.clear();
        lenses.clear();
        double sum = 0;
        Eigen::RowVector3d ln = Eigen::RowVector3d::Zero();
        for (std::size_t i = 0; i < disc.size(); ++i) {
            const WeightedObservation& w = ws.emplace_back(weighted(disc[i], weights[at + i], m));
            sum += w.weight;
            ln += w.ln;
            if (with_vignetting) add(lenses, w);
        }
        ln /= sum;
        for (const WeightedObservation& a : ws) {
            n.A(a.photo, a.photo) += a.weight;
            for (const WeightedObservation& b : ws)
                if (b.photo <= a.photo) n.A(a.photo, b.photo) -= a.weight * b.weight / sum;
            n.b.row(a.photo) += a.weight * ln - a.ln;
            if (!with_vignetting) continue;
            n.B.block<1, 3>(a.photo, a.lens) += a.features.transpose();
            for (const LensSum& l : lenses)
                n.B.block<1, 3>(a.photo, l.lens) -= a.weight / sum * l.features.transpose();
            n.C.block<3, 3>(a.lens, a.lens) += a.features * a.features.transpose() / a.weight;
            n.d.block<3, 3>(a.lens, 0) += a.features * (ln - a.ln / a.weight);
        }
        for (const LensSum& k : lenses)
            for (const LensSum& l : lenses)
                n.C.block<3, 3>(k.lens, l.lens) -= k.features * l.features.transpose() / sum;
    });
    return n;
}

void solve(const SharedDiscs& obs, const std::vector<double>& weights, Model& m) {
    Normal n = normal_equations(obs, m, weights);
    // Regularizes the null space, which consists of each component's mean and of photos and lenses without
    // observations.
    const double ridge = 1e-7 * (n.A.trace() / double(n.A.rows()) + 1);
    n.A.diagonal().array() += ridge;
    n.C.diagonal().array() += ridge;
    const Eigen::LLT<Eigen::MatrixXd> A(n.A);
    const Eigen::MatrixXd AB = A.solve(n.B), Ab = A.solve(n.b);
    m.vignetting =
        (3 * (n.C - n.B.transpose() * AB)).ldlt().solve((n.d - n.B.transpose() * Ab).rowwise().sum());
    m.gain = Ab - (AB * m.vignetting).replicate(1, 3);
    for (std::size_t l = 0; l < m.terms.size(); ++l)
        for (int t = m.terms[l]; t < 3; ++t) m.vignetting[3 * Eigen::Index(l) + t] = 0;
}

/// The model's robust weights at a scale. Residuals are relative to each disc's mean color, which is weighted
/// by `before`.
std::vector<double> robust_weights(const SharedDiscs& obs, const Model& m, const std::vector<double>& before,
                                   double at) {
    std::vector<double> weights(before.size());
    each_residual(obs, m, before, [&](std::size_t o, double e2) { weights[o] = 1 / (1 + e2 / (at * at)); });
    return weights;
}

/// Alternates between solving and reweighting; the scale halves from `from` down to `scale`.
void iterate(const SharedDiscs& obs, Model& m, std::vector<double>& weights, double from) {
    for (int i = 0; i < iterations; ++i) {
        const double at = std::max(scale, from * std::pow(0.5, i));
        solve(obs, weights, m);
        weights = robust_weights(obs, m, weights, at);
    }
}

/// Whether the vignetting increases outward and its value in the corner is within the bounds.
bool is_plausible(const Vignetting& f) {
    double before = 0;
    for (int i = 1; i <= 64; ++i) {
        const double now = log_vignetting(f, i / 64.0);
        if (!(now >= before - 1e-9)) return false;
        before = now;
    }
    const double lost = 1 - std::exp(-before);
    return lost >= min_corner && lost <= max_corner;
}

std::vector<int> photos_of(std::span<const std::uint32_t> lens, std::size_t lenses) {
    std::vector<int> count(lenses, 0);
    for (const std::uint32_t l : lens) ++count[l];
    return count;
}

/// Fits vignetting. Each lens gets the largest number of terms that gives a plausible result. If vignetting
/// does not lower the cost enough, the model is left without it.
void fit_vignetting(const SharedDiscs& obs, Model& m, std::vector<double>& weights) {
    const Model without = m;
    const double cost_without = cost(obs, m, weights);
    const std::vector<int> photos = photos_of(m.lens, m.terms.size());
    for (std::size_t l = 0; l < m.terms.size(); ++l) m.terms[l] = photos[l] >= min_photos ? 3 : 0;
    for (;;) {
        iterate(obs, m, weights, scale);
        bool all_plausible = true;
        for (std::size_t l = 0; l < m.terms.size(); ++l)
            if (m.terms[l] > 0 && !is_plausible(m.of_lens(l))) --m.terms[l], all_plausible = false;
        if (all_plausible) break;
    }
    if (cost(obs, m, weights) < (1 - min_improvement) * cost_without) return;
    m = without;
}

/// Makes the geometric mean of the gains in each component 1, and limits the gains.
void center_gains(Model& m, const std::vector<std::uint32_t>& component,
                  const std::vector<std::size_t>& count) {
    for (std::uint32_t root = 0; root < component.size(); ++root) {
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        int members = 0;
        for (std::size_t i = 0; i < component.size(); ++i)
            if (component[i] == root && count[i]) sum += m.gain.row(Eigen::Index(i)), ++members;
        for (std::size_t i = 0; i < component.size() && members; ++i)
            if (component[i] == root && count[i]) m.gain.row(Eigen::Index(i)) -= sum / members;
    }
    m.gain = m.gain.cwiseMax(-std::log(max_gain)).cwiseMin(std::log(max_gain));
}

/// Measures the color differences between consecutive photos of each disc, including the last and the first.
/// Stores the median over all discs and the median for each photo.
void measure(const SharedDiscs& obs, const Model& m, double& all, std::vector<double>& of_photo) {
    std::vector<float> differences;
    std::vector<std::vector<float>> by_photo(of_photo.size());
    obs.each_disc([&](std::span<const Observation> disc, std::size_t) {
        for (std::size_t i = 0; i < disc.size(); ++i) {
            const Observation &a = disc[i], &b = disc[(i + 1) % disc.size()];
            if (i + 1 == disc.size() && i < 2) break;  // two photos form only one pair
            const double d = (m.corrected(a) - m.corrected(b)).lpNorm<1>() / 3;
            differences.push_back(float(d));
            by_photo[a.photo].push_back(float(d));
            by_photo[b.photo].push_back(float(d));
        }
    });
    all = double(upper_median(std::span(differences)));
    for (std::size_t i = 0; i < of_photo.size(); ++i)
        of_photo[i] = double(upper_median(std::span(by_photo[i])));
}

std::vector<std::array<double, 3>> gains_of(const Model& m) {
    std::vector<std::array<double, 3>> out;
    for (Eigen::Index i = 0; i < m.gain.rows(); ++i)
        out.push_back({m.gain(i, 0), m.gain(i, 1), m.gain(i, 2)});
    return out;
}

/// The input and the intermediate result of a fit.
struct Fit {
    std::vector<std::size_t> samples;  ///< as in ColorFit
    SharedDiscs obs;
    std::vector<std::uint32_t> component;  ///< as in ColorFit
    Model m;
    std::vector<double> weights;

    Fit(Samples of_photos, std::span<const std::uint32_t> lens)
        : obs(shared_discs(of_photos, samples)),
          component(components(obs, of_photos.size())),
          weights(obs.all.size(), 1) {
        const auto photos = of_photos.size(), lenses = photos ? std::ranges::max(lens) + std::size_t(1) : 0;
        m = {Eigen::MatrixXd::Zero(Eigen::Index(photos), 3), Eigen::VectorXd::Zero(3 * Eigen::Index(lenses)),
             std::vector<int>(lenses, 0), lens};
    }
    void add_gains() {
        if (!obs.all.empty()) iterate(obs, m, weights, initial_scale);
    }
    void add_vignetting() {
        if (!obs.all.empty()) fit_vignetting(obs, m, weights);
    }
    PhotoColors colors() const {
        Model centered = m;
        center_gains(centered, component, samples);
        PhotoColors out{gains_of(centered), {}};
        for (const std::uint32_t l : m.lens) out.vignetting.push_back(m.of_lens(l));
        return out;
    }
};

Fit gains_without(Samples samples, std::span<const std::uint32_t> lens, std::uint32_t photo) {
    std::vector<std::span<const package::SampleRecord>> others(samples.begin(), samples.end());
    others[photo] = {};
    Fit fit(others, lens);
    fit.add_gains();
    return fit;
}

}  // namespace

double log_vignetting_at_square(const Vignetting& f, double r2) {
    return r2 * (f[0] + r2 * (f[1] + r2 * f[2]));
}

double vignetting_radius(const Intrinsics& k, const Eigen::Vector2d& pixel) {
    return (pixel - Eigen::Vector2d(k.cx, k.cy)).norm() / (0.5 * std::hypot(k.width, k.height));
}

double log_vignetting(const Vignetting& f, double radius) {
    return log_vignetting_at_square(f, radius * radius);
}

std::vector<std::uint32_t> lenses_of(std::span<const package::PhotoRecord> photos) {
    std::vector<std::uint32_t> out;
    std::vector<const package::PhotoRecord*> lenses;
    for (const package::PhotoRecord& p : photos) {
        const auto same = [&](const package::PhotoRecord* l) {
            const bool turned = l->width == p.height && l->height == p.width;
            return l->image_set == p.image_set &&
                   ((l->width == p.width && l->height == p.height) || turned) &&
                   std::abs(l->fx / p.fx - 1) < 0.005;
        };
        const auto it = std::ranges::find_if(lenses, same);
        out.push_back(std::uint32_t(it - lenses.begin()));
        if (it == lenses.end()) lenses.push_back(&p);
    }
    return out;
}

ColorFit fit_colors(Samples samples, std::span<const std::uint32_t> lens, bool with_vignetting) {
    Fit fit(samples, lens);
    ColorFit out;
    out.ln_gain.resize(samples.size(), {});
    out.vignetting.resize(fit.m.terms.size(), {});
    out.photo_before.resize(samples.size(), 0);
    out.photo_after.resize(samples.size(), 0);
    out.samples = fit.samples;
    out.component = fit.component;
    if (fit.obs.all.empty()) return out;
    measure(fit.obs, fit.m, out.before, out.photo_before);
    fit.add_gains();
    if (with_vignetting) fit.add_vignetting();
    center_gains(fit.m, fit.component, fit.samples);
    measure(fit.obs, fit.m, out.after, out.photo_after);
    out.ln_gain = gains_of(fit.m);
    for (std::size_t l = 0; l < out.vignetting.size(); ++l) out.vignetting[l] = fit.m.of_lens(l);
    return out;
}

PhotoColors colors_of(const ColorFit& fit, std::span<const std::uint32_t> lens) {
    PhotoColors out{fit.ln_gain, {}};
    for (const std::uint32_t l : lens) out.vignetting.push_back(fit.vignetting[l]);
    return out;
}

PhotoColors fit_without(Samples samples, std::span<const std::uint32_t> lens, std::uint32_t photo,
                        bool with_vignetting) {
    Fit fit = gains_without(samples, lens, photo);
    if (with_vignetting) fit.add_vignetting();
    return fit.colors();
}

FitsWithout fits_without(Samples samples, std::span<const std::uint32_t> lens, std::uint32_t photo) {
    Fit fit = gains_without(samples, lens, photo);
    PhotoColors gains = fit.colors();
    fit.add_vignetting();
    return {std::move(gains), fit.colors()};
}

void apply_colors(const PhotoColors& colors, bool gains_on, bool vignetting_on,
                  std::span<package::PhotoRecord> photos) {
    for (std::size_t i = 0; i < photos.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) photos[i].gain[c] = gains_on ? std::exp(colors.ln_gain[i][c]) : 1;
        for (std::size_t t = 0; t < 3; ++t)
            photos[i].vignetting[t] = vignetting_on ? float(colors.vignetting[i][t]) : 0;
    }
}

}  // namespace vantage
