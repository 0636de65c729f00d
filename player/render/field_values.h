#pragma once
#include <span>
#include <utility>
#include <vector>

#include "base/gl/object.h"
#include "player/render/passes/cluster_draws.h"
#include "player/render/render_settings.h"
#include "scene/package/contents/photo_fields.h"

namespace vantage {

/// The scalar fields of a package. Must be used on the OpenGL thread. The package must outlive it.
class FieldValues {
  public:
    explicit FieldValues(const PackageReader& package);

    /// Computed fields have no values until first shown.
    std::span<const ScalarField> all() const { return fields_; }
    /// The field that the settings show; null if none.
    const ScalarField* shown(const RenderSettings& settings) const;
    bool shows(const RenderSettings& settings) const { return shown(settings) != nullptr; }
    /// Computes the settings' field and passes its values to the model, unless the model already has them.
    /// Returns whether graphics memory was allocated.
    bool load(const RenderSettings& settings, ClusterDraws& clusters);
    /// Sets the uniforms for the settings' field in the current program.
    void set(const FieldSettings& settings);

  private:
    const PackageReader* package_;
    std::vector<ScalarField> fields_;
    std::vector<std::vector<float>> measured_;  ///< per field; empty if stored in the file or not yet shown
    int loaded_ = -1;                           ///< the field whose values are loaded into the model
    gl::Texture color_map_;                     ///< created when a field is first shown
    std::pair<ColorMap, double> mapped_{ColorMap::automatic, 0};  ///< with its center
};

}  // namespace vantage
