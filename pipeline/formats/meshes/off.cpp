#include "pipeline/formats/meshes/off.h"

#include "pipeline/formats/meshes/color_bytes.h"
#include "pipeline/formats/meshes/ply.h"
#include "pipeline/formats/tokens.h"

namespace vantage {
namespace {

void skip_comments(Tokens& in) {
    while (in.skip_comment()) {
    }
}

/// The attributes of the vertices, from the first word.
struct Kind {
    bool normals = false, texture = false;
};

/// Reads the first word if it is not a number.
Kind read_kind(Tokens& in) {
    skip_comments(in);
    if (in.at_number() && !in.at_word_with('F')) return {};
    const std::string word(in.word("OFF"));
    if (!word.ends_with("OFF") || word.find('4') != word.npos || word.find('n') != word.npos)
        in.fail("OFF, COFF, NOFF or STOFF", "'" + word.substr(0, 40) + "'");
    return {.normals = word.find('N') != word.npos, .texture = word.starts_with("ST")};
}

/// The numbers in the rest of the line, up to a comment.
std::vector<double> rest_of_line(Tokens& in, bool& is_real) {
    std::vector<double> values;
    while (!in.at_line_end() && !in.at_comment()) {
        const std::string_view word = in.word("a number");
        double value = 0;
        if (!parse_number(word, value)) in.fail("a number", "'" + std::string(word.substr(0, 40)) + "'");
        is_real |= word.find_first_of(".eE") != word.npos;
        values.push_back(value);
    }
    in.line();
    return values;
}

void read_vertices(Tokens& in, Kind kind, std::size_t count, Mesh& mesh) {
    std::array<std::vector<double>, 4> colors;
    bool colored = false, is_real = false, has_alpha = true;
    for (std::size_t i = 0; i < count; ++i) {
        skip_comments(in);
        Eigen::Vector3d p, n;
        for (double& v : p) v = in.number<double>("a coordinate");
        if (kind.normals)
            for (double& v : n) v = in.number<double>("a normal");
        std::vector<double> rest = rest_of_line(in, is_real);
        if (kind.texture && rest.size() >= 2) rest.resize(rest.size() - 2);
        mesh.positions.push_back(p);
        if (kind.normals) mesh.normals.push_back(n.cast<float>());
        colored |= rest.size() >= 3;
        has_alpha &= rest.size() == 4;
        if (rest.size() < 3) rest.assign(3, 0);
        rest.resize(4);
        for (std::size_t c = 0; c < 4; ++c) colors[c].push_back(rest[c]);
    }
    if (!has_alpha) colors[3].clear();
    if (colored) mesh.colors = color_bytes(colors, is_real, true);
}

void read_faces(Tokens& in, std::size_t count, Mesh& mesh) {
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < count; ++i) {
        skip_comments(in);
        const auto n = in.number<std::size_t>("the number of a face's corners");
        corners.clear();
        for (std::size_t c = 0; c < n; ++c) {
            const auto v = in.number<std::int64_t>("the index of a corner");
            corners.push_back(v >= 0 && std::size_t(v) < mesh.positions.size() ? std::uint32_t(v)
                                                                               : no_vertex);
        }
        in.line();  // the face's color
        for (std::size_t c = 2; c < n; ++c)
            mesh.triangles.push_back({corners[0], corners[c - 1], corners[c]});
    }
}

}  // namespace

bool is_binary_off(const std::filesystem::path& file) {
    constexpr std::size_t header_bytes = 64;
    const std::vector<std::byte> bytes = read_file(file, header_bytes);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.substr(0, text.find('\n')).find("BINARY") != text.npos;
}

Mesh read_off(const std::filesystem::path& file) {
    Tokens in(file);
    const Kind kind = read_kind(in);
    skip_comments(in);
    const auto vertices = in.number<std::size_t>("the number of vertices");
    const auto faces = in.number<std::size_t>("the number of faces");
    in.line();  // the number of edges
    Mesh mesh;
    read_vertices(in, kind, vertices, mesh);
    read_faces(in, faces, mesh);
    return mesh;
}

}  // namespace vantage
