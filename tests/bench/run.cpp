#include "tests/bench/run.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <optional>
#include <thread>

#include "base/cli/command.h"
#include "base/files/make_folder.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "pipeline/input/file_identity.h"
#include "pipeline/run/processor_name.h"
#include "tests/bench/measure/timing.h"
#include "tests/bench/page/page.h"
#include "tests/bench/plots/gnuplot.h"
#include "tests/bench/results/log.h"
#include "tests/bench/results/tables.h"
#include "tests/bench/sweeps/sweep.h"

namespace vantage::bench {
namespace {

namespace fs = std::filesystem;

// The columns are name, longest, views, photos, repeats and points.
const Effort efforts[] = {
    {"smoke", 200, 2, 2, 1, 2000}, {"short", 400, 2, 2, 2, 20000}, {"full", 640, 2, 3, 3, 200000}};

const Effort& effort_named(const std::string& name) {
    const auto found = std::ranges::find(efforts, name, &Effort::name);
    if (found == std::end(efforts))
        throw Error(Exit::usage, "--set " + name + ": expected smoke, short or full");
    return *found;
}

fs::path datasets() {
    const char* root = std::getenv("VANTAGE_DATASETS");
    return root ? root : "../shared/datasets";
}

/// The default inputs of a set: synthetic scenes, and those real scans that are available.
std::vector<fs::path> default_inputs(const std::string& set) {
    const fs::path data = fs::path(VANTAGE_SOURCE_DIR) / "data";
    if (set == "smoke") return {data / "tiny.toml"};
    std::vector<fs::path> out{data / "small.toml"};
    for (const char* name : {"sceaux", "fountain-P11"}) {
        if (fs::is_directory(datasets() / name)) out.push_back(datasets() / name);
        if (set == "short") break;
    }
    return out;
}

std::vector<std::string> machine() {
    const gl::HeadlessContext context;
    const gl::Device device = gl::current_device();
    const std::time_t now = std::time(nullptr);
    return {fmt::format("{}, {} cores", processor_name(), std::thread::hardware_concurrency()),
            fmt::format(
                "OpenGL: {}{}", device.renderer,
                device.software ? " (software: frame times do not predict those of a graphics card)" : ""),
            fmt::format("{:%Y-%m-%d}", fmt::gmtime(now))};
}

bool wanted(const RunOptions& o, const char* sweep) {
    return o.only.empty() || std::ranges::count(o.only, sweep) > 0;
}

void run_job(Log& log, const std::string& key, const Sweep& sweep, const BenchScene& scene, const Job& job) {
    std::vector<Measurement> found;
    const double ms = milliseconds([&] { found = job.run(); });
    for (Measurement& m : found) {
        m.sweep = sweep.name;
        m.scene = scene.name;
    }
    log.add(key, ms / 1000, found);
}

/// Prints one line per job; the job's name appears when its measurement starts.
void run_scene(const RunOptions& o, const Effort& effort, const BenchScene& scene, Log& log) {
    for (const Sweep& sweep : sweeps()) {
        if (!wanted(o, sweep.name)) continue;
        for (const Job& job : sweep.jobs(scene, effort, o.folder / "pictures")) {
            const std::string key = scene.name + " " + sweep.name + " " + job.name;
            if (log.holds(key)) continue;
            fmt::print("{:<14} {:<14} {:<24}", scene.name, sweep.name, job.name);
            std::fflush(stdout);
            const double before = log.seconds();
            run_job(log, key, sweep, scene, job);
            fmt::print(" {:6.1f} s\n", log.seconds() - before);
            std::fflush(stdout);
        }
    }
}

/// Identifies the effort and this program; a run is resumed only if neither has changed.
std::string identity(const Effort& effort) {
    return fmt::format("{} {:016x}", effort.name, identify(fs::read_symlink("/proc/self/exe")).checksum);
}

int list_sweeps() {
    for (const Sweep& s : sweeps()) fmt::print("{:<14} {}\n               {}\n", s.name, s.title, s.question);
    return int(Exit::ok);
}

/// Writes the tables and the page of a run.
int write_results(const RunOptions& o, const Run& now) {
    make_folder(o.folder);
    std::optional<Run> before;
    if (!o.against.empty()) before = read_json(o.against);
    write_csv(o.folder / "results.csv", now.measurements);
    write_json(o.folder / "results.json", now);
    write_page(o.folder, {"What accuracy costs", sweeps(), now, before});
    fmt::print("{}\n", (o.folder / "index.html").string());
    return int(Exit::ok);
}

}  // namespace

void add_run_options(const Command& c, RunOptions& o) {
    c.list("INPUT", o.inputs,
           "folders of scans, or specifications of synthetic scenes (TOML); default: those of the set, with "
           "real scans from $VANTAGE_DATASETS")
        .type("FILE");
    c.choice("--set", o.set, {"smoke", "short", "full"},
             "how much to measure: smoke (about a minute), short (about ten minutes), full");
    c.list("--only", o.only, "sweeps to run; see --list").commas();
    c.file("-o,--output", o.folder, "output folder; an interrupted run there is resumed").type("FOLDER");
    c.file("--against", o.against, "results.json of an earlier run; the page shows what has changed since");
    c.file("--redraw", o.redraw, "results.json of a run; its page is written again without measuring");
    c.flag("--list", o.list, "list the sweeps and exit");
    c.notes(
        "Writes index.html (self-contained), results.csv and results.json. An interrupted run resumes where\n"
        "it stopped, unless --set or the program has changed since.\n"
        "Examples:\n  vantage-bench\n  vantage-bench --set full -o full\n"
        "  vantage-bench scans/chapel --only blending,selection -o chapel\n"
        "  vantage-bench --set short -o new --against old/results.json");
    c.action([&o] { return run(o); });
}

int run(const RunOptions& o) {
    if (o.list) return list_sweeps();
    if (!o.redraw.empty()) return write_results(o, read_json(o.redraw));
    const Effort& effort = effort_named(o.set);
    for (const std::string& name : o.only)
        if (std::ranges::find(sweeps(), name, [](const Sweep& s) { return std::string(s.name); }) ==
            sweeps().end())
            throw Error(Exit::usage, "--only " + name + ": no such sweep; see --list");
    if (!o.against.empty()) read_json(o.against);  // fail early if it is invalid
    std::vector<fs::path> inputs(o.inputs.begin(), o.inputs.end());
    if (inputs.empty()) inputs = default_inputs(effort.name);
    svg_plot({});  // fail early if gnuplot is missing
    make_folder(o.folder);
    Log log(o.folder / "log.jsonl", identity(effort));
    if (log.jobs()) fmt::print("resuming after {} completed jobs\n", log.jobs());
    for (const fs::path& input : inputs) {
        fmt::print("{}\n", input.string());
        std::fflush(stdout);
        run_scene(o, effort, open_scene(input, o.folder / "scenes", effort), log);
    }
    std::vector<std::string> about = machine();
    about.push_back(fmt::format("measured in {:.1f} minutes", log.seconds() / 60));
    return write_results(o, {VANTAGE_VERSION, effort.name, about, log.measurements()});
}

}  // namespace vantage::bench
