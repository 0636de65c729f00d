#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "scene/story/story.h"

namespace vantage {

/// The value of "format" in a story.
inline constexpr const char* story_format = "vantage-story-1";

/// A story, and keys of its file that were ignored, one line each.
struct ReadStory {
    Story story;
    std::vector<std::string> unknown;
};

/// The sidecar of a package or a scene file: NAME.story.json beside NAME.vantage. Empty for a URL.
std::filesystem::path story_file_of(const std::filesystem::path& package);

/// Reads a story as docs/story.md describes it; `file` names it in messages. Every number is finite and
/// within its range, every text within its length, and eyes and targets of views differ. What a story refers
/// to is not looked for, see story_references(). Throws Error(input), one line with the file, the place in
/// it, what was found and what was expected.
ReadStory parse_story(const std::string& text, const std::string& file);

/// Reads a file of at most 8 MiB. Throws Error(input).
ReadStory read_story(const std::filesystem::path& file);

/// The text of a story's file. The same story gives the same bytes.
std::string story_text(const Story& story);

/// Writes a story to NAME.part and renames it. Replaces any file of that name. Throws Error(usage) for a
/// story that could not be read back, Error(storage).
void write_story(const std::filesystem::path& file, const Story& story);

}  // namespace vantage
