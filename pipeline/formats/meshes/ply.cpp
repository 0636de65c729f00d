#include "pipeline/formats/meshes/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <span>

#include "base/text/error.h"
#include "base/text/parse_number.h"
#include "pipeline/formats/meshes/color_bytes.h"
#include "pipeline/formats/meshes/ply_header.h"
#include "pipeline/run/read_file.h"

namespace vantage {
namespace {

using namespace ply;

template <class T>
void convert_as(const char* from, std::size_t stride, bool swapped, std::span<double> out) {
    for (double& v : out) {
        char bytes[sizeof(T)];
        std::memcpy(bytes, from, sizeof bytes);
        if (swapped) std::reverse(bytes, bytes + sizeof bytes);
        v = double(std::bit_cast<T>(bytes));
        from += stride;
    }
}

/// Converts binary values that are `stride` bytes apart.
void convert(Type type, const char* from, std::size_t stride, bool swapped, std::span<double> out) {
    switch (type) {
        case Type::i8:
            return convert_as<std::int8_t>(from, stride, swapped, out);
        case Type::u8:
            return convert_as<std::uint8_t>(from, stride, swapped, out);
        case Type::i16:
            return convert_as<std::int16_t>(from, stride, swapped, out);
        case Type::u16:
            return convert_as<std::uint16_t>(from, stride, swapped, out);
        case Type::i32:
            return convert_as<std::int32_t>(from, stride, swapped, out);
        case Type::u32:
            return convert_as<std::uint32_t>(from, stride, swapped, out);
        case Type::f32:
            return convert_as<float>(from, stride, swapped, out);
        case Type::f64:
            return convert_as<double>(from, stride, swapped, out);
    }
}

/// Reads the values after the header in order.
class Values {
  public:
    explicit Values(const Ply& ply) : ply_(ply), rest_(ply.body) {}

    double next(Type type) {
        double value = 0;
        next(type, {&value, 1});
        return value;
    }
    /// Fills `out` with values of one type.
    void next(Type type, std::span<double> out) {
        if (ply_.format == Format::text)
            for (double& v : out) v = from_text();
        else
            convert(type, take(out.size() * size_of(type)), size_of(type), swapped(), out);
    }
    /// Reads whole rows of these types into one column per type.
    void next_rows(std::span<const Type> types, std::span<const std::span<double>> columns) {
        const std::size_t rows = columns.empty() ? 0 : columns[0].size();
        if (ply_.format == Format::text) {
            for (std::size_t row = 0; row < rows; ++row)
                for (const auto& column : columns) column[row] = from_text();
            return;
        }
        std::size_t stride = 0;
        for (const Type type : types) stride += size_of(type);
        const char* from = take(rows * stride);
        for (std::size_t i = 0; i < types.size(); from += size_of(types[i++]))
            convert(types[i], from, stride, swapped(), columns[i]);
    }
    /// Reads the most common face: a byte and three 32-bit integers. If anything else follows, reads nothing
    /// and returns false.
    bool next_triangle(std::array<std::uint32_t, 3>& corners) {
        constexpr std::size_t bytes = 1 + sizeof corners;
        if (rest_.size() < bytes || rest_[0] != 3) return false;
        std::memcpy(corners.data(), rest_.data() + 1, sizeof corners);
        rest_ = rest_.subspan(bytes);
        return true;
    }
    bool is_native() const { return ply_.format != Format::text && !swapped(); }
    /// Rejects a count of elements for which the rest of the file is too short, before memory is allocated.
    /// In text files, a value takes at least two bytes: a digit and a space.
    void check_count(std::size_t count, std::size_t bytes_each, std::size_t values_each) const {
        const std::size_t each = ply_.format == Format::text ? 2 * values_each : bytes_each;
        if (count > (rest_.size() + 1) / std::max<std::size_t>(1, each)) fail_truncated();
    }

    [[noreturn]] void fail_truncated() const { ply_.fail("more values: the file is truncated"); }

  private:
    double from_text() {
        const auto blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
        const auto begin = std::find_if_not(rest_.begin(), rest_.end(), blank);
        const auto end = std::find_if(begin, rest_.end(), blank);
        if (begin == end) fail_truncated();
        double value = 0;
        const std::string_view text(&*begin, std::size_t(end - begin));
        if (!parse_number(text, value))
            ply_.fail("a number, found '" + std::string(text.substr(0, 40)) + "'");
        rest_ = rest_.subspan(std::size_t(end - rest_.begin()));
        return value;
    }
    const char* take(std::size_t bytes) {
        if (rest_.size() < bytes) fail_truncated();
        const char* from = rest_.data();
        rest_ = rest_.subspan(bytes);
        return from;
    }
    bool swapped() const {
        return (ply_.format == Format::little) != (std::endian::native == std::endian::little);
    }

    const Ply& ply_;
    std::span<const char> rest_;
};

void read_list(Values& values, const Property& p, std::vector<double>& list) {
    const double n = values.next(p.count_type);
    list.clear();
    if (!(n >= 0)) return;
    if (!(n < 1e15)) values.fail_truncated();
    values.check_count(std::size_t(n), size_of(p.type), 1);
    list.resize(static_cast<std::size_t>(n));
    values.next(p.type, list);
}

/// Size of an element in a binary file if all its lists are empty.
std::size_t min_bytes(const Element& e) {
    std::size_t bytes = 0;
    for (const Property& p : e.properties) bytes += size_of(p.list ? p.count_type : p.type);
    return bytes;
}

/// The values of each scalar property.
using Columns = std::map<std::string, std::vector<double>>;

Columns read_columns(Values& values, const Element& e) {
    values.check_count(e.count, min_bytes(e), e.properties.size());
    Columns columns;
    std::vector<Type> types;
    std::vector<std::span<double>> to;
    for (const Property& p : e.properties) {
        if (p.list) continue;
        std::vector<double>& column = columns[p.name];
        column.resize(e.count);
        types.push_back(p.type);
        to.push_back(column);
    }
    if (to.size() == e.properties.size()) {
        values.next_rows(types, to);
        return columns;
    }
    std::vector<double> unused;
    for (std::size_t row = 0; row < e.count; ++row) {
        auto column = to.begin();
        for (const Property& p : e.properties)
            if (p.list)
                read_list(values, p, unused);
            else
                (*column++)[row] = values.next(p.type);
    }
    return columns;
}

std::uint32_t corner(double index, std::size_t vertices) {
    return index >= 0 && index < double(vertices) ? std::uint32_t(index) : no_vertex;
}

void add_fan(const std::vector<double>& face, std::size_t vertices, Mesh& mesh) {
    const auto at = [&](std::size_t i) { return corner(face[i], vertices); };
    for (std::size_t i = 2; i < face.size(); ++i) mesh.triangles.push_back({at(0), at(i - 1), at(i)});
}

/// Triangle strips, each terminated by -1; every second triangle has the opposite winding.
void add_strips(const std::vector<double>& strip, std::size_t vertices, Mesh& mesh) {
    const auto at = [&](std::size_t i) { return corner(strip[i], vertices); };
    std::size_t first = 0;
    for (std::size_t i = 0; i < strip.size(); ++i) {
        if (strip[i] < 0) {
            first = i + 1;
        } else if (i >= first + 2) {
            const std::size_t odd = (i - first) % 2;
            mesh.triangles.push_back({at(i - 2 + odd), at(i - 1 - odd), at(i)});
        }
    }
}

bool lists_corners(const Property& p) {
    return p.list && (p.name == "vertex_indices" || p.name == "vertex_index" || p.name == "vertex_indexes");
}

/// Whether faces may be read by Values::next_triangle.
bool has_plain_triangles(const Values& values, const Element& e) {
    if (!values.is_native() || e.name != "face" || e.properties.size() != 1) return false;
    const Property& p = e.properties[0];
    return lists_corners(p) && p.count_type == Type::u8 && (p.type == Type::i32 || p.type == Type::u32);
}

/// `vertices` is the total number of vertices, including those after the faces. Returns whether a face has
/// alpha and is not opaque.
bool read_faces(Values& values, const Element& e, std::size_t vertices, Mesh& mesh) {
    values.check_count(e.count, min_bytes(e), e.properties.size());
    mesh.triangles.reserve(mesh.triangles.size() + e.count);
    const bool plain = has_plain_triangles(values, e);
    bool clear = false;
    std::vector<double> list;
    for (std::size_t row = 0; row < e.count; ++row) {
        if (std::array<std::uint32_t, 3> t; plain && values.next_triangle(t)) {
            for (std::uint32_t& v : t) v = v < vertices ? v : no_vertex;
            mesh.triangles.push_back(t);
            continue;
        }
        for (const Property& p : e.properties) {
            if (!p.list) {
                const double value = values.next(p.type);
                clear |= p.name == "alpha" && value < (is_real(p.type) ? 1 : 255);
                continue;
            }
            read_list(values, p, list);
            if (lists_corners(p))
                e.name == "tristrips" ? add_strips(list, vertices, mesh) : add_fan(list, vertices, mesh);
        }
    }
    return clear;
}

/// Prefixes of the names of the color channels, in order of preference.
constexpr std::array<std::array<const char*, 4>, 3> color_names{
    {{"red", "green", "blue", "alpha"},
     {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
     {"r", "g", "b", "a"}}};

void take_colors(const Element& e, Columns& columns, Mesh& mesh) {
    const auto names = std::ranges::find_if(color_names, [&](const auto& n) {
        return columns.contains(n[0]) && columns.contains(n[1]) && columns.contains(n[2]);
    });
    if (names == color_names.end()) return;
    std::array<std::vector<double>, 4> channels;
    bool real_color = false, real_alpha = false;
    for (std::size_t c = 0; c < 4; ++c) {
        const std::string name = columns.contains((*names)[c]) || c < 3 ? (*names)[c] : "alpha";
        const auto column = columns.extract(name);
        if (!column) continue;
        channels[c] = std::move(column.mapped());
        real_alpha |= is_real(std::ranges::find(e.properties, name, &Property::name)->type);
        if (c < 3) real_color = real_alpha;
    }
    mesh.colors = color_bytes(channels, real_color, real_alpha);
}

void take_vertices(const Ply& ply, const Element& e, Columns columns, Mesh& mesh) {
    mesh.positions.resize(e.count);
    const char* const axes[] = {"x", "y", "z"};
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto column = columns.extract(axes[i]);
        if (!column) ply.fail("vertices with x, y and z");
        for (std::size_t v = 0; v < e.count; ++v) mesh.positions[v][i] = column.mapped()[v];
    }
    const char* const normals[] = {"nx", "ny", "nz"};
    if (columns.contains("nx") && columns.contains("ny") && columns.contains("nz")) {
        mesh.normals.resize(e.count);
        for (Eigen::Index i = 0; i < 3; ++i) {
            const auto column = columns.extract(normals[i]);
            for (std::size_t v = 0; v < e.count; ++v) mesh.normals[v][i] = float(column.mapped()[v]);
        }
    }
    take_colors(e, columns, mesh);
    for (const auto& [name, values] : columns)
        mesh.scalars.push_back({name, std::vector<float>(values.begin(), values.end())});
}

}  // namespace

bool ply_has_faces(const std::filesystem::path& file) {
    constexpr std::size_t header_bytes = 1 << 16;
    const std::vector<std::byte> bytes = read_file(file, header_bytes);
    try {
        const Ply ply = read_header(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
        return std::ranges::any_of(ply.elements, [](const Element& e) {
            return (e.name == "face" || e.name == "tristrips") && e.count > 0;
        });
    } catch (const Error&) {
        return true;
    }
}

Mesh read_ply(const std::filesystem::path& file, std::vector<std::string>& warnings) {
    const std::vector<std::byte> bytes = read_file(file);
    const Ply ply = read_header(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    Values values(ply);
    Mesh mesh;
    bool clear = false;
    const auto vertex = std::ranges::find(ply.elements, "vertex", &Element::name);
    const std::size_t vertices = vertex == ply.elements.end() ? 0 : vertex->count;
    for (const Element& e : ply.elements)
        if (e.name == "vertex")
            take_vertices(ply, e, read_columns(values, e), mesh);
        else if (e.name == "face" || e.name == "tristrips")
            clear |= read_faces(values, e, vertices, mesh);
        else
            read_columns(values, e);
    if (clear)
        warnings.push_back(file.filename().string() +
                           ": alpha of faces is not read; expected alpha of vertices");
    return mesh;
}

}  // namespace vantage
