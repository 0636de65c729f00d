#pragma once
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/output/stage_keys.h"
#include "scene/package/package_reader.h"
#include "scene/package/package_writer.h"

namespace vantage {

/// A package, finished or partial, left by an earlier run; its chunks are reused if they were made from the
/// same inputs.
class EarlierPackage {
  public:
    /// `in_place`: the file is the one being written. Throws Error if the file is not a package.
    EarlierPackage(const std::filesystem::path& file, bool in_place);

    /// The index of the photo with this name; empty if the photo is missing or its record is damaged.
    std::optional<std::uint32_t> photo(const std::string& name) const;
    const package::PhotoRecord& record(std::uint32_t photo) const;
    const package::PhotoState& state(std::uint32_t photo) const;
    /// Whether the file is a finished package, not a part or a shard.
    bool finished() const {
        return !in_place_ && reader_.header().shares == 0 && reader_.find(package::Type::pose_refinement);
    }
    const PackageReader& reader() const { return reader_; }
    /// The settings with which the package was prepared, as stored in META; null if META cannot be read.
    const nlohmann::json& settings() const { return *settings_; }

    /// Passes a stage's chunks to the writer if all are present and intact, and were made with the key and
    /// pose in `wanted` for a photo with the same number of levels. Sets the stage's content in `wanted`.
    /// Thread-safe.
    bool reuse(package::Stage stage, std::uint32_t from, std::uint32_t to, int levels,
               package::PhotoState& wanted, PackageWriter& writer) const;

  private:
    bool made_from(package::Stage stage, std::uint32_t from, int levels,
                   const package::PhotoState& wanted) const;

    PackageReader reader_;
    bool in_place_;
    std::vector<package::PhotoRecord> records_;
    std::vector<package::PhotoState> states_;
    std::map<std::string, std::uint32_t> by_name_;
    std::shared_ptr<const nlohmann::json> settings_;
};
using EarlierPackages = std::vector<std::unique_ptr<EarlierPackage>>;

/// The packages that earlier runs left for `out`, best first: the part (resumed by the writer, or moved
/// aside), then the finished package. Unreadable files are skipped.
EarlierPackages earlier_packages(const std::filesystem::path& out, bool resumed);

/// XXH3-64 of the checksums of a stage's chunks, as the writer sealed them.
std::uint64_t content_of(package::Stage stage, std::uint32_t photo, int levels, const PackageWriter& writer);

/// The reason why a stage has to run for this photo, as a message.
std::string reason_to_run(package::Stage stage, const std::string& photo, const package::PhotoState& wanted,
                          const nlohmann::json& settings, const EarlierPackages& earlier);

}  // namespace vantage
