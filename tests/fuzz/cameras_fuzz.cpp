// Reads cameras of one format from one file, or from the two files of a folder, separated by a line of
// "----". If the format has two forms, a leading zero byte selects the first.
#include <algorithm>
#include <set>

#include "base/text/error.h"
#include "pipeline/formats/cameras/cameras.h"
#include "tests/fuzz/support/fuzz_target.h"
#include "tests/fuzz/support/memory_file.h"

using namespace vantage;

namespace {

std::vector<CameraFormat> forms(std::string_view name) {
    std::vector<CameraFormat> forms;
    for (const CameraFormat& f : camera_formats())
        if (f.name == name) forms.push_back(f);
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

int read_cameras_of(const std::vector<CameraFormat>& formats, const std::uint8_t* data, std::size_t size) {
    static const fuzz::MemoryFolder folder;
    const bool binary = formats.size() > 1 && size > 0 && data[0] == 0;
    const CameraFormat& format = binary ? formats.front() : formats.back();
    try {
        const auto path = put(folder, format, fuzz::text_of(data, size).substr(binary));
        for (CameraSet::Entry& e : format.read(path).entries) validate(e.camera, e.photo);
    } catch (const Error&) {
    }
    return 0;
}

}  // namespace

#ifdef FUZZ_CORPUS
/// Each format's corpus has the format's name in lower case.
TEST(Fuzz, cameras) {
    std::set<std::string> names;
    for (const CameraFormat& f : camera_formats()) names.insert(f.name);
    names.erase("Bundler");  // has its own target
    for (const std::string& name : names) {
        std::string folder = name;
        std::ranges::transform(folder, folder.begin(),
                               [](char c) { return c == ' ' ? '_' : char(std::tolower(c)); });
        fuzz::replay(folder, [formats = forms(name)](auto* data, std::size_t size) {
            read_cameras_of(formats, data, size);
        });
    }
}
#else
FUZZ_TARGET(cameras)(const std::uint8_t* data, std::size_t size) {
    static const std::vector<CameraFormat> formats = forms(CAMERA_FORMAT);
    return read_cameras_of(formats, data, size);
}
#endif
