// Reads camera path files. Checks that every view in a file can be drawn.
#include <cstdlib>

#include "base/text/error.h"
#include "player/view/camera_path.h"
#include "player/view/shots.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"
#include "tests/fuzz/support/valid_package.h"

using namespace vantage;

FUZZ_TARGET(path)(const std::uint8_t* data, std::size_t size) {
    static const fuzz::ValidPackage valid;
    static fuzz::MemoryFile file;
    static const PackageReader package = [] {
        std::vector<std::uint8_t> bytes = valid.bytes;
        fuzz::fix_checksums(bytes);
        file.set(bytes);
        return PackageReader(file.path());
    }();
    static const fuzz::MemoryFolder folder;
    folder.set("path.txt", fuzz::text_of(data, size));
    const std::string path = folder.path() / "path.txt";
    try {
        for (const Shot& shot : read_path(path, package, {64, 48})) {
            const View& v = shot.view;
            if (!v.cam_from_origin.R.allFinite() || !v.cam_from_origin.t.allFinite() ||
                !(v.intrinsics.fx > 0) || !(v.intrinsics.fy > 0))
                std::abort();
        }
        for (const Navigation& n : recorded_path(path, package, 7).frames)
            if (!n.R.allFinite() || !n.eye.allFinite() || !(n.fov > 0)) std::abort();
    } catch (const Error&) {
    }
    return 0;
}
