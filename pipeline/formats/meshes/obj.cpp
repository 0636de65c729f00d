#include "pipeline/formats/meshes/obj.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/text/file_name.h"
#include "base/text/parse_number.h"
#include "pipeline/formats/meshes/color_by_material.h"
#include "pipeline/formats/meshes/color_bytes.h"
#include "pipeline/formats/meshes/mtl.h"
#include "pipeline/formats/meshes/ply.h"
#include "pipeline/formats/tokens.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string_view>;

std::string joined(const Words& words) {
    std::string out;
    for (const std::string_view word : words) out.append(out.empty() ? "" : " ").append(word);
    return out;
}

/// Whether a name follows this word; names may contain `#` and end in a backslash.
bool names_something(std::string_view word) {
    return word == "usemtl" || word == "mtllib" || word == "g" || word == "o";
}

/// The start of a comment; not the `#` in "1.#QNAN".
std::size_t comment_in(std::string_view word) {
    std::size_t at = word.find('#');
    while (at != word.npos && at > 0 && word[at - 1] == '.') at = word.find('#', at + 1);
    return at;
}

/// The argument of `mtllib`.
struct Library {
    std::string text;
    std::vector<std::string> words;
    bool operator==(const Library&) const = default;
};

/// A mesh and the names of its materials.
struct ObjMesh {
    Mesh mesh;
    std::vector<std::uint32_t> of_triangle;  ///< index into `names`; out of range without a material
    std::vector<std::string> names;          ///< names in the order of their first use
    std::vector<Library> libraries;
};

class ObjReader {
  public:
    explicit ObjReader(const std::filesystem::path& file) : in_(file) {}

    ObjMesh read() {
        for (Words words; next_line(words);) {
            if (words.empty()) continue;  // only a comment
            if (words[0] == "v")
                add_vertex(words);
            else if (words[0] == "vn")
                normals_.push_back(point(words).cast<float>());
            else if (words[0] == "f")
                add_face(words);
            else if (words[0] == "mtllib" && words.size() > 1)
                use_library(words);
            else if (words[0] == "usemtl")
                use_material(joined({words.begin() + 1, words.end()}));
        }
        return result();
    }

  private:
    ObjMesh result() {
        if (colored_) mesh_.colors = color_bytes(colors_, true, true);
        for (std::size_t v = 0; v < mesh_.colors.size(); ++v)
            if (std::isnan(colors_[0][v])) mesh_.colors[v] = {255, 255, 255, 255};
        // Vertices and normals may follow the faces.
        for (std::array<std::uint32_t, 3>& t : mesh_.triangles)
            for (std::uint32_t& v : t)
                if (v >= mesh_.positions.size()) v = no_vertex;
        for (const auto& [v, n] : later_)
            if (v < mesh_.positions.size() && n < normals_.size()) add_normal(v, n);
        if (!mesh_.normals.empty()) mesh_.normals.resize(mesh_.positions.size(), Eigen::Vector3f::Zero());
        return {std::move(mesh_), std::move(of_triangle_), std::move(names_), std::move(libraries_)};
    }
    /// The words of a line and of its continuation lines; views of the file's text.
    bool next_line(Words& words) {
        words.clear();
        if (in_.at_end()) return false;
        while (!in_.at_line_end()) {
            std::string_view word = in_.word("a word");
            const bool in_a_name = !words.empty() && names_something(words[0]);
            const std::size_t comment = in_a_name ? word.npos : comment_in(word);
            if (comment != word.npos)
                word = word.substr(0, comment), in_.skip_to_line_end();
            else if ((in_a_name ? word == "\\" : word.ends_with('\\')) && in_.at_line_end())
                word.remove_suffix(1), in_.next_line();
            if (!word.empty()) words.push_back(word);
        }
        return true;
    }
    [[noreturn]] void fail(const std::string& expected, std::string_view found) const {
        in_.fail(expected, "'" + std::string(found.substr(0, 40)) + "'");
    }
    double real(std::string_view word) const {
        double value = 0;
        if (!parse_number(word, value)) fail("a number", word);
        return value;
    }
    Eigen::Vector3d point(const Words& words) const {
        if (words.size() < 4) fail("three coordinates", words[0]);
        return {real(words[1]), real(words[2]), real(words[3])};
    }
    void add_vertex(const Words& words) {
        mesh_.positions.push_back(point(words));
        const bool colored = words.size() >= 7;  // a single fourth number is a weight
        colored_ |= colored;
        for (std::size_t c = 0; c < 3; ++c) colors_[c].push_back(colored ? real(words[4 + c]) : no_color);
    }
    /// The element that a corner's index refers to; `no_vertex` if the index is out of range. Indices count
    /// from 1 (the element may be defined later) or, if negative, backward from the last of `count` elements.
    std::uint32_t element(std::string_view index, std::size_t count) const {
        std::int64_t i = 0;
        if (!parse_number(index, i)) fail("the index of a corner", index);
        if (i < 0) i += std::int64_t(count) + 1;
        return i >= 1 && i <= std::int64_t(no_vertex) ? std::uint32_t(i - 1) : no_vertex;
    }
    std::uint32_t corner(std::string_view word) {
        const std::uint32_t v = element(word.substr(0, word.find('/')), mesh_.positions.size());
        const std::size_t normal =
            word.find('/') == word.npos ? word.npos : word.find('/', word.find('/') + 1);
        if (v == no_vertex || normal == word.npos || normal + 1 == word.size()) return v;
        const std::uint32_t n = element(word.substr(normal + 1), normals_.size());
        if (v < mesh_.positions.size() && n < normals_.size())
            add_normal(v, n);
        else if (n != no_vertex)
            later_.emplace_back(v, n);
        return v;
    }
    void add_normal(std::uint32_t v, std::uint32_t n) {
        mesh_.normals.resize(mesh_.positions.size(), Eigen::Vector3f::Zero());
        mesh_.normals[v] += normals_[n];
    }
    void add_face(const Words& words) {
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 1; i < words.size(); ++i) corners.push_back(corner(words[i]));
        for (std::size_t i = 2; i < corners.size(); ++i)
            mesh_.triangles.push_back({corners[0], corners[i - 1], corners[i]});
        of_triangle_.resize(mesh_.triangles.size(), material_);
    }
    void use_library(const Words& words) {
        const std::string_view last = words.back();
        const Library library{{words[1].data(), last.data() + last.size()}, {words.begin() + 1, words.end()}};
        if (std::ranges::find(libraries_, library) == libraries_.end()) libraries_.push_back(library);
    }
    void use_material(const std::string& name) {
        const auto [at, is_new] = numbers_.try_emplace(name, std::uint32_t(names_.size()));
        if (is_new) names_.push_back(name);
        material_ = at->second;
    }

    static constexpr double no_color = std::numeric_limits<double>::quiet_NaN();

    Tokens in_;
    Mesh mesh_;
    std::vector<Eigen::Vector3f> normals_;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> later_;  ///< vertices and their normals
    std::array<std::vector<double>, 4> colors_;
    bool colored_ = false;
    std::uint32_t material_ = no_vertex;
    std::vector<std::uint32_t> of_triangle_;
    std::map<std::string, std::uint32_t> numbers_;
    std::vector<std::string> names_;
    std::vector<Library> libraries_;
};

/// The only file in a folder whose name differs at most in case; empty if there is none or more than one.
fs::path file_called(const fs::path& folder, const fs::path& name) {
    std::vector<fs::path> found = files_called(folder, name.string());
    std::erase_if(found, [](const fs::path& file) {
        std::error_code error;
        return !fs::is_regular_file(file, error);
    });
    return found.size() == 1 ? found[0] : fs::path();
}

/// The expected paths of a library, whose name may use backslashes instead of slashes: first the path as
/// named, if it is below the OBJ's folder, then the file of that name next to the OBJ.
std::vector<fs::path> places_of(const fs::path& folder, std::string name) {
    std::ranges::replace(name, '\\', '/');
    const fs::path given = fs::path(name).lexically_normal();
    if (given.filename().empty()) return {};
    std::vector<fs::path> out;
    if (given.is_relative() && given.has_parent_path() && *given.begin() != "..")
        out.push_back(folder / given);
    out.push_back(folder / given.filename());
    return out;
}

/// The existing file with a library's name, possibly in a different case; empty if there is no such file.
fs::path library_file(const fs::path& folder, const std::string& name) {
    std::error_code error;
    const std::vector<fs::path> places = places_of(folder, name);
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, error)) return place;
    return places.empty() ? fs::path() : file_called(folder, places.back().filename());
}

/// The possible names in the text of an `mtllib`, the likeliest first: the whole text, or the part before a
/// comment, each also without quotes.
std::vector<std::string> readings(std::string text) {
    std::vector<std::string> out;
    for (std::size_t end = text.size(); end != text.npos; end = text.rfind(" #")) {
        text.resize(end);
        text.resize(text.find_last_not_of(' ') + 1);
        out.push_back(text);
        if (text.size() > 2 && text.starts_with('"') && text.ends_with('"'))
            out.push_back(text.substr(1, text.size() - 2));
    }
    return out;
}

/// The files that an `mtllib` line names: one file whose name contains spaces, or several files. Missing
/// files are added to `missing`.
std::vector<fs::path> library_files(const fs::path& folder, const Library& library,
                                    std::vector<std::string>& missing) {
    for (const std::string& name : readings(library.text))
        if (fs::path file = library_file(folder, name); !file.empty()) return {file};
    std::vector<fs::path> out;
    for (const std::string& word : library.words)
        if (word.starts_with('#'))
            break;  // a comment
        else if (fs::path file = library_file(folder, word); !file.empty())
            out.push_back(std::move(file));
        else
            missing.push_back(word);
    return out;
}

/// Adds the paths at which the missing files of an `mtllib` may appear.
void add_missing(const fs::path& folder, const Library& library, std::set<fs::path>& to) {
    std::vector<std::string> names = readings(library.text);
    for (auto word = library.words.begin(); word != library.words.end() && !word->starts_with('#'); ++word)
        names.push_back(*word);
    for (const std::string& name : names)
        for (const fs::path& place : places_of(folder, name))
            if (!fs::exists(place)) to.insert(place);
}

/// The names of materials that triangles use and `known` lacks, except the empty name, which means no
/// material.
std::vector<std::string> unknown_materials(const ObjMesh& obj,
                                           const std::map<std::string, MaterialColor>& known) {
    std::vector<bool> used(obj.names.size(), false);
    for (const std::uint32_t m : obj.of_triangle)
        if (m < used.size()) used[m] = true;
    std::vector<std::string> out;
    for (std::size_t m = 0; m < used.size(); ++m)
        if (used[m] && !obj.names[m].empty() && !material_named(known, obj.names[m]))
            out.push_back(obj.names[m]);
    return out;
}

std::string and_others(std::size_t count) {
    return count == 0 ? "" : " and " + std::to_string(count) + (count == 1 ? " other" : " others");
}

/// The colors of the mesh's materials, by index; for a duplicate name, the color in the first library. Adds
/// the files read and the missing ones to `files`.
std::vector<MaterialColor> material_colors(const ObjMesh& obj, const fs::path& file,
                                           std::set<fs::path>& files, std::vector<std::string>& warnings) {
    std::map<std::string, MaterialColor> known;
    std::vector<std::string> missing;
    for (const Library& named : obj.libraries) {
        const std::size_t before = missing.size();
        for (const fs::path& library : library_files(file.parent_path(), named, missing))
            if (files.insert(library).second) known.merge(read_mtl(library, warnings));
        if (missing.size() > before) add_missing(file.parent_path(), named, files);
    }
    const std::string name = file.filename().string();
    if (!missing.empty())
        warnings.push_back(name + ": its material file " + missing.front().substr(0, 80) +
                           and_others(missing.size() - 1) + (missing.size() > 1 ? " are" : " is") +
                           " missing; faces that use its materials are treated as opaque");
    else if (const auto unknown = unknown_materials(obj, known); !files.empty() && !unknown.empty())
        warnings.push_back(files.begin()->filename().string() + and_others(files.size() - 1) +
                           (files.size() > 1 ? ": have" : ": has") + " no material '" +
                           unknown.front().substr(0, 80) + "'" + and_others(unknown.size() - 1) +
                           ", which faces of " + name + " use; these faces are treated as opaque");
    std::vector<MaterialColor> out;
    for (const std::string& used : obj.names)
        out.push_back(material_named(known, used).value_or(MaterialColor{255, 255, 255, 255}));
    return out;
}

}  // namespace

Mesh read_obj(const fs::path& file, std::vector<std::string>& warnings, std::vector<fs::path>& materials) {
    ObjMesh obj = ObjReader(file).read();
    const auto none = [](std::uint32_t m) { return m == no_vertex; };
    if (obj.libraries.empty() || std::ranges::all_of(obj.of_triangle, none)) return std::move(obj.mesh);
    std::set<fs::path> files;
    const std::vector<MaterialColor> colors = material_colors(obj, file, files, warnings);
    materials.insert(materials.end(), files.begin(), files.end());
    const auto clear = [&](std::uint32_t m) { return m < colors.size() && colors[m][3] < 255; };
    if (std::ranges::any_of(obj.of_triangle, clear)) color_by_material(obj.mesh, obj.of_triangle, colors);
    return std::move(obj.mesh);
}

}  // namespace vantage
