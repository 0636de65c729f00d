#pragma once
#include <cstdio>
#include <nlohmann/json_fwd.hpp>

namespace vantage {

/// The form in which a verb reports on the standard output: lines for people; nothing (-q); one JSON object
/// (--json), by docs/results.schema.json.
enum class OutputForm { lines, none, json };

/// Chosen by Command before an action runs; forgets results().
void choose_output(OutputForm form);
OutputForm output_form();

/// The standard output if lines are wanted, otherwise a file that discards what is written.
std::FILE* text_output();

/// Members of the JSON object. Command adds those of all verbs.
nlohmann::json& results();

/// Prints results() if JSON is wanted.
void print_results(int exit_code);

}  // namespace vantage
