#include "pipeline/costs/measure_costs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/text/error.h"
#include "pipeline/costs/cost_programs.h"
#include "pipeline/costs/cost_trials.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/costs/picture_costs.h"
#include "pipeline/costs/recipes.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// The maximum longer side of pictures in px: that of a full HD screen.
constexpr int screen = 1920;

/// Evenly spaced photos in `folds` groups, an eighth of the photos or up to three in each. The photos of a
/// group are held out together.
std::vector<std::vector<std::string>> photos_to_hold_out(const PackageReader& whole, std::size_t folds) {
    std::vector<std::string> usable;
    for (const package::PhotoRecord& p : whole.photos())
        if (!(p.flags & package::photo_held_out) && p.image_set == 0) usable.push_back(p.name);
    const std::size_t n = usable.size();
    if (n < 4)
        throw Error(Exit::input,
                    fmt::format("{}: has {} usable photos; expected at least 4, of which some are "
                                "held out to measure quality",
                                whole.path().string(), n));
    const std::size_t each = std::min(std::clamp<std::size_t>(n / 8, std::clamp<std::size_t>(n / 3, 2, 3), 8),
                                      std::max<std::size_t>(1, n / folds));
    const std::size_t all = each * folds;
    std::vector<std::vector<std::string>> out(folds);
    for (std::size_t i = 0; i < all; ++i) out[i % folds].push_back(usable[(2 * i + 1) * n / (2 * all)]);
    return out;
}

/// The photo's view, reduced to at most the size of a screen.
PhotoView view_of(const package::PhotoRecord& p) {
    const double scale = std::min(1.0, screen / double(std::max(p.width, p.height)));
    const auto scaled = [&](std::uint32_t side) { return std::max(1, int(std::lround(side * scale))); };
    return {p.name, scaled(p.width), scaled(p.height)};
}

class Measurement {
  public:
    Measurement(const std::string& input, const CostEffort& effort, const fs::path& work, ScanCosts before,
                const CostRun& run)
        : input_(input),
          effort_(effort),
          work_(work),
          run_(run),
          programs_(work),
          costs_(std::move(before)) {}

    ScanCosts measure() {
        describe();
        const std::vector<CostTrial> trials = cost_trials(PackageReader(whole_), prepares_);
        std::size_t done = 0;
        bool complete = true;
        for (const CostTrial& t : trials) {
            ++done;
            if (measured(t)) continue;
            if (!fits()) return finished(false);
            run_.report(fmt::format("{:3.0f} s  {} of {}  {} {}", elapsed(), done, trials.size(),
                                    t.setting.empty() ? "the defaults" : t.setting, t.value));
            try {
                costs_.trials.push_back(measured_trial(t));
            } catch (const Error& e) {
                if (t.setting.empty() || e.code() == Exit::interrupted) throw;
                run_.report(std::string("       skipped: ") + e.what());
                complete = false;
            }
            run_.save(costs_);
        }
        return finished(complete);
    }

  private:
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

    /// Whether there is time for another trial and for a trial of a recommendation.
    bool fits() const {
        return effort_.full || costs_.trials.empty() || elapsed() + 2 * longest_ < 60 * effort_.minutes;
    }

    void stop_if_asked() const {
        if (run_.stop && *run_.stop)
            throw Error(Exit::interrupted, "stopped; the same command continues the measurement");
    }

    bool measured(const CostTrial& t) const {
        return std::ranges::any_of(costs_.trials, [&](const TrialCosts& c) { return c.trial == t; });
    }

    /// Prepares the scan with all photos, for comparison, and records its properties.
    void describe() {
        prepares_ = fs::is_directory(input_);
        whole_ = prepares_ ? (work_ / "whole.vantage").string() : input_;
        if (prepares_ && !(costs_.whole_seconds && fs::exists(whole_))) {
            run_.report("  0 s  all photos, for comparison");
            const CostPrograms::Prepared p = programs_.prepare(input_, whole_, {});
            costs_.whole_seconds = p.seconds;
            costs_.whole_bytes = p.package_bytes;
        }
        const PackageReader whole(whole_);
        const std::string key = costs_key(whole);
        if (costs_.key != key) {  // the scan has changed since it was measured
            costs_.trials.clear();
            costs_.held_out.clear();
        }
        const fs::path named = fs::absolute(input_).lexically_normal();
        costs_.name = (named.has_filename() ? named : named.parent_path()).stem().string();
        costs_.key = key;
        costs_.input = input_;
        costs_.excluded = !prepares_;
        costs_.photos = whole.photos().size();
        costs_.triangles = whole.scene().triangles;
        costs_.photo_bytes = photo_file_bytes(whole);
        for (const package::PhotoRecord& p : whole.photos())
            if (std::max(p.width, p.height) > unsigned(std::max(costs_.width, costs_.height))) {
                costs_.width = int(p.width);
                costs_.height = int(p.height);
            }
        costs_.picture = std::min(std::max(costs_.width, costs_.height), screen);
        if (costs_.held_out.empty()) costs_.held_out = photos_to_hold_out(whole, effort_.full ? 3 : 1);
        for (const std::vector<std::string>& photos : costs_.held_out) {
            Fold& fold = folds_.emplace_back();
            fold.package =
                prepares_ ? work_ / fmt::format("default-{}.vantage", folds_.size()) : fs::path(input_);
            fold.hold_out = {"--hold-out"};
            for (const package::PhotoRecord& p : whole.photos())
                if (std::ranges::find(photos, p.name) != photos.end()) {
                    fold.hold_out.push_back(p.name);
                    fold.views.push_back(view_of(p));
                }
        }
    }

    /// Pictures of a fold's views.
    struct References {
        std::vector<fs::path> photos;    ///< the photos themselves
        std::vector<fs::path> defaults;  ///< with the defaults
    };
    /// Photos that are held out together.
    struct Fold {
        std::vector<PhotoView> views;
        std::vector<std::string> hold_out;  ///< options
        fs::path package;                   ///< prepared with the defaults
        std::optional<CostPrograms::Prepared> prepared;
        References references[2];  ///< 0: of the model; 1: of the whole frame
    };

    /// Renders the views of the held-out photos without using these photos. If there is only a package, each
    /// photo is excluded in turn.
    std::vector<fs::path> pictures(const Fold& fold, const std::string& package,
                                   std::vector<std::string> options, bool whole_frame,
                                   const fs::path& folder) const {
        options.insert(options.end(), {"--background", whole_frame ? "on" : "off"});
        if (std::ranges::find(options, "--max-photos") == options.end())
            options.insert(options.end(), {"--max-photos", window_photos});
        if (prepares_) return programs_.render(package, fold.views, options, folder);
        std::vector<fs::path> out;
        for (const PhotoView& view : fold.views) {
            std::vector<std::string> without = options;
            without.insert(without.end(), {"--exclude", view.photo});
            out.push_back(programs_.render(package, {&view, 1}, without, folder / view.photo).front());
        }
        return out;
    }

    const References& references(Fold& fold, bool whole_frame) {
        References& r = fold.references[whole_frame];
        if (!r.photos.empty()) return r;
        const std::string name = fmt::format("{}-{}", whole_frame ? "frame" : "model", &fold - folds_.data());
        const std::vector<std::string> own{"--background", whole_frame ? "on" : "off"};
        r.photos = programs_.render(whole_, fold.views, own, work_ / ("photos-" + name));
        r.defaults = pictures(fold, default_package(fold), {}, whole_frame, work_ / ("defaults-" + name));
        return r;
    }

    std::string default_package(Fold& fold) {
        if (!fs::exists(fold.package)) fold.prepared = programs_.prepare(input_, fold.package, fold.hold_out);
        return fold.package;
    }

    TrialCosts measured_trial(const CostTrial& t) {
        const double begin = elapsed();
        TrialCosts out;
        out.trial = t;
        for (Fold& fold : folds_) {
            stop_if_asked();
            std::string package = default_package(fold);
            if (t.setting.empty() && fold.prepared) take(*fold.prepared, out);
            if (!t.prepare.empty()) package = prepared_beside_defaults(fold, t, out);
            stop_if_asked();
            compare(fold, t, package, out);
            if (!t.frames) continue;
            if (!t.setting.empty())
                out.default_ms.push_back(
                    programs_.frame_ms(default_package(fold), show_options(CostTrial{})));
            out.frame_ms.push_back(programs_.frame_ms(package, show_options(t)));
        }
        longest_ = std::max(longest_, elapsed() - begin);
        return out;
    }

    /// Prepares the scan in turn with the defaults and with the trial's options, twice if that is quick:
    /// other programs disturb short runs the most. Returns the trial's package.
    std::string prepared_beside_defaults(const Fold& fold, const CostTrial& t, TrialCosts& out) const {
        constexpr double quick = 5;  // seconds
        const fs::path package = work_ / "trial.vantage";
        std::vector<std::string> options = fold.hold_out;
        options.insert(options.end(), t.prepare.begin(), t.prepare.end());
        for (int run = 0; run == 0 || (run == 1 && out.default_seconds.back() < quick); ++run) {
            out.default_seconds.push_back(programs_.prepare(input_, fold.package, fold.hold_out).seconds);
            take(programs_.prepare(input_, package, options), out);
        }
        return package;
    }

    static void take(const CostPrograms::Prepared& p, TrialCosts& out) {
        out.prepare_seconds.push_back(p.seconds);
        out.memory_bytes = p.memory_bytes;
        out.package_bytes = p.package_bytes;
    }

    static std::vector<std::string> show_options(const CostTrial& t) {
        std::vector<std::string> out = t.show;
        if (std::ranges::find(out, "--max-photos") == out.end())
            out.insert(out.end(), {"--max-photos", window_photos});
        return out;
    }

    void compare(Fold& fold, const CostTrial& t, const std::string& package, TrialCosts& out) {
        const References& r = references(fold, t.whole_frame);
        const std::vector<fs::path> shown =
            t.setting.empty() ? r.defaults : pictures(fold, package, t.show, t.whole_frame, work_ / "trial");
        for (std::size_t i = 0; i < r.photos.size(); ++i) {
            const PictureDifference d = compare_pictures(r.photos[i], r.defaults[i], shown[i], t.whole_frame);
            out.psnr.push_back(t.setting.empty() ? d.psnr : d.psnr_difference);
            out.ssim.push_back(t.setting.empty() ? d.ssim : d.ssim_difference);
        }
    }

    /// Adds the recommendations, and measures those that differ from all trials.
    ScanCosts finished(bool complete) {
        costs_.recipes = recipes(costs_, input_);
        for (Recipe& r : costs_.recipes) {
            if (const auto same = std::ranges::find_if(costs_.trials,
                                                       [&](const TrialCosts& c) {
                                                           return c.trial.prepare == r.costs.trial.prepare &&
                                                                  c.trial.show == r.costs.trial.show;
                                                       });
                same != costs_.trials.end()) {
                const CostTrial combined = r.costs.trial;
                r.costs = *same;
                r.costs.trial = combined;
                continue;
            }
            run_.report(fmt::format("{:3.0f} s  the recommendation for {}", elapsed(), r.purpose));
            r.costs = measured_trial(r.costs.trial);
        }
        costs_.complete = complete;
        run_.save(costs_);
        return costs_;
    }

    const std::string input_;
    const CostEffort effort_;
    const fs::path work_;
    const CostRun& run_;
    const CostPrograms programs_;
    ScanCosts costs_;
    const Clock::time_point start_ = Clock::now();
    bool prepares_ = false;
    std::string whole_;   ///< package of all photos
    double longest_ = 0;  ///< duration of the longest trial, in seconds
    std::vector<Fold> folds_;
};

}  // namespace

ScanCosts measure_costs(const std::string& input, const CostEffort& effort, const fs::path& work,
                        ScanCosts before, const CostRun& run) {
    return Measurement(input, effort, work, std::move(before), run).measure();
}

}  // namespace vantage
