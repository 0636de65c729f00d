#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "player/plan/plan_settings.h"
#include "player/plan/section_plane.h"
#include "player/plan/selection/weights.h"
#include "player/render/frame_report.h"
#include "player/view/frame_size.h"
#include "player/view/view.h"
#include "scene/package/contents/color_map.h"
#include "scene/package/contents/scalar_field.h"

namespace vantage {

/// Weighted average [M], unstructured lumigraph (after Buehler et al. 2001) or best photo [P]; rows of
/// blend_table(). The window's settings file stores the numbers.
enum class Blend { average, lumigraph, best, count };
/// Texture coordinates per vertex or per fragment; `automatic` depends on the package's effects.
enum class Coordinates { automatic, vertex, fragment, count };
/// False colors: photo index, or number of photos. Values as in shaders/contract.glsl.
enum class Show { colors, sources, coverage, count };
/// Comparison of a photo with the model, which is blended from the other photos. Values as in
/// shaders/contract.glsl.
enum class Compare { nothing, side_by_side, swipe, difference, count };
/// The photographed background, if the package has one.
enum class ShowBackground { on, dimmed, off, count };

inline constexpr int max_photos_per_pass = 16;
/// The number of photos that a window blends: 4 look as good as 8 and take two thirds to four fifths of the
/// time (`vantage-bench --only blending`).
inline constexpr int window_photos = 4;

/// A scalar field instead of the photos, or mixed with them. Its colors are not shaded, so that they match
/// the legend.
struct FieldSettings {
    int index = -1;  ///< -1: none
    ColorMap map = ColorMap::automatic;
    std::optional<ValueRange> range;  ///< whole_range() by default; clamps values outside it
    bool logarithmic = false;         ///< non-positive values count as missing
    int isolines = 0;                 ///< intervals between lines; 0: no lines
    double share = 1;                 ///< weight of the field's color in a mix with photos
    bool operator==(const FieldSettings&) const = default;
};

/// Light on the bare geometry, instead of the photos or multiplied with them. Values as in
/// shaders/contract.glsl.
enum class Light { photos, lamp, raking, normals, count };
struct LightSettings {
    Light light = Light::photos;
    double azimuth = 135;    ///< direction of the raking light, degrees: 0 from the right, 90 from above
    double elevation = 15;   ///< degrees above the picture plane, 1 to 90
    bool on_photos = false;  ///< multiplied with the photos; does not apply to normals
    bool wireframe = false;  ///< edges of the visible triangles, over the picture
    bool operator==(const LightSettings&) const = default;
};

/// The color map and the value range of one field, as determined by the settings.
struct FieldLegend {
    ColorMap map;
    ValueRange range;
    double center = 0.5;  ///< the position of 0 in a diverging color map, see color_table()
};
FieldLegend field_legend(const ScalarField& field, const FieldSettings& settings);

/// The unit of a field's values, to be translated; null if it is only stored in the field's file.
const char* unit_of(const ScalarField& field);

/// How transparent surfaces are blended: sorted at each pixel, or by weighted sums.
enum class Transparency { exact, approximate, off, count };

/// Unit of point sizes.
enum class PointSize {
    gaps,    ///< spacing of neighboring points, which fills gaps
    pixels,  ///< pixels of the picture
    world    ///< in input units
};

/// Source of point colors.
enum class PointColor {
    automatic,  ///< photos in a point-only scene; the points' own colors if there is a mesh
    photos,     ///< from photos where one shows the point, otherwise the point's own color
    own
};

/// Display of a package's point cloud.
struct PointSettings {
    bool show = true;
    bool alone = false;  ///< without the model
    PointColor color = PointColor::automatic;
    bool pick = false;  ///< also draws the data for Renderer::pick()
    PointSize by = PointSize::gaps;
    double size = 1;                   ///< diameter, in the unit of `by`
    double eye_dome = 1;               ///< strength of the shading by depth; 0: none
    std::uint64_t budget = 2'000'000;  ///< maximum number of points per frame
    bool operator==(const PointSettings&) const = default;
};

/// Layout of two image sets.
enum class ImageSetView { mix, side_by_side, swipe, count };

/// The indices of the image sets that are shown. Photos of different image sets are never blended: each image
/// set makes its own picture.
struct ImageSetSettings {
    std::uint32_t shown = 0;
    std::optional<std::uint32_t> other{};  ///< a second image set
    ImageSetView how = ImageSetView::mix;
    double share = 0;    ///< weight of the other image set in a mix, 0 to 1
    double swipe = 0.5;  ///< fraction of the width at which the other image set begins
    bool operator==(const ImageSetSettings&) const = default;
};

/// The background behind the model if holes are filled.
struct PlainBackground {
    std::array<float, 3> top{0.012f, 0.014f, 0.018f},
        bottom = top;  ///< linear light, with a gradient between them
    /// The fraction of the shorter side over which the picture fades toward its edges, into the background or
    /// into transparency. It does not fade during a comparison.
    double soft_edges = 0;
    bool operator==(const PlainBackground&) const = default;
};

/// The background for a scene that has no photographed one: neutral, with the brightness that the photos show
/// around the model.
PlainBackground plain_background_of(const package::SceneRecord& scene);

/// The tiles and points that a frame waits for.
enum class Loading {
    complete,  ///< all that the view needs; photos do not fade
    sparing,   ///< like `complete`, but without tiles of which only a small part is visible
    /// All that the frame needs. Photos fade as in a window, and are chosen for the triangles visible in the
    /// previous frame: identical frames at identical times give identical pictures.
    repeatable,
    streamed,   ///< does not wait: shows resident tiles, after uploading at most upload_bytes; photos fade
    uploading,  ///< like `streamed`, but waits for tiles until upload_bytes are uploaded
    beginning   ///< like `streamed`, but waits for the minimum of each photo; for the first frame
};
/// Whether a frame's pictures are complete immediately: photos are chosen for this frame, and no photo fades.
inline bool is_complete(Loading l) { return l == Loading::complete || l == Loading::sparing; }
/// Whether a frame waits for all that it needs.
inline bool waits_for_tiles(Loading l) { return is_complete(l) || l == Loading::repeatable; }

/// How a view is rendered.
struct RenderSettings {
    Blend blend = Blend::lumigraph;
    bool transients = false;  ///< outlying colors get lower weights; this needs a second round of passes
    Coordinates coordinates = Coordinates::automatic;
    WeightSettings weights;
    Choice choice = Choice::cover;
    int photos = 0;               ///< minimum number of photos; 0: all
    double angle_limit = 150;     ///< degrees between viewing directions [M]
    bool fill_holes = false;      ///< plain shading on surfaces without photos, and a background
    bool fill_background = true;  ///< if holes are filled; otherwise the background stays transparent
    int photos_per_pass = max_photos_per_pass;
    double lod_bias = 0;      ///< levels; negative values are sharper
    bool thumbnails = false;  ///< uses nothing finer than base levels (see base_level())
    Show show = Show::colors;
    ShowBackground background = ShowBackground::on;
    Transparency transparency = Transparency::exact;
    FieldSettings field;
    LightSettings light;
    PointSettings points;
    ImageSetSettings image_sets;
    Compare compare = Compare::nothing;
    std::uint32_t compare_photo = 0;
    std::optional<View> weights_from;  ///< if set, the weights are frozen at those for this view [M]
    double swipe = 0.5;                ///< fraction of the width
    bool refined_colors = true;        ///< apply gains and vignetting if the package's effects are enabled
    std::optional<std::uint32_t> exposure;  ///< exposure of this photo instead of the view's
    Loading loading = Loading::complete;
    bool reduced = false;                                                ///< see PlanSettings::reduced
    std::size_t upload_bytes = std::numeric_limits<std::size_t>::max();  ///< per frame
    std::vector<SectionPlane> sections;  ///< at most max_sections; only cut the mesh
    PlainBackground plain_background;
    FrameSize capacity;  ///< targets are at least this large, so frames up to this size need no new ones
    bool operator==(const RenderSettings&) const = default;
};

/// The plan settings derived from these, for one sample per pixel. `anisotropy`: see RenderTrials.
PlanSettings plan_settings(const RenderSettings& settings, int anisotropy = 1);

/// Memory limits in bytes.
struct MemoryBudget {
    std::uint64_t graphics = 0;                    ///< 0: depends on the frame size
    std::uint64_t ring = std::uint64_t(32) << 20;  ///< upload buffer
    std::uint64_t elsewhere = 0;                   ///< graphics memory of other renderers
    std::uint64_t cache = std::uint64_t(4) << 30;  ///< on the disk, for remote packages
};

}  // namespace vantage
