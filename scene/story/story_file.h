#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/story/story.h"

namespace vantage {

/// The value of "format" in a story.
inline constexpr const char* story_format = "vantage-story-1";

/// A story, and one line for each unknown key in its file. These keys were ignored.
struct ReadStory {
    Story story;
    std::vector<std::string> unknown;
};

/// The story's path for a package or a scene file: NAME.story.json, next to NAME.vantage. Empty for a URL.
std::filesystem::path story_file_of(const std::filesystem::path& package);

/// Reads a story in the format that docs/story.md describes. `file`: the story's name in messages. Checks
/// that every number is finite and within its range, that no text exceeds its maximum length, and that the
/// eye and the target of each view differ. References are not checked (see story_references.h). Throws
/// Error(input): one line with the file, the location, the value found and the value expected.
ReadStory parse_story(const std::string& text, const std::string& file);

/// Reads a file of at most 8 MiB. Throws Error(input).
ReadStory read_story(const std::filesystem::path& file);

/// The content of a story's file. Equal stories yield identical bytes.
std::string story_text(const Story& story);

/// Writes a story, replacing any existing file atomically. Throws Error(usage) if the story could not be read
/// back, and Error(storage) if the file cannot be written.
void write_story(const std::filesystem::path& file, const Story& story);

}  // namespace vantage
