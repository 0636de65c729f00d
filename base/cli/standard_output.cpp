#include "base/cli/standard_output.h"

#include <nlohmann/json.hpp>

#include "base/text/json_text.h"

namespace vantage {
namespace {

OutputForm form = OutputForm::lines;

}  // namespace

void choose_output(OutputForm wanted) {
    form = wanted;
    results() = nlohmann::json::object();
}

OutputForm output_form() { return form; }

std::FILE* text_output() {
    static std::FILE* const discarded = std::fopen("/dev/null", "w");
    return form == OutputForm::lines || !discarded ? stdout : discarded;
}

nlohmann::json& results() {
    static nlohmann::json all = nlohmann::json::object();
    return all;
}

void print_results(int exit_code) {
    if (form != OutputForm::json) return;
    results()["exit_code"] = exit_code;
    std::printf("%s\n", json_text(results()).c_str());
    std::fflush(stdout);
}

}  // namespace vantage
