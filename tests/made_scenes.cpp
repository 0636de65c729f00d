#include "tests/made_scenes.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include "pipeline/input/discover.h"
#include "pipeline/input/read_scene.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/prepare.h"
#include "pipeline/run/until_stopped.h"
#include "pipeline/synth/synthesize.h"

namespace vantage {
namespace fs = std::filesystem;
namespace {

std::string key_of(const SynthSpec& s) {
    static_assert(sizeof(SynthSpec) == 272, "add new members to the key");
    std::ostringstream out;
    out << std::hexfloat;
    const auto add = [&](const auto&... values) { ((out << values << ' '), ...); };
    add(s.seed, s.height_field);
    add(s.building.width, s.building.height, s.building.depth, s.building.recess, s.building.bays,
        s.building.floors, s.building.max_edge, s.building.chapel);
    add(s.object.size, s.object.triangles, s.object.distance);
    add(s.garden.radius, s.garden.hill, s.garden.railing, s.glass.alpha, s.glass.max_edge);
    add(s.photos.count, s.photos.width, s.photos.height, s.photos.fov, s.photos.radius, s.photos.arc,
        s.photos.low, s.photos.high, s.photos.samples);
    add(s.infrared.count, s.infrared.width, s.infrared.height, s.infrared.fov, s.infrared.stops);
    add(s.lens.k1, s.lens.k2, s.exposure.stops, s.exposure.white_balance, s.exposure.vignetting,
        s.error.pixels);
    return out.str();
}

/// A key that is computed from the names and contents of the files.
std::string key_of(const fs::path& scan) {
    constexpr auto follow = fs::directory_options::follow_directory_symlink;
    std::set<fs::path> files;
    for (const auto& e : fs::recursive_directory_iterator(scan, follow))
        if (e.is_regular_file()) files.insert(e.path());
    std::ostringstream out;
    for (const fs::path& file : files) {
        std::ostringstream bytes;
        if (fs::file_size(file) > 0) bytes << std::ifstream(file, std::ios::binary).rdbuf();
        out << file.lexically_relative(scan) << ' ' << std::hash<std::string>{}(bytes.str()) << '\n';
    }
    return out.str();
}

/// The folder for scenes made by this build of the program; scenes from an earlier build may be outdated.
fs::path collection() {
    static const fs::path folder = [] {
        const fs::path program = fs::read_symlink("/proc/self/exe");
        struct stat s {};
        ::stat(program.c_str(), &s);
        const fs::path of_program = fs::path(VANTAGE_MADE_SCENES) / program.filename();
        const fs::path out =
            of_program / (std::to_string(s.st_mtim.tv_sec) + "." + std::to_string(s.st_mtim.tv_nsec));
        if (fs::create_directories(out))
            for (const auto& earlier : fs::directory_iterator(of_program))
                if (earlier.path() != out) fs::remove_all(earlier.path());
        return out;
    }();
    return folder;
}

/// The file or folder for this key, made by `make` unless it already exists.
fs::path once(const std::string& key, const std::string& extension,
              const std::function<void(const fs::path&)>& make) {
    std::ostringstream name;
    name << std::hex << std::hash<std::string>{}(key);
    const fs::path made = collection() / (name.str() + extension),
                   unfinished = collection() / (name.str() + ".new" + extension);
    if (fs::exists(made)) return made;
    const int lock =
        ::open((collection() / (name.str() + ".lock")).c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644);
    if (lock < 0 || ::flock(lock, LOCK_EX) != 0) throw std::runtime_error("cannot lock " + made.string());
    if (!fs::exists(made)) {
        fs::remove_all(unfinished);
        make(unfinished);
        fs::rename(unfinished, made);
    }
    ::close(lock);
    return made;
}

}  // namespace

SynthSpec spec_named(const char* name) {
    return read_spec(std::string(VANTAGE_SOURCE_DIR "/data/") + name + ".toml");
}

SynthSpec tiny_spec() {
    SynthSpec spec = spec_named("tiny");
    spec.photos.samples = 1;
    return spec;
}

void copy_scene(const SynthSpec& spec, const fs::path& folder) {
    const fs::path made = once(key_of(spec), "", [&](const fs::path& to) { synthesize(spec, to, {}); });
    fs::create_directories(folder.parent_path());
    fs::copy(made, folder, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
}

fs::path made_package(const fs::path& scan, const PrepareSettings& settings) {
    if (!settings.points.empty() || !settings.deviation_from.empty())
        throw std::invalid_argument("the key covers only the names of further files, not their contents");
    return once(key_of(scan) + settings_json(settings).dump(), ".vantage", [&](const fs::path& file) {
        prepare(read_scene(discover(scan)), settings, file, [](const Progress&) {});
    });
}

void copy_package(const fs::path& scan, const PrepareSettings& settings, const fs::path& to) {
    const fs::path unfinished = to.string() + ".new";
    fs::copy_file(made_package(scan, settings), unfinished);
    fs::rename(unfinished, to);  // the file that it replaces may be open
}

}  // namespace vantage
