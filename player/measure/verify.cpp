#include "player/measure/verify.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "base/cli/progress_line.h"
#include "base/cli/standard_output.h"
#include "base/files/junit.h"
#include "base/files/make_folder.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/json_text.h"
#include "player/measure/bench/finite_targets.h"
#include "player/measure/golden.h"
#include "player/options/memory_options.h"
#include "player/options/shown/blending_options.h"
#include "player/options/shown/package_options.h"
#include "player/render/picture.h"
#include "player/view/shots.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

/// The findings for one package.
struct Verified {
    std::string package;
    Exit exit = Exit::ok;
    std::vector<std::string> lines;  ///< one per finding
    std::vector<GoldenDifference> views;
    double seconds = 0;
    bool opened = false;  ///< whether the package could be opened

    void add(Exit code, const std::string& line) {
        exit = code;
        lines.push_back(line);
    }
};

/// The folder of a package's stored pictures: for one package, the folder given; for several, its subfolder
/// with the package's name.
fs::path golden_of(const VerifyOptions& o, const std::string& package) {
    return o.packages.size() == 1 ? o.golden : o.golden / fs::path(package).stem();
}

std::string percent(double share) { return formatted("%.3g %%", 100 * share); }

std::string words(const GoldenDifference& d, int tolerance) {
    if (!d.problem.empty()) return d.view + ": " + d.problem;
    return d.view + ": " + percent(d.share) + " of the pixels differ by more than " +
           std::to_string(tolerance) + ", the worst by " + std::to_string(d.worst) + " of 255 at " +
           std::to_string(d.x) + "," + std::to_string(d.y);
}

/// `inputs`: files that must not be overwritten.
void verify_view(const VerifyOptions& o, const fs::path& folder, const Inputs& inputs, const Shot& shot,
                 const Picture& now, Verified& out) {
    const fs::path file = folder / (shot.name + ".png");
    if (o.update) return write_png(output_file(file, Product::png, inputs, std::nullopt), now);
    GoldenDifference d;
    if (!fs::exists(file)) {
        d.problem = "no picture is stored, see --update";
    } else {
        const Picture stored = read_png(file);
        d = compare_pictures(stored, now, o.tolerance);
        if (d.problem.empty() && d.share > o.share) {
            const fs::path pictures = o.differences / fs::path(out.package).stem();
            make_folder(pictures);
            write_png(output_file(pictures / (shot.name + ".png"), Product::png, inputs, std::nullopt),
                      side_by_side(stored, now));
        }
    }
    d.view = shot.name;
    if (!d.problem.empty() || d.share > o.share) out.add(Exit::different, words(d, o.tolerance));
    out.views.push_back(d);
}

void verify_package(const VerifyOptions& o, Verified& out) {
    const PackageReader package(out.package);
    out.opened = true;
    const fs::path folder = golden_of(o, out.package), views = folder / "views.path";
    if (o.update) make_folder(folder);
    if (o.update && !fs::exists(views)) write_default_views(views, package);
    if (!fs::exists(views))
        return out.add(Exit::input, views.string() + ": does not exist; --update stores views and pictures");
    const Inputs inputs = inputs_of(package);
    RenderSettings settings = render_settings(package, {}, Purpose::pictures);
    const std::vector<std::uint32_t> photos = photos_in_use(package, {});
    Renderer renderer(package, memory_budget({}));
    const std::vector<Shot> shots = read_path(views.string(), package, parse_size(o.size));
    ProgressLine progress(ProgressStyle::automatic, 10);
    std::size_t done = 0;
    for (const Shot& shot : shots) {
        progress.show({"views", shot.name, done, shots.size()});
        settings.image_sets.shown = shot.image_set.value_or(0);
        const Picture now = take_picture(renderer, shot.view, settings, photos, 2);
        if (now.report.tiles_damaged)
            return out.add(Exit::damaged,
                           std::to_string(now.report.tiles_damaged) + " tiles have a checksum mismatch");
        if (const NonFinite wrong = count_non_finite(renderer.resources().targets); wrong.all() > 0)
            out.add(Exit::different, shot.name + ": " + words(wrong));
        verify_view(o, folder, inputs, shot, now, out);
        progress.show({"views", "", ++done, shots.size()});
    }
}

/// Errors of the package become findings; all other errors end the run.
Verified verify_one(const VerifyOptions& o, const std::string& package) {
    Verified out;
    out.package = package;
    const auto start = std::chrono::steady_clock::now();
    try {
        verify_package(o, out);
    } catch (const Error& e) {
        if (e.code() != Exit::damaged && e.code() != Exit::input) throw;
        std::string text = e.what();
        if (text.starts_with(package + ": ")) text.erase(0, package.size() + 2);
        out.add(e.code(), text);
    }
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
}

const char* kind(const Verified& v) {
    if (v.exit == Exit::ok) return "";
    if (v.exit == Exit::input) return v.opened ? "views unreadable" : "unreadable";
    return v.exit == Exit::damaged ? "damaged" : "different";
}

void print(const VerifyOptions& o, const Verified& v) {
    for (const std::string& line : v.lines)
        std::fprintf(text_output(), "%s: %s: %s\n", v.package.c_str(), kind(v), line.c_str());
    if (!v.lines.empty()) return;
    int worst = 0;
    for (const GoldenDifference& d : v.views) worst = std::max(worst, d.worst);
    if (o.update)
        std::fprintf(text_output(), "%s: stored\n", v.package.c_str());
    else
        std::fprintf(text_output(), "%s: as stored, %zu views, largest difference %d of 255\n",
                     v.package.c_str(), v.views.size(), worst);
    std::fflush(text_output());
}

nlohmann::json json_of(const std::vector<Verified>& all) {
    nlohmann::json out = nlohmann::json::array();
    for (const Verified& v : all) {
        nlohmann::json views = nlohmann::json::array();
        for (const GoldenDifference& d : v.views)
            views.push_back({{"view", d.view},
                             {"problem", d.problem},
                             {"worst", d.worst},
                             {"x", d.x},
                             {"y", d.y},
                             {"share", d.share},
                             {"mean", d.mean}});
        out.push_back({{"file", v.package},
                       {"kind", kind(v)},
                       {"issues", v.lines},
                       {"views", views},
                       {"seconds", v.seconds}});
    }
    return out;
}

CheckCase junit_case(const Verified& v) {
    std::string text;
    for (const std::string& line : v.lines) text += (text.empty() ? "" : "\n") + line;
    return {v.package, kind(v), text, v.seconds};
}

/// Packages with the same name in different folders would share golden pictures.
void expect_outputs(const VerifyOptions& o) {
    if (!o.junit.empty())
        output_file(o.junit, Product::junit, {{o.packages.begin(), o.packages.end()}, {}}, std::nullopt);
    std::set<fs::path> names;
    for (const std::string& package : o.packages)
        if (!names.insert(fs::path(package).stem()).second)
            throw Error(Exit::usage,
                        package + ": another package has the same name; verify them in two runs");
}

}  // namespace

int run_verify(const VerifyOptions& o) {
    expect_outputs(o);
    const gl::HeadlessContext context;
    std::vector<Verified> all;
    std::vector<CheckCase> cases;
    for (const std::string& package : o.packages) {
        all.push_back(verify_one(o, package));
        cases.push_back(junit_case(all.back()));
        print(o, all.back());
    }
    results()["packages"] = json_of(all);
    if (!o.junit.empty()) write_junit(o.junit, "vantage-player verify", cases);
    for (const Exit code : {Exit::input, Exit::damaged, Exit::different})
        if (std::ranges::count(all, code, &Verified::exit) > 0) return int(code);
    return int(Exit::ok);
}

}  // namespace vantage
