#include "player/measure/evaluation/error_causes.h"

#include <cmath>
#include <numeric>

#include "player/measure/evaluation/local_shifts.h"

namespace vantage {
namespace {

/// An explanation must account for this fraction of the error. The threshold for fine detail is higher,
/// because smoothing halves almost any error.
constexpr double explained = 0.5, explained_as_detail = 0.75;
constexpr int coarse_block = 4;       ///< px, for coarse differences
constexpr double least_judged = 0.5;  ///< fraction of the colored pixels that the compared pictures show

/// Mean differences of two pictures over blocks of 4x4 px and their neighbors: a low-pass filter with a
/// standard deviation of 3 px. Empty blocks have weight 0.
struct CoarseDifference {
    int columns, rows;
    std::vector<std::array<float, 4>> blocks;  ///< sums in three channels, and number of pixels

    /// Squared mean difference over three channels; 0 for weight 0.
    double square(std::size_t i) const {
        const auto& b = blocks[i];
        return b[3] > 0 ? double((b[0] * b[0] + b[1] * b[1] + b[2] * b[2]) / (b[3] * b[3])) : 0;
    }
    double weight(std::size_t i) const { return double(blocks[i][3]); }
};

/// Weights 1, 2, 1 along rows and then columns.
void smooth(CoarseDifference& d) {
    for (const bool rows : {true, false}) {
        const CoarseDifference from = d;
        for (int y = 0; y < d.rows; ++y)
            for (int x = 0; x < d.columns; ++x)
                for (int i = -1; i <= 1; i += 2) {
                    const int u = rows ? x + i : x, v = rows ? y : y + i;
                    if (u < 0 || v < 0 || u >= d.columns || v >= d.rows) continue;
                    for (std::size_t c = 0; c < 4; ++c)
                        d.blocks[std::size_t(y * d.columns + x)][c] +=
                            0.5f * from.blocks[std::size_t(v * d.columns + u)][c];
                }
    }
}

/// The coarse difference over the pixels at which `where` holds.
template <class Where>
CoarseDifference coarse_difference(const Picture& a, const Picture& b, const Where& where) {
    CoarseDifference d{
        (a.width + coarse_block - 1) / coarse_block, (a.height + coarse_block - 1) / coarse_block, {}};
    d.blocks.resize(std::size_t(d.columns) * std::size_t(d.rows));
    std::size_t i = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x, ++i) {
            if (!where(i)) continue;
            auto& sums = d.blocks[std::size_t(y / coarse_block * d.columns + x / coarse_block)];
            for (std::size_t c = 0; c < 3; ++c)
                sums[c] += float(int(a.rgba[4 * i + c]) - int(b.rgba[4 * i + c]));
            ++sums[3];
        }
    smooth(d);
    return d;
}

/// The pixels of a window, clipped to the frame, at which `flags` are set.
template <class Visit>
void each_pixel(const Place& p, int width, const std::vector<bool>& flags, const Visit& visit) {
    for (int y = p.y; y < p.y + p.height; ++y)
        for (int x = p.x; x < p.x + p.width; ++x) {
            const std::size_t i = std::size_t(y) * std::size_t(width) + std::size_t(x);
            if (flags[i]) visit(x, y, i);
        }
}

class Judge {
  public:
    explicit Judge(const CauseEvidence& e);
    Cause cause(std::size_t cell) const;
    const std::vector<bool>& judged() const { return judged_; }

  private:
    struct Window {
        Place place;
        double pixels = 0, squares = 0;  ///< of the picture
        double coarse = 0;               ///< squared error after low-pass filtering, on the same scale
        double unlike_mean = 0;          ///< squared error after subtracting the mean difference
    };
    struct Comparison {
        double all = 0,
               judged = 0;  ///< weights of the colored pixels, and of those that `others` also show
        double picture = 0, others = 0;  ///< squared differences at the pixels that `others` show
        bool enough() const { return judged > 0 && judged >= least_judged * all; }
    };
    Window window(std::size_t cell) const;
    Comparison compare(const Place& p, std::span<const CoarseDifference> others) const;
    bool displaced(const Window& w, std::size_t cell) const;
    double squares(const Picture& picture, const Place& p, PixelShift shift) const;
    template <class Sum>
    void each_block(const Place& p, const Sum& sum) const;
    Cause by_others(const Window& w) const;

    const CauseEvidence& e_;
    Cells cells_;
    std::vector<bool> judged_;
    std::vector<Picture> candidates_;  ///< the picture; single-photo pictures with gaps filled from it
    std::vector<std::vector<PixelShift>> shifts_;  ///< per candidate and cell
    CoarseDifference off_;                         ///< difference of the picture from the photo
    std::vector<CoarseDifference> alone_;          ///< differences of single-photo pictures from the photo
    std::vector<CoarseDifference> pairs_;          ///< differences between single-photo pictures
};

Judge::Judge(const CauseEvidence& e) : e_(e), cells_{e.photo.width, e.photo.height}, judged_(e.taken) {
    Plane mask(e.photo.width, e.photo.height);
    for (std::size_t i = 0; i < judged_.size(); ++i) {
        judged_[i] = judged_[i] && e.colored[i];
        mask.values[i] = judged_[i] ? 1.0f : 0.0f;
    }
    candidates_.push_back(e.shown);
    for (Picture p : e.alone) {
        for (std::size_t i = 0; i < judged_.size(); ++i)
            for (std::size_t c = 0; p.rgba[4 * i + 3] < 128 && c < 3; ++c)
                p.rgba[4 * i + c] = e.shown.rgba[4 * i + c];
        candidates_.push_back(std::move(p));
    }
    const Plane photo = luminance(e.photo);
    for (const Picture& p : candidates_) shifts_.push_back(local_shifts(photo, luminance(p), mask));
    off_ = coarse_difference(e.photo, e.shown, [&](std::size_t i) { return bool(judged_[i]); });
    for (std::size_t a = 0; a < e.alone.size(); ++a) {
        const auto shows = [&](std::size_t i) { return judged_[i] && e.alone[a].rgba[4 * i + 3] >= 128; };
        alone_.push_back(coarse_difference(e.photo, e.alone[a], shows));
        for (std::size_t b = a + 1; b < e.alone.size(); ++b)
            pairs_.push_back(coarse_difference(e.alone[a], e.alone[b], [&](std::size_t i) {
                return shows(i) && e.alone[b].rgba[4 * i + 3] >= 128;
            }));
    }
}

template <class Sum>
void Judge::each_block(const Place& p, const Sum& sum) const {
    for (int y = p.y / coarse_block; y < (p.y + p.height + coarse_block - 1) / coarse_block; ++y)
        for (int x = p.x / coarse_block; x < (p.x + p.width + coarse_block - 1) / coarse_block; ++x)
            sum(std::size_t(y * off_.columns + x));
}

Judge::Window Judge::window(std::size_t cell) const {
    Window w;
    w.place = cells_.place(cell, cell_margin);
    std::array<double, 3> mean{};
    each_pixel(w.place, cells_.width, judged_, [&](int, int, std::size_t i) {
        ++w.pixels;
        for (std::size_t c = 0; c < 3; ++c) {
            const double off = double(e_.photo.rgba[4 * i + c]) - double(e_.shown.rgba[4 * i + c]);
            mean[c] += off;
            w.squares += off * off;
        }
    });
    if (!(w.pixels > 0)) return w;
    w.unlike_mean = w.squares;
    for (const double m : mean) w.unlike_mean -= m * m / w.pixels;
    double weights = 0;
    each_block(w.place, [&](std::size_t i) {
        w.coarse += off_.weight(i) * off_.square(i);
        weights += off_.weight(i);
    });
    w.coarse *= w.pixels / std::max(weights, 1e-9);
    return w;
}

/// Squared difference of a shifted picture from the photo, over a window.
double Judge::squares(const Picture& picture, const Place& p, PixelShift shift) const {
    double sum = 0;
    each_pixel(p, cells_.width, judged_, [&](int x, int y, std::size_t i) {
        const int u = std::clamp(x + shift.x, 0, picture.width - 1),
                  v = std::clamp(y + shift.y, 0, picture.height - 1);
        const std::size_t j = std::size_t(v) * std::size_t(picture.width) + std::size_t(u);
        for (std::size_t c = 0; c < 3; ++c) {
            const int off = int(e_.photo.rgba[4 * i + c]) - int(picture.rgba[4 * j + c]);
            sum += off * off;
        }
    });
    return sum;
}

/// Whether a shift of some picture explains the error, and does so better than a change in brightness or
/// tint, because a shift and such a change look alike on a smooth gradient.
bool Judge::displaced(const Window& w, std::size_t cell) const {
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
        const PixelShift s = shifts_[k][cell];
        if (s.x == 0 && s.y == 0) continue;
        const double shifted = squares(candidates_[k], w.place, s);
        if (shifted > (1 - explained) * w.squares || shifted >= w.unlike_mean) continue;
        if (k == 0 || shifted <= (1 - explained) * squares(candidates_[k], w.place, {})) return true;
    }
    return false;
}

/// Low-pass filtered errors of the picture and of `others`, where both have values.
Judge::Comparison Judge::compare(const Place& p, std::span<const CoarseDifference> others) const {
    Comparison c;
    double weights = 0;
    each_block(p, [&](std::size_t i) {
        double most = 0;
        for (const CoarseDifference& d : others) {
            most = std::max(most, d.weight(i));
            c.others += d.weight(i) * d.square(i);
            weights += d.weight(i);
        }
        c.all += off_.weight(i);
        c.judged += most;
        c.picture += most * off_.square(i);
    });
    if (weights > 0) c.others *= c.judged / weights;
    return c;
}

/// The cause according to the other photos, all of which contribute to the picture. These photos disagree if
/// one of them is much closer to the photo than the picture is, or if they differ from each other at least as
/// much as the picture differs from the photo.
Cause Judge::by_others(const Window& w) const {
    for (const CoarseDifference& one : alone_) {
        const Comparison c = compare(w.place, std::span(&one, 1));
        if (c.enough() && c.others <= (1 - explained) * c.picture) return Cause::disagreement;
    }
    const Comparison pairs = compare(w.place, pairs_);
    if (!pairs.enough()) return Cause::unjudged;
    return pairs.others >= pairs.picture ? Cause::disagreement : Cause::odd_photo;
}

Cause Judge::cause(std::size_t cell) const {
    const Window w = window(cell);
    if (!(w.squares > 0)) return Cause::detail;
    if (displaced(w, cell)) return Cause::displaced;
    if (w.coarse <= (1 - explained_as_detail) * w.squares) return Cause::detail;
    return by_others(w);
}

}  // namespace

const std::array<CauseRow, cause_count>& cause_table() {
    static const std::array<CauseRow, cause_count> rows{{
        {Cause::no_surface,
         "no surface",
         "no mesh there: sky, trees, missing parts",
         "no_surface",
         {120, 120, 120}},
        {Cause::unseen, "unseen", "no other photo shows the mesh there", "unseen", {60, 90, 255}},
        {Cause::displaced,
         "displaced",
         "content is off by a few pixels: mesh or camera",
         "displaced",
         {230, 60, 200}},
        {Cause::detail,
         "fine detail",
         "disappears when smoothed: blur, oversharpening, noise",
         "detail",
         {60, 200, 90}},
        {Cause::disagreement,
         "disagreement",
         "the other photos differ from each other",
         "disagreement",
         {255, 140, 0}},
        {Cause::odd_photo,
         "odd photo",
         "others agree: light, gloss, something in front",
         "odd_photo",
         {225, 40, 40}},
        {Cause::unjudged, "unjudged", "too few other photos show it", "unjudged", {150, 110, 70}},
    }};
    return rows;
}

double CauseSquares::all() const { return std::accumulate(begin(), end(), 0.0); }

double CauseSquares::colored() const { return all() - of(Cause::no_surface) - of(Cause::unseen); }

double CauseSquares::share(Cause cause) const { return all() > 0 ? of(cause) / all() : 0; }

double CauseSquares::colored_share(Cause cause) const {
    return !is_hole(cause) && colored() > 0 ? of(cause) / colored() : 0;
}

CauseSquares CauseMap::totals() const {
    CauseSquares out{};
    for (const auto& cell : squares)
        for (std::size_t c = 0; c < cause_count; ++c) out[c] += cell[c];
    return out;
}

CauseMap find_causes(const CauseEvidence& e) {
    const Judge judge(e);
    CauseMap out{{e.photo.width, e.photo.height}, {}};
    out.squares.resize(out.cells.count());
    for (std::size_t cell = 0; cell < out.cells.count(); ++cell) {
        auto& squares = out.squares[cell];
        double colored = 0;
        each_pixel(out.cells.place(cell), e.photo.width, e.taken, [&](int, int, std::size_t i) {
            const double error = double(e.errors.values[i]);
            if (e.colored[i])
                colored += error;
            else
                squares[std::size_t(e.surface[i] ? Cause::unseen : Cause::no_surface)] += error;
        });
        if (colored > 0) squares[std::size_t(judge.cause(cell))] += colored;
    }
    return out;
}

}  // namespace vantage
