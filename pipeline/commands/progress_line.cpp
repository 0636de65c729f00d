#include "pipeline/commands/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace vantage {

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (terminal_) std::fputc('\n', stderr);
}

void ProgressLine::show(const std::string& stage, const std::string& photo, std::size_t done,
                        std::size_t total) const {
    const double s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::string line = fmt::format("{:>8}  {}/{}", stage, done, total);
    if (!photo.empty()) line += "  " + photo;
    if (done > 0 && done < total)
        line += fmt::format("  {:.1f} photos/s, {:.0f} s left", double(done) / s,
                            s / double(done) * double(total - done));
    std::fputs(((terminal_ ? "\r\033[K" : "") + line + (terminal_ ? "" : "\n")).c_str(), stderr);
}

}  // namespace vantage
