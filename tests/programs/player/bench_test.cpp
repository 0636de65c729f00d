// Tests the program vantage-bench on a small synthetic scene: the exact setting of every sweep must reproduce
// the reference with its stated precision, and interrupted runs must be resumed.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/bench/results/log.h"
#include "tests/bench/results/tables.h"
#include "tests/bench/sweeps/sweep.h"
#include "tests/temporary_folder.h"

using namespace vantage;
using namespace vantage::bench;
namespace fs = std::filesystem;

namespace {

/// The bounds on a metric in rows with the exact setting.
struct Bound {
    const char *sweep, *metric;
    double least, most;
};
// The bounds described by Sweep::precision.
constexpr Bound precisions[] = {
    {"border", "weight_worst", 0, 0},      {"border", "distance_worst", 0, 0},
    {"depth", "false_hidden", 0, 0.05},    {"depth", "false_visible", 0, 0.05},
    {"coordinates", "px_worst", 0, 0.001}, {"tile-format", "psnr", 100, 100},
    {"tile-border", "psnr", 100, 100},     {"blending", "uncoloured", 0, 0.2},
    {"sums", "psnr_exact", 100, 100},      {"selection", "uncoloured", 0, 0.2},
    {"hysteresis", "changes", 0, 0},       {"hysteresis", "uncovered", 0, 0},
    {"filtering", "psnr_exact", 100, 100},
};

class VantageBench : public TemporaryFolder {
  protected:
    /// Returns the status of std::system(); the command's output is in the file `output`.
    int run(const std::string& options) {
        const std::string command =
            std::string(VANTAGE_BENCH) + " " + options + " > " + (dir / "output").string() + " 2>&1";
        const int status = std::system(command.c_str());
        output = slurp(dir / "output");
        return status;
    }
    std::string output;
};

std::vector<Measurement> of(const std::vector<Measurement>& all, const std::string& sweep) {
    std::vector<Measurement> out;
    std::ranges::copy_if(all, std::back_inserter(out),
                         [&](const Measurement& m) { return m.sweep == sweep; });
    return out;
}

const Measurement& row(const std::vector<Measurement>& all, const std::string& sweep,
                       const std::string& curve, const std::string& setting) {
    for (const Measurement& m : all)
        if (m.sweep == sweep && m.curve == curve && m.setting == setting) return m;
    throw std::out_of_range(sweep + ", " + curve + ", " + setting + ": not measured");
}

}  // namespace

TEST_F(VantageBench, ExactSettingsReproduceTheReference) {
    ASSERT_EQ(run("--set smoke -o " + (dir / "out").string()), 0) << output;
    const std::vector<Measurement> all = read_json(dir / "out" / "results.json").measurements;
    for (const Sweep& sweep : sweeps()) EXPECT_FALSE(of(all, sweep.name).empty()) << sweep.name;
    for (const Measurement& m : all)
        for (const auto& [name, v] : m.values) EXPECT_TRUE(std::isfinite(v)) << m.sweep << m.setting << name;
    for (const Bound& b : precisions) {
        std::size_t exact = 0;
        for (const Measurement& m : of(all, b.sweep)) {
            if (!m.exact || !m.values.contains(b.metric)) continue;
            ++exact;
            EXPECT_GE(m.values.at(b.metric), b.least) << m.sweep << ", " << m.curve << ", " << m.setting;
            EXPECT_LE(m.values.at(b.metric), b.most) << m.sweep << ", " << m.curve << ", " << m.setting;
        }
        EXPECT_GT(exact, 0u) << b.sweep << " " << b.metric;
    }
    // Coarser settings must have larger errors.
    const auto value = [&](const char* sweep, const char* curve, const char* setting, const char* metric) {
        return row(all, sweep, curve, setting).values.at(metric);
    };
    EXPECT_GT(value("border", "weight maps at 1/8", "exact", "weight_mean"),
              value("border", "weight maps at 1/2", "exact", "weight_mean"));
    EXPECT_LT(value("filtering", "samples", "1x1", "psnr_exact"),
              value("filtering", "samples", "2x2", "psnr_exact"));
    EXPECT_LT(value("loading", "tiles", "3 levels coarser", "psnr"),
              value("loading", "tiles", "full resolution", "psnr"));
    EXPECT_TRUE(fs::exists(dir / "out" / "index.html"));
}

TEST_F(VantageBench, ResumesAfterBeingKilled) {
    const std::string options = "--set smoke --only border,hysteresis -o " + (dir / "out").string();
    ASSERT_EQ(run(options), 0) << output;
    const std::string whole = slurp(dir / "out" / "log.jsonl"), results = slurp(dir / "out" / "results.csv");
    // Change the log as if the program had been killed while it wrote the last job.
    std::ofstream(dir / "out" / "log.jsonl") << whole.substr(0, whole.size() - 40);
    ASSERT_EQ(run(options), 0) << output;
    EXPECT_NE(output.find("resuming after 4 completed jobs"), std::string::npos) << output;
    const std::string again = slurp(dir / "out" / "log.jsonl");
    const std::size_t kept = whole.rfind('\n', whole.size() - 2);
    EXPECT_EQ(again.substr(0, kept), whole.substr(0, kept)) << "completed measurements should be kept";
    ASSERT_EQ(run(options), 0) << output;
    EXPECT_EQ(slurp(dir / "out" / "log.jsonl"), again);
}

TEST_F(VantageBench, ReportsUsageErrors) {
    EXPECT_EQ(run("--only nonsense"), 2 << 8);
    EXPECT_NE(output.find("nonsense"), std::string::npos);
    EXPECT_EQ(run("--set huge"), 2 << 8);
    EXPECT_EQ(run("--set smoke --only border --against " + (dir / "none.json").string()), 3 << 8);
    EXPECT_NE(output.find("none.json"), std::string::npos);
    EXPECT_EQ(
        run("--set smoke --only border -o " + (dir / "out").string() + " " + (dir / "no-scan").string()),
        3 << 8);
}

TEST_F(VantageBench, LogOfAnotherRunIsDiscarded) {
    Measurement m{"border", "tiny", "weight maps at 1/2",    "jfa",
                  true,     false,  {{"weight_mean", 0.25}}, {{"a", "b.jpg"}}};
    {
        Log log(dir / "log", "one");
        log.add("job", 1.5, {m, m});
    }
    {
        const Log log(dir / "log", "one");
        EXPECT_TRUE(log.holds("job"));
        ASSERT_EQ(log.measurements().size(), 2u);
        EXPECT_EQ(to_json(log.measurements()[1]), to_json(m));
        EXPECT_EQ(log.seconds(), 1.5);
    }
    EXPECT_EQ(Log(dir / "log", "another").jobs(), 0u);
    EXPECT_EQ(Log(dir / "log", "one").jobs(), 0u);
}
