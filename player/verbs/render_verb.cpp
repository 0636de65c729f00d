#include "player/options/shown/opened_package.h"
#include "player/pictures/run_render.h"
#include "player/verbs/verbs.h"

namespace vantage {
namespace {

int render(const ShowOptions& o) {
    const std::vector<SceneObject> objects = named_objects(o.package, o.objects);
    return run_render(opened_package(objects.front().package, o.memory), o, objects);
}

}  // namespace

void add_render(const Command& program) {
    const auto o = std::make_shared<ShowOptions>();
    const Command c = program.verb("render", "Write pictures: from photos' cameras, views or a path");
    add_package_argument(c, o->package).required();
    add_photo_option(c, o->package, "photos whose cameras to render from, or 'all'");
    add_view_option(c, o->pictures);
    add_path_option(c, o->pictures, "a picture of each");
    add_output_options(c, o->output);
    add_picture_options(c, o->pictures);
    add_samples_option(c, o->pictures);
    add_legend_option(c, o->pictures);
    add_scene_options(c, *o);
    add_stereo_options(c, o->stereo);
    c.common({"--help", "--help-all", "--photo", "--view", "--path", "--output", "--size", "--scale",
              "--blend", "--max-photos", "--holes", "--background", "--field", "--light", "--stereo",
              "--panorama", "--exclude", "--add"});
    c.notes(
        "Writes PNG files, with transparent holes and background unless --holes shade is given.\n"
        "Examples:\n"
        "  vantage-player render chapel.vantage --photo 0003 -o 0003.png\n"
        "  vantage-player render chapel.vantage --view 4,-9,2,0,0,1,40 --size 1920x1080 -o view.png\n"
        "  vantage-player render chapel.vantage --photo all --scale 0.5 --blend best -o pictures\n"
        "  vantage-player render chapel.vantage --photo 0003 --field photo-count --isolines 10 -o map.png\n"
        "  vantage-player render chapel.vantage --photo 0003 --light raking --lamp 200,10 -o relief.png\n"
        "  vantage-player render chapel.vantage --photo 0003 --panorama -o around.png\n"
        "  vantage-player render chapel.vantage --photo 0003 --stereo anaglyph -o 0003-3d.png\n"
        "  vantage-player render panel.vantage --photo 0003 --image-set visible --second-image-set "
        "infrared=0.5 -o mixed.png");
    c.action([o] { return render(*o); });
}

}  // namespace vantage
