#pragma once
#include <filesystem>

#include "pipeline/run/settings.h"
#include "pipeline/synth/spec.h"

namespace vantage {

/// The specification data/NAME.toml; `tiny` with one ray per pixel, which suffices if picture quality does
/// not matter.
SynthSpec spec_named(const char* name);
SynthSpec tiny_spec();

/// Puts a synthetic scene, as made by synthesize(), into a test's folder. The first test that needs the scene
/// makes it, and others reuse it until the test program is rebuilt.
void copy_scene(const SynthSpec& spec, const std::filesystem::path& folder);

/// The package of a scan, as written by prepare(), made for the first test that has the same files and
/// settings. Tests must not write to it.
std::filesystem::path made_package(const std::filesystem::path& scan, const PrepareSettings& settings = {});
/// Copies such a package to a test's file, replacing an existing one.
void copy_package(const std::filesystem::path& scan, const PrepareSettings& settings,
                  const std::filesystem::path& to);

}  // namespace vantage
