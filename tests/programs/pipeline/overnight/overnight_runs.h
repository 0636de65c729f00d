#pragma once
#include <cstdlib>
#include <future>

#include "base/text/error.h"
#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/prepare/merge_packages.h"
#include "pipeline/prepare/prepare.h"
#include "tests/one_line.h"
#include "tests/programs/overnight.h"

namespace vantage {

/// The number of photos for which a stage was run (made) or its result was kept (kept).
inline std::size_t made(const PrepareResult& p, package::Stage s) { return p.stages[std::size_t(s)].made; }
inline std::size_t kept(const PrepareResult& p, package::Stage s) { return p.stages[std::size_t(s)].kept; }
inline constexpr package::Stage every_stage[] = {package::Stage::thumbnail, package::Stage::tiles,
                                                 package::Stage::weight_maps, package::Stage::coordinates,
                                                 package::Stage::coverage};

class OvernightRuns : public Overnight {
  protected:
    /// For each fault, kills a run and expects the next run to write the same bytes as an uninterrupted run.
    void expect_resumes_after(const std::vector<std::string>& faults) const {
        const std::string bytes = undisturbed();
        for (const std::string& fault : faults) {
            fs::remove(file);
            EXPECT_EQ(with_fault(fault).code, -1) << fault;
            const Outcome next = prepare_program();
            ASSERT_EQ(next.code, 0) << fault << next.err;
            expect_whole(bytes, fault);
        }
    }
    void expect_reported_and_resumed(const std::vector<std::string>& faults) const {
        const std::string bytes = undisturbed();
        for (const std::string& fault : faults) {
            const Outcome failed = with_fault(fault);
            EXPECT_EQ(failed.code, int(Exit::storage)) << fault << failed.err;
            EXPECT_TRUE(one_line(failed.err)) << fault << failed.err;
            EXPECT_NE(failed.err.find("scene.vantage"), std::string::npos) << failed.err;
            const Outcome next = prepare_program();
            ASSERT_EQ(next.code, 0) << fault << next.err;
            expect_whole(bytes, fault);
            fs::remove(file);
        }
    }
    /// Starts several processes that prepare the package simultaneously. At least one of them must finish.
    void expect_one_package_of(const std::vector<int>& processes) const {
        const std::string bytes = undisturbed();
        for (const int n : processes) {
            fs::remove(file);
            std::vector<std::future<int>> codes;
            const auto text_of = [&](int i) { return dir / ("process" + std::to_string(i)); };
            for (int i = 0; i < n; ++i)
                codes.push_back(std::async(std::launch::async, [&, i] {
                    const int status =
                        std::system((VANTAGE_PROGRAM " prepare --progress none " + scene.string() + " -o " +
                                     file.string() + " --no-report >/dev/null 2>" + text_of(i).string())
                                        .c_str());
                    return WEXITSTATUS(status);
                }));
            int done = 0;
            for (int i = 0; i < n; ++i) {
                const int code = codes[std::size_t(i)].get();
                done += code == 0;
                const std::string said = slurp(text_of(i));
                if (code == 0) continue;
                EXPECT_EQ(code, int(Exit::storage)) << said;
                EXPECT_NE(said.find("another process is writing it"), std::string::npos) << said;
            }
            EXPECT_GE(done, 1) << n << " processes";
            expect_whole(bytes, std::to_string(n) + " processes");
        }
    }
    void expect_shares_merge(const std::vector<unsigned>& numbers) const {
        fs::resize_file(photos()[4], 1000);  // one photo is skipped
        const std::string bytes = undisturbed();
        for (const unsigned n : numbers) {
            std::vector<fs::path> shares;
            for (unsigned i = 1; i <= n; ++i) {
                shares.insert(shares.begin(), dir / ("share" + std::to_string(i)));
                PrepareRun run;
                run.share = {i, n};
                prepare(
                    read_scene(discover(scene)), {}, shares.front(), [](const Progress&) {}, run);
            }
            merge(shares, file);
            expect_whole(bytes, std::to_string(n) + " shares");
            EXPECT_THROW(merge({shares.begin() + 1, shares.end()}, dir / "lacking"), Error);
        }
    }
};
class OvernightAtLength : public OvernightRuns {};

}  // namespace vantage
