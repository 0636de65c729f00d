#include "pipeline/reports/inspect/facts_text.h"

#include <fmt/format.h>

#include <map>
#include <span>
#include <string_view>

#include "base/text/photo_names.h"
#include "pipeline/formats/cameras/cameras.h"
#include "pipeline/reports/inspect/file_facts.h"
#include "pipeline/stages/mesh_in_view.h"

namespace vantage {
namespace {

constexpr std::size_t max_names = 5, max_lines = 8;

/// Labeled lines; a label that repeats is printed only once.
class Lines {
  public:
    template <class... Args>
    void add(std::string_view label, fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format("{:<9}{}\n", label == label_ ? "" : label,
                             fmt::format(format, std::forward<Args>(args)...));
        label_ = label;
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_, label_;
};

std::string counted(std::size_t n, const std::string& one, const std::string& more) {
    return fmt::format("{} {}", n, n == 1 ? one : more);
}
std::string counted(std::size_t n, const std::string& one) { return counted(n, one, one + "s"); }

std::string megabytes(double bytes) { return fmt::format("{:.{}f} MB", bytes / 1e6, bytes < 1e5 ? 3 : 1); }

std::string corner(const Eigen::Vector3d& p) {
    return fmt::format("({:.7g}, {:.7g}, {:.7g})", p.x(), p.y(), p.z());
}

/// "0.5", or "0.5 to 0.7" if the limits differ when printed.
std::string in_words(const Range& range, int digits) {
    const std::string low = fmt::format("{:.{}g}", range.low, digits),
                      high = fmt::format("{:.{}g}", range.high, digits);
    return low == high ? low : low + " to " + high;
}

void add_shape(const ShapeFacts& shape, const std::vector<std::filesystem::path>& files,
               const std::vector<std::filesystem::path>& companions, const char* label, Lines& out) {
    const std::string others = files.size() > 1 ? fmt::format(" and {} more", files.size() - 1) : "";
    const std::string size = shape.triangles > 0 ? counted(shape.vertices, "vertex", "vertices") + ", " +
                                                       counted(shape.triangles, "triangle")
                                                 : counted(shape.vertices, "point");
    out.add(label, "{}{}: {}, {}, {}", files.front().string(), others, format_of(files.front()),
            megabytes(double(length_of(files))), size);
    const Eigen::Vector3d extent = shape.high - shape.low;
    out.add(label, "{:.4g} x {:.4g} x {:.4g} units, from {} to {}{}", extent.x(), extent.y(), extent.z(),
            corner(shape.low), corner(shape.high),
            shape.strays ? ", without " + counted(shape.strays, "vertex", "vertices") + " far away" : "");
    std::string has = shape.colors ? "vertex colors" : "no vertex colors";
    if (!shape.fields.empty())
        has += fmt::format(", {} ({})", counted(shape.fields.size(), "scalar field"),
                           first_of(shape.fields, max_names));
    std::vector<std::string> names;
    for (const auto& file : companions)
        if (std::filesystem::exists(file)) names.push_back(file.filename().string());
    if (!names.empty()) has += ", also read: " + first_of(names, max_names);
    out.add(label, "{}", has);
}

/// Text for a horizontal and a vertical range.
std::string in_words(const Range& x, const Range& y, int digits, std::string_view unit) {
    const std::string across = in_words(x, digits), down = in_words(y, digits);
    if (y.empty() || across == down) return fmt::format("{} {}", across, unit);
    return fmt::format("{} {} across, {} down", across, unit, down);
}

std::string in_words(const LensFacts& lens) {
    std::string out = counted(lens.cameras, "camera");
    if (lens.width > 0) out += fmt::format(" of {}x{}", lens.width, lens.height);
    if (lens.calibrations == 0) return out + ": no usable calibration";
    const std::string unit = name(lens.unit);
    out += ": focal length " + in_words(lens.focal_x, lens.focal_y, 6, unit == "px" ? unit : unit + "s");
    if (!lens.view_x.empty()) out += "; field of view " + in_words(lens.view_x, lens.view_y, 3, "degrees");
    if (lens.cameras > 1)
        out += lens.calibrations == 1              ? "; one calibration"
               : lens.calibrations == lens.cameras ? "; each with its own calibration"
                                                   : fmt::format("; {} calibrations", lens.calibrations);
    return out;
}

std::string distortion(const LensFacts& lens) {
    std::string out(name(lens.model));
    const Eigen::Vector2d ray(0.5, 0.5);
    if (lens.coefficients.empty())
        return distort({lens.model, {}}, ray) == ray ? "no distortion" : out + ", all coefficients 0";
    for (const LensFacts::Coefficient& c : lens.coefficients)
        out += fmt::format("{} {} {}", &c == &lens.coefficients.front() ? ":" : ",", c.name,
                           in_words(c.value, 4));
    return out;
}

void add_cameras(const InputFacts& facts, Lines& out) {
    const InputFiles& files = facts.files;
    if (files.cameras.empty()) {
        const std::string names = camera_format_names();
        const bool said = facts.error && std::string_view(facts.error->what()).find(names) != names.npos;
        if (files.points.empty() || !files.photos.empty())
            out.add("cameras", "none{}", said ? "" : "; expected " + names);
        return;
    }
    const std::string more =
        files.more_cameras.empty() ? "" : fmt::format(" and {} more", files.more_cameras.size());
    if (!facts.cameras) {
        out.add("cameras", "{}{}: cannot be used", files.cameras.string(), more);
        return;
    }
    out.add("cameras", "{}{}: {}, {}", files.cameras.string(), more, facts.camera_format,
            counted(facts.cameras->cameras, "camera"));
    if (const auto& box = facts.cameras->centers; !box.isEmpty())
        out.add("cameras", "at {}{}", corner(box.min()),
                box.min() == box.max() ? "" : " to " + corner(box.max()));
    for (const LensFacts& lens :
         std::span(facts.cameras->lenses).first(std::min(facts.cameras->lenses.size(), max_lines))) {
        out.add("lens", "{}", in_words(lens));
        out.add("lens", "{}", distortion(lens));
    }
    if (facts.cameras->lenses.size() > max_lines)
        out.add("lens", "and {} more kinds", facts.cameras->lenses.size() - max_lines);
}

std::string in_words(const PhotoGroup& group) {
    const std::string kind = fmt::format("{} {}", group.photos, group.format);
    return group.size.width > 0 ? fmt::format("{} of {}x{}", kind, group.size.width, group.size.height)
                                : kind + " that cannot be read";
}

void add_photos(const InputFacts& facts, Lines& out) {
    if (facts.files.photos.empty()) {
        if (facts.files.points.empty() || !facts.files.cameras.empty()) out.add("photos", "none");
        return;
    }
    if (!facts.photos) {
        out.add("photos", "{}: cannot be used", facts.files.photos.string());
        return;
    }
    const PhotoFacts& photos = *facts.photos;
    out.add("photos", "{}: {}, {:.1f} megapixels, {}", facts.files.photos.string(),
            counted(photos.photos(), "photo"), photos.pixels() / 1e6, megabytes(double(photos.bytes())));
    for (const PhotoGroup& group : std::span(photos.groups).first(std::min(photos.groups.size(), max_lines)))
        out.add("photos", "{}", in_words(group));
    if (photos.groups.size() > max_lines)
        out.add("photos", "and {} more sizes or formats", photos.groups.size() - max_lines);
    if (photos.masks > 0) out.add("photos", "{} of them with a mask", photos.masks);
}

void add_scale(const ScaleFacts& scale, Lines& out) {
    out.add("scale", "no unit known: the files do not state one");
    const std::string distance = in_words(scale.distance, 3), typical = fmt::format("{:.3g}", scale.typical);
    out.add("scale", "cameras are {} units from the surface{}: {:.3g} of the model's diagonal", distance,
            distance == typical ? "" : ", typically " + typical, scale.in_model);
    out.add("scale", "a pixel is typically {:.3g} units wide there", scale.pixel);
    const std::vector<std::string> units = plausible_units(scale.typical);
    if (units.empty())
        out.add("scale", "a guess from the distance: the scale is arbitrary");
    else
        out.add("scale", "a guess from the distance: a unit is 1 {}, unless the scale is arbitrary",
                fmt::join(units, " or 1 "));
}

void add_scene(const InputFacts& facts, Lines& out) {
    for (const auto& image_set : facts.scene->image_sets)
        out.add("image_set", "{} ({})", image_set.name, counted(image_set.photos, "photo"));
    if (facts.scene->scale) add_scale(*facts.scene->scale, out);
}

void add_view(const InputFacts& facts, Lines& out) {
    const std::size_t all = facts.scene->photos, blind = facts.plan->not_seeing.size();
    const char* what = facts.files.mesh.empty() ? "points" : "mesh";
    if (all == 0) return;
    if (blind == 0)
        out.add("view", "every photo's camera sees the {}", what);
    else
        out.add("view", "{} of {} cameras do not see the {} (less than {:g} % of the frame): {}", blind, all,
                what, 100 * least_share_of_frame, first_of(facts.plan->not_seeing, max_names));
}

void add_effects(const std::vector<EffectDecision>& effects, std::size_t photos, Lines& out) {
    std::vector<std::string> open;
    for (const EffectDecision& d : effects)
        if (const EffectRow& row = effect_row(d.effect); from_all_photos(row))
            open.emplace_back(row.option);
        else
            out.add("effects", "{:<18} {:<4} {}", row.option, d.on ? "on" : "off", d.evidence);
    if (photos > 0)
        out.add("effects", "{} are decided from the photos' pixels during preparation",
                fmt::join(open, ", "));
}

void add_warnings(const InputFacts& facts, Lines& out) {
    for (const std::string& note : facts.files.notes) out.add("note", "{}", note);
    const std::size_t shown = std::min(facts.warnings.size(), max_lines);
    for (std::size_t i = 0; i < shown; ++i) out.add("warning", "{}", facts.warnings[i]);
    if (shown < facts.warnings.size()) out.add("warning", "and {} more", facts.warnings.size() - shown);
}

/// Adds one line per reason.
void add_skipped(const std::vector<UnusablePhoto>& skipped, Lines& out) {
    std::map<std::string, std::vector<std::string>> by_reason;
    for (const UnusablePhoto& photo : skipped) by_reason[photo.why].push_back(photo.photo);
    for (const auto& [why, names] : by_reason) out.add("skipped", "{}: {}", first_of(names, max_names), why);
}

void add_result(const InputFacts& facts, Lines& out) {
    const std::size_t all = facts.scene->photos, skipped = facts.skipped.size();
    out.add("result", "prepare would use {}{}", all > 0 ? counted(all, "photo") : "the points alone",
            skipped ? fmt::format(" and skip {}", skipped) : "");
}

}  // namespace

std::string facts_text(const InputFacts& facts) {
    Lines out;
    const InputFiles& files = facts.files;
    if (facts.mesh)
        add_shape(*facts.mesh, {files.mesh}, companions_of(files.mesh, files), "mesh", out);
    else if (!files.mesh.empty())
        out.add("mesh", "{}: cannot be used", files.mesh.string());
    else if (files.points.empty())
        out.add("mesh", "none, and no point cloud");
    if (facts.points)
        add_shape(*facts.points, files.points, {}, "points", out);
    else if (!files.points.empty())
        out.add("points", "{}: cannot be used", files.points.front().string());
    add_cameras(facts, out);
    add_photos(facts, out);
    if (facts.scene) add_scene(facts, out);
    if (facts.plan) {
        add_view(facts, out);
        add_effects(facts.plan->effects, facts.scene->photos, out);
    }
    add_warnings(facts, out);
    add_skipped(facts.skipped, out);
    if (facts.plan) out.add("needs", "{}", in_words(facts.plan->needs));
    if (facts.scene && !facts.error) add_result(facts, out);
    return out.take();
}

}  // namespace vantage
