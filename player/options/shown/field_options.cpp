#include "player/options/shown/field_options.h"

#include "base/cli/command.h"
#include "base/text/error.h"
#include "scene/package/contents/photo_fields.h"

namespace vantage {

void add_field_options(const Command& c, FieldOptions& o) {
    const std::string group = "Scalar fields";
    const Option name =
        c.text("--field", o.name,
               "show this scalar field instead of the photos: a field of the package ('vantage info' lists "
               "them under scalar-fields), photo-count (number of photos that see the surface) or "
               "photo-density (pixels per input unit in the photo with the finest pixels)")
            .group(group);
    c.pair("--field-range", o.range,
           "values at the ends of the color map, LOW,HIGH; values beyond an end have its color (default: "
           "lowest and highest value)")
        .group(group)
        .needs(name);
    c.integer("--isolines", o.shown.isolines, 0, 100,
              "isolines that divide the color map into this many intervals")
        .group(group)
        .needs(name);
}

FieldSettings field_settings(const PackageReader& package, const FieldOptions& o) {
    FieldSettings out = o.shown;
    if (o.name.empty()) return out;
    const std::vector<ScalarField> fields = all_fields(package);
    out.index = field_named(fields, o.name);
    if (o.range.empty()) return out;
    const double low = o.range[0], high = o.range[1];
    if (!(low < high)) throw Error(Exit::usage, "--field-range: expected two numbers, the lower one first");
    out.range = ValueRange{low, high};
    return out;
}

}  // namespace vantage
