#pragma once
#include <cstdio>
#include <nlohmann/json_fwd.hpp>

namespace vantage {

/// The form of a verb's report on standard output: lines for people, nothing (-q), or one JSON object
/// (--json) that follows docs/results.schema.json.
enum class OutputForm { lines, none, json };

/// Called by Command before an action runs; clears results().
void choose_output(OutputForm form);
OutputForm output_form();

/// Standard output if the form is `lines`, otherwise a file that discards everything written to it.
std::FILE* text_output();

/// The JSON object that is printed if the form is `json`. Command adds the members common to all verbs.
nlohmann::json& results();

/// Prints results() if the form is `json`.
void print_results(int exit_code);

}  // namespace vantage
