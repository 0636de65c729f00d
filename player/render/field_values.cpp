#include "player/render/field_values.h"

#include <cmath>
#include <tuple>

#include "shaders/contract.h"

namespace vantage {

FieldValues::FieldValues(const PackageReader& package)
    : package_(&package), fields_(all_fields(package)), measured_(fields_.size()) {}

const ScalarField* FieldValues::shown(const RenderSettings& settings) const {
    const FieldSettings& l = settings.field;
    const bool exists = l.index >= 0 && std::size_t(l.index) < fields_.size() && l.share > 0;
    return exists ? &fields_[std::size_t(l.index)] : nullptr;
}

bool FieldValues::load(const RenderSettings& settings, ClusterDraws& clusters) {
    if (!shows(settings) || loaded_ == settings.field.index) return false;
    loaded_ = settings.field.index;
    const auto i = std::size_t(loaded_);
    ScalarField& field = fields_[i];
    if (field.measure && field.values.empty()) {
        measured_[i] = measure_photos(*package_, *field.measure);
        field.values = measured_[i];
        summarize_values(field);
    }
    const bool taken = clusters.show_values(field.values);
    if (!field.measure) package_->forget(std::as_bytes(field.values));
    return taken;
}

void FieldValues::set(const FieldSettings& settings) {
    const ScalarField& field = fields_[std::size_t(settings.index)];
    const FieldLegend legend = field_legend(field, settings);
    if (!color_map_)
        color_map_ =
            gl::make_texture_2d("color map", GL_SRGB8_ALPHA8, std::tuple_size_v<ColorTable>, 1, GL_LINEAR);
    if (mapped_ != std::pair(legend.map, legend.center)) {
        const ColorTable table = color_table(legend.map, legend.center);
        glTextureSubImage2D(color_map_.id(), 0, 0, 0, GLsizei(table.size()), 1, GL_RGBA, GL_UNSIGNED_BYTE,
                            table.data());
        mapped_ = {legend.map, legend.center};
    }
    const auto [low, high] = legend.range;
    const double begin = settings.logarithmic ? std::log(low) : low,
                 end = settings.logarithmic ? std::log(high) : high;
    glUniform3f(shader::field_scale_uniform, float(begin), float(1 / (end - begin)), settings.logarithmic);
    glUniform1f(shader::isolines_uniform, float(settings.isolines));
    glBindTextureUnit(shader::color_map_unit, color_map_.id());
}

}  // namespace vantage
