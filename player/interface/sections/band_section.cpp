#include "player/interface/sections/band_section.h"

#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "base/text/formatted.h"
#include "base/text/translation.h"

namespace vantage {
namespace {

/// Shows another band; if it is the second one, they change places.
void show_band(BandSettings& b, std::uint32_t band) {
    if (b.other == band) b.other = b.shown;
    b.shown = band;
}

/// The second band, and how it is shown.
void second_band(Controls& c, Session& session, const PlanScene& scene) {
    BandSettings& b = session.settings.bands;
    std::vector<const char*> names{tr("none")};
    std::vector<std::uint32_t> bands;
    int chosen = 0;
    for (std::uint32_t i = 0; i < scene.bands.size(); ++i) {
        if (i == b.shown) continue;
        bands.push_back(i);
        names.push_back(scene.bands[i].name.c_str());
        if (b.other == i) chosen = int(bands.size());
    }
    if (c.combo("Second band", &chosen, names.data(), int(names.size())))
        b.other = chosen > 0 ? std::optional(bands[std::size_t(chosen) - 1]) : std::nullopt;
    if (!b.other) return;
    static const char* const hows[] = {marked("cross-fade"), marked("beside each other"), marked("divided")};
    static_assert(std::size(hows) == std::size_t(BandView::count));
    int how = int(b.how);
    if (c.choice("Together", &how, hows, int(std::size(hows)))) {
        b.how = BandView(how);
        if (b.how != BandView::mix) session.settings.compare = Compare::nothing;
    }
    if (b.how == BandView::mix) c.slider("Share of the second", &b.share, 0.0, 1.0);
    if (b.how == BandView::wiper) c.slider("Divided at", &b.wiper, 0.0, 1.0);
}

}  // namespace

void band_section(Controls& c, Session& session, const Renderer& renderer) {
    const PlanScene& scene = renderer.scene();
    BandSettings& b = session.settings.bands;
    std::vector<std::string> names;
    for (std::uint32_t i = 0; i < scene.bands.size(); ++i) {
        const auto photos = std::ranges::count(scene.photos, i, &package::PhotoRecord::band);
        const auto count = std::size_t(photos);
        names.push_back(scene.bands[i].name + ": " +
                        formatted(tr_count("%zu photo", "%zu photos", count), count));
    }
    std::vector<const char*> shown;
    for (const std::string& name : names) shown.push_back(name.c_str());
    int band = int(std::min<std::size_t>(b.shown, names.size() - 1));
    if (c.combo("Band", &band, shown.data(), int(shown.size()))) show_band(b, std::uint32_t(band));
    c.explain("The set of photos that is shown (X: the next one).");
    second_band(c, session, scene);
}

bool is_shown(const BandSettings& s, const package::PhotoRecord& photo) {
    return photo.band == s.shown || s.other == photo.band;
}

void show_next_band(Session& session, std::size_t bands) {
    BandSettings& b = session.settings.bands;
    if (bands > 1) show_band(b, std::uint32_t((b.shown + 1) % bands));
}

}  // namespace vantage
