#include "tests/openxr/calls/record.h"

#include <png.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace test_runtime {
namespace {

/// The folder for the records; empty if nothing is to be recorded.
const std::filesystem::path& folder() {
    static const std::filesystem::path path = [] {
        const char* const name = std::getenv("VANTAGE_TEST_XR_OUT");
        const std::filesystem::path path(name ? name : "");
        if (!path.empty()) {
            std::filesystem::create_directories(path);
            std::ofstream(path / "violations.txt", std::ios::app);  // empty if there are none
        }
        return path;
    }();
    return path;
}

/// Appends a line. The file is opened and closed for each line, so that nothing is lost if the program
/// crashes.
void append(const char* file, const std::string& line) {
    if (!folder().empty()) std::ofstream(folder() / file, std::ios::app) << line << '\n';
}

}  // namespace

void record_violation(const std::string& call, const std::string& what) {
    append("violations.txt", call + ": " + what);
    if (folder().empty()) std::fprintf(stderr, "%s: %s\n", call.c_str(), what.c_str());
}

void record_event(int frame, const std::string& what) {
    append("events.txt", std::to_string(frame) + " " + what);
}

void record_frame(const std::string& json) { append("frames.jsonl", json); }

void save_picture(const std::string& name, uint32_t width, uint32_t height,
                  const std::vector<uint8_t>& rgba) {
    if (folder().empty()) return;
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGBA;
    const auto upward = -png_int_32(width * 4);
    png_image_write_to_file(&image, (folder() / (name + ".png")).c_str(), 0, rgba.data(), upward, nullptr);
}

void save_depth(const std::string& name, uint32_t width, uint32_t height, const std::vector<float>& depth) {
    if (folder().empty()) return;
    std::ofstream out(folder() / (name + ".pfm"), std::ios::binary);
    out << "Pf\n" << width << ' ' << height << "\n-1.0\n";
    out.write(reinterpret_cast<const char*>(depth.data()), std::streamsize(depth.size() * sizeof(float)));
}

}  // namespace test_runtime
