// Simulates power cuts after random operations. Of the unflushed changes, a random subset has reached the
// disk.
#include <random>

#include "tests/faults/disk_log.h"
#include "tests/faults/number_from.h"
#include "tests/faults/written_package.h"

using namespace vantage;

namespace {

class PowerCut : public WrittenPackage {
  protected:
    void expect_old_or_new_after(int cuts) const {
        std::mt19937 random(1);
        for (const WritingCommand& c : commands) {
            start(c);
            const Files before = files_below(out);
            const fs::path log = dir / "log";
            ASSERT_EQ(run_command(c, "FAULT_FOLDER=" + out.string() + " FAULT_LOG=" + log.string()).code, 0);
            const std::vector<DiskOperation> operations = read_disk_log(log);
            fs::remove(log);
            EXPECT_TRUE(after_power_cut(before, operations, random).at(package) == c.after)
                << c.name << ": reported as done, but not yet on the disk";
            int old = 0, fresh = 0;
            for (int i = 0; i < cuts / int(commands.size()); ++i) {
                // Half of the cuts are near the end, during flushing, renaming and cleaning up.
                const std::size_t n = operations.size() - random() % (i % 2 ? 8 : operations.size() + 1);
                restore(out, after_power_cut(before, std::span(operations).first(n), random));
                const std::string when = "after " + std::to_string(n) + " operations";
                expect_old_or_new(c, when);
                ++(fs::exists(package) && slurp(package) == c.after ? fresh : old);
                expect_finished_by_next_run(c, when);
            }
            std::printf("%-24s %4zu operations, %3d cuts left the old state, %3d the new package\n",
                        c.name.c_str(), operations.size(), old, fresh);
        }
    }
};
class PowerCutAtLength : public PowerCut {};

}  // namespace

TEST_F(PowerCut, LeavesTheOldPackageOrTheNewOne) { expect_old_or_new_after(4); }

TEST_F(PowerCutAtLength, LeavesTheOldPackageOrTheNewOne) {
    expect_old_or_new_after(number_from("VANTAGE_POWER_CUTS", 24));
}
