#pragma once
#include <span>
#include <vector>

#include "base/gl/object.h"
#include "player/render/passes/cluster_draws.h"
#include "player/render/render_settings.h"
#include "scene/package/contents/photo_fields.h"

namespace vantage {

/// The scalar fields of a package. Belongs to the OpenGL thread; the package must outlive it.
class FieldValues {
  public:
    explicit FieldValues(const PackageReader& package);

    /// Those that are not stored have no values until they were shown.
    std::span<const ScalarField> all() const { return fields_; }
    /// Whether the settings show a field that there is.
    bool shows(const RenderSettings& settings) const;
    /// Measures the field that the settings show and gives its values to the model, unless that was done
    /// last. Returns whether that has taken graphics memory.
    bool load(const RenderSettings& settings, ClusterDraws& clusters);
    /// Sets the colors of the field that the settings show, for the program that is current.
    void set(const FieldSettings& settings);

  private:
    const PackageReader* package_;
    std::vector<ScalarField> fields_;
    std::vector<std::vector<float>> measured_;  ///< per field; empty if it is stored or was not shown
    int loaded_ = -1;                           ///< whose values the model has
    gl::Texture color_map_;                     ///< once a field was shown
    ColorMap mapped_ = ColorMap::automatic;
};

}  // namespace vantage
