#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <thread>

#include "base/cli/standard_output.h"
#include "base/cli/stop_signals.h"
#include "base/files/checksum.h"
#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/gl/context.h"
#include "base/gl/failure.h"
#include "base/text/error.h"
#include "base/text/lower_extension.h"
#include "pipeline/commands/commands.h"
#include "pipeline/costs/cost_table.h"
#include "pipeline/costs/costs_page.h"
#include "pipeline/costs/known_costs.h"
#include "pipeline/costs/measure_costs.h"
#include "pipeline/run/processor_name.h"
#include "scene/package/output_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

struct CostsOptions {
    std::vector<std::string> inputs;
    std::string folder = "costs";
    CostEffort effort;
    bool force = false;
};

/// A result without measurements yet, for this program on this machine.
Costs costs_here() {
    Costs out{VANTAGE_VERSION, {}, processor_name(), "none", std::thread::hardware_concurrency(), {}};
    out.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)));
    try {
        const gl::HeadlessContext context;
        out.renderer = gl::current_device().renderer;
    } catch (const gl::Failure&) {  // only preparing can be measured, as the player will report
    }
    return out;
}

/// The interrupted measurement in the folder, if this version made it.
Costs interrupted_in(const fs::path& file, const Costs& here) {
    if (!fs::is_regular_file(file)) return here;
    try {
        Costs before = read_costs(file);
        if (before.version == here.version) return before;
    } catch (const Error&) {  // to be replaced
    }
    return here;
}

bool is_results(const std::string& input) { return lower_extension(input) == ".json"; }

void expect_inputs(const std::vector<std::string>& inputs) {
    for (const std::string& input : inputs) {
        if (!fs::exists(input)) throw Error(Exit::input, input + ": does not exist");
        if (lower_extension(input) == ".toml")
            throw Error(Exit::usage, input +
                                         ": is a scene file; expected the folder of one scan, a package, or "
                                         "a results file (costs.json)");
    }
}

void print_costs(const Costs& costs, const fs::path& page) {
    const auto print = [](const std::string& line) { fmt::print(text_output(), "{}\n", line); };
    for (const std::string& line : as_lines(scan_table(costs))) print(line);
    print("");
    for (const std::string& line : as_lines(trial_table(costs.scans))) print(line);
    for (const ScanCosts& s : costs.scans) {
        print("");
        for (const std::string& line : recipes_in_words(s)) print(line);
    }
    print("");
    print(page.string());
}

int run_costs(const CostsOptions& o) {
    expect_inputs(o.inputs);
    const fs::path folder = o.folder, file = folder / "costs.json";
    const fs::path page = output_file(folder / "index.html", Product::page, {}, o.force);
    const std::atomic<bool>& stop = stop_on_signals(InFlight::abandoned);
    Costs here = costs_here();
    const Costs before = interrupted_in(file, here);
    make_folder(folder);
    for (const std::string& input : o.inputs) {
        if (is_results(input)) {
            const Costs more = read_costs(input);
            here.scans.insert(here.scans.end(), more.scans.begin(), more.scans.end());
            continue;
        }
        const fs::path work =
            folder / "work" / fmt::format("{:016x}", checksum(std::as_bytes(std::span(input))));
        const auto earlier = std::ranges::find(before.scans, input, &ScanCosts::input);
        const ScanCosts so_far = earlier == before.scans.end() ? ScanCosts{} : *earlier;
        here.scans.push_back(so_far);
        const auto report = [&](const std::string& line) {
            fmt::print(text_output(), "{}\n", line);
            std::fflush(text_output());
        };
        const auto save = [&](const ScanCosts& scan) {
            here.scans.back() = scan;
            replace_file(file, to_json(here).dump(1));
        };
        here.scans.back() = measure_costs(input, o.effort, work, so_far, {report, save, &stop});
    }
    fs::remove_all(folder / "work");
    keep_costs(here);
    replace_file(file, to_json(here).dump(1));
    replace_file(page, costs_page(here));
    print_costs(here, page);
    results().update(to_json(here));
    results()["page"] = page.string();
    return int(Exit::ok);
}

}  // namespace

void add_costs(const Command& program) {
    auto o = std::make_shared<CostsOptions>();
    const Command c =
        program.verb("costs", "Measure how much quality, time and space each setting costs on a scan");
    c.notes(
        "Prepares the scan with some photos held out, renders their views, and compares them with the "
        "photos: first with the defaults, then with one other value of each setting in turn, beginning with "
        "the most important settings. Prints a table and recommended command lines, and writes index.html "
        "and costs.json into the folder given by -o. If the command is interrupted, run it again to "
        "continue. 'prepare --explain' and 'info' show the results.\n"
        "Examples:\n  vantage costs scans/chapel\n  vantage costs scans/chapel --full -o chapel-costs\n"
        "  vantage costs chapel.vantage            # display settings only\n"
        "  vantage costs a/costs.json b/costs.json -o both");
    c.list("INPUT", o->inputs,
           "folder of a scan; or a package, to measure only display settings; or an earlier costs.json, to "
           "show several results on one page")
        .type("FILE")
        .required();
    c.file("-o,--output", o->folder, "folder for the results").type("FOLDER");
    c.real("--minutes", o->effort.minutes, 0.1, 10000, "time limit; the defaults are measured in any case");
    c.flag("--full", o->effort.full,
           "measure every setting, however long it takes, with more photos and with each time measured three "
           "times");
    c.force(o->force);
    c.action([o] { return run_costs(*o); });
}

}  // namespace vantage
