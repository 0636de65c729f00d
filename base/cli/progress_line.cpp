#include "base/cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/cli/standard_output.h"
#include "base/text/json_text.h"

namespace vantage {
namespace {

std::string duration(double seconds) {
    const auto s = long(seconds + 0.5);
    if (s < 60) return fmt::format("{} s", s);
    if (s < 3600) return fmt::format("{}:{:02} min", s / 60, s % 60);
    return fmt::format("{}:{:02} h", s / 3600, s / 60 % 60);
}

constexpr double measurable = 0.1;  ///< seconds that must pass before the rate is shown

std::string rate(const Progress& p, double seconds) {
    if (p.done == 0 || p.done >= p.total || seconds < measurable) return {};
    return fmt::format("  {:.1f}/s, {} left", double(p.done) / seconds,
                       duration(seconds / double(p.done) * double(p.total - p.done)));
}

std::string bar(const Progress& p, double seconds) {
    constexpr std::size_t width = 30;
    const std::size_t full = p.total ? std::min(p.done, p.total) * width / p.total : 0;
    return fmt::format("\r\033[K{:>8} [{}{}] {}/{}{}  {}", p.stage, std::string(full, '='),
                       std::string(width - full, ' '), p.done, p.total, rate(p, seconds), p.photo);
}

std::string json_line(const Progress& p, double seconds) {
    nlohmann::json j{
        {"stage", p.stage}, {"photo", p.photo}, {"done", p.done}, {"total", p.total}, {"seconds", seconds}};
    if (p.done > 0 && seconds >= measurable)
        j["seconds_left"] = seconds / double(p.done) * double(p.total - p.done);
    return json_text(j, -1) + "\n";
}

}  // namespace

ProgressLine::ProgressLine(ProgressStyle style, double seconds_between_lines)
    : style_(style), seconds_between_lines_(seconds_between_lines), next_line_(seconds_between_lines) {
    if (style == ProgressStyle::automatic && output_form() == OutputForm::none)
        style_ = ProgressStyle::none;
    else if (style == ProgressStyle::automatic)
        style_ = ::isatty(STDERR_FILENO) == 1 ? ProgressStyle::bar : ProgressStyle::lines;
}

ProgressLine::~ProgressLine() {
    if (shown_ && style_ == ProgressStyle::bar) std::fputc('\n', stderr);
}

void ProgressLine::show(const Progress& p) {
    if (p.stage != stage_) {
        stage_ = p.stage;
        start_ = std::chrono::steady_clock::now();
        next_line_ = seconds_between_lines_;
    }
    const double s = seconds();
    shown_ = true;
    if (style_ == ProgressStyle::bar)
        std::fputs(bar(p, s).c_str(), stderr);
    else if (style_ == ProgressStyle::json)
        std::fputs(json_line(p, s).c_str(), stderr);
    else if (style_ == ProgressStyle::lines && s >= next_line_) {
        next_line_ = s + seconds_between_lines_;
        std::fputs(fmt::format("{:>8}  {}/{}  {}{}\n", p.stage, p.done, p.total, p.photo, rate(p, s)).c_str(),
                   stderr);
    }
}

double ProgressLine::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

}  // namespace vantage
