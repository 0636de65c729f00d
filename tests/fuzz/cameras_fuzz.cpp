// Cameras in the format CAMERA_FORMAT: one file, or the two files of a folder, divided by a line of "----".
// If the format has two forms, a leading zero byte selects the first.
#include "pipeline/formats/cameras/cameras.h"
#include "scene/error.h"
#include "tests/fuzz/memory_file.h"

using namespace vantage;

namespace {

std::vector<CameraFormat> forms() {
    std::vector<CameraFormat> forms;
    for (const CameraFormat& f : camera_formats())
        if (std::string_view(f.name) == CAMERA_FORMAT) forms.push_back(f);
    if (forms.empty()) std::abort();
    return forms;
}

/// Puts the files of an input into the folder; returns the path to read.
std::filesystem::path put(const fuzz::MemoryFolder& folder, const CameraFormat& format,
                          std::string_view input) {
    if (format.files.empty()) {
        const char* const name = format.one_per_photo ? "cameras.xmp" : "cameras";
        folder.set(name, input);
        return folder.path() / name;
    }
    const auto [first, second] = fuzz::divided(input);
    folder.set(format.files.at(0), first);
    folder.set(format.files.at(1), second);
    return folder.path();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    static const std::vector<CameraFormat> formats = forms();
    const bool binary = formats.size() > 1 && size > 0 && data[0] == 0;
    const CameraFormat& format = binary ? formats.front() : formats.back();
    try {
        const auto path = put(folder, format, fuzz::text_of(data, size).substr(binary));
        for (CameraSet::Entry& e : format.read(path).entries) validate(e.camera, e.photo);
    } catch (const Error&) {
    }
    return 0;
}
