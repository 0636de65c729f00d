#include "pipeline/former.h"

#include <cstring>

#include "scene/checksum.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::DirectoryEntry;
using package::PhotoRecord;
using package::PhotoState;
using package::Stage;
using package::Type;

/// Copied, because a part changes while it is written.
template <class T>
std::vector<T> copy_records(const PackageReader& reader, Type type) {
    const auto bytes = reader.bytes(reader.find(type));
    std::vector<T> records(bytes.size() / sizeof(T));
    if (!records.empty()) std::memcpy(records.data(), bytes.data(), records.size() * sizeof(T));
    return records;
}

nlohmann::json read_settings(const PackageReader& reader) {
    const auto bytes = reader.bytes(reader.find(Type::meta));
    const auto meta =
        nlohmann::json::parse(reinterpret_cast<const char*>(bytes.data()),
                              reinterpret_cast<const char*>(bytes.data()) + bytes.size(), nullptr, false);
    return meta.is_object() && meta.contains("config") ? meta["config"] : nlohmann::json{};
}

std::uint64_t content(const std::vector<std::uint64_t>& checksums) { return checksum(bytes_of(checksums)); }

}  // namespace

Former::Former(const std::filesystem::path& file, bool in_place)
    : reader_(file, PackageReader::Expect::part),
      in_place_(in_place),
      records_(copy_records<PhotoRecord>(reader_, Type::photos)),
      states_(copy_records<PhotoState>(reader_, Type::states)),
      settings_(read_settings(reader_)) {
    states_.resize(records_.size());
    for (std::uint32_t i = 0; i < records_.size(); ++i)
        if (records_[i].name[sizeof records_[i].name - 1] == 0 && sealed(states_[i], records_[i]))
            by_name_[records_[i].name] = i;
}

std::optional<std::uint32_t> Former::photo(const std::string& name) const {
    const auto it = by_name_.find(name);
    return it == by_name_.end() ? std::nullopt : std::optional(it->second);
}

const PhotoRecord& Former::record(std::uint32_t photo) const { return records_[photo]; }
const PhotoState& Former::state(std::uint32_t photo) const { return states_[photo]; }

bool Former::hand_over(Stage stage, std::uint32_t from, std::uint32_t to, int levels, PhotoState& wanted,
                       PackageWriter& writer) const {
    const PhotoState::Made& had = states_[from].stages[std::size_t(stage)];
    PhotoState::Made& made = wanted.stages[std::size_t(stage)];
    if (had.key == 0 || had.key != made.key || int(records_[from].levels) != levels) return false;
    if (depends_on_pose(stage) && states_[from].pose != wanted.pose) return false;
    std::vector<const DirectoryEntry*> entries;
    std::vector<std::uint64_t> checksums;
    if (levels > 0)
        for (const auto& [type, level] : chunks_of(stage, levels)) {
            const DirectoryEntry* e = reader_.find(type, from, level);
            if (e == nullptr) return false;
            entries.push_back(e);
            checksums.push_back(e->checksum);
        }
    if (content(checksums) != had.content) return false;
    for (const DirectoryEntry* e : entries)
        if (!reader_.sound(*e)) return false;
    for (const DirectoryEntry* e : entries) {
        if (in_place_)
            writer.keep(*e);
        else
            writer.copy(reader_, *e, to);
        reader_.forget(reader_.raw(*e));
    }
    made.content = had.content;
    if (stage == Stage::masks) wanted.consensus = states_[from].consensus;
    return true;
}

std::vector<std::unique_ptr<Former>> formers_of(const std::filesystem::path& out, bool resumed) {
    std::vector<std::unique_ptr<Former>> found;
    const auto add = [&](const std::filesystem::path& file, bool in_place) {
        try {
            if (std::filesystem::exists(file)) found.push_back(std::make_unique<Former>(file, in_place));
        } catch (const Error&) {
            // Of no help.
        }
    };
    if (resumed) add(part_of(out), true);
    add(displaced_part_of(out), false);
    add(out, false);
    return found;
}

std::uint64_t content_of(Stage stage, std::uint32_t photo, int levels, const PackageWriter& writer) {
    std::vector<std::uint64_t> checksums;
    if (levels > 0)
        for (const auto& [type, level] : chunks_of(stage, levels))
            checksums.push_back(writer.checksum_of(type, photo, level));
    return content(checksums);
}

std::string why_made(Stage stage, const std::string& photo, const PhotoState& wanted,
                     const nlohmann::json& settings, const std::vector<std::unique_ptr<Former>>& formers) {
    if (formers.empty()) return "nothing was prepared before";
    for (const auto& former : formers) {
        const auto i = former->photo(photo);
        if (!i) continue;
        const PhotoState& had = former->state(*i);
        const bool pixels = stage == Stage::tiles || stage == Stage::thumbnail || stage == Stage::masks ||
                            stage == Stage::samples;
        const bool geometry = depends_on_pose(stage);
        const std::size_t s = std::size_t(stage);
        if (pixels && had.photo != wanted.photo) return "the photo's file has changed";
        if (had.stages[s].key == 0) return "it was not made before";
        if (geometry && had.pose != wanted.pose) return "the photo's camera has changed";
        if (had.stages[s].key == wanted.stages[s].key) return "what was there is damaged";
        for (const std::string& setting : settings_of(stage))
            if (former->settings().is_object() && former->settings().value(setting, nlohmann::json{}) !=
                                                      settings.value(setting, nlohmann::json{}))
                return "the setting " + setting + " has changed";
        if (geometry && had.model != wanted.model) return "the model has changed";
        if (geometry && had.camera != wanted.camera) return "the photo's camera has changed";
        return "what it is made from, or how, has changed";
    }
    return "the photo is new";
}

}  // namespace vantage
