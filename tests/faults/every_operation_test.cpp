// Makes each file operation of a command fail once.
#include <algorithm>
#include <array>
#include <set>

#include "base/text/error.h"
#include "tests/faults/number_from.h"
#include "tests/faults/written_package.h"

using namespace vantage;

namespace {

class EveryOperation : public WrittenPackage {
  protected:
    std::string fault(int n, const std::string& how) const {
        return "FAULT=any:" + std::to_string(n) + ":" + how + " FAULT_FOLDER=" + dir.string();
    }
    /// The number of file operations of the command without faults; if `how` is "BAD_PAGE", the number of
    /// pages that it maps.
    int operations_of(const WritingCommand& c, const std::string& how = "SHORT_ONCE") const {
        start(c);
        const fs::path count = fs::temp_directory_path() / (dir.filename().string() + ".count");
        EXPECT_EQ(run_command(c, fault(0, how) + " FAULT_COUNT=" + count.string()).code, 0);
        const int n = std::atoi(slurp(count).c_str());
        fs::remove(count);
        return n;
    }
    void expect_said(const Outcome& o, const std::string& when) const {
        const std::set<int> codes{int(Exit::ok), int(Exit::input), int(Exit::damaged), int(Exit::storage),
                                  int(Exit::incomplete)};
        EXPECT_TRUE(codes.contains(o.code)) << when << ": exit " << o.code << ": " << o.err;
        const bool fails = o.code != int(Exit::ok) && o.code != int(Exit::incomplete);
        EXPECT_EQ(std::ranges::count(o.err, '\n'), fails ? 1 : 0) << when << ": " << o.err;
    }
    /// Makes about `at_most` operations of each command fail, one per run, in each of the given ways.
    void expect_nothing_lost(int at_most, const std::vector<const char*>& ways) const {
        for (const WritingCommand& c : commands) {
            const int operations = operations_of(c);
            ASSERT_GT(operations, 50) << c.name;
            const int step = std::max(1, operations / at_most);
            int runs = 0;
            for (const char* how : ways)
                for (int n = 1 + runs % step; n <= operations; n += step, ++runs) {
                    const std::string when = std::string(how) + " at operation " + std::to_string(n);
                    start(c);
                    const Outcome done = run_command(c, fault(n, how));
                    if (std::string_view(how) != "KILL") expect_said(done, c.name + ", " + when);
                    if (done.code == 0) {
                        EXPECT_TRUE(slurp(package) == c.after) << c.name << ", " << when;
                    } else if (done.code != int(Exit::incomplete)) {
                        expect_old_or_new(c, when);
                    }
                    expect_finished_by_next_run(c, when);
                }
            std::printf("%-24s %4d operations, %4d runs\n", c.name.c_str(), operations, runs);
        }
    }
};
class EveryOperationAtLength : public EveryOperation {};

}  // namespace

TEST_F(EveryOperation, MayFailAndNothingIsLost) { expect_nothing_lost(1, {"EIO_ONCE"}); }

TEST_F(EveryOperationAtLength, MayFailAndNothingIsLost) {
    expect_nothing_lost(number_from("VANTAGE_FAULTS", 2), {"EIO_ONCE", "ENOSPC", "SHORT_ONCE", "KILL"});
}

TEST_F(EveryOperationAtLength, MayMeetAPageThatCannotBeRead) {
    const int at_most = number_from("VANTAGE_FAULTS", 10);
    for (const WritingCommand& c : commands) {
        const int pages = operations_of(c, "BAD_PAGE");
        ASSERT_GT(pages, 50) << c.name;
        const int step = std::max(1, pages / at_most);
        int runs = 0, met = 0;
        for (int n = 1 + step / 2; n <= pages; n += step, ++runs) {
            const std::string when = "page " + std::to_string(n) + " cannot be read";
            start(c);
            const Outcome done = run_command(c, fault(n, "BAD_PAGE"));
            expect_said(done, c.name + ", " + when);
            met += done.code == int(Exit::damaged);
            if (done.code == 0)
                EXPECT_TRUE(slurp(package) == c.after) << c.name << ", " << when;
            else
                expect_old_or_new(c, when);
            expect_finished_by_next_run(c, when);
        }
        std::printf("%-24s %5d pages mapped, %4d runs, %4d of which read the bad page\n", c.name.c_str(),
                    pages, runs, met);
        EXPECT_GT(met, 0) << c.name;
    }
}

TEST_F(EveryOperationAtLength, IgnoresAClockThatJumps) {
    for (const WritingCommand& c : commands) {
        start(c);
        const Outcome done = run_command(c, "FAULT_CLOCK=1");
        EXPECT_EQ(done.code, 0) << c.name << ": " << done.err;
        EXPECT_TRUE(slurp(package) == c.after) << c.name;
        expect_finished_by_next_run(c, "the clock jumped");
    }
}
