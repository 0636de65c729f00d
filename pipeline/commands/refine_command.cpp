#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/cli/standard_output.h"
#include "base/text/error.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/shared/effect_option.h"
#include "pipeline/commands/shared/progress_option.h"
#include "pipeline/output/meta.h"
#include "pipeline/prepare/refine_package.h"
#include "scene/package/output_file.h"
#include "scene/package/package_inputs.h"
#include "scene/package/package_reader.h"

namespace vantage {
namespace {

struct RefineOptions {
    std::string file, out;
    ProgressStyle progress = ProgressStyle::automatic;
    bool force = false;
    std::vector<std::string> effects;
};

/// One choice for each effect that depends on all photos. Throws Error(usage) if `texts` names any other
/// effect.
std::map<Effect, EffectChoice> refined_effects(const std::vector<std::string>& texts) {
    std::map<Effect, EffectChoice> choices;
    choose_effects(texts, choices);
    for (const auto& [effect, choice] : choices)
        if (!from_all_photos(effect_row(effect)))
            throw Error(Exit::usage, std::string("--effect ") + effect_row(effect).option +
                                         ": depends on the inputs; change it with 'vantage prepare'");
    for (const EffectRow& row : effect_table())
        if (from_all_photos(row)) choices.emplace(row.effect, EffectChoice::automatic);
    return choices;
}

/// The package to write, which may be FILE itself: the refined package then replaces FILE.
std::filesystem::path refined_file(const RefineOptions& o) {
    const std::filesystem::path out = o.out.empty() ? o.file : o.out;
    std::error_code error;
    const bool in_place = o.out.empty() || std::filesystem::equivalent(out, o.file, error);
    Inputs inputs = inputs_of(PackageReader(o.file));
    if (in_place) inputs.files.clear();  // the package alone
    return output_file(out, Product::package, inputs, o.force);
}

int run_refine(const RefineOptions& o) {
    const std::map<Effect, EffectChoice> choices = refined_effects(o.effects);
    const std::string out = refined_file(o).string();
    {
        ProgressLine line(o.progress);
        refine_package(o.file, choices, out, shown_until_signal(line));
    }
    const PackageReader package(out);
    const std::string meta(package.meta());
    for (const auto& [effect, choice] : choices) {
        const bool on = effect_on(package.scene(), effect);
        const std::string evidence = decision_in(meta, effect).evidence;
        fmt::print(text_output(), "{:<13} {:<4} {}\n", effect_row(effect).option, on ? "on" : "off",
                   evidence);
        results()["effects"].push_back(
            {{"name", effect_row(effect).option}, {"on", on}, {"evidence", evidence}});
    }
    const std::vector<std::string> warnings = findings_in(meta);
    for (const std::string& w : warnings) fmt::print(text_output(), "warning       {}\n", w);
    results().update({{"package", out}, {"warnings", warnings}});
    fmt::print(text_output(), "package       {}\n", out);
    return 0;
}

}  // namespace

void add_refine(const Command& program) {
    auto o = std::make_shared<RefineOptions>();
    const Command c =
        program.verb("refine", "Recompute pose refinement, colors and transient masking of a package");
    c.notes(
        "Needs only the package: tiles are copied, and only data that depends on moved cameras is "
        "recomputed.\n"
        "Examples:\n  vantage refine chapel.vantage --effect exposure=off -o as-taken.vantage\n"
        "  vantage refine chapel.vantage --effect pose-refinement=on\n"
        "  vantage refine chapel.vantage");
    c.file("FILE", o->file, "the package").type("PACKAGE").required();
    c.file("-o,--output", o->out, "the package to write (default: replace FILE)");
    add_effects(c, o->effects);
    c.force(o->force);
    add_progress(c, o->progress);
    c.action([o] { return run_refine(*o); });
}

}  // namespace vantage
