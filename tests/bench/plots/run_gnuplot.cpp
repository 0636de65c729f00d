#include "tests/bench/plots/run_gnuplot.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/files/run_child.h"
#include "base/text/error.h"
#include "tests/bench/measure/scratch_folder.h"

namespace vantage::bench {
namespace {

/// The line of gnuplot's output that states the reason for a failure; this line follows the failed command.
std::string complaint(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string first, line;
    while (std::getline(in, line)) {
        if (line.find_first_not_of(" \t^") == std::string::npos) continue;
        if (first.empty()) first = line;
        if (line.find(", line ") != std::string::npos) return line;
    }
    return first;
}

}  // namespace

std::string drawn_by_gnuplot(const std::string& script) {
    const ScratchFolder folder;
    const auto file = folder.path() / "plot.gp", svg = folder.path() / "plot.svg",
               errors = folder.path() / "errors";
    std::ofstream out(file, std::ios::binary);
    out << script;
    out.close();
    if (!out) throw Error(Exit::storage, file.string() + ": cannot be written");
    const int status = run_child({"gnuplot", "-d", file.string()}, svg, errors);
    if (status == 127)
        throw Error(Exit::input, "gnuplot is missing; on Debian, install the package gnuplot-nox");
    if (status != 0) throw Error(Exit::input, "gnuplot failed: " + complaint(errors));
    std::ifstream in(svg, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace vantage::bench
