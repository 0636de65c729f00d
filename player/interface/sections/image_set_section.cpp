#include "player/interface/sections/image_set_section.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "base/text/formatted.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

/// Shows another image set. If that set is currently the second one, swaps the two.
void show_image_set(ImageSetSettings& b, std::uint32_t image_set) {
    if (b.other == image_set) b.other = b.shown;
    b.shown = image_set;
}

/// The second image set, and its display.
void second_image_set(Controls& c, RenderSettings& settings, const PlanScene& scene) {
    ImageSetSettings& b = settings.image_sets;
    std::vector<const char*> names{tr_in("image set", "none")};
    std::vector<std::uint32_t> image_sets;
    int chosen = 0;
    for (std::uint32_t i = 0; i < scene.image_sets.size(); ++i) {
        if (i == b.shown) continue;
        image_sets.push_back(i);
        names.push_back(scene.image_sets[i].name.c_str());
        if (b.other == i) chosen = int(image_sets.size());
    }
    if (c.combo("Second image set", &chosen, names.data(), int(names.size())))
        b.other = chosen > 0 ? std::optional(image_sets[std::size_t(chosen) - 1]) : std::nullopt;
    c.explain("Photos that are shown together with the first set.");
    if (!b.other) return;
    static const char* const hows[] = {marked("cross-fade"), marked("beside each other"), marked("divided")};
    static_assert(std::size(hows) == std::size_t(ImageSetView::count));
    int how = int(b.how);
    if (c.choice("Together", &how, hows, int(std::size(hows)))) {
        b.how = ImageSetView(how);
        if (b.how != ImageSetView::mix) settings.compare = Compare::nothing;
    }
    c.explain("Mixes the two sets, shows one beside the other, or divides the picture between them.");
    if (b.how == ImageSetView::mix) c.slider("Share of the second", &b.share, 0.0, 1.0);
    if (b.how == ImageSetView::swipe) c.slider("Divided at", &b.swipe, 0.0, 1.0);
}

}  // namespace

void image_set_section(Controls& c, RenderSettings& settings, const Renderer& renderer, bool more) {
    const PlanScene& scene = renderer.scene();
    ImageSetSettings& b = settings.image_sets;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < scene.image_sets.size(); ++i) {
        const auto photos = std::ranges::count(scene.photos, i, &package::PhotoRecord::image_set);
        const auto count = std::size_t(photos);
        names.push_back(scene.image_sets[i].name + ": " +
                        formatted(tr_count("%zu photo", "%zu photos", count), count));
    }
    std::vector<const char*> shown;
    for (const std::string& name : names) shown.push_back(name.c_str());
    int image_set = int(std::min<std::size_t>(b.shown, names.size() - 1));
    if (c.combo("Image set", &image_set, shown.data(), int(shown.size())))
        show_image_set(b, std::uint32_t(image_set));
    c.explain("The set of photos that is shown (X: the next one).");
    if (more) second_image_set(c, settings, scene);
}

bool is_shown(const ImageSetSettings& s, const package::PhotoRecord& photo) {
    return photo.image_set == s.shown || s.other == photo.image_set;
}

void show_next_image_set(ImageSetSettings& b, std::size_t image_sets) {
    if (image_sets > 1) show_image_set(b, std::uint32_t((b.shown + 1) % image_sets));
}

}  // namespace vantage
