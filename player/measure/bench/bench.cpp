#include "player/measure/bench/bench.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/files/make_folder.h"
#include "base/files/replace_file.h"
#include "base/gl/context.h"
#include "base/text/error.h"
#include "base/text/json_text.h"
#include "player/measure/bench/flight_summary.h"
#include "player/measure/bench/plot.h"

namespace vantage {
namespace {

/// Flies all repeats and modes of one path. Repeats alternate between modes, so that a slowdown of the
/// machine affects all of them.
std::vector<Flight> fly_path(const PackageReader& package, const BenchOptions& o, const std::string& name,
                             const FlightTarget& target) {
    std::vector<Flight> flights;
    for (int repeat = 0; repeat < o.repeats; ++repeat)
        for (const std::string& mode : o.modes)
            flights.push_back(fly(package, o, path_named(name, package, o, repeat), mode, repeat, target));
    return flights;
}

/// Prints and appends a summary per mode, and plots the frame times.
void summarize_path(const BenchOptions& o, const std::vector<Flight>& flights, nlohmann::json& summaries) {
    std::vector<Curve> curves;
    for (const std::string& mode : o.modes) {
        std::vector<const Flight*> same;
        for (const Flight& f : flights)
            if (f.mode == mode) same.push_back(&f);
        summaries.push_back(summarize(same, o.memory.upload_bytes()));
        print_summary(summaries.back());
        curves.push_back({mode, frame_times(*same.front())});
    }
    const std::string stem = flights.front().path;
    write_plot(o.folder / (stem + ".svg"), "frame time, " + stem, "ms", curves);
}

}  // namespace

int run_bench(const PackageReader& package, const BenchOptions& o) {
    const FrameSize size = o.output.size.empty() ? FrameSize{1280, 720} : parse_size(o.output.size);
    make_folder(o.folder);
    const gl::HeadlessContext context;
    const FlightTarget target = make_flight_target(size);
    std::fprintf(text_output(), "%s, %dx%d, %d repeats\n", gl::current_device().renderer.c_str(), size.width,
                 size.height, o.repeats);
    std::fflush(text_output());
    std::vector<Flight> all;
    nlohmann::json summaries = nlohmann::json::array();
    for (const std::string& name : o.paths) {
        std::vector<Flight> flights = fly_path(package, o, name, target);
        summarize_path(o, flights, summaries);
        std::ranges::move(flights, std::back_inserter(all));
    }
    write_frames(o.folder / "frames.csv", all);
    replace_file(o.folder / "summary.json", json_text(summaries) + "\n");
    results().update({{"folder", o.folder.string()}, {"flights", summaries}});
    return int(Exit::ok);
}

}  // namespace vantage
