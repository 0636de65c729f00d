#include "player/measure/verify.h"
#include "player/verbs/verbs.h"

namespace vantage {

void add_verify(const Command& program) {
    const auto o = std::make_shared<VerifyOptions>();
    const Command c = program.verb("verify", "Compare renderings of packages with stored pictures");
    c.list("FILES", o->packages, "packages").type("PACKAGE").required();
    c.file("--golden", o->golden,
           "folder with views.path and the stored pictures; for several packages, the folder that contains "
           "these folders")
        .type("FOLDER")
        .required();
    c.flag("--update", o->update, "store the pictures, and also views if there are none");
    c.text("--size", o->size, "size of the pictures, in pixels").type("WIDTHxHEIGHT");
    c.integer("--tolerance", o->tolerance, 0, 255, "gray levels by which a pixel may differ");
    c.real("--max-diff-fraction", o->share, 0, 1, "fraction of the pixels that may differ by more");
    c.file("-o,--output", o->differences, "folder for pictures that show the differences").type("FOLDER");
    c.file("--junit", o->junit, "write a JUnit file for CI");
    c.notes(
        "views.path holds one view per line, as recorded by the window and read by --path.\n"
        "Examples:\n"
        "  vantage-player verify chapel.vantage --golden golden/chapel --update\n"
        "  vantage-player verify chapel.vantage --golden golden/chapel\n"
        "  vantage-player verify collection/*.vantage --golden golden --junit pictures.xml   "
        "(collection/a.vantage "
        "with golden/a)\n"
        "The exit code is the first of these that applies to any package: 3 unreadable, 4 damaged, 10 "
        "different;\notherwise 0.");
    c.action([o] { return run_verify(*o); });
}

}  // namespace vantage
