#include "tests/bench/measure/prepared.h"

#include <cstdlib>
#include <fstream>

#include "base/files/run_child.h"
#include "base/text/error.h"
#include "tests/bench/measure/timing.h"

namespace vantage::bench {
namespace {

std::string last_line(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::string last;
    for (std::string line; std::getline(in, line);)
        if (!line.empty()) last = line;
    return last;
}

/// The number in the output line that starts with `word`; 0 if there is no such line.
double number_after(const std::filesystem::path& file, const std::string& word) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(word)) return std::strtod(line.c_str() + word.size(), nullptr);
    return 0;
}

}  // namespace

PrepareCost run_prepare(const std::filesystem::path& folder, const std::filesystem::path& package,
                        const std::vector<std::string>& options) {
    std::vector<std::string> words{VANTAGE_PROGRAM, "prepare", folder.string(), "-o", package.string()};
    words.insert(words.end(), options.begin(), options.end());
    const std::filesystem::path log = package.string() + ".log";
    PrepareCost cost;
    int status = -1;
    cost.seconds = milliseconds([&] { status = run_child(words, log, log); }) / 1000;
    if (status != 0) throw Error(Exit::input, std::string(VANTAGE_PROGRAM) + " prepare: " + last_line(log));
    cost.memory_bytes = 1e6 * number_after(log, "memory");
    std::filesystem::remove(log);
    return cost;
}

Measurement measure_prepared(const BenchScene& scene, const Effort& effort,
                             const std::vector<std::string>& options, const PictureSetting& setting,
                             const std::filesystem::path& folder, const std::string& tag) {
    const std::filesystem::path file = scene.package.string() + ".candidate";
    const PrepareCost cost = run_prepare(scene.folder, file, options);
    Measurement m = measure_pictures(file, scene, effort, std::vector{setting}, folder, tag).front();
    m.values.erase("psnr_exact");
    std::erase_if(m.exhibits, [](const Exhibit& e) { return e.caption == "truth"; });
    m.values["package_bytes"] = double(std::filesystem::file_size(file));
    m.values["prepare_s"] = cost.seconds;
    m.values["memory_bytes"] = cost.memory_bytes;
    std::filesystem::remove(file);
    return m;
}

}  // namespace vantage::bench
