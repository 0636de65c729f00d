#include "player/window/orthophoto_writer.h"

#include "base/text/error.h"
#include "base/text/formatted.h"
#include "base/text/translation.h"
#include "player/interface/sections/orthophoto_section.h"
#include "player/interface/state/failure_text.h"
#include "player/window/input/numbered_file.h"
#include "scene/package/contents/image_sets.h"

namespace vantage {

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
    const std::string pixel = formatted("%.12g", s.orthophoto.pixel);
    file_ = free_name(stem_for_files(package, "-orthophoto", true),
                      s.orthophoto.file == OrthophotoRequest::File::tiff ? ".tif" : ".png");
    std::vector<std::string> arguments = {
        "orthophoto",   package.path().string(),
        "--plane",      plane_option(s.orthophoto.plane, s.viewpoint.camera),
        "--resolution", pixel,
        "-o",           file_,
        "--quiet"};
    if (const std::vector<ImageSet> image_sets = read_image_sets(package); image_sets.size() > 1)
        arguments.insert(arguments.end(), {"--image-set", image_sets[s.settings.image_sets.shown].name});
    try {
        program_.emplace(own_program, std::move(arguments));
        s.orthophoto.writing = true;
        say(s.message, formatted(tr("the orthophoto is being written to %s"), file_.c_str()), now);
    } catch (const Error& e) {
        say(s.message, failure_text(cannot_write(), e), now);
    }
}

}  // namespace vantage
