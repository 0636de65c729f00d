#include "pipeline/refine/poses/systematic_errors.h"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "base/values/quantile.h"
#include "pipeline/run/for_each_photo.h"
#include "scene/agreement/color_fit.h"

namespace vantage {
namespace {

using Eigen::Vector2d;
using Eigen::VectorXd;
using package::PairRecord;

constexpr double min_pixels = 1;         ///< minimum error of a lens, px
constexpr double min_apart = 0.5;        ///< minimum displacement between photos due to a common motion, px
constexpr double min_sigmas = 3;         ///< minimum size of any error, in standard errors
constexpr double common_explains = 0.5;  ///< largest remaining fraction of the cost of held-out cells
constexpr double lens_explains = 0.75;
constexpr double pose_prior = 0.5, lens_prior = 1e-3;  ///< 1/px^2
constexpr double weak = 0.03;   ///< prior of the common motion, relative to the best-determined unknown
constexpr int max_groups = 12;  ///< maximum number of photo groups held out by the jackknife
constexpr int iterations = 15;
constexpr double converged_step = 1e-4;  ///< px

/// The unknowns of a fit.
struct Model {
    bool poses = false, lenses = true, frame = true;
    std::vector<bool> moving{};  ///< if `poses`, the photos whose cameras move; empty: all
    std::optional<std::uint32_t> without_focal{}, without_rows{};  ///< of a lens
};
const Model poses_only{.poses = true, .lenses = false, .frame = false};

/// Whether a cell is used.
using Used = std::function<bool(const PairCells&, const CellDisplacement&)>;
bool any_cell(const PairCells&, const CellDisplacement&) { return true; }

/// Robust fits of all unknowns, in px: six per pose, three per lens, and seven for the common motion.
class SystematicFit {
  public:
    SystematicFit(const CellDisplacements& cells, std::vector<std::uint32_t> lens)
        : cells_(cells), lens_(std::move(lens)), lenses_(lens_.empty() ? 0 : std::ranges::max(lens_) + 1) {}

    std::uint32_t lens(std::uint32_t photo) const { return lens_[photo]; }
    std::uint32_t lenses() const { return lenses_; }
    int lens_at(std::uint32_t lens) const { return int(6 * lens_.size() + 3 * lens); }

    /// Least squares with Cauchy weights at 1 px, starting at `x` if that is not empty.
    VectorXd solve(const Model& model, const Used& used, VectorXd x = {}) const {
        if (x.size() == 0) x = VectorXd::Zero(frame_at() + frame_size);
        for (int i = 0; i < iterations; ++i) {
            const VectorXd step = newton_step(model, used, x);
            if (!step.allFinite()) break;
            x += step;
            if (step.norm() < converged_step) break;
        }
        return x;
    }
    /// Holds out first one half of the cells and then the other, and visits the held-out cells with their
    /// residual displacement.
    template <class Visit>
    void each_held_out(const Model& model, const Used& used, const Visit& visit) const {
        for (const bool half : {false, true}) {
            const VectorXd x = solve(model, [=](const auto&, const auto& c) { return c.odd != half; });
            for (const PairCells& p : cells_.pairs) {
                const Columns columns = columns_of(model, p);
                for (const CellDisplacement& c : p.cells)
                    if (c.odd == half && used(p, c)) visit(c, residual(c, columns, jacobian(c, columns), x));
            }
        }
    }
    /// The mean of ln(1 + |residual|^2) over held-out cells.
    double held_out_cost(const Model& model, const Used& used) const {
        double sum = 0, weight = 0;
        each_held_out(model, used, [&](const CellDisplacement& c, const Vector2d& left) {
            sum += c.weight * std::log1p(left.squaredNorm());
            weight += c.weight;
        });
        return weight > 0 ? sum / weight : 0;
    }

  private:
    static constexpr int frame_size = 7, per_cell = 25;  ///< unknowns; a cell involves 2 poses and 2 lenses
    using Jacobian = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, per_cell>;
    using Block = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, per_cell, per_cell>;
    /// The columns of a pair's unknowns: among the unknowns of a cell, and among all unknowns.
    struct Columns {
        std::vector<int> of_cell, of_all;
    };

    int frame_at() const { return lens_at(lenses_); }
    Columns columns_of(const Model& m, const PairCells& p) const {
        Columns out;
        const auto add = [&](int cell, int all) { out.of_cell.push_back(cell), out.of_all.push_back(all); };
        for (int i = 0; i < 12 && m.poses; ++i)
            if (const std::uint32_t photo = i < 6 ? p.a : p.b; m.moving.empty() || m.moving[photo])
                add(i, int(6 * photo) + i % 6);
        for (int i = 0; i < 6 && m.lenses; ++i) {
            const std::uint32_t lens = lens_[i < 3 ? p.a : p.b];
            if ((i % 3 == 0 ? m.without_focal : m.without_rows) != lens) add(12 + i, lens_at(lens) + i % 3);
        }
        for (int i = 0; i < frame_size && m.frame; ++i) add(18 + i, frame_at() + i);
        return out;
    }
    static Jacobian jacobian(const CellDisplacement& c, const Columns& columns) {
        Eigen::Matrix<double, 2, per_cell> all;
        all << c.pose_a, c.pose_b, c.lens_a, c.lens_b, c.frame;
        Jacobian out(2, Eigen::Index(columns.of_cell.size()));
        for (int i = 0; i < out.cols(); ++i) out.col(i) = all.col(columns.of_cell[std::size_t(i)]);
        return out;
    }
    static Vector2d residual(const CellDisplacement& c, const Columns& columns, const Jacobian& j,
                             const VectorXd& x) {
        Vector2d out = c.moved;
        for (int i = 0; i < j.cols(); ++i) out -= j.col(i) * x[columns.of_all[std::size_t(i)]];
        return out;
    }
    /// Weights of the priors that pull each unknown toward 0. The prior of the common motion is strong enough
    /// to keep motions along the surface at 0, because pairs of photos do not determine them.
    VectorXd priors(const VectorXd& diagonal) const {
        VectorXd out = VectorXd::Constant(diagonal.size(), pose_prior);
        out.tail(out.size() - lens_at(0)).setConstant(lens_prior);
        out.tail<frame_size>().setConstant(
            std::max(weak * diagonal.tail<frame_size>().maxCoeff(), lens_prior));
        return out;
    }
    VectorXd newton_step(const Model& model, const Used& used, const VectorXd& x) const {
        std::vector<Eigen::Triplet<double>> entries;
        VectorXd right = VectorXd::Zero(x.size()), diagonal = VectorXd::Zero(x.size());
        for (const PairCells& p : cells_.pairs) {
            const Columns columns = columns_of(model, p);
            const int n = int(columns.of_all.size());
            Block block = Block::Zero(n, n);
            for (const CellDisplacement& c : p.cells) {
                if (!used(p, c)) continue;
                const Jacobian j = jacobian(c, columns);
                const Vector2d r = residual(c, columns, j, x);
                const double w = c.weight / (1 + r.squaredNorm());
                block += w * j.transpose() * j;
                for (int i = 0; i < n; ++i) right[columns.of_all[std::size_t(i)]] += w * j.col(i).dot(r);
            }
            for (int i = 0; i < n; ++i) {
                const int row = columns.of_all[std::size_t(i)];
                diagonal[row] += block(i, i);
                for (int k = 0; k < n; ++k)
                    entries.emplace_back(row, columns.of_all[std::size_t(k)], block(i, k));
            }
        }
        const VectorXd prior = priors(diagonal);
        for (int i = 0; i < x.size(); ++i) entries.emplace_back(i, i, prior[i]);
        Eigen::SparseMatrix<double> normal(x.size(), x.size());
        normal.setFromTriplets(entries.begin(), entries.end());
        return Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(normal).solve(right -
                                                                                prior.cwiseProduct(x));
    }

    const CellDisplacements& cells_;
    std::vector<std::uint32_t> lens_;
    std::uint32_t lenses_;
};

/// The search for the systematic errors of one scene.
class ErrorSearch {
  public:
    ErrorSearch(const PoseRefinementInput& in, const CellDisplacements& cells)
        : in_(in), cells_(cells), fit_(cells, lenses_of(in.photos)) {
        if (cells_.frame_unit == 0) return;
        all_ = fit_.solve({}, any_cell);
        groups_ = std::min(std::uint32_t(in.photos.size()), std::uint32_t(max_groups));
    }
    SystematicErrors result() {
        SystematicErrors out;
        if (cells_.frame_unit == 0) return out;
        for (std::uint32_t l = 0; l < fit_.lenses(); ++l)
            if (LensError e = lens_error(l); !e.words.empty()) out.lenses.push_back(std::move(e));
        find_common_motion(out);
        return out;
    }

  private:
    std::vector<std::uint32_t> photos_of(std::uint32_t lens) const {
        std::vector<std::uint32_t> out;
        for (std::uint32_t i = 0; i < in_.photos.size(); ++i)
            if (fit_.lens(i) == lens) out.push_back(i);
        return out;
    }
    /// The fits that each exclude one group of photos. They are computed on first use, because most scenes
    /// show no error.
    const std::vector<VectorXd>& fits_without_groups() {
        if (!without_.empty()) return without_;
        without_.resize(groups_);
        for_each_photo(groups_, in_.threads, [&](std::size_t g) {
            const auto rest = [&](const PairCells& p, const auto&) {
                return p.a % groups_ != g && p.b % groups_ != g;
            };
            without_[g] = fit_.solve({}, rest, all_);
        });
        return without_;
    }
    /// The standard error from a jackknife over the groups of photos, except for groups that contain all of
    /// `photos`.
    double uncertainty(const std::function<double(const VectorXd&)>& distance,
                       std::span<const std::uint32_t> photos = {}) {
        std::vector<double> distances;
        for (std::uint32_t g = 0; g < groups_; ++g) {
            const auto in_group = [&](std::uint32_t i) { return i % groups_ == g; };
            if (photos.empty() || !std::ranges::all_of(photos, in_group))
                distances.push_back(distance(fits_without_groups()[g]));
        }
        return jackknife_error(distances);
    }
    /// Whether these unknowns of a lens indicate an error.
    bool is_found(std::uint32_t lens, int at, int count, const Model& without) {
        const double value = all_.segment(at, count).norm();
        const auto distance = [&](const VectorXd& x) { return (x - all_).segment(at, count).norm(); };
        if (!(value >= min_pixels && value >= min_sigmas * uncertainty(distance, photos_of(lens))))
            return false;
        const auto shown = [&](const PairCells& p, const CellDisplacement&) {
            return fit_.lens(p.a) == lens || fit_.lens(p.b) == lens;
        };
        const double with = fit_.held_out_cost({}, shown);
        return with <= lens_explains * fit_.held_out_cost(without, shown) &&
               with <= fit_.held_out_cost(poses_only, shown);
    }
    std::string name_of(std::span<const std::uint32_t> photos) const {
        if (photos.size() == in_.photos.size()) return "all photos";
        const std::string first = in_.photos[photos[0]].name;
        return photos.size() == 1 ? first : fmt::format("{} and {} more", first, photos.size() - 1);
    }
    LensError lens_error(std::uint32_t lens) {
        LensError out{.photos = photos_of(lens)};
        const int at = fit_.lens_at(lens);
        const package::PhotoRecord& photo = in_.photos[out.photos[0]];
        if (is_found(lens, at, 1, {.without_focal = lens})) {
            out.focal = all_[at] / (std::hypot(photo.width, photo.height) / 2);
            out.words = fmt::format(
                "the displacement grows with the distance from the center of the picture, by {0:.1f} %: the "
                "focal length is likely {0:.1f} % too {1}",
                100 * std::abs(out.focal), out.focal < 0 ? "long" : "short");
        }
        if (is_found(lens, at + 1, 2, {.without_rows = lens})) {
            out.rows = all_.segment<2>(at + 1);
            out.words += fmt::format(
                "{}the displacement grows from row to row, by {:.1f} px over the height of the picture: "
                "rolling shutter?",
                out.words.empty() ? "" : "; ", out.rows.norm());
        }
        if (!out.words.empty()) out.words = name_of(out.photos) + ": " + out.words;
        return out;
    }
    /// Median distance in px between two common motions, measured between photos or on the visible surface.
    double motion(Eigen::Matrix<double, 2, 7> CellDisplacement::*of, const VectorXd& a,
                  const VectorXd& b) const {
        std::vector<double> moved;
        for (const PairCells& p : cells_.pairs)
            for (const CellDisplacement& c : p.cells) moved.push_back((c.*of * (a - b).tail<7>()).norm());
        return quantile(std::move(moved), 0.5);
    }
    void find_common_motion(SystematicErrors& out) {
        const auto size = [&](auto of) { return motion(of, all_, VectorXd::Zero(all_.size())); };
        const auto error = [&](auto of) {
            return uncertainty([&](const VectorXd& x) { return motion(of, x, all_); });
        };
        const double apart = size(&CellDisplacement::frame);
        if (!(apart >= min_apart)) return;
        const double apart_error = error(&CellDisplacement::frame);
        if (!(apart >= min_sigmas * apart_error)) return;
        const double before = fit_.held_out_cost({.frame = false}, any_cell);
        if (!(fit_.held_out_cost({}, any_cell) <= common_explains * before)) return;
        out.common = similarity(cells_.frame_unit * all_.tail<7>(), cells_.frame);
        out.common_motion = size(&CellDisplacement::seen);
        out.uncertainty = error(&CellDisplacement::seen);
        out.words = fmt::format(
            "all cameras together are displaced by at least {:.2f} px from the mesh, or the mesh from the "
            "cameras, which displaces photos from each other by {:.2f} px (standard error {:.2f})",
            out.common_motion, apart, apart_error);
    }

    const PoseRefinementInput& in_;
    const CellDisplacements& cells_;
    SystematicFit fit_;
    std::uint32_t groups_ = 0;
    VectorXd all_;
    std::vector<VectorXd> without_;
};

}  // namespace

SystematicErrors systematic_errors(const PoseRefinementInput& in, const CellDisplacements& cells) {
    return ErrorSearch(in, cells).result();
}

LeftByPoses left_by_poses(const PoseRefinementInput& in, const CellDisplacements& cells,
                          std::span<const std::uint32_t> photos) {
    Model model = poses_only;
    model.moving.assign(in.photos.size(), photos.empty());
    for (const std::uint32_t i : photos) model.moving[i] = true;
    const auto moves = [&](const PairCells& p, const CellDisplacement&) {
        return model.moving[p.a] || model.moving[p.b];
    };
    std::vector<double> before, after;
    SystematicFit(cells, lenses_of(in.photos))
        .each_held_out(model, moves, [&](const CellDisplacement& c, const Vector2d& left) {
            before.push_back(c.moved.norm());
            after.push_back(left.norm());
        });
    return {quantile(std::move(before), 0.5), quantile(std::move(after), 0.5)};
}

}  // namespace vantage
