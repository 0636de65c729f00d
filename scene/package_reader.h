#pragma once
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/camera.h"
#include "scene/effects.h"
#include "scene/package_format.h"

namespace vantage {

/// A mapped package. Opening checks header and directory against the file and against each other; it reads
/// nothing else. While it is open it holds a shared lock, by which others see that the file is in use. Spans
/// point into the mapping and live as long as the reader.
class PackageReader {
  public:
    /// What a file may be: a whole package, or also one that is still being prepared, of which only the
    /// chunks sealed so far are there (META and the like may not be, and records are the caller's to check).
    enum class Expect { whole, part };
    /// Throws Error(input) when the file cannot be opened, Error(damaged) when it is not what is expected.
    explicit PackageReader(const std::filesystem::path& file, Expect expect = Expect::whole);
    ~PackageReader();
    PackageReader(PackageReader&&) noexcept;
    PackageReader& operator=(PackageReader&&) noexcept;

    const std::filesystem::path& path() const;
    std::uint64_t size() const;
    const package::Header& header() const;
    std::span<const package::DirectoryEntry> directory() const;

    /// The entry, or null where the package has no such chunk.
    const package::DirectoryEntry* find(package::Type type, std::uint32_t photo = package::scene_wide,
                                        std::uint32_t level = 0) const;

    /// All bytes of a chunk that has no blocks; empty for null.
    std::span<const std::byte> bytes(const package::DirectoryEntry* entry) const;
    std::size_t blocks(const package::DirectoryEntry& entry) const;
    std::span<const std::byte> block(const package::DirectoryEntry& entry, std::size_t index) const;
    bool block_sound(const package::DirectoryEntry& entry, std::size_t index) const;
    /// Head and blocks as they lie in the file, and the file itself: for copying.
    std::span<const std::byte> raw(const package::DirectoryEntry& entry) const;
    int descriptor() const;
    /// Gives the memory of these bytes back to the system until they are read again.
    void forget(std::span<const std::byte> bytes) const;
    void forget_all() const;
    /// XXH3-64 of the head agrees with the directory.
    bool head_sound(const package::DirectoryEntry& entry) const;
    /// Head and every block agree with their checksums.
    bool sound(const package::DirectoryEntry& entry) const;

    /// A chunk as records. Throws Error(damaged) when it is missing (and `required`), its length is no
    /// multiple of the record, or its checksum is wrong.
    template <class T>
    std::span<const T> records(package::Type type, std::uint32_t photo = package::scene_wide,
                               bool required = true) const {
        const auto raw = checked(type, photo, sizeof(T), required);
        return {reinterpret_cast<const T*>(raw.data()), raw.size() / sizeof(T)};
    }

    /// The scene record and photo records, their counts and values checked when first asked for, and kept.
    /// Throws Error(damaged).
    const package::SceneRecord& scene() const;
    std::span<const package::PhotoRecord> photos() const;
    std::string_view meta() const;

    /// Index of the photo called `name` (with or without its extension).
    std::optional<std::uint32_t> photo_index(std::string_view name) const;

  private:
    struct Mapping;
    std::span<const std::byte> checked(package::Type type, std::uint32_t photo, std::size_t record,
                                       bool required) const;
    package::SceneRecord checked_scene() const;
    std::unique_ptr<Mapping> map_;
};

/// A photo's pinhole camera, for positions relative to the origin.
Intrinsics intrinsics(const package::PhotoRecord& photo);
Pose cam_from_origin(const package::PhotoRecord& photo);
Pose cam_from_origin(const package::RegistrationRecord& given);
bool effect_on(const package::SceneRecord& scene, Effect effect);

/// "TILE of 00003.jpg, level 2": the name people read in messages.
std::string describe(const package::DirectoryEntry& entry, const PackageReader& reader);

}  // namespace vantage
