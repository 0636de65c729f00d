#include "player/options/output_options.h"

#include "base/cli/command.h"

namespace vantage {

void add_size_option(const Command& c, OutputOptions& o) {
    c.text("--size", o.size,
           "size of the window or the pictures, in pixels (default 1280x720, or the photo's size)")
        .type("WIDTHxHEIGHT");
}

void add_output_options(const Command& c, OutputOptions& o) {
    c.file("-o,--output", o.file, "file, or folder for several files");
    c.force(o.force);
}

}  // namespace vantage
