#include "player/measure/evaluation/evaluation_table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/cli/standard_output.h"
#include "base/files/replace_file.h"

namespace vantage {
namespace {

constexpr double max_decibels = 99;  ///< upper limit, reached if all of the error has one cause

double decibels_without(double share) {
    return share < 1 ? std::min(max_decibels, -10 * std::log10(1 - share)) : max_decibels;
}

CauseTotal cause_total(Cause cause, const std::vector<PhotoEvaluation>& results, const CauseSquares& all) {
    CauseTotal t{cause, all.share(cause), all.colored_share(cause)};
    for (std::size_t i = 0; i < results.size(); ++i) {
        const CauseSquares& own = results[i].causes;
        t.decibels += decibels_without(own.share(cause)) / double(results.size());
        t.colored_decibels += decibels_without(own.colored_share(cause)) / double(results.size());
        if (own.of(cause) > results[t.worst].causes.of(cause)) t.worst = i;
    }
    return t;
}

}  // namespace

std::vector<CauseTotal> cause_totals(const std::vector<PhotoEvaluation>& results) {
    CauseSquares all{};
    for (const PhotoEvaluation& r : results)
        for (std::size_t c = 0; c < cause_count; ++c) all[c] += r.causes[c];
    std::vector<CauseTotal> out;
    for (const CauseRow& row : cause_table())
        if (all.of(row.cause) > 0) out.push_back(cause_total(row.cause, results, all));
    std::ranges::stable_sort(out, std::ranges::greater{}, &CauseTotal::share);
    return out;
}

void print_heading(int names) {
    std::fprintf(text_output(), "%-*s %5s %5s %6s %6s %5s %6s %7s %6s %5s %5s %5s %5s\n", names, "photo",
                 "PSNR", "gain", "SSIM", "gain", "frame", "SSIM", "nearest", "color%", "stops", "right",
                 "down", "sharp");
}

void print_row(const PhotoEvaluation& r, int names) {
    std::fprintf(text_output(),
                 "%-*s %5.2f %5.2f %6.4f %6.4f %5.2f %6.4f %+7.2f %6.1f %+5.2f %+5.2f %+5.2f %5.2f\n", names,
                 r.name.c_str(), r.score.psnr, r.score.psnr_gain, r.score.ssim, r.score.ssim_gain,
                 r.frame.psnr_gain, r.frame.ssim_gain, r.over_nearest, 100 * r.colored, r.brightness.stops,
                 r.shift[0], r.shift[1], r.score.sharpness);
    std::fflush(text_output());
}

void print_means(const std::vector<PhotoEvaluation>& results, int names) {
    const double n = double(std::ranges::count_if(results, [](auto& r) { return r.score.pixels > 0; }));
    if (n == 0) return;
    const auto mean = [&](const auto& value) {
        double sum = 0;
        for (const PhotoEvaluation& r : results) sum += r.score.pixels > 0 ? value(r) : 0;
        return sum / n;
    };
    std::fprintf(
        text_output(), "%-*s %5.2f %5.2f %6.4f %6.4f %5.2f %6.4f %+7.2f %6.1f %23.2f\n", names, "mean",
        mean([](auto& r) { return r.score.psnr; }), mean([](auto& r) { return r.score.psnr_gain; }),
        mean([](auto& r) { return r.score.ssim; }), mean([](auto& r) { return r.score.ssim_gain; }),
        mean([](auto& r) { return r.frame.psnr_gain; }), mean([](auto& r) { return r.frame.ssim_gain; }),
        mean([](auto& r) { return r.over_nearest; }), mean([](auto& r) { return 100 * r.colored; }),
        mean([](auto& r) { return r.score.sharpness; }));
}

void print_causes(const std::vector<PhotoEvaluation>& results) {
    const std::vector<CauseTotal> totals = cause_totals(results);
    if (totals.empty()) return;
    std::fprintf(text_output(), "\n%-12s %7s %6s %7s %6s\n", "error", "frame", "dB", "colored", "dB");
    for (const CauseTotal& t : totals) {
        const CauseRow& row = cause_row(t.cause);
        std::fprintf(text_output(), "%-12s %5.1f %% %+6.2f ", row.name, 100 * t.share, t.decibels);
        if (is_hole(t.cause))
            std::fprintf(text_output(), "%15s  %s\n", "", row.meaning);
        else
            std::fprintf(text_output(), "%5.1f %% %+6.2f  %s\n", 100 * t.colored_share, t.colored_decibels,
                         row.meaning);
    }
    std::fprintf(text_output(), "\n");
}

nlohmann::json json_of(const std::vector<PhotoEvaluation>& results) {
    nlohmann::json out = nlohmann::json::array();
    for (const PhotoEvaluation& r : results)
        out.push_back({{"name", r.name},
                       {"pixels", r.score.pixels},
                       {"psnr", r.score.psnr},
                       {"psnr_gain", r.score.psnr_gain},
                       {"ssim", r.score.ssim},
                       {"ssim_gain", r.score.ssim_gain},
                       {"frame_psnr_gain", r.frame.psnr_gain},
                       {"frame_ssim_gain", r.frame.ssim_gain},
                       {"over_nearest", r.over_nearest},
                       {"colored", r.colored},
                       {"sharpness", r.score.sharpness}});
    return out;
}

void write_photos(const std::filesystem::path& file, const std::vector<PhotoEvaluation>& results) {
    std::ostringstream out;
    out << "photo,pixels,psnr,psnr_gain,ssim,ssim_gain,frame_pixels,frame_psnr,frame_psnr_gain,frame_ssim,"
           "frame_ssim_gain,over_nearest,coloured,gain_red,gain_green,gain_blue,shift_right,shift_down,"
           "sharpness";
    for (const CauseRow& row : cause_table()) out << ",error_" << row.file;
    out << '\n';
    for (const PhotoEvaluation& r : results) {
        out << r.name << ',' << r.score.pixels << ',' << r.score.psnr << ',' << r.score.psnr_gain << ','
            << r.score.ssim << ',' << r.score.ssim_gain << ',' << r.frame.pixels << ',' << r.frame.psnr << ','
            << r.frame.psnr_gain << ',' << r.frame.ssim << ',' << r.frame.ssim_gain << ',' << r.over_nearest
            << ',' << r.colored << ',' << r.score.gain[0] << ',' << r.score.gain[1] << ',' << r.score.gain[2]
            << ',' << r.shift[0] << ',' << r.shift[1] << ',' << r.score.sharpness;
        for (const CauseRow& row : cause_table()) out << ',' << r.causes.share(row.cause);
        out << '\n';
    }
    replace_file(file, out.view());
}

}  // namespace vantage
