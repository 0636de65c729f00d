#include "scene/package/output_file.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "base/files/part_file.h"
#include "base/text/error.h"
#include "base/text/page_style.h"
#include "scene/package/package_format.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t head_bytes = 1024;
constexpr int max_links = 40;  ///< the same limit as in the kernel

/// The first bytes of a file. Throws Error(storage) if the file cannot be read.
std::string head_of(const fs::path& file) {
    std::string head(head_bytes, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(head.data(), std::streamsize(head.size()));
    if (!in.is_open() || in.bad())
        throw Error(Exit::storage, file.string() + ": exists and cannot be read: " + std::strerror(errno));
    head.resize(std::size_t(in.gcount()));
    return head;
}

bool is_package(std::string_view head) {
    const auto begins = [&](const char(&magic)[8]) { return head.starts_with(std::string_view(magic, 8)); };
    return begins(package::magic) || begins(package::part_magic);
}

bool is_csv(std::string_view head) {
    return head.starts_with("photo,red,green,blue\n") || head.starts_with("path,mode,repeat,") ||
           head.starts_with("frame,degrees,mean,");
}

/// Whether the file consists of six lines with one number each.
bool is_world_file(std::string_view head) {
    std::istringstream in{std::string(head)};
    int lines = 0;
    for (std::string line; std::getline(in, line); ++lines) {
        char* end = nullptr;
        std::strtod(line.c_str(), &end);
        if (line.empty() || *end != 0) return false;
    }
    return lines == 6;
}

bool contains(std::string_view text, std::string_view part) { return text.find(part) != text.npos; }

bool is_video(std::string_view head) {
    return head.starts_with("\x1a\x45\xdf\xa3") || (head.size() > 8 && head.substr(4, 4) == "ftyp");
}

struct Row {
    Product product;
    const char* name;  ///< in messages
    bool (*is_ours)(std::string_view head);
};

constexpr Row rows[] = {
    {Product::package, "a Vantage package", is_package},
    {Product::page, "a page written by Vantage", [](std::string_view h) { return contains(h, page_mark); }},
    {Product::trace, "a trace written by Vantage",
     [](std::string_view h) { return h.starts_with("{\"traceEvents\":[{\"args\":{\"photo\":"); }},
    {Product::junit, "a JUnit file written by Vantage",
     [](std::string_view h) { return contains(h, "<testsuite name=\"vantage"); }},
    {Product::ply, "a mesh written by Vantage",
     [](std::string_view h) { return h.starts_with("ply\n") && contains(h, ply_mark); }},
    {Product::csv, "a table written by Vantage", is_csv},
    {Product::plot, "a plot written by Vantage",
     [](std::string_view h) { return h.starts_with("<svg ") && contains(h, "font-family='sans-serif'"); }},
    {Product::png, "a PNG picture", [](std::string_view h) { return h.starts_with("\x89PNG\r\n\x1a\n"); }},
    {Product::tiff, "a TIFF picture",
     [](std::string_view h) { return h.starts_with(std::string_view("II*\0", 4)) || h.starts_with("II+"); }},
    {Product::exr, "an EXR picture", [](std::string_view h) { return h.starts_with("\x76\x2f\x31\x01"); }},
    {Product::jpeg, "a photo written by Vantage",
     [](std::string_view h) { return h.starts_with("\xff\xd8\xff\xfe") && contains(h, jpeg_mark); }},
    {Product::cameras, "a camera file written by Vantage",
     [](std::string_view h) { return h.starts_with(cameras_mark); }},
    {Product::scene, "a scene file written by Vantage",
     [](std::string_view h) { return h.starts_with(scene_mark); }},
    {Product::world, "a world file", is_world_file},
    {Product::video, "an MP4 or WebM video", is_video},
};

const Row& row_of(Product product) { return *std::ranges::find(rows, product, &Row::product); }

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
    throw Error(Exit::usage, file.string() + ": " + why);
}

/// The target of a link, even if it does not exist.
fs::path followed(const fs::path& file) {
    fs::path at = file;
    std::error_code error;
    for (int n = 0; fs::is_symlink(fs::symlink_status(at, error)); ++n) {
        const fs::path to = fs::read_symlink(at, error);
        if (error || n == max_links) refuse(file, "cannot follow the link");
        at = at.parent_path() / to;  // which is `to` if that is absolute
    }
    return at;
}

bool same_place(const fs::path& a, const fs::path& b) {
    std::error_code error;
    const bool exist[] = {fs::exists(a, error), fs::exists(b, error)};
    if (exist[0] != exist[1]) return false;
    if (exist[0]) return fs::equivalent(a, b, error);
    return fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool has_content_of(const fs::path& file, const std::vector<FileIdentity>& contents) {
    const std::uint64_t size = fs::file_size(file);
    if (!std::ranges::count(contents, size, &FileIdentity::bytes)) return false;
    std::vector<std::byte> bytes(size);
    std::ifstream(file, std::ios::binary).read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size));
    return std::ranges::count(contents, identify(bytes)) > 0;
}

void expect_replaceable(const fs::path& file, const fs::path& to, const Row& row, const Inputs& inputs,
                        std::optional<bool> force) {
    for (const fs::path& input : inputs.files)
        if (same_place(to, input))
            refuse(file, "would overwrite " + input.string() + ", which this command reads or writes");
    const fs::file_status status = fs::status(file);
    if (!fs::exists(status)) return;
    if (fs::is_directory(status)) refuse(file, "is a folder, expected a file");
    // /dev/stdout may link to a target that is not a path.
    if (!fs::is_regular_file(status) || !fs::exists(to))
        refuse(file, "is a device or a pipe, expected a file");
    if (fs::file_size(to) == 0) return;
    if (has_content_of(to, inputs.contents)) refuse(file, "is an input of the package and is not replaced");
    if (!force.value_or(false) && !row.is_ours(head_of(to)))
        refuse(file, std::string("exists and is not ") + row.name + "; expected another name" +
                         (force ? ", or --force to replace it" : ""));
}

/// Checks an auxiliary file, whose name this program chose and which only this program uses.
void expect_own(const fs::path& file) {
    const fs::file_status status = fs::status(file);
    if (!fs::exists(status)) return;
    if (!fs::is_regular_file(status) || (fs::file_size(file) > 0 && !is_package(head_of(file))))
        refuse(file,
               "has a name that is needed while the package is written, but was not written by Vantage; move "
               "it away");
}

}  // namespace

fs::path output_file(const fs::path& file, Product product, const Inputs& inputs, std::optional<bool> force) {
    if (file.filename().empty()) refuse(file, "is a folder, expected a file");
    const fs::path to = followed(file);
    expect_replaceable(file, to, row_of(product), inputs, force);
    if (product == Product::package)
        for (const fs::path& own : {part_of(to), packing_of(to), displaced_part_of(to)}) expect_own(own);
    return to;
}

void expect_result_folder(const fs::path& folder, const char* mark, Product product,
                          const std::vector<fs::path>& others, const Inputs& inputs, bool force) {
    output_file(folder / mark, product, inputs, force);
    std::error_code error;
    const bool marked = fs::exists(folder / mark, error);
    for (const fs::path& other : others) {
        const fs::path file = folder / other;
        if (!fs::exists(file, error)) continue;
        if (has_content_of(file, inputs.contents))
            refuse(file, "is an input of the package and is not replaced");
        if (!marked && !force)
            refuse(file,
                   "exists, but the folder was not written by this command; expected another folder, or "
                   "--force to replace it");
    }
}

void expect_result_pictures(const fs::path& folder,
                            const std::function<bool(const std::string& name)>& is_result,
                            const Inputs& inputs, bool force) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".png" && is_result(entry.path().stem()))
            output_file(entry.path(), Product::png, inputs, force);
}

}  // namespace vantage
