#include "player/window/asked_files.h"

#include <chrono>
#include <utility>

#include "player/survey/section.h"
#include "player/window/numbered_file.h"
#include "values/formatted.h"
#include "values/translation.h"

namespace vantage {

void AskedFiles::attend(Session& s, const PackageReader& package, const ObjectSet& objects, double now) {
    if (said_.valid()) {
        if (said_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
        say(s, said_.get(), now);
    }
    const std::string stem = package.path().stem().string();
    if (!s.table.empty()) {
        start(stem + "-measurements", ".csv", tr("measurements"),
              [table = std::exchange(s.table, "")](const std::string& file) { write_text(file, table); });
    } else if (std::exchange(s.save_scene, false)) {
        start("scene", ".toml", tr("scene"),
              [all = objects.objects()](const std::string& file) { write_scene_file(file, all); });
    } else if (std::exchange(s.cut.saves, false)) {
        const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
        const auto lines = section_lines(objects.meshes(), s.settings.sections);
        start(stem + "-cut", ".dxf", formatted(tr("%zu lines"), lines.size()),
              [lines, origin](const std::string& file) { write_text(file, section_dxf(lines, origin)); });
    }
}

void AskedFiles::start(const std::string& stem, const char* extension, const std::string& what,
                       std::function<void(const std::string& file)> write) {
    said_ = std::async(std::launch::async, [=] { return written_numbered(stem, extension, what, write); });
}

}  // namespace vantage
