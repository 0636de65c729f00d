#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/survey/survey.h"

namespace vantage {

/// The file in which a scene's measurements are kept, docs/surveying.md; and its content as this program last
/// read or wrote it, so that a file that someone else has changed is not overwritten.
struct SurveyFile {
    std::filesystem::path path;
    std::optional<std::string> content{};  ///< nothing: there was none
};

/// NAME.measurements.json beside NAME.vantage; in the current folder for a package on a server.
SurveyFile survey_file_of(const std::filesystem::path& package, bool remote);

/// Reads the file; `otherwise` if there is none. Throws Error(input) naming the file and what is wrong, and
/// then leaves `file` as it was.
Survey read_survey(SurveyFile& file, const Survey& otherwise);

/// Writes the file, whole or not at all. Throws Error(storage) if it cannot be written, or if it is not as it
/// was when last read or written.
void write_survey(SurveyFile& file, const Survey& survey);

/// The text of such a file.
std::string survey_text(const Survey& survey);
/// Its content. Throws Error(input) naming `file`.
Survey survey_from(const std::string& text, const std::filesystem::path& file);

}  // namespace vantage
