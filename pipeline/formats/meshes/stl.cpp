#include "pipeline/formats/meshes/stl.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/text/error.h"
#include "base/text/lower_case.h"
#include "pipeline/formats/tokens.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t header_bytes = 84, triangle_bytes = 50;

void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c, Mesh& to) {
    const auto first = std::uint32_t(to.positions.size());
    to.positions.insert(to.positions.end(), {a, b, c});
    to.triangles.push_back({first, first + 1, first + 2});
}

class TextReader {
  public:
    explicit TextReader(const fs::path& file) : in_(file) {}

    /// Reads one or more solids.
    Mesh read() {
        while (!in_.at_end()) {
            expect("solid");
            in_.line();  // its name
            while (read_facet()) {
            }
            in_.line();
        }
        return std::move(mesh_);
    }

  private:
    /// Reads a facet; returns false at the end of the solid.
    bool read_facet() {
        if (!at("facet", "endsolid")) return false;
        expect("normal");
        for (int i = 0; i < 3; ++i) in_.word("a normal");
        expect("outer"), expect("loop");
        std::vector<Eigen::Vector3d> corners;
        while (at("vertex", "endloop")) {
            corners.emplace_back();
            for (double& x : corners.back()) x = in_.number<double>("a coordinate");
        }
        expect("endfacet");
        for (std::size_t i = 2; i < corners.size(); ++i) add(corners[0], corners[i - 1], corners[i], mesh_);
        return true;
    }
    /// Whether the next word is `wanted` rather than `other`, ignoring case.
    bool at(const std::string& wanted, const std::string& other) {
        const std::string expected = wanted + " or " + other;
        const std::string word(in_.word(expected.c_str()));
        if (lower_case(word) == wanted) return true;
        if (lower_case(word) != other) in_.fail(expected, "'" + word.substr(0, 40) + "'");
        return false;
    }
    void expect(const char* wanted) {
        const std::string word(in_.word(wanted));
        if (lower_case(word) != wanted) in_.fail(wanted, "'" + word.substr(0, 40) + "'");
    }

    Tokens in_;
    Mesh mesh_;
};

std::uint32_t count_in(const std::byte* header) {
    std::uint32_t count = 0;
    std::memcpy(&count, header + 80, sizeof count);
    return count;
}

/// Text has no zero bytes; the header of a binary file has some in practice.
bool is_binary(const fs::path& file) {
    constexpr std::size_t looked_at = 1024;
    const std::vector<std::byte> bytes = read_file(file, looked_at);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
        return false;  // UTF-16: rejected by the text reader
    if (text.find('\0') != text.npos) return true;
    return bytes.size() >= header_bytes &&
           fs::file_size(file) == header_bytes + triangle_bytes * std::uint64_t(count_in(bytes.data()));
}

Mesh read_binary(const fs::path& file) {
    const std::vector<std::byte> bytes = read_file(file);
    const auto fail = [&](const std::string& what) { throw Error(Exit::input, file.string() + ": " + what); };
    if (bytes.size() < header_bytes) fail("is cut off: expected a header of 84 bytes");
    const std::size_t count = count_in(bytes.data()), there = (bytes.size() - header_bytes) / triangle_bytes;
    const bool padded =
        count < there && std::all_of(bytes.begin() + std::ptrdiff_t(header_bytes + count * triangle_bytes),
                                     bytes.end(), [](std::byte b) { return b == std::byte(0); });
    if (count != there && !padded)
        fail((count > there ? "is cut off: its header says " : "is damaged: its header says ") +
             std::to_string(count) + " triangles, but the file has " + std::to_string(there));
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        float numbers[12];  // the normal and three corners
        std::memcpy(numbers, bytes.data() + header_bytes + i * triangle_bytes, sizeof numbers);
        const auto corner = [&](int c) { return Eigen::Vector3f(numbers + 3 * c).cast<double>().eval(); };
        add(corner(1), corner(2), corner(3), mesh);
    }
    return mesh;
}

}  // namespace

Mesh read_stl(const fs::path& file) { return is_binary(file) ? read_binary(file) : TextReader(file).read(); }

}  // namespace vantage
