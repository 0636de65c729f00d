#pragma once
#include <filesystem>

#include "pipeline/run/settings.h"
#include "pipeline/synth/spec.h"

namespace vantage {

/// The specification data/NAME.toml. tiny_spec() is `tiny` with only one ray per pixel, which suffices where
/// picture quality does not matter.
SynthSpec spec_named(const char* name);
SynthSpec tiny_spec();

/// Puts a synthetic scene, as made by synthesize(), into a test's folder. The first test that needs the scene
/// makes it, and others reuse it until the test program is rebuilt.
void copy_scene(const SynthSpec& spec, const std::filesystem::path& folder);

/// The package of a scan as written by prepare(). The first test that needs the package makes it, and tests
/// with the same files and settings reuse it. Tests must not write to the package.
std::filesystem::path made_package(const std::filesystem::path& scan, const PrepareSettings& settings = {});
/// Copies such a package to a test's file, which is replaced if it exists.
void copy_package(const std::filesystem::path& scan, const PrepareSettings& settings,
                  const std::filesystem::path& to);

}  // namespace vantage
