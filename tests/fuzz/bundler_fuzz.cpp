// Reads Bundler cameras from list.txt and the .out file, separated by a line of "----".
#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

FUZZ_TARGET(bundler)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    const auto [list, cameras] = fuzz::divided(fuzz::text_of(data, size));
    folder.set("list.txt", list);
    folder.set("bundle.out", cameras);
    try {
        read_bundler(folder.path() / "bundle.out");
    } catch (const Error&) {
    }
    return 0;
}
