#include "pipeline/registered.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "pipeline/former.h"
#include "pipeline/join_tiles.h"
#include "pipeline/provenance.h"
#include "pipeline/stages/pyramid.h"
#include "scene/checksum.h"
#include "scene/error.h"

namespace vantage {
namespace {

using package::PairRecord;
using package::PhotoRecord;
using package::PhotoState;
using package::RegistrationRecord;
using package::Stage;
using package::Type;

/// Goes up where a change of ours changes what registration finds.
constexpr std::uint64_t version = 1;

std::uint64_t hash(std::span<const std::uint64_t> values) { return checksum(std::as_bytes(values)); }

/// Of a chunk without blocks, copied; none where it is not there or not sound.
template <class T>
std::vector<T> sound_records(const PackageReader& package, Type type) {
    const package::DirectoryEntry* e = package.find(type);
    if (!e || !package.head_sound(*e)) return {};
    const auto bytes = package.bytes(e);
    std::vector<T> out(bytes.size() / sizeof(T));
    if (!out.empty()) std::memcpy(out.data(), bytes.data(), out.size() * sizeof(T));
    return out;
}

RgbaImage tiles_at(const PackageReader& part, std::uint32_t photo, const PhotoRecord& r, int level) {
    const int stored = std::min(level, int(r.levels) - 1);
    RgbaImage image = read_level_image(part, r, photo, Type::tiles, stored);
    for (int l = stored; l < level; ++l) image = halve(image);
    return image;
}

}  // namespace

std::vector<std::uint64_t> registration_fingerprints(std::span<const PhotoState> states,
                                                     std::span<const Pose> given, bool opengl) {
    std::vector<std::uint64_t> out;
    for (std::size_t i = 0; i < states.size(); ++i)
        out.push_back(
            hash(std::array{states[i].stages[std::size_t(Stage::tiles)].key, states[i].camera,
                            states[i].model, pose_checksum(given[i]), std::uint64_t(opengl), version}));
    return out;
}

std::uint64_t registration_key(std::span<const std::uint64_t> fingerprints, EffectChoice choice) {
    return hash(std::array{hash(fingerprints), std::uint64_t(choice), version});
}

std::optional<Registration> registration_of(const PackageReader& package, std::uint64_t key) {
    const auto records = sound_records<RegistrationRecord>(package, Type::registration);
    const auto photos = sound_records<PhotoRecord>(package, Type::photos);
    const package::DirectoryEntry* meta = package.find(Type::meta);
    if (records.empty() || records.size() != photos.size() || records[0].key != key || !meta ||
        !package.head_sound(*meta))
        return {};
    Registration out;
    const std::string text(package.meta());
    out.decision = decision_of(text, Effect::registration);
    out.warnings = findings_of(text);
    out.pairs = pairs_of(package);
    for (std::size_t i = 0; i < records.size(); ++i) {
        out.photos.push_back({{}, records[i].by, records[i].before, records[i].after});
        if (photos[i].flags & package::photo_registered) out.photos.back().pose = cam_from_origin(photos[i]);
    }
    return out;
}

std::vector<PairRecord> pairs_of(const PackageReader& package) {
    std::vector<PairRecord> out = sound_records<PairRecord>(package, Type::pairs);
    const auto photos = sound_records<PhotoRecord>(package, Type::photos).size();
    std::erase_if(out, [&](const PairRecord& p) { return p.a >= p.b || p.b >= photos; });
    return out;
}

std::vector<Pose> given_poses(const PackageReader& package) {
    std::vector<Pose> out;
    const auto given = sound_records<RegistrationRecord>(package, Type::registration);
    const auto photos = sound_records<PhotoRecord>(package, Type::photos);
    for (std::size_t i = 0; i < photos.size(); ++i)
        out.push_back(i < given.size() ? cam_from_origin(given[i]) : cam_from_origin(photos[i]));
    return out;
}

void write_registration(PackageWriter& writer, const Registration& found, std::span<const Pose> given,
                        std::uint64_t key) {
    std::vector<RegistrationRecord> records;
    for (std::size_t i = 0; i < given.size(); ++i) {
        RegistrationRecord& r = records.emplace_back();
        set_pose(given[i], r);
        const PhotoRegistration& p = found.photos[i];
        r.by = p.by;
        r.before = p.before;
        r.after = p.after;
        r.key = key;
    }
    std::vector<PairRecord> pairs(package::stored_pairs_per_photo * given.size(), PairRecord{});
    std::copy_n(found.pairs.begin(), std::min(pairs.size(), found.pairs.size()), pairs.begin());
    writer.write(Type::registration, package::scene_wide, bytes_of(records));
    writer.write(Type::pairs, package::scene_wide, bytes_of(pairs));
}

void move_photo(const GeometryStages& s, const PackageReader& part, std::uint32_t i, const Pose& pose,
                PhotoRecord& r, PhotoState& state) {
    const PhotoAtModel photo{i, r.name, intrinsics(r), pose};
    set_pose(pose, r);
    Due due;
    for (std::size_t n = 0; n < stage_count; ++n) due.stage[n] = depends_on_pose(Stage(n));
    CoarsePixels coarse{{}, tiles_at(part, i, r, sample_level)};
    if (r.flags & package::photo_has_alpha) coarse.valid = validity(tiles_at(part, i, r, mask_level));
    std::promise<CoarsePixels> pixels;
    pixels.set_value(std::move(coarse));
    const auto view = std::make_shared<const PhotoView>(view_of(s, photo));
    PhotoGeometry geometry = s.renderer.render(view, photo.k, s.trace, photo.name).get();
    make_from_geometry(s, photo, due, *view, std::move(geometry), pixels.get_future(), r);
    state.pose = pose_checksum(pose);
    state.consensus = 0;
    for (std::size_t n = 0; n < stage_count; ++n)
        if (due.stage[n]) state.stages[n].content = content_of(Stage(n), i, int(r.levels), s.writer);
    seal(state, r);
    s.writer.note(Type::photos, i, bytes_of_one(r));
    s.writer.note(Type::states, i, bytes_of_one(state));
}

}  // namespace vantage
