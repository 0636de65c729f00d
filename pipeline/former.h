#pragma once
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pipeline/stage_keys.h"
#include "scene/package_reader.h"
#include "scene/package_writer.h"

namespace vantage {

/// A package, or a part of one, that an earlier run left: whatever in it was made from the same is kept.
class Former {
  public:
    /// With `in_place` it is the very file that is being written. Throws Error where it is none.
    Former(const std::filesystem::path& file, bool in_place);

    /// Its photo of this name, where it is whole: an index; else nothing.
    std::optional<std::uint32_t> photo(const std::string& name) const;
    const package::PhotoRecord& record(std::uint32_t photo) const;
    const package::PhotoState& state(std::uint32_t photo) const;
    /// A whole package, not a part of one.
    bool finished() const {
        return !in_place_ && reader_.header().shares == 0 && reader_.find(package::Type::registration);
    }
    const PackageReader& reader() const { return reader_; }
    /// The settings it was prepared with, as META names them; null where META is not there.
    const nlohmann::json& settings() const { return settings_; }

    /// Hands the chunks of a stage to the writer, where they are all there and sound, were made with the key
    /// and from the pose that `wanted` has, from a photo of as many levels; completes `wanted`. Thread-safe.
    bool hand_over(package::Stage stage, std::uint32_t from, std::uint32_t to, int levels,
                   package::PhotoState& wanted, PackageWriter& writer) const;

  private:
    PackageReader reader_;
    bool in_place_;
    std::vector<package::PhotoRecord> records_;
    std::vector<package::PhotoState> states_;
    std::map<std::string, std::uint32_t> by_name_;
    nlohmann::json settings_;
};

/// What the runs before left of the package `out`, best first: its part, when the writer goes on with it, or
/// one that it moved aside, and the finished package. Unreadable ones are no help and are passed over.
std::vector<std::unique_ptr<Former>> formers_of(const std::filesystem::path& out, bool resumed);

/// XXH3-64 of the checksums of a stage's chunks, as the writer has sealed them.
std::uint64_t content_of(package::Stage stage, std::uint32_t photo, int levels, const PackageWriter& writer);

/// Why a stage has to be made for this photo, for people.
std::string why_made(package::Stage stage, const std::string& photo, const package::PhotoState& wanted,
                     const nlohmann::json& settings, const std::vector<std::unique_ptr<Former>>& formers);

}  // namespace vantage
