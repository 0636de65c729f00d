#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "player/survey/survey.h"

namespace vantage {

/// The file of a scene's measurements (see docs/surveying.md), and the content that this program last read or
/// wrote, to avoid overwriting external changes.
struct SurveyFile {
    std::filesystem::path path;
    std::optional<std::string> content{};  ///< nullopt: no file
};

/// NAME.measurements.json next to NAME.vantage, or in the current folder for a remote package.
SurveyFile survey_file_of(const std::filesystem::path& package, bool remote);

/// Reads the file; returns `otherwise` if there is none. Throws Error(input) with the file name and the
/// reason, leaving `file` unchanged.
Survey read_survey(SurveyFile& file, const Survey& otherwise);

/// Writes the file atomically. Throws Error(storage) if the file cannot be written, or if it has changed
/// since this program last read or wrote it.
void write_survey(SurveyFile& file, const Survey& survey);

/// The content of the measurements file for a survey.
std::string survey_text(const Survey& survey);
/// Parses such content. Throws Error(input) naming `file`.
Survey survey_from(const std::string& text, const std::filesystem::path& file);

}  // namespace vantage
