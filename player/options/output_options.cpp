#include "player/options/output_options.h"

#include "cli/force_option.h"

namespace vantage {

void add_output_options(CLI::App& app, OutputOptions& o) {
    app.add_option("--size", o.size,
                   "size of the window or the pictures, in pixels (default 1280x720, or the photo's size)")
        ->type_name("WIDTHxHEIGHT");
    app.add_option("-o,--output", o.file, "file, or folder for several files")->type_name("FILE");
    add_force(app, o.force);
    app.add_flag("-q,--quiet", o.quiet, "print only errors");
}

}  // namespace vantage
