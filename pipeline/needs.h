#pragma once
#include <cstdint>
#include <filesystem>

#include "pipeline/prepare.h"
#include "scene/package_format.h"

namespace vantage {

/// What a photo in flight takes of memory, in bytes: its pixels, what the model is rendered into, and masks.
std::uint64_t photo_memory(const SceneInput& scene, const package::SceneRecord& model);

/// What is still to come for the whole scene, whatever the photos.
std::uint64_t scene_memory(const package::SceneRecord& model, bool opengl);

/// What this process holds now, and has held at most, in bytes; 0 where the system does not say.
std::uint64_t memory_now();
std::uint64_t memory_peak();

/// As many as the settings ask for, or as there are cores.
unsigned threads_of(const PrepareSettings& settings);

/// Photos in flight that the settings' threads and memory allow, `base` bytes gone to the scene. Throws
/// Error(usage) where memory is too little for one.
unsigned photos_in_flight(const PrepareSettings& settings, std::uint64_t base, std::uint64_t photo_bytes);

/// Seconds that the photos will take, by how fast this machine was the last time.
double expected_seconds(const SceneInput& scene, const package::SceneRecord& model, unsigned in_flight);
/// Remembers how long they took, for the next time. Only a hint.
void remember_speed(double expected, double took);

}  // namespace vantage
