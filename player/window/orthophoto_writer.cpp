#include "player/window/orthophoto_writer.h"

#include <algorithm>
#include <array>

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/sections/orthophoto_section.h"
#include "player/interface/state/failure_text.h"
#include "player/survey/picture_plane.h"
#include "player/window/input/numbered_file.h"
#include "scene/package/contents/image_sets.h"

namespace vantage {

std::vector<std::string> orthophoto_arguments(const Session& s, const PackageReader& package,
                                              const std::string& file) {
    std::vector<std::string> out = {"orthophoto",   package.path().string(),
                                    "--plane",      plane_option(s.orthophoto.plane, s.viewpoint.camera),
                                    "--resolution", formatted("%.12g", s.orthophoto.pixel),
                                    "-o",           file,
                                    "--quiet"};
    const auto add = [&](const char* option, const std::string& value) {
        out.insert(out.end(), {option, value});
    };
    const std::uint32_t shown = s.settings.image_sets.shown;
    if (const std::vector<ImageSet> image_sets = read_image_sets(package); image_sets.size() > 1)
        add("--image-set", image_sets[shown].name);
    const Eigen::Map<const Eigen::Vector3d> origin(package.scene().origin);
    for (const SectionPlane& cut : s.settings.sections) add("--cut", section_text(cut, origin));
    for (std::uint32_t p = 0; p < package.photos().size(); ++p)
        if (package.photos()[p].image_set == shown && !std::ranges::count(s.photos, p))
            add("--exclude", package.photos()[p].name);
    const LightSettings& light = s.settings.light;
    if (light.light == Light::photos || light.on_photos) return out;
    add("--light", std::array{"", "lamp", "raking", "normals"}[std::size_t(light.light)]);
    if (light.light == Light::raking) add("--lamp", formatted("%.12g,%.12g", light.azimuth, light.elevation));
    return out;
}

void OrthophotoWriter::attend(Session& s, const PackageReader& package, double now) {
    if (!program_) {
        if (take<SaveOrthophoto>(s.window.commands)) start(s, package, now);
        return;
    }
    const auto ended = program_->ended();
    if (!ended) return;
    program_.reset();
    s.orthophoto.writing = false;
    say(s.message,
        ended->well ? formatted(tr("%s written to %s"), tr_in("written", "orthophoto"), file_.c_str())
                    : failure_text(cannot_write(), ended->says),
        now, ended->well ? file_ : "");
}

std::string OrthophotoWriter::cannot_write() const {
    return formatted(tr("%s cannot be written."), file_.c_str());
}

void OrthophotoWriter::start(Session& s, const PackageReader& package, double now) {
    file_ = free_name(stem_for_files(package, "-orthophoto", true),
                      s.orthophoto.file == OrthophotoRequest::File::tiff ? ".tif" : ".png");
    try {
        program_.emplace(own_program, orthophoto_arguments(s, package, file_));
        s.orthophoto.writing = true;
        say(s.message, formatted(tr("the orthophoto is being written to %s"), file_.c_str()), now);
    } catch (const Error& e) {
        say(s.message, failure_text(cannot_write(), e), now);
    }
}

}  // namespace vantage
