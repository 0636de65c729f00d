#include "player/measure/bench/flight_summary.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/cli/standard_output.h"
#include "base/files/replace_file.h"
#include "player/render/timing/frame_statistics.h"

namespace vantage {

namespace {

/// Mean milliseconds per frame of each pass with a nonzero time.
nlohmann::json pass_times(const std::vector<const Flight*>& flights) {
    nlohmann::json out = nlohmann::json::object();
    for (std::size_t pass = 0; pass < timed_pass_names.size(); ++pass) {
        double ms = 0, frames = 0;
        for (const Flight* f : flights) ms += f->pass_ms.at(pass), frames += double(f->frames.size());
        if (ms > 0) out[timed_pass_names.at(pass)] = ms / std::max(1.0, frames);
    }
    return out;
}

}  // namespace

nlohmann::json summarize(const std::vector<const Flight*>& flights, std::size_t upload_budget) {
    std::vector<double> all, medians, ratios, scales, plans;
    std::uint64_t uploaded = 0, over = 0, graphics = 0, process = 0, missing = 0;
    StreamedSoFar streamed;
    for (const Flight* f : flights) {
        const std::vector<double> ms = frame_times(*f);
        const FrameStatistics s = frame_statistics(ms);
        all.insert(all.end(), ms.begin(), ms.end());
        medians.push_back(s.median);
        ratios.push_back(s.median > 0 ? s.p999 / s.median : 0);
        streamed = streamed + f->streamed;
        for (const FrameRecord& r : f->frames) {
            uploaded = std::max<std::uint64_t>(uploaded, r.report.uploaded);
            over += r.report.uploaded > upload_budget;
            graphics = std::max(graphics, r.graphics);
            process = std::max(process, r.process.resident);
            missing += r.report.tiles_missing > 0;
            scales.push_back(r.scale);
            plans.push_back(r.report.plan_ms);
        }
    }
    const FrameStatistics s = frame_statistics(all), planning = frame_statistics(plans);
    const auto [low, high] = std::ranges::minmax(medians);
    nlohmann::json out{
        {"path", flights[0]->path},
        {"mode", flights[0]->mode},
        {"repeats", flights.size()},
        {"frames", all.size()},
        {"ms", {{"mean", s.mean}, {"median", s.median}, {"p99", s.p99}, {"p999", s.p999}, {"max", s.max}}},
        {"pass_ms", pass_times(flights)},
        {"plan_ms", {{"median", planning.median}, {"p999", planning.p999}}},
        {"scale", {{"median", frame_statistics(scales).median}, {"least", std::ranges::min(scales)}}},
        {"median_spread", low > 0 ? high / low : 0},
        {"p999_over_median", frame_statistics(ratios).median},
        {"frames_with_tiles_missing", missing},
        {"uploaded_bytes_a_frame_max", uploaded},
        {"upload_budget_bytes", upload_budget},
        {"frames_over_upload_budget", over},
        {"graphics_bytes_max", graphics},
        {"graphics_budget_bytes", flights.back()->graphics_budget},
        {"process_bytes_max", process},
        {"bytes_read", streamed.bytes / flights.size()},
        {"reading_and_decoding_seconds", streamed.seconds / double(flights.size())}};
    if (const Flight& f = *flights.back(); f.frames_to_exact >= 0) {
        out["frames_to_exact"] = f.frames_to_exact;
        out["seconds_to_exact"] = f.ms_to_exact / 1000;
        out["bytes_to_exact"] = f.streamed_to_exact.bytes;
        out["reading_and_decoding_seconds_to_exact"] = f.streamed_to_exact.seconds;
        out["bytes_touched"] = f.touched_bytes;
        out["read_over_touched"] =
            double(f.streamed_to_exact.bytes) / double(std::max<std::uint64_t>(1, f.touched_bytes));
    }
    return out;
}

void print_summary(const nlohmann::json& s) {
    const auto& ms = s["ms"];
    std::fprintf(
        text_output(),
        "%-10s %-9s  mean %7.2f  median %7.2f  99 %% %7.2f  99.9 %% %7.2f  max %7.2f ms  99.9 %%/median %.2f"
        "  %5.1f MiB read and decoded in %.2f s  at most %.1f MiB per frame",
        s["path"].get<std::string>().c_str(), s["mode"].get<std::string>().c_str(), ms["mean"].get<double>(),
        ms["median"].get<double>(), ms["p99"].get<double>(), ms["p999"].get<double>(),
        ms["max"].get<double>(), s["p999_over_median"].get<double>(),
        double(s["bytes_read"].get<std::uint64_t>()) / 1048576,
        s["reading_and_decoding_seconds"].get<double>(),
        double(s["uploaded_bytes_a_frame_max"].get<std::uint64_t>()) / 1048576);
    if (s["mode"] == "adaptive")
        std::fprintf(text_output(), "  at %.0f %% of the resolution (median)",
                     100 * s["scale"]["median"].get<double>());
    if (s.contains("read_over_touched"))
        std::fprintf(text_output(), "  exact after %d frames, %.2f s, %.2f bytes read per byte touched",
                     s["frames_to_exact"].get<int>(), s["seconds_to_exact"].get<double>(),
                     s["read_over_touched"].get<double>());
    if (s["mode"] == "resident" && s["uploaded_bytes_a_frame_max"] > 0)
        std::fprintf(
            text_output(),
            "  not all tiles fit into graphics memory, so frames upload some again (--graphics-memory)");
    const auto& plan = s["plan_ms"];
    std::fprintf(text_output(),
                 "\n    plan %.2f, 99.9 %% %.2f ms; mean of passes:", plan["median"].get<double>(),
                 plan["p999"].get<double>());
    for (const auto& [name, ms_of_pass] : s["pass_ms"].items())
        std::fprintf(text_output(), "  %s %.2f", name.c_str(), ms_of_pass.get<double>());
    std::fprintf(text_output(), " ms\n");
    std::fflush(text_output());
}

void write_frames(const std::filesystem::path& file, const std::vector<Flight>& flights) {
    std::ostringstream out;
    out << "path,mode,repeat,frame,ms,scale,uploaded_bytes,tiles,tiles_missing,tiles_damaged,photos,passes,"
           "draws,"
           "graphics_bytes,process_bytes,anonymous_bytes,plan_ms\n";
    for (const Flight& f : flights)
        for (std::size_t i = 0; i < f.frames.size(); ++i) {
            const FrameRecord& r = f.frames[i];
            out << f.path << ',' << f.mode << ',' << f.repeat << ',' << i << ',' << r.ms << ',' << r.scale
                << ',' << r.report.uploaded << ',' << r.report.tiles << ',' << r.report.tiles_missing << ','
                << r.report.tiles_damaged << ',' << r.report.photos << ',' << r.report.passes << ','
                << r.report.draws << ',' << r.graphics << ',' << r.process.resident << ','
                << r.process.anonymous << ',' << r.report.plan_ms << '\n';
        }
    replace_file(file, out.view());
}

}  // namespace vantage
