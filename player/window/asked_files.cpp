#include "player/window/asked_files.h"

#include <utility>

#include "player/survey/section.h"
#include "player/window/numbered_file.h"
#include "values/formatted.h"
#include "values/translation.h"

namespace vantage {

void write_asked_files(Session& s, const PackageReader& package, const ObjectSet& objects, double now) {
    const std::string stem = package.path().stem().string();
    if (const std::string table = std::exchange(s.table, ""); !table.empty())
        write_numbered(s, stem + "-measurements", ".csv", tr("measurements"), now,
                       [&](const std::string& file) { write_text(file, table); });
    if (std::exchange(s.save_scene, false))
        write_numbered(s, "scene", ".toml", tr("scene"), now,
                       [&](const std::string& file) { write_scene_file(file, objects.objects()); });
    if (!std::exchange(s.cut.saves, false)) return;
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const auto lines = section_lines(objects.meshes(), s.settings.sections);
    write_numbered(s, stem + "-cut", ".dxf", formatted(tr("%zu lines"), lines.size()), now,
                   [&](const std::string& file) { write_text(file, section_dxf(lines, origin)); });
}

}  // namespace vantage
