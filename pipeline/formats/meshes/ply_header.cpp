#include "pipeline/formats/meshes/ply_header.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <string_view>

namespace vantage::ply {
namespace {

Type parse_type(const Ply& ply, const std::string& name) {
    static const std::map<std::string, Type> types{
        {"char", Type::i8},   {"int8", Type::i8},     {"uchar", Type::u8},   {"uint8", Type::u8},
        {"short", Type::i16}, {"int16", Type::i16},   {"ushort", Type::u16}, {"uint16", Type::u16},
        {"int", Type::i32},   {"int32", Type::i32},   {"uint", Type::u32},   {"uint32", Type::u32},
        {"float", Type::f32}, {"float32", Type::f32}, {"double", Type::f64}, {"float64", Type::f64}};
    const auto found = types.find(name);
    if (found == types.end()) ply.fail("a PLY property type, found '" + name + "'");
    return found->second;
}

void read_property(Ply& ply, std::istringstream& words) {
    if (ply.elements.empty()) ply.fail("an element before the first property");
    Property p;
    std::string type;
    words >> type;
    if (type == "list") {
        std::string count;
        words >> count >> type;
        p.list = true;
        p.count_type = parse_type(ply, count);
    }
    p.type = parse_type(ply, type);
    if (!(words >> p.name)) ply.fail("a property name");
    ply.elements.back().properties.push_back(p);
}

void read_format(Ply& ply, const std::string& name) {
    if (name == "ascii")
        ply.format = Format::text;
    else if (name == "binary_little_endian")
        ply.format = Format::little;
    else if (name == "binary_big_endian")
        ply.format = Format::big;
    else
        ply.fail("PLY format ascii, binary_little_endian or binary_big_endian, found '" + name + "'");
}

}  // namespace

Ply read_header(const std::filesystem::path& file, std::span<const char> bytes) {
    Ply ply{file, Format::text, {}, {}};
    constexpr std::string_view mark = "\xef\xbb\xbf";
    const std::size_t start =
        std::string_view(bytes.data(), bytes.size()).starts_with(mark) ? mark.size() : 0;
    std::size_t at = start;
    for (bool first = true;; first = false) {
        const auto end = std::find(bytes.begin() + std::ptrdiff_t(at), bytes.end(), '\n');
        if (end == bytes.end() || (first && end - bytes.begin() > std::ptrdiff_t(start) + 5))
            ply.fail("a PLY header");
        std::istringstream words(std::string(bytes.begin() + std::ptrdiff_t(at), end));
        at = std::size_t(end - bytes.begin()) + 1;
        std::string key, name;
        words >> key;
        if (first && key != "ply") ply.fail("a PLY header");
        if (key == "end_header") break;
        if (key == "format") {
            words >> name;
            read_format(ply, name);
        } else if (key == "element") {
            Element e;
            if (!(words >> e.name >> e.count)) ply.fail("an element name and count");
            if (e.name == "vertex" && std::ranges::count(ply.elements, e.name, &Element::name) > 0)
                ply.fail("one element vertex, found two");
            ply.elements.push_back(e);
        } else if (key == "property") {
            read_property(ply, words);
        }
    }
    ply.body = bytes.subspan(at);
    return ply;
}

}  // namespace vantage::ply
