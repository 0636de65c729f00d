#include "player/options/shown/image_set_options.h"

#include <cmath>
#include <cstdlib>

#include "base/cli/command.h"
#include "base/text/error.h"
#include "scene/package/contents/image_sets.h"

namespace vantage {
namespace {

const char* const image_sets_group = "Image sets";

/// Reads NAME or NAME=SHARE.
std::string image_set_and_share(const std::string& text, double& share) {
    const std::size_t at = text.rfind('=');
    if (at == std::string::npos) return text;
    const std::string number = text.substr(at + 1);
    char* end = nullptr;
    share = std::strtod(number.c_str(), &end);
    if (number.empty() || *end || !(share >= 0 && share <= 1))
        throw Error(Exit::usage,
                    "--second-image-set " + text + ": expected NAME or NAME=SHARE with a share from 0 to 1");
    return text.substr(0, at);
}

}  // namespace

void add_image_set_option(const Command& c, ImageSetOptions& o) {
    c.text("--image-set", o.image_set,
           "show the photos of this image set only, such as infrared ('vantage info' lists a package's "
           "image sets; default: the first one, or that of the photo to view from)")
        .group(image_sets_group);
}

void add_second_image_set_options(const Command& c, ImageSetOptions& o) {
    const Option second =
        c.text("--second-image-set", o.second,
               "another image set to show with the first, and its share, 0 to 1 (default 0.5)")
            .type("NAME[=SHARE]")
            .group(image_sets_group);
    c.choice("--image-set-view", o.view,
             {{"mix", ImageSetView::mix},
              {"swipe", ImageSetView::swipe},
              {"side-by-side", ImageSetView::side_by_side}},
             "mix: the second image set is mixed in by its share; swipe: it is shown to the right of that "
             "share of the width; side-by-side: the middle half of each picture is shown")
        .group(image_sets_group)
        .needs(second);
}

ImageSetSettings image_set_settings(const PackageReader& package, const ImageSetOptions& o) {
    ImageSetSettings out;
    if (!o.image_set.empty()) out.shown = image_set_named(package, o.image_set);
    if (o.second.empty()) return out;
    out.how = o.view;
    double share = 0.5;
    const std::string name = image_set_and_share(o.second, share);
    (o.view == ImageSetView::swipe ? out.swipe : out.share) = share;
    out.other = image_set_named(package, name);
    if (out.other == out.shown)
        throw Error(Exit::usage, "image set '" + name + "' is already shown, expected another image set");
    return out;
}

}  // namespace vantage
