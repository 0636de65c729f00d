#include "pipeline/commands/shared/effect_option.h"

#include "base/text/error.h"

namespace vantage {
namespace {

void choose_effect(const std::string& text, std::map<Effect, EffectChoice>& choices) {
    const std::size_t eq = text.find('=');
    const EffectRow& row = effect_row(text.substr(0, eq));
    const std::string choice = eq == std::string::npos ? "" : text.substr(eq + 1);
    if (choice == "on")
        choices[row.effect] = EffectChoice::on;
    else if (choice == "off")
        choices[row.effect] = EffectChoice::off;
    else if (choice == "auto")
        choices.erase(row.effect);
    else
        throw Error(Exit::usage, "--effect " + text + ": expected " + row.option + "=on, off or auto");
}

}  // namespace

void add_effects(const Command& command, std::vector<std::string>& texts) {
    command
        .list("--effect", texts,
              "turn an effect on or off, or let the scene decide; 'vantage info' lists the effects")
        .type("NAME=on|off|auto")
        .one_word();
}

void choose_effects(const std::vector<std::string>& texts, std::map<Effect, EffectChoice>& choices) {
    for (const std::string& text : texts) choose_effect(text, choices);
}

}  // namespace vantage
