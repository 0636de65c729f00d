#include "player/render/passes/scalar_layers.h"

#include <cmath>
#include <tuple>

#include "shaders/contract.h"

namespace vantage {

ScalarLayers::ScalarLayers(const PackageReader& package)
    : package_(&package), layers_(all_layers(package)), measured_(layers_.size()) {}

bool ScalarLayers::shows(const RenderSettings& settings) const {
    const FieldSettings& l = settings.layer;
    return l.layer >= 0 && std::size_t(l.layer) < layers_.size() && l.share > 0;
}

bool ScalarLayers::load(const RenderSettings& settings, ClusterDraws& clusters) {
    if (!shows(settings) || loaded_ == settings.layer.layer) return false;
    loaded_ = settings.layer.layer;
    const auto i = std::size_t(loaded_);
    ScalarField& layer = layers_[i];
    if (layer.measure && layer.values.empty()) {
        measured_[i] = measure_photos(*package_, *layer.measure);
        layer.values = measured_[i];
        summarize_values(layer);
    }
    const bool taken = clusters.show_values(layer.values);
    if (!layer.measure) package_->forget(std::as_bytes(layer.values));
    return taken;
}

void ScalarLayers::set(const FieldSettings& settings) {
    const ScalarField& layer = layers_[std::size_t(settings.layer)];
    const FieldLegend legend = field_legend(layer, settings);
    if (!color_map_)
        color_map_ =
            gl::make_texture_2d("color map", GL_SRGB8_ALPHA8, std::tuple_size_v<ColorTable>, 1, GL_LINEAR);
    if (mapped_ != legend.map) {
        const ColorTable table = color_table(legend.map);
        glTextureSubImage2D(color_map_.id(), 0, 0, 0, GLsizei(table.size()), 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            table.data());
        mapped_ = legend.map;
    }
    const auto [low, high] = legend.range;
    const double begin = settings.logarithmic ? std::log(low) : low,
                 end = settings.logarithmic ? std::log(high) : high;
    glUniform3f(shader::layer_scale_uniform, float(begin), float(1 / (end - begin)), settings.logarithmic);
    glUniform1f(shader::isolines_uniform, float(settings.isolines));
    glBindTextureUnit(shader::color_map_unit, color_map_.id());
}

}  // namespace vantage
