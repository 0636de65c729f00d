#include "pipeline/output/earlier_package.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "base/files/checksum.h"
#include "base/files/part_file.h"
#include "base/text/error.h"
#include "base/text/json_text.h"
#include "base/values/bytes_of.h"

namespace vantage {
namespace {

using nlohmann::json;
using package::DirectoryEntry;
using package::PhotoRecord;
using package::PhotoState;
using package::Stage;
using package::Type;

/// Copies the values, because a part changes while it is written.
template <class T>
std::vector<T> copy_records(const PackageReader& reader, Type type) {
    const auto bytes = reader.bytes(reader.find(type));
    std::vector<T> records(bytes.size() / sizeof(T));
    if (!records.empty()) std::memcpy(records.data(), bytes.data(), records.size() * sizeof(T));
    return records;
}

json read_settings(const PackageReader& reader) {
    const auto bytes = reader.bytes(reader.find(Type::meta));
    const char* text = reinterpret_cast<const char*>(bytes.data());
    const auto meta = json_of({text, bytes.size()});
    return meta.is_object() && meta.contains("config") ? meta["config"] : json{};
}

std::uint64_t content(const std::vector<std::uint64_t>& checksums) { return checksum(bytes_of(checksums)); }

}  // namespace

EarlierPackage::EarlierPackage(const std::filesystem::path& file, bool in_place)
    : reader_(file, PackageReader::Expect::part),
      in_place_(in_place),
      records_(copy_records<PhotoRecord>(reader_, Type::photos)),
      states_(copy_records<PhotoState>(reader_, Type::states)),
      settings_(std::make_shared<json>(read_settings(reader_))) {
    states_.resize(records_.size());
    for (std::uint32_t i = 0; i < records_.size(); ++i)
        if (records_[i].name[sizeof records_[i].name - 1] == 0 && sealed(states_[i], records_[i]))
            by_name_[records_[i].name] = i;
}

std::optional<std::uint32_t> EarlierPackage::photo(const std::string& name) const {
    const auto it = by_name_.find(name);
    return it == by_name_.end() ? std::nullopt : std::optional(it->second);
}

const PhotoRecord& EarlierPackage::record(std::uint32_t photo) const { return records_[photo]; }
const PhotoState& EarlierPackage::state(std::uint32_t photo) const { return states_[photo]; }

bool EarlierPackage::made_from(Stage stage, std::uint32_t from, int levels, const PhotoState& wanted) const {
    const std::size_t s = std::size_t(stage);
    const PhotoState& had = states_[from];
    return had.stages[s].key != 0 && had.stages[s].key == wanted.stages[s].key &&
           int(records_[from].levels) == levels && (!stage_row(stage).model || had.pose == wanted.pose);
}

bool EarlierPackage::reuse(Stage stage, std::uint32_t from, std::uint32_t to, int levels, PhotoState& wanted,
                           PackageWriter& writer) const {
    if (!made_from(stage, from, levels, wanted)) return false;
    std::vector<const DirectoryEntry*> entries;
    std::vector<std::uint64_t> checksums;
    if (levels > 0)
        for (const auto& [row, level] : chunks_of(stage, levels)) {
            if (!writer.plans(row->type, to, level)) continue;
            const DirectoryEntry* e = reader_.find(row->type, from, level);
            if (e == nullptr) return false;
            entries.push_back(e);
            checksums.push_back(e->checksum);
        }
    const std::uint64_t had = states_[from].stages[std::size_t(stage)].content;
    if (content(checksums) != had) return false;
    for (const DirectoryEntry* e : entries)
        if (!reader_.valid(*e)) return false;
    for (const DirectoryEntry* e : entries) {
        if (in_place_)
            writer.keep(*e);
        else
            writer.copy(reader_, *e, to);
        reader_.forget(reader_.raw(*e));
    }
    wanted.stages[std::size_t(stage)].content = had;
    if (stage == Stage::weight_maps) wanted.transients = states_[from].transients;
    return true;
}

EarlierPackages earlier_packages(const std::filesystem::path& out, bool resumed) {
    EarlierPackages found;
    const auto add = [&](const std::filesystem::path& file, bool in_place) {
        try {
            if (std::filesystem::exists(file))
                found.push_back(std::make_unique<EarlierPackage>(file, in_place));
        } catch (const Error&) {
            // An unreadable file contains nothing to reuse.
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
        for (const auto& [row, level] : chunks_of(stage, levels))
            if (writer.plans(row->type, photo, level))
                checksums.push_back(writer.checksum_of(row->type, photo, level));
    return content(checksums);
}

std::string reason_to_run(Stage stage, const std::string& photo, const PhotoState& wanted,
                          const json& settings, const EarlierPackages& earlier) {
    if (earlier.empty()) return "there is no earlier package";
    const StageRow& row = stage_row(stage);
    for (const auto& package : earlier) {
        const auto i = package->photo(photo);
        if (!i) continue;
        const PhotoState& had = package->state(*i);
        const std::size_t s = std::size_t(stage);
        if (row.pixels != PixelInput::none && had.photo != wanted.photo)
            return "the photo's file has changed";
        if (had.stages[s].key == 0) return "the stage has not run before";
        if (row.model && had.pose != wanted.pose) return "the photo's camera has changed";
        if (had.stages[s].key == wanted.stages[s].key) return "its data in the earlier package is damaged";
        for (const std::string& setting : row.settings)
            if (package->settings().is_object() &&
                package->settings().value(setting, json{}) != settings.value(setting, json{}))
                return "the setting " + setting + " has changed";
        if (row.model && had.model != wanted.model) return "the model has changed";
        if (row.model && had.camera != wanted.camera) return "the photo's camera has changed";
        return "an input or the program has changed";
    }
    return "the photo is new";
}

}  // namespace vantage
