#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/cli/standard_output.h"
#include "base/cli/stop_signals.h"
#include "base/files/part_file.h"
#include "base/text/error.h"
#include "base/text/parse_number.h"
#include "pipeline/align/conventions.h"
#include "pipeline/align/settle_turns.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/apply_config.h"
#include "pipeline/commands/shared/effect_option.h"
#include "pipeline/commands/shared/input_options.h"
#include "pipeline/commands/shared/prepare_scene.h"
#include "pipeline/commands/shared/progress_option.h"
#include "pipeline/commands/shared/skipped_photos.h"
#include "pipeline/costs/cost_table.h"
#include "pipeline/costs/effect_costs.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/input/input_paths.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/output/meta.h"
#include "pipeline/output/stage_table.h"
#include "pipeline/output/staleness.h"
#include "pipeline/prepare/finish.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/prepare/resources.h"
#include "pipeline/reports/page/report.h"
#include "pipeline/run/config_files.h"
#include "pipeline/run/settings.h"
#include "pipeline/run/trace.h"
#include "scene/package/damaged_package.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"

namespace vantage {
namespace {

/// The corrections that are made where photos disagree.
enum class Refine { off, color, full };

struct PrepareOptions {
    InputOptions input;
    std::string out, config, share, trace, report;
    ProgressStyle progress = ProgressStyle::automatic;
    Refine refine = Refine::full;
    std::vector<std::string> effects, conventions{convention_auto};
    PrepareSettings settings;
    bool explain = false, strict = false, rehash = false, no_report = false, force = false;

    bool writes_report() const { return !no_report && share.empty(); }
};

/// "3/8": the third of eight shards.
Share share(const std::string& text) {
    constexpr unsigned most = 65536;
    Share s;
    if (text.empty()) return s;
    const std::size_t slash = std::min(text.find('/'), text.size() - 1);
    if (!parse_number(text.substr(0, slash), s.share) || !parse_number(text.substr(slash + 1), s.shares) ||
        s.share < 1 || s.share > s.shares || s.shares > most)
        throw Error(Exit::usage,
                    fmt::format("--shard {}: expected i/n, i from 1 to n, n up to {}", text, most));
    return s;
}

/// Resolves the files to write, following links. Throws Error(usage) if one of these files must not be
/// replaced.
void resolve_outputs(PrepareOptions& o, const InputFiles& files) {
    Inputs inputs{input_paths(files), {}};
    if (!o.config.empty()) inputs.files.push_back(find_preset(o.config));
    if (o.writes_report()) o.report = std::filesystem::path(o.out).replace_extension(".html").string();
    o.out = output_file(o.out, Product::package, inputs, o.force).string();
    for (const std::filesystem::path& own :
         {std::filesystem::path(o.out), part_of(o.out), packing_of(o.out), displaced_part_of(o.out)})
        inputs.files.push_back(own);
    if (o.writes_report()) {
        o.report = output_file(o.report, Product::page, inputs, o.force).string();
        inputs.files.emplace_back(o.report);
    }
    if (!o.trace.empty()) o.trace = output_file(o.trace, Product::trace, inputs, o.force).string();
}

/// The photos missing from the existing package if it is valid and current; otherwise nullopt.
std::optional<std::vector<UnusablePhoto>> current(const PrepareOptions& o, const InputFiles& files,
                                                  IdentityCache& identities) {
    if (!std::filesystem::exists(o.out)) return {};
    try {
        const PackageReader package(o.out);
        if (!changed_settings(package, o.settings).empty() ||
            !changed_inputs(package, files, identities).empty())
            return {};
        if (const std::string damage = damage_of(package, identities); !damage.empty()) {
            fmt::print(text_output(), "package  {} is damaged and will be repaired: {}\n", o.out, damage);
            return {};
        }
        return skipped_of(package);
    } catch (const DamagedPackage& e) {
        if (e.defect() == Defect::newer_format)
            throw Error(Exit::input, std::string(e.what()) + "; not overwritten");
        return {};
    } catch (const Error&) {
        return {};
    }
}

void print_warnings(const std::vector<std::string>& warnings) {
    for (const std::string& w : warnings) {
        fmt::print(text_output(), "warning  {}\n", w);
        results()["warnings"].push_back(w);
    }
    std::fflush(text_output());
}

void print_scene(const SceneInput& scene, const ConventionTrials& fit) {
    if (!scene.files.mesh.empty())
        fmt::print(text_output(), "mesh     {} ({} vertices, {} triangles)\n", scene.files.mesh.string(),
                   scene.mesh.positions.size(), scene.mesh.triangles.size());
    if (!scene.files.cameras.empty())
        fmt::print(text_output(), "cameras  {}{} ({})\n", scene.files.cameras.string(),
                   scene.files.more_cameras.empty()
                       ? ""
                       : fmt::format(" and {} more", scene.files.more_cameras.size()),
                   scene.camera_format);
    if (!scene.files.photos.empty())
        fmt::print(text_output(), "photos   {} ({})\n", scene.files.photos.string(), scene.photos.size());
    for (std::uint32_t b = 0; scene.image_sets.size() > 1 && b < scene.image_sets.size(); ++b)
        fmt::print(text_output(), "image set     {} ({})\n", scene.image_sets[b],
                   std::ranges::count(scene.photos, b, &PhotoInput::image_set));
    if (!scene.points.positions.empty())
        fmt::print(text_output(), "points   {}{} ({})\n", scene.files.points.front().string(),
                   scene.files.points.size() > 1 ? " and others" : "", scene.points.positions.size());
    if (scene.convention != as_read)
        fmt::print(text_output(), "taken    with --convention {}\n", scene.convention);
    if (const std::string text = fit_of(fit, scene); !text.empty())
        fmt::print(text_output(), "fit      {}\n", text);
    for (const std::string& n : scene.files.notes) fmt::print(text_output(), "note     {}\n", n);
    print_warnings(scene.warnings);
    results().update({{"mesh", scene.files.mesh.string()},
                      {"vertices", scene.mesh.positions.size()},
                      {"triangles", scene.mesh.triangles.size()},
                      {"cameras", scene.files.cameras.string()},
                      {"camera_format", scene.camera_format},
                      {"photos", scene.photos.size()},
                      {"points", scene.points.positions.size()},
                      {"notes", scene.files.notes}});
}

std::string some(const std::vector<std::string>& photos) {
    const std::string first = photos.front();
    return photos.size() == 1 ? first : fmt::format("{} photos, the first {}", photos.size(), first);
}

/// Prints for how many photos each stage ran and for how many its earlier results were kept; with `why`, also
/// the reasons.
void print_done(const PrepareResult& done, bool why) {
    std::size_t kept = 0;
    for (const PrepareResult::Stage& s : done.stages) kept += s.kept;
    for (std::size_t s = 0; s < done.stages.size() && (why || kept > 0); ++s) {
        fmt::print(text_output(), "{:<12} {} made, {} kept\n", stage_row(package::Stage(s)).name,
                   done.stages[s].made, done.stages[s].kept);
        for (const auto& [reason, photos] : done.stages[s].why)
            if (why) fmt::print(text_output(), "             {}: {}\n", some(photos), reason);
    }
    for (std::size_t s = 0; s < done.stages.size(); ++s)
        results()["stages"].push_back({{"name", stage_row(package::Stage(s)).name},
                                       {"made", done.stages[s].made},
                                       {"kept", done.stages[s].kept},
                                       {"why", done.stages[s].why}});
}

/// Prints the names of the finished package and of its report, and the size, time and memory.
void print_package(const PrepareOptions& o, double seconds) {
    const std::uintmax_t bytes = std::filesystem::file_size(o.out);
    fmt::print(text_output(), "package  {} ({:.1f} MB, {:.1f} s)\nmemory   {:.0f} MB peak\n", o.out,
               double(bytes) / 1e6, seconds, double(memory_peak()) / 1e6);
    results().update({{"package", o.out},
                      {"current", false},
                      {"bytes", bytes},
                      {"seconds", seconds},
                      {"memory_bytes", memory_peak()}});
    if (!o.writes_report()) return;
    fmt::print(text_output(), "report   {}\n", o.report);
    results()["report"] = o.report;
}

/// Prints the costs of the settings: those measured on this scan or, if there are none, those shipped with
/// the program.
void print_known_costs(const std::string& package) {
    const KnownCosts known = known_costs(costs_key(PackageReader(package)));
    fmt::print(text_output(), "costs    {}\n", origin_of(known));
    if (known.costs.scans.empty()) return;
    for (const std::string& line : as_lines(trial_table(known.costs.scans)))
        fmt::print(text_output(), "         {}\n", line);
}

/// Reports that the package is current; with --explain, also why.
void print_current(const PrepareOptions& o) {
    fmt::print(text_output(), "package  {} is current, nothing to do\n", o.out);
    results().update({{"package", o.out}, {"current", true}});
    if (!o.explain) return;
    const std::size_t files = inputs_of(PackageReader(o.out)).contents.size();
    fmt::print(text_output(),
               "explain  {} input files: none changed, added or missing; settings and program unchanged; "
               "every checksum matches\n",
               files);
    print_known_costs(o.out);
}

void print_needs(const ResourceEstimate& n) {
    fmt::print(text_output(), "needs    {}\n", in_words(n));
    std::fflush(text_output());
}

PrepareResult prepare_shown(const PrepareOptions& o, const Share& part, SceneInput scene,
                            IdentityCache& identities, Trace& trace,
                            std::chrono::steady_clock::time_point start) {
    ProgressLine line(o.progress);
    const PrepareRun run{
        &stop_on_signals(InFlight::finished), o.strict, &identities, part, &trace, print_needs, true, start};
    return prepare(
        std::move(scene), o.settings, o.out, [&](const Progress& p) { line.show(p); }, run);
}

SceneInput read_traced(const InputFiles& files, Trace& trace) {
    const Traced traced(&trace, "import");
    return read_scene(files);
}

ConventionTrials settle_traced(SceneInput& scene, const PrepareSettings& settings, Trace& trace) {
    const Traced traced(&trace, "conventions");
    // Each thread takes about 70 MB, which the memory estimate does not include.
    const unsigned threads = settings.memory > 0 ? 1 : std::min(2u, threads_of(settings));
    settle_turns(scene, threads);
    return settle_convention(scene, settings.convention, threads);
}

/// Also prints the scene's warnings if the mesh does not fit, because they may give the reason.
ConventionTrials settled_or_warned(SceneInput& scene, const PrepareSettings& settings, Trace& trace) {
    try {
        return settle_traced(scene, settings, trace);
    } catch (const Error& e) {
        if (e.code() == Exit::misplaced) print_warnings(scene.warnings);
        throw;
    }
}

int run_prepare(PrepareOptions o) {
    o.settings.convention = wanted_conventions(o.conventions);
    for (const EffectRow& row : effect_table())
        if ((row.basis == Basis::pixels && o.refine != Refine::full) ||
            (row.basis == Basis::colors && o.refine == Refine::off))
            o.settings.effects[row.effect] = EffectChoice::off;
    choose_effects(o.effects, o.settings.effects);
    const Share part = share(o.share);
    const auto start = std::chrono::steady_clock::now();
    const FoundInput found = find_input(o.input, o.settings);
    if (found.lacks) throw *found.lacks;
    const InputFiles& files = found.files;
    resolve_outputs(o, files);
    IdentityCache identities(default_identity_cache(), o.rehash);
    publish_interrupted(o.out);
    if (const auto lacking = current(o, files, identities)) {
        print_current(o);
        return int(report_skipped(*lacking));
    }
    Trace trace;
    SceneInput scene = read_traced(files, trace);
    const ConventionTrials fit = settled_or_warned(scene, o.settings, trace);
    print_scene(scene, fit);
    const PrepareResult done = prepare_shown(o, part, std::move(scene), identities, trace, start);
    if (!o.trace.empty()) write_trace(o.trace, trace.spans());
    const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (o.writes_report())
        write_report(o.report, PackageReader(o.out),
                     ReportRun{done, trace.spans(), s, double(memory_peak()) / 1e6});
    if (done.agreement) print_warnings(done.agreement->pose_refinement.warnings);
    print_done(done, o.explain);
    if (o.explain) print_known_costs(o.out);
    print_package(o, s);
    return int(report_skipped(done.skipped));
}

/// Prepares the scene file's objects, with the same settings, into packages in the output folder.
int run_prepare_scene(const PrepareOptions& o) {
    if (!o.share.empty() || !o.trace.empty())
        throw Error(Exit::usage,
                    o.input.input + ": --shard and --trace are for one package, not for a scene file");
    return prepare_scene(o.input.input, o.out, o.force, [&](const SceneObject& object) {
        PrepareOptions one = o;
        take_input(object.input, one.input, one.settings);
        one.out = object.package.string();
        return run_prepare(one);
    });
}

/// The values, each with its name in META.
template <class Enum>
std::vector<std::pair<std::string, Enum>> named(std::initializer_list<Enum> values) {
    std::vector<std::pair<std::string, Enum>> out;
    for (const Enum value : values) out.emplace_back(name(value), value);
    return out;
}

}  // namespace

void add_prepare(const Command& program) {
    auto o = std::make_shared<PrepareOptions>();
    const Command c = program.verb("prepare", "Prepare a mesh and its photos into one package");
    c.notes(
        "Examples:\n  vantage prepare scans/chapel -o chapel.vantage\n"
        "  vantage prepare --mesh m.ply --cameras bundle.out --photos images -o m.vantage\n"
        "  vantage prepare chapel -o look.vantage --preset preview\n"
        "  vantage prepare chapel -o c.vantage --effect per-fragment=on --hold-out 0003,0007\n"
        "  vantage prepare chapel -o raw.vantage --effect compact=off    # raw tiles, not JPEG\n"
        "  vantage prepare chapel -o c.vantage --deviation-from chapel-2019.ply\n"
        "  vantage prepare chapel -o c.vantage --points scanner.ply\n"
        "  vantage prepare panel -o panel.vantage --image-sets folders\n"
        "  vantage prepare chapel -o chapel-3.shard --shard 3/8\n"
        "  vantage prepare church.toml -o church    # several objects; see docs/scenes.md\n"
        "If it is run again, it resumes an interrupted run and repeats only the stages that a change "
        "affects.");
    PrepareSettings& settings = o->settings;
    add_input_options(c, o->input, settings);
    c.list("--deviation-from", settings.deviation_from,
           "measure the mesh's signed distance from this mesh or point cloud, as a scalar field; may be "
           "repeated")
        .type("FILE");
    c.list("--convention", o->conventions,
           "corrections to the convention of cameras or mesh: auto (tested against the photos), as-read "
           "(none), or one or more of the others")
        .type("NAME")
        .suggests(convention_names())
        .commas()
        .one_word();
    c.file("-o,--output", o->out, "the package to write, or the folder for the packages of a scene file")
        .required();
    c.file("--preset", o->config,
           "preset to use, or a TOML file with settings; options on the command line take precedence")
        .suggests({presets.begin(), presets.end()});
    c.choice("--border-distance", settings.distance,
             named({DistanceMethod::automatic, DistanceMethod::exact, DistanceMethod::jump_flooding}),
             "method for the distance from depth borders: exact, or jump flooding with OpenGL; "
             "auto: jump flooding on a GPU");
    c.integer("--thumbnail-size", settings.thumbnail, 16, 4096, "long side of the thumbnails in px");
    c.integer("--max-photo-size", settings.photo_size, 0, 1 << 16,
              "scale photos down so that the long side is at most this many px; 0 = full size");
    c.flag("--vertex-coordinates", settings.vertex_coordinates,
           "store texture coordinates per vertex, for the player's --coordinates vertex, even if the scene "
           "does not need them");
    c.choice("--refine", o->refine, {{"off", Refine::off}, {"color", Refine::color}, {"full", Refine::full}},
             "full: correct cameras and colors and mask moving objects where photos disagree; color: correct "
             "colors only; off: change nothing");
    c.choice("--validate", settings.validate, {{"on", true}, {"off", false}},
             "on: effects must improve held-out photos; off: faster, thresholds alone decide");
    c.choice("--renderer", settings.render_by,
             named({RenderBy::automatic, RenderBy::opengl, RenderBy::processor}),
             "renderer of the model as seen by the photos' cameras; auto: a GPU if available");
    c.integer("--threads", settings.threads, 0, 1024,
              "number of threads, and of photos in flight; 0 = one per core");
    c.bytes("--memory", settings.memory,
            "memory limit in bytes, such as 800M; lowers the number of photos in flight");
    c.list("--hold-out", settings.hold_out, "photos to store as cameras only, without their pixels")
        .type("PHOTO")
        .commas();
    c.flag("--explain", o->explain, "print for how many photos each stage ran, and why");
    c.flag("--strict", o->strict, "stop at the first unusable photo instead of skipping it");
    c.flag("--rehash", o->rehash, "detect changed files by content, not by size and timestamps");
    c.text("--shard", o->share, "i/n: prepare only every n-th photo, for 'vantage merge'").type("I/N");
    c.flag("--no-report", o->no_report, "do not write a report (NAME.html) next to the package");
    c.force(o->force);
    c.file("--trace", o->trace, "write a trace of all threads for Perfetto or chrome://tracing");
    add_progress(c, o->progress);
    add_effects(c, o->effects);
    c.action([o, c] {
        if (!o->config.empty()) apply_config(c, o->config);
        return is_scene_of_objects(o->input, o->settings) ? run_prepare_scene(*o) : run_prepare(*o);
    });
}

}  // namespace vantage
