#include "pipeline/synth/spec.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <set>
#include <sstream>
#include <string>

#include "base/text/error.h"

namespace vantage {
namespace {

/// A table in the file. Reading an invalid value throws Error(input), and so does the destructor if any keys
/// are unknown.
class Table {
  public:
    Table(const std::filesystem::path& file, const toml::table& root, std::string name)
        : file_(file), name_(std::move(name)), table_(root[name_].as_table()) {
        if (!table_ && root.contains(name_)) fail(name_, "not a table");
    }
    template <class T>
    void read(const char* key, T& value, double low, double high) {
        known_.insert(key);
        if (!table_ || !table_->contains(key)) return;
        const auto number = (*table_)[key].value<double>();
        if (!number || !(*number >= low && *number <= high) || double(T(*number)) != *number)
            fail(name_ + "." + key, fmt::format("expected a number from {} to {}", low, high));
        value = T(*number);
    }
    ~Table() noexcept(false) {
        if (!table_ || std::uncaught_exceptions()) return;
        for (const auto& [key, node] : *table_)
            if (!known_.contains(std::string(key.str())))
                fail(name_ + "." + std::string(key.str()), "unknown key");
    }

  private:
    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw Error(Exit::input, file_.string() + ": " + key + ": " + what);
    }
    std::filesystem::path file_;
    std::string name_;
    const toml::table* table_;
    std::set<std::string> known_;
};

toml::table parse(const std::filesystem::path& file) {
    try {
        return toml::parse_file(file.string());
    } catch (const toml::parse_error& e) {
        throw Error(Exit::input,
                    fmt::format("{}:{}: {}", file.string(), e.source().begin.line, e.description()));
    }
}

void check_tables(const std::filesystem::path& file, const toml::table& root) {
    const std::set<std::string_view> known{"scene",  "building", "object", "garden",   "glass",
                                           "photos", "infrared", "lens",   "exposure", "error"};
    for (const auto& [key, node] : root)
        if (!known.contains(key.str()))
            throw Error(Exit::input, file.string() + ": " + std::string(key.str()) + ": unknown table");
}

}  // namespace

SynthSpec read_spec(const std::filesystem::path& file) {
    const toml::table root = parse(file);
    check_tables(file, root);
    SynthSpec s;
    {
        Table t(file, root, "scene");
        t.read("seed", s.seed, 0, 4e9);
        t.read("height_field", s.height_field, 0, 1);
    }
    {
        Table t(file, root, "building");
        t.read("width", s.building.width, 1, 1000);
        t.read("height", s.building.height, 1, 1000);
        t.read("depth", s.building.depth, 1, 1000);
        t.read("recess", s.building.recess, 0.01, 10);
        t.read("bays", s.building.bays, 1, 100);
        t.read("floors", s.building.floors, 1, 100);
        t.read("max_edge", s.building.max_edge, 0, 100);
        t.read("chapel", s.building.chapel, 0, 1);
    }
    {
        Table t(file, root, "object");
        t.read("size", s.object.size, 0.01, 100);
        t.read("triangles", s.object.triangles, 200, 1e7);
        t.read("distance", s.object.distance, 0, 1000);
    }
    {
        Table t(file, root, "garden");
        t.read("radius", s.garden.radius, 0, 1e5);
        t.read("hill", s.garden.hill, 0, 1e4);
        t.read("railing", s.garden.railing, 0, 1);
    }
    {
        Table t(file, root, "glass");
        t.read("alpha", s.glass.alpha, 0, 1);
        t.read("max_edge", s.glass.max_edge, 0, 100);
    }
    {
        Table t(file, root, "photos");
        t.read("count", s.photos.count, 1, 2000);
        t.read("width", s.photos.width, 8, 20000);
        t.read("height", s.photos.height, 8, 20000);
        t.read("fov", s.photos.fov, 1, 150);
        t.read("radius", s.photos.radius, 0.1, 1e4);
        t.read("arc", s.photos.arc, 0, 360);
        t.read("low", s.photos.low, 0, 1e4);
        t.read("high", s.photos.high, 0, 1e4);
        t.read("samples", s.photos.samples, 1, 16);
    }
    {
        Table t(file, root, "infrared");
        t.read("count", s.infrared.count, 0, 2000);
        t.read("width", s.infrared.width, 8, 20000);
        t.read("height", s.infrared.height, 8, 20000);
        t.read("fov", s.infrared.fov, 1, 150);
        t.read("stops", s.infrared.stops, -4, 4);
    }
    {
        Table t(file, root, "lens");
        t.read("k1", s.lens.k1, -0.5, 0.5);
        t.read("k2", s.lens.k2, -0.5, 0.5);
    }
    {
        Table t(file, root, "exposure");
        t.read("stops", s.exposure.stops, 0, 4);
        t.read("white_balance", s.exposure.white_balance, 0, 4);
        t.read("vignetting", s.exposure.vignetting, 0, 0.9);
    }
    Table(file, root, "error").read("pixels", s.error.pixels, 0, 1000);
    return s;
}

}  // namespace vantage
