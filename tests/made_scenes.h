#pragma once
#include <filesystem>

#include "pipeline/run/settings.h"
#include "pipeline/synth/spec.h"

namespace vantage {

/// The specifications data/NAME.toml; `tiny` with one ray per pixel, which is enough where no picture is
/// judged.
SynthSpec spec_named(const char* name);
SynthSpec tiny_spec();

/// A synthetic scene, as by synthesize(), in a folder of the test's. It is made by the first test that asks
/// for it and kept for all others until the test program is built again.
void copy_scene(const SynthSpec& spec, const std::filesystem::path& folder);

/// The package of a scan, as by prepare(), made for the first test that has the same files and settings.
/// Nobody may write to it.
std::filesystem::path made_package(const std::filesystem::path& scan, const PrepareSettings& settings = {});
/// The same as a file of the test's, which replaces an existing one.
void copy_package(const std::filesystem::path& scan, const PrepareSettings& settings,
                  const std::filesystem::path& to);

}  // namespace vantage
