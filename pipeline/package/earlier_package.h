#pragma once
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/package/stage_keys.h"
#include "scene/package_reader.h"
#include "scene/package_writer.h"

namespace vantage {

/// A package, finished or partial, that an earlier run left. Its chunks are reused if they were made from the
/// same inputs.
class EarlierPackage {
  public:
    /// `in_place`: it is the very file that is being written. Throws Error if it is no package.
    EarlierPackage(const std::filesystem::path& file, bool in_place);

    /// The index of the photo of this name; nothing if it is not there or its record is not intact.
    std::optional<std::uint32_t> photo(const std::string& name) const;
    const package::PhotoRecord& record(std::uint32_t photo) const;
    const package::PhotoState& state(std::uint32_t photo) const;
    /// A finished package, not a part or a share.
    bool finished() const {
        return !in_place_ && reader_.header().shares == 0 && reader_.find(package::Type::registration);
    }
    const PackageReader& reader() const { return reader_; }
    /// The settings it was prepared with, as named in META; null if META cannot be read.
    const nlohmann::json& settings() const { return settings_; }

    /// Passes the chunks of a stage to the writer if all of them are present and sound and were made under
    /// the key and from the pose in `wanted`, for a photo of as many levels. Completes `wanted`. Thread-safe.
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
    nlohmann::json settings_;
};
using EarlierPackages = std::vector<std::unique_ptr<EarlierPackage>>;

/// What earlier runs left of the package `out`, best first: its part (if the writer resumed it, or the one it
/// moved aside), then the finished package. Unreadable ones are skipped.
EarlierPackages earlier_packages(const std::filesystem::path& out, bool resumed);

/// XXH3-64 of the checksums of a stage's chunks, as the writer sealed them.
std::uint64_t content_of(package::Stage stage, std::uint32_t photo, int levels, const PackageWriter& writer);

/// Why a stage has to run for this photo, for people.
std::string reason_to_run(package::Stage stage, const std::string& photo, const package::PhotoState& wanted,
                          const nlohmann::json& settings, const EarlierPackages& earlier);

}  // namespace vantage
