#include "player/options/show_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_scene_options(const Command& c, ShowOptions& o) {
    add_exclude_option(c, o.package);
    add_object_options(c, o.objects);
    add_size_option(c, o.output);
    add_memory_options(c, o.memory);
    add_blending_options(c, o.blending);
    add_blended_option(c, o.blending);
    add_holes_option(c, o.blending);
    add_background_option(c, o.blending);
    add_transparency_option(c, o.blending);
    add_second_image_set_options(c, o.blending.image_sets);
    add_field_options(c, o.field);
    add_light_options(c, o.light);
    add_point_options(c, o.points);
}

void show_by(const Command& c, const std::shared_ptr<ShowOptions>& o, int (*show)(const ShowOptions&)) {
    c.action([o, show](const Command& given) {
        o->blending.given = given.given(blending_group);
        return show(*o);
    });
}

}  // namespace vantage
