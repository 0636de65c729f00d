#include "player/window/input/asked_files.h"

#include <chrono>
#include <cstdio>
#include <utility>

#include "base/files/replace_file.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/survey/section.h"

namespace vantage {

AskedFiles::~AskedFiles() {
    const auto tell = [](const WrittenFile& what) {
        std::fprintf(stderr, "vantage-player: %s\n", what.text.c_str());
    };
    if (written_.valid()) tell(written_.get());
    for (const Job& job : jobs_) tell(job());
}

void AskedFiles::attend(Session& s, const PackageReader& package, const ObjectSet& objects, double now) {
    while (const auto command = take_one_of<SaveTable, SaveScene, SaveCut>(s.window.commands)) {
        if (const auto* const table = std::get_if<SaveTable>(&*command))
            add(stem_for_files(package, (std::string("-") + without_context(table->name)).c_str()), ".csv",
                tr(table->name), [csv = table->csv](const std::string& file) { replace_file(file, csv); });
        else if (std::holds_alternative<SaveScene>(*command))
            add(stem_for_files(package).replace_filename("scene"), ".toml", tr_in("written", "scene"),
                [all = objects.objects()](const std::string& file) { write_scene_file(file, all); });
        else
            add_cut(section_lines(objects.meshes(), s.settings.sections), package);
    }
    if (written_.valid() && written_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
        const WrittenFile written = written_.get();
        say(s.message, written.text, now, written.file);
    }
    if (written_.valid() || jobs_.empty()) return;
    written_ = std::async(std::launch::async, std::move(jobs_.front()));
    jobs_.pop_front();
}

void AskedFiles::add_cut(std::vector<SectionLine> lines, const PackageReader& package) {
    const Eigen::Vector3d origin = Eigen::Map<const Eigen::Vector3d>(package.scene().origin);
    const std::string what = formatted(tr_in("written", "%zu lines"), lines.size());
    add(stem_for_files(package, "-cut"), ".dxf", what,
        [lines = std::move(lines), origin](const std::string& file) {
            replace_file(file, section_dxf(lines, origin));
        });
}

void AskedFiles::add(const std::filesystem::path& stem, const char* extension, const std::string& what,
                     std::function<void(const std::string& file)> write) {
    // Texts are translated here, since translations may be used only on this thread.
    jobs_.push_back([=, write = std::move(write), texts = WrittenTexts{what}] {
        return written_numbered(stem, extension, texts, write);
    });
}

}  // namespace vantage
