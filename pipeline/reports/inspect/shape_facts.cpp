#include "pipeline/reports/inspect/shape_facts.h"

#include "base/text/file_name.h"
#include "base/values/main_box.h"

namespace vantage {

ShapeFacts shape_facts(const Mesh& mesh) {
    const MainBox box = main_box(mesh);
    ShapeFacts facts{.vertices = mesh.positions.size(),
                     .triangles = mesh.triangles.size(),
                     .low = box.low,
                     .high = box.high,
                     .strays = box.strays.size(),
                     .colors = !mesh.colors.empty(),
                     .fields = {}};
    for (const VertexField& field : mesh.scalars) facts.fields.push_back(utf8_name(field.name));
    return facts;
}

}  // namespace vantage
