#include "player/measure/evaluation/evaluate.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "player/measure/evaluation/cause_page.h"
#include "player/measure/evaluation/colors_without.h"
#include "player/measure/evaluation/evaluation_page.h"
#include "player/measure/evaluation/evaluation_table.h"
#include "player/measure/evaluation/held_out.h"
#include "player/view/shots.h"
#include "scene/agreement/registered_without.h"
#include "scene/agreement/transient_without.h"

namespace vantage {
namespace {

void write_pictures(const std::filesystem::path& folder, const PhotoEvaluation& r,
                    const EvaluationPictures& p) {
    write_png(folder / (r.name + "-photo.png"), p.photo);
    write_png(folder / (r.name + "-rendered.png"), p.rendered);
    write_png(folder / (r.name + "-difference.png"), p.difference);
    write_png(folder / (r.name + "-causes.png"), p.causes);
    for (std::size_t i = 0; i < r.worst.size(); ++i)
        write_png(folder / region_file(r, r.worst[i]), p.worst[i]);
}

/// The change since an earlier evaluation, if it contains the photo.
void compare(const EvaluateOptions& o, PhotoEvaluation& r, const EvaluationPictures& p) {
    const std::filesystem::path file = o.against / (r.name + "-rendered.png");
    if (!std::filesystem::exists(file)) return;
    const Picture before = read_png(file);
    if (before.width != p.photo.width || before.height != p.photo.height)
        throw Error(Exit::input, file.string() + ": is " + std::to_string(before.width) + "x" +
                                     std::to_string(before.height) + ", expected " +
                                     std::to_string(p.photo.width) + "x" + std::to_string(p.photo.height) +
                                     " (the size at this --level)");
    std::vector<bool> both = scored_pixels(before);
    for (std::size_t i = 0; i < both.size(); ++i) both[i] = both[i] && p.scored[i];
    r.change = change_of(p.photo, before, p.rendered, both);
    for (const auto& [place, kind] :
         {std::pair{r.change->better, "-better.png"}, std::pair{r.change->worse, "-worse.png"}})
        if (place)
            write_png(o.folder / (r.name + kind),
                      side_by_side(std::array{&p.photo, &before, &p.rendered}, *place));
}

void write_regions(const std::filesystem::path& file, const PackageReader& package,
                   const std::vector<RegionError>& regions) {
    std::ostringstream out;
    out.precision(10);
    out << "x,y,z,radius,pixels,uncoloured,rms\n";
    const auto clusters = package.records<package::ClusterRecord>(package::Type::clusters);
    const double* origin = package.scene().origin;
    for (std::size_t c = 0; c < regions.size(); ++c) {
        if (regions[c].pixels == 0) continue;
        for (std::size_t i = 0; i < 3; ++i) out << clusters[c].center[i] + origin[i] << ',';
        out << clusters[c].radius << ',' << regions[c].pixels << ',' << regions[c].uncolored << ','
            << regions[c].rms() << '\n';
    }
    replace_file(file, out.view());
}

/// Green to red for 0 to 40 gray levels, blue if no other photo shows most of the region, gray if no photo
/// was compared there.
std::array<int, 3> error_color(const RegionError& r) {
    if (r.pixels == 0) return {128, 128, 128};
    if (2 * r.uncolored > r.pixels) return {60, 90, 255};
    const double t = std::clamp(r.rms() / 40, 0.0, 1.0);
    return {int(255 * std::min(1.0, 2 * t)), int(255 * std::min(1.0, 2 - 2 * t)), 40};
}

/// The model as ASCII PLY, one color per triangle, relative to the package's origin.
void write_model(const std::filesystem::path& file, const PackageReader& package,
                 const std::vector<RegionError>& regions) {
    const auto positions = package.records<Eigen::Vector3f>(package::Type::positions);
    const auto indices = package.records<std::uint32_t>(package::Type::indices);
    const auto clusters = package.records<package::ClusterRecord>(package::Type::clusters);
    std::ostringstream out;
    out << "ply\nformat ascii 1.0\nelement vertex " << positions.size()
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << indices.size() / 3
        << "\nproperty list uchar uint vertex_indices\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nend_header\n";
    for (const Eigen::Vector3f& p : positions) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    for (std::size_t c = 0; c < clusters.size(); ++c) {
        const auto [red, green, blue] = error_color(c < regions.size() ? regions[c] : RegionError{});
        for (std::size_t t = clusters[c].first_triangle;
             t < clusters[c].first_triangle + clusters[c].triangles; ++t)
            out << "3 " << indices[3 * t] << ' ' << indices[3 * t + 1] << ' ' << indices[3 * t + 2] << ' '
                << red << ' ' << green << ' ' << blue << '\n';
    }
    replace_file(file, out.view());
}

void print_changes(const std::filesystem::path& against, const std::vector<PhotoEvaluation>& results) {
    double decibels = 0, ssim = 0, sharp_before = 0, sharp_after = 0, n = 0;
    std::fprintf(text_output(), "\n%-20s %7s %7s %7s %8s %7s %7s\n", "against", "gain", "now", "change",
                 "SSIM", "sharp", "now");
    for (const std::size_t i : by_change(results)) {
        const auto& [before, after, better, worse] = *results[i].change;
        std::fprintf(text_output(), "%-20s %7.2f %7.2f %+7.2f %+8.4f %7.2f %7.2f\n", results[i].name.c_str(),
                     before.psnr_gain, after.psnr_gain, after.psnr_gain - before.psnr_gain,
                     after.ssim - before.ssim, before.sharpness, after.sharpness);
        ++n;
        decibels += after.psnr_gain - before.psnr_gain;
        ssim += after.ssim - before.ssim;
        sharp_before += before.sharpness;
        sharp_after += after.sharpness;
    }
    if (n == 0)
        std::fprintf(text_output(), "%s contains none of these photos\n", against.c_str());
    else
        std::fprintf(text_output(), "%-20s %23.2f %+8.4f %7.2f %7.2f\n", "mean", decibels / n, ssim / n,
                     sharp_before / n, sharp_after / n);
}

void print_remarks(const std::vector<PhotoEvaluation>& results) {
    for (const std::size_t i : worst_first(results))
        for (const std::string& s : results[i].remarks)
            std::fprintf(text_output(), "%s: %s\n", results[i].name.c_str(), s.c_str());
}

/// Width of the table's first column.
int name_width(const PackageReader& package, const std::vector<std::uint32_t>& photos) {
    std::size_t width = 5;
    const std::vector<std::string> stems = package.photo_stems();
    for (const std::uint32_t p : photos) width = std::max(width, stems[p].size());
    return int(width);
}

/// The photos to hold out: those of --photo, or every n-th photo. Photos without pixels are skipped.
std::vector<std::uint32_t> photos_to_hold_out(const PackageReader& package, const EvaluateOptions& o,
                                              const std::vector<std::uint32_t>& in_use) {
    std::vector<std::uint32_t> out = named_photos(package, o.package.photos);
    if (out.empty())
        for (std::size_t i = 0; i < in_use.size(); i += std::size_t(o.every)) out.push_back(in_use[i]);
    std::erase_if(out, [&](std::uint32_t p) { return package.photos()[p].levels == 0; });
    return out;
}

void expect_earlier(const EvaluateOptions& o) {
    if (o.against.empty()) return;
    if (!std::filesystem::is_directory(o.against))
        throw Error(Exit::input,
                    o.against.string() + ": not a folder, expected the folder of an earlier evaluation");
    std::error_code none;
    if (std::filesystem::equivalent(o.against, o.folder, none))
        throw Error(Exit::usage,
                    o.against.string() + ": would be overwritten, expected another folder for -o");
}

/// Warns that the held-out photos have influenced pose refinement.
void report_pose_refinement(const PackageReader& package) {
    if (effect_on(package.scene(), Effect::pose_refinement) &&
        !package.find(package::Type::pose_refinement_without))
        std::fprintf(text_output(),
                     "the held-out photos took part in the refinement of all cameras; for results that they "
                     "do not influence, use vantage prepare --hold-out\n");
}

/// The package's data with one photo held out.
class SceneWithout {
  public:
    SceneWithout(const PackageReader& package, bool transient_masks)
        : colors_(package), fits_colors_(uses_colors(package.scene())) {
        if (transient_masks && effect_on(package.scene(), Effect::transients))
            transient_.emplace(package, colors_.samples());
    }
    /// Sets the other photos' weight maps to those computed without this photo. Returns the records.
    std::vector<package::PhotoRecord> hold_out(std::uint32_t photo, Renderer& renderer) {
        const PhotoColors colors = fits_colors_ ? colors_.colors(photo) : PhotoColors{};
        std::vector<package::PhotoRecord> out = colors_.records(colors, photo);
        if (effect_on(renderer.package().scene(), Effect::pose_refinement))
            use_poses_without(renderer.package(), photo, out);
        if (transient_) {
            transient_->hold_out(photo, colors, out);
            renderer.resources().store.use_weights(
                [this](std::uint32_t other) { return transient_->of(other); });
        }
        return out;
    }

  private:
    static bool uses_colors(const package::SceneRecord& scene) {
        return effect_on(scene, Effect::exposure) || effect_on(scene, Effect::vignetting) ||
               effect_on(scene, Effect::transients);
    }

    ColorsWithout colors_;
    bool fits_colors_;
    std::optional<TransientWithout> transient_;
};

}  // namespace

int run_evaluate(const PackageReader& package, const EvaluateOptions& o) {
    const std::vector<std::uint32_t> photos = photos_in_use(package, o.package);
    const std::vector<std::uint32_t> held_out = photos_to_hold_out(
        package, o,
        o.blending.image_sets.image_set.empty()
            ? photos
            : photos_in_use(package, o.package, image_set_settings(package, o.blending.image_sets).shown));
    if (held_out.empty()) throw Error(Exit::input, package.path().string() + ": no photos to hold out");
    expect_earlier(o);
    make_folder(o.folder);
    RenderSettings settings = render_settings(package, o.blending, Purpose::pictures);
    settings.fill_holes = false;   // the whole frame is scored separately
    settings.points.show = false;  // photos are scored
    settings.transparency = Transparency::off;
    report_pose_refinement(package);
    const gl::HeadlessContext context;
    Renderer renderer(package, memory_budget(o.memory));
    SceneWithout without(package, settings.weights.transient_mask);
    std::vector<PhotoEvaluation> results;
    std::vector<RegionError> regions(renderer.scene().clusters.size());
    const int names = name_width(package, held_out);
    print_heading(names);
    for (const std::uint32_t p : held_out) {
        EvaluationPictures pictures;
        settings.image_sets = {.shown = package.photos()[p].image_set};  // predicted by its image set
        const int level = std::min(o.level, int(package.photos()[p].levels) - 1);
        const auto records = without.hold_out(p, renderer);
        results.push_back(
            evaluate_held_out(renderer, settings, {p, level, photos, records}, regions, pictures));
        write_pictures(o.folder, results.back(), pictures);
        if (!o.against.empty()) compare(o, results.back(), pictures);
        print_row(results.back(), names);
    }
    remark(results);
    print_means(results, names);
    print_causes(results);
    print_remarks(results);
    if (!o.against.empty()) print_changes(o.against, results);
    write_photos(o.folder / "photos.csv", results);
    write_regions(o.folder / "regions.csv", package, regions);
    write_model(o.folder / "regions.ply", package, regions);
    write_evaluation_page(o.folder, package.path().filename().string() + ": each photo held out", results,
                          o.worst);
    std::fprintf(text_output(), "%s\n", (o.folder / "index.html").c_str());
    vantage::results().update({{"photos", json_of(results)}, {"page", (o.folder / "index.html").string()}});
    return int(Exit::ok);
}

}  // namespace vantage
