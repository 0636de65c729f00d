// MeshLab projects.
#include "pipeline/formats/import/cameras.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static fuzz::MemoryFile file;
    file.set({data, size});
    try {
        for (CameraSet::Entry& e : read_meshlab(file.path()).entries) validate(e.camera, e.photo);
    } catch (const Error&) {
    }
    return 0;
}
