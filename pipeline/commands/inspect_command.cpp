#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/cli/report_exception.h"
#include "base/cli/standard_output.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/input_options.h"
#include "pipeline/reports/inspect/facts_json.h"
#include "pipeline/reports/inspect/facts_text.h"

namespace vantage {
namespace {

struct InspectOptions {
    InputOptions input;
    PrepareSettings settings;
};

/// Like find_input(), but all parts are empty if the input cannot be searched.
FoundInput find_anything(const InspectOptions& o) {
    try {
        return find_input(o.input, o.settings);
    } catch (const Error& e) {
        return {{}, e};
    }
}

/// Throws whatever find_input() throws, unless `anything` is set.
InputFacts facts_of(const InspectOptions& o, bool anything) {
    const auto start = std::chrono::steady_clock::now();
    return input_facts(anything ? find_anything(o) : find_input(o.input, o.settings), o.settings,
                       "scene.vantage", start);
}

/// Prints the error, if any, after the other facts, and returns the exit code.
int finish(const InputFacts& facts) {
    if (!facts.error) return int(facts.exit());
    std::fflush(text_output());
    try {
        throw *facts.error;
    } catch (...) {
        return report_exception("vantage");
    }
}

int inspect_one(const InspectOptions& o) {
    const InputFacts facts = facts_of(o, output_form() == OutputForm::json);
    fmt::print(text_output(), "{}", facts_text(facts));
    results().update(facts_json(facts));
    return finish(facts);
}

/// Inspects each object of a scene file. Returns the exit code of the first error; if there is none,
/// `incomplete` if photos of any object would be skipped.
int inspect_objects(const InspectOptions& o) {
    nlohmann::json all = nlohmann::json::array();
    int code = int(Exit::ok);
    for (const SceneObject& object : read_scene_file(o.input.input, SceneUse::prepare)) {
        InspectOptions one = o;
        take_input(object.input, one.input, one.settings);
        const InputFacts facts = facts_of(one, true);
        fmt::print(text_output(), "object   {}\n{}", object.name, facts_text(facts));
        all.push_back(facts_json(facts));
        all.back()["name"] = object.name;
        const int here = finish(facts);
        if (code == int(Exit::ok) || (code == int(Exit::incomplete) && here != int(Exit::ok))) code = here;
    }
    results()["objects"] = all;
    return code;
}

}  // namespace

void add_inspect(const Command& program) {
    auto o = std::make_shared<InspectOptions>();
    const Command c = program.verb("inspect",
                                   "Show the contents of an input, the photos that would be skipped, and the "
                                   "resources needed to prepare it");
    c.notes(
        "Reads the mesh, the cameras and the headers of the photos, decodes no photo and writes nothing.\n"
        "Examples:\n  vantage inspect scans/chapel\n"
        "  vantage inspect --mesh m.ply --cameras bundle.out --photos images --json\n"
        "Exit code, that of 'vantage prepare': 0 if it would use all photos, 9 if it would skip some, or "
        "that "
        "of\nthe error, which is printed after the other facts.");
    add_input_options(c, o->input, o->settings);
    c.action(
        [o] { return is_scene_of_objects(o->input, o->settings) ? inspect_objects(*o) : inspect_one(*o); });
}

}  // namespace vantage
