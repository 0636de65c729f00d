// COLMAP cameras: binary if the first byte is zero, otherwise text. Two files, separated by a line of "----".
#include "pipeline/formats/import/cameras.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    const bool binary = size > 0 && data[0] == 0;
    const auto [cameras, images] = fuzz::divided(fuzz::text_of(data, size).substr(binary));
    folder.set(binary ? "cameras.bin" : "cameras.txt", cameras);
    folder.set(binary ? "images.bin" : "images.txt", images);
    try {
        for (CameraSet::Entry& e :
             (binary ? read_colmap_binary(folder.path()) : read_colmap_text(folder.path())).entries)
            validate(e.camera, e.photo);
    } catch (const Error&) {
    }
    return 0;
}
