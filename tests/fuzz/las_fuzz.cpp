// LAS point clouds. Checks that colors match the points and that there are no more points than the file can
// hold.
#include <cstdlib>

#include "base/text/error.h"
#include "pipeline/formats/las.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(las)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    folder.set("scan.las", fuzz::text_of(data, size));
    try {
        std::vector<std::string> warnings;
        const Mesh cloud = read_las(folder.path() / "scan.las", warnings);
        constexpr std::size_t shortest = 20;
        if (cloud.positions.empty() || cloud.positions.size() > size / shortest) std::abort();
        if (!cloud.colors.empty() && cloud.colors.size() != cloud.positions.size()) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
