#include "scene/story/scene_file.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "base/files/replace_file.h"
#include "base/text/error.h"
#include "base/text/is_url.h"
#include "base/text/lower_extension.h"
#include "scene/package/output_file.h"

namespace vantage {
namespace {

namespace fs = std::filesystem;

constexpr double farthest = 1e12;  ///< input units; positions farther from the origin would be too imprecise
constexpr double smallest = 1e-6, largest = 1e6;
constexpr double matrix_tolerance = 1e-4;  ///< for matrices that other programs wrote with few digits

/// Reads one object's table key by key.
class ObjectTable {
  public:
    ObjectTable(const fs::path& file, const toml::table& table, std::size_t number)
        : folder_(file.parent_path()),
          where_(file.string() + ": object " + std::to_string(number)),
          table_(table) {
        static const std::set<std::string, std::less<>> known{
            "name",  "package", "input", "mesh",  "cameras", "photos", "points",
            "align", "move",    "turn",  "scale", "matrix",  "shown",  "opacity"};
        for (const auto& [key, value] : table)
            if (!known.contains(key.str())) {
                std::ostringstream what;
                what << "unknown key '" << key.str()
                     << "', expected name, package, input, mesh, cameras, photos, points, align, move, turn, "
                        "scale, matrix, shown or opacity";
                fail(what.str());
            }
    }
    [[noreturn]] void fail(const std::string& what) const { throw Error(Exit::input, where_ + ": " + what); }
    bool has(const char* key) const { return table_.contains(key); }

    std::string text(const char* key) const {
        const auto value = table_[key].value<std::string>();
        if (!value || value->empty()) fail(std::string(key) + ": expected a non-empty string");
        return *value;
    }
    /// Resolves a path relative to the file's folder; the result is empty if the path is not given.
    fs::path path(const char* key) const { return has(key) ? from_folder(text(key)) : fs::path(); }
    std::vector<fs::path> points() const {
        std::vector<fs::path> out;
        if (!has("points")) return out;
        const auto* list = table_["points"].as_array();
        if (!list) return {path("points")};
        for (const toml::node& node : *list) {
            const auto value = node.value<std::string>();
            if (!value || value->empty()) fail("points: expected files, such as [\"a.ply\"]");
            out.push_back(from_folder(*value));
        }
        return out;
    }
    bool flag(const char* key, bool otherwise) const {
        if (!has(key)) return otherwise;
        const auto* value = table_[key].as_boolean();
        if (!value) fail(std::string(key) + ": expected true or false");
        return value->get();
    }
    double number(const char* key, double otherwise, double low, double high) const {
        if (!has(key)) return otherwise;
        const auto value = table_[key].value<double>();
        if (!value || !(*value >= low && *value <= high)) {
            std::ostringstream range;
            range << key << ": expected a number from " << low << " to " << high;
            fail(range.str());
        }
        return *value;
    }
    Eigen::Vector3d vector(const char* key) const {
        Eigen::Vector3d out = Eigen::Vector3d::Zero();
        if (!has(key)) return out;
        const auto* list = table_[key].as_array();
        bool valid = list && list->size() == 3;
        for (std::size_t i = 0; valid && i < 3; ++i) {
            const auto value = (*list)[i].value<double>();
            valid = value && std::abs(*value) <= farthest;
            if (valid) out[Eigen::Index(i)] = *value;
        }
        if (!valid) fail(std::string(key) + ": expected three numbers, such as [1, 0, 0.5]");
        return out;
    }

    /// Reads 3 rows of 4 numbers: a rotation times a scale, and a translation.
    std::optional<Similarity> align() const {
        if (!has("align")) return {};
        const auto* rows = table_["align"].as_array();
        Eigen::Matrix<double, 3, 4> m = Eigen::Matrix<double, 3, 4>::Constant(NAN);
        for (std::size_t i = 0; rows && rows->size() == 3 && i < 3; ++i)
            if (const auto* row = (*rows)[i].as_array(); row && row->size() == 4)
                for (std::size_t j = 0; j < 4; ++j)
                    m(Eigen::Index(i), Eigen::Index(j)) = (*row)[j].value<double>().value_or(NAN);
        const std::optional<Similarity> s = similarity(m, 1e-6);
        if (!s) fail("align: expected 3 rows of 4 numbers: a rotation times a scale, and a translation");
        return s;
    }

    /// Reads 4 rows of 4 numbers, or the 16 numbers in one list: a rotation times a scale, a translation, and
    /// 0 0 0 1.
    std::optional<Similarity> matrix() const {
        if (!has("matrix")) return {};
        if (has("move") || has("turn") || has("scale"))
            fail("matrix: replaces move, turn and scale, which must not be given as well");
        const std::vector<double> v = matrix_numbers();
        Eigen::Matrix4d m = Eigen::Matrix4d::Constant(NAN);
        if (v.size() == 16) m = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(v.data());
        const std::optional<Similarity> s = similarity(m.topRows<3>(), matrix_tolerance);
        if (!s || m.row(3) != Eigen::RowVector4d(0, 0, 0, 1) ||
            !(s->scale >= smallest && s->scale <= largest))
            fail(
                "matrix: expected 4 rows of 4 numbers, or these 16: a rotation times a scale, a translation, "
                "and the last row 0, 0, 0, 1");
        return s;
    }

  private:
    /// The similarity that `m` describes; empty if `m` does not consist of a rotation times a scale and a
    /// translation.
    static std::optional<Similarity> similarity(const Eigen::Matrix<double, 3, 4>& m, double tolerance) {
        const Eigen::Matrix3d turn = m.leftCols<3>();
        const double scale = std::cbrt(turn.determinant());
        const bool valid = m.allFinite() && scale > 0 && m.col(3).cwiseAbs().maxCoeff() <= farthest &&
                           (turn * turn.transpose() / (scale * scale)).isIdentity(tolerance);
        if (!valid) return {};
        return Similarity{turn / scale, m.col(3), scale};
    }
    /// The numbers of the matrix, row by row.
    std::vector<double> matrix_numbers() const {
        std::vector<double> out;
        const auto add = [&](const toml::node& n) { out.push_back(n.value<double>().value_or(NAN)); };
        if (const auto* list = table_["matrix"].as_array())
            for (const toml::node& node : *list) {
                const auto* row = node.as_array();
                if (row && row->size() != 4) return {};
                if (row)
                    for (const toml::node& number : *row) add(number);
                else
                    add(node);
            }
        return out;
    }
    fs::path from_folder(const fs::path& p) const {
        return p.is_absolute() || is_url(p.native()) ? p : folder_ / p;
    }
    fs::path folder_;
    std::string where_;
    const toml::table& table_;
};

SceneObject::Input read_input(const ObjectTable& t) {
    SceneObject::Input in{t.path("input"),  t.path("mesh"), t.path("cameras"),
                          t.path("photos"), t.points(),     t.align()};
    const bool photos = !in.cameras.empty() && !in.photos.empty(),
               neither = in.cameras.empty() && in.photos.empty();
    const bool parts = in.mesh.empty() ? !in.points.empty() && (photos || neither) : photos;
    if (in.folder.empty() && !parts)
        t.fail(
            "has no input, expected input (a folder), or mesh, cameras and photos, or points, alone or with "
            "cameras and photos");
    return in;
}

/// The last name in a path without its extension, such as "altar" for "scans/altar/".
std::string stem_of(const fs::path& path) {
    return (path.has_filename() ? path : path.parent_path()).stem().string();
}

std::string name_of(const ObjectTable& t, const SceneObject& object) {
    const fs::path& from = !object.package.empty()        ? object.package
                           : !object.input.folder.empty() ? object.input.folder
                           : !object.input.mesh.empty() || object.input.points.empty()
                               ? object.input.mesh
                               : object.input.points.front();
    std::string name = t.has("name") ? t.text("name") : stem_of(from);
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
        name.size() > 200)
        t.fail("name: '" + name + "' cannot be the name of a file");
    return name;
}

SceneObject read_object(const fs::path& file, const toml::table& table, std::size_t number, SceneUse use) {
    const ObjectTable t(file, table, number);
    SceneObject out;
    out.package = t.path("package");
    if (use == SceneUse::prepare) out.input = read_input(t);
    if (use == SceneUse::show && out.package.empty()) {
        if (t.has("input") || t.has("mesh") || t.has("points"))
            t.fail("has no package; 'vantage prepare' makes packages of a scene's inputs");
        t.fail("has no package");
    }
    out.name = name_of(t, out);
    out.placement = {t.vector("move"), t.vector("turn"), t.number("scale", 1, smallest, largest)};
    out.matrix = t.matrix();
    out.shown = t.flag("shown", true);
    out.opacity = t.number("opacity", 1, 0, 1);
    const bool stays = !out.matrix || matrix_of(*out.matrix) == matrix_of({});
    if (number == 1 && (out.placement != Placement{} || !stays))
        t.fail("the scene has this object's coordinates, so it cannot be moved, turned or scaled");
    return out;
}

toml::array list_of(const Eigen::Vector3d& v) { return toml::array{v.x(), v.y(), v.z()}; }

toml::array list_of(const Similarity& s) {
    toml::array out;
    const auto m = matrix_of(s);
    for (const auto& row : m.rowwise()) out.push_back(toml::array{row[0], row[1], row[2], row[3]});
    return out;
}

toml::array matrix_rows(const Similarity& s) {
    toml::array out = list_of(s);
    out.push_back(toml::array{0.0, 0.0, 0.0, 1.0});
    return out;
}

/// Makes paths relative to a folder; URLs and paths on other disks stay unchanged.
class RelativePaths {
  public:
    explicit RelativePaths(const fs::path& folder) : folder_(fs::absolute(folder)) {}
    std::string operator()(const fs::path& path) const {
        if (is_url(path.native())) return path.string();
        const fs::path relative = fs::absolute(path).lexically_relative(folder_);
        return (relative.empty() ? path : relative).string();
    }

  private:
    fs::path folder_;
};

void insert_input(toml::table& t, const SceneObject::Input& in, const RelativePaths& relative) {
    const std::pair<const char*, const fs::path&> paths[] = {
        {"input", in.folder}, {"mesh", in.mesh}, {"cameras", in.cameras}, {"photos", in.photos}};
    for (const auto& [key, path] : paths)
        if (!path.empty()) t.insert(key, relative(path));
    toml::array points;
    for (const fs::path& p : in.points) points.push_back(relative(p));
    if (!points.empty()) t.insert("points", std::move(points));
    if (in.align) t.insert("align", list_of(*in.align));
}

}  // namespace

bool is_scene_file(const fs::path& file) { return lower_extension(file) == ".toml"; }

std::vector<SceneObject> read_scene_file(const fs::path& file, SceneUse use) {
    std::vector<SceneObject> out;
    try {
        const toml::table root = toml::parse_file(file.string());
        for (const auto& [key, value] : root)
            if (key.str() != "object" || !value.is_array_of_tables())
                throw Error(Exit::input, file.string() + ": unknown key '" + std::string(key.str()) +
                                             "', expected [[object]]");
        if (const auto* objects = root["object"].as_array())
            for (const toml::node& node : *objects)
                out.push_back(read_object(file, *node.as_table(), out.size() + 1, use));
    } catch (const toml::parse_error& e) {
        throw Error(Exit::input, file.string() + ":" + std::to_string(e.source().begin.line) + ": " +
                                     std::string(e.description()));
    }
    if (out.empty()) throw Error(Exit::input, file.string() + ": has no [[object]]");
    std::set<std::string> names;
    for (const SceneObject& o : out)
        if (!names.insert(o.name).second)
            throw Error(Exit::input, file.string() + ": two objects are called " + o.name);
    return out;
}

std::string scene_file_text(const std::vector<SceneObject>& objects, const fs::path& folder) {
    toml::array list;
    const RelativePaths relative(folder);
    for (const SceneObject& o : objects) {
        toml::table t{{"name", o.name}};
        if (o.package.empty())
            insert_input(t, o.input, relative);
        else
            t.insert("package", relative(o.package));
        if (o.matrix) t.insert("matrix", matrix_rows(*o.matrix));
        const Placement& p = o.placement;
        if (!p.move.isZero(0)) t.insert("move", list_of(p.move));
        if (!p.turn.isZero(0)) t.insert("turn", list_of(p.turn));
        if (p.scale != 1) t.insert("scale", p.scale);
        if (!o.shown) t.insert("shown", false);
        if (o.opacity != 1) t.insert("opacity", o.opacity);
        list.push_back(std::move(t));
    }
    std::ostringstream out;
    out << scene_mark << toml::table{{"object", std::move(list)}} << "\n";
    return out.str();
}

void write_scene_file(const fs::path& file, const std::vector<SceneObject>& objects) {
    const fs::path folder = fs::absolute(file).parent_path();
    replace_file(file, scene_file_text(objects, folder));
}

}  // namespace vantage
