#include "scene/package/contents/background.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/text/error.h"
#include "base/values/bytes_of.h"

namespace vantage {
namespace {

using package::BackgroundRecord;
using package::ClusterRecord;
using package::CoverageRecord;

/// Appends `count` values, with zeros in place of missing ones.
template <class T>
void put(std::vector<std::byte>& out, const std::vector<T>& values, std::size_t count) {
    const std::size_t at = out.size();
    out.resize(at + count * sizeof(T));
    std::ranges::copy(std::as_bytes(std::span(values)), out.begin() + std::ptrdiff_t(at));
}

/// Removes `count` values from the front of `bytes` and returns them.
template <class T>
std::vector<T> take(std::span<const std::byte>& bytes, std::size_t count) {
    std::vector<T> out(count);
    std::ranges::copy(bytes.first(count * sizeof(T)), std::as_writable_bytes(std::span(out)).begin());
    bytes = bytes.subspan(count * sizeof(T));
    return out;
}

std::uint64_t size_of(const BackgroundRecord& r) {
    return sizeof r +
           r.photos * (16 * package::visible_words(r.triangles) + r.clusters * sizeof(CoverageRecord)) +
           r.vertices * 20 + r.photos + r.triangles * 12 + r.hidden * 4 + r.clusters * sizeof(ClusterRecord);
}

/// The first error in the content; empty if it is valid.
const char* problem(const BackgroundContent& s) {
    for (const Eigen::Vector3f& p : s.positions)
        if (!p.allFinite()) return "a position is not finite";
    for (const auto& t : s.triangles)
        if (std::ranges::any_of(t, [&](std::uint32_t v) { return v >= s.positions.size(); }))
            return "an index is out of range";
    std::uint64_t next = 0;
    for (const ClusterRecord& c : s.clusters) {
        const float finite = c.center[0] + c.center[1] + c.center[2] + c.radius;
        if (c.first_triangle != next || !std::isfinite(finite) || !(c.radius >= 0))
            return "a cluster is out of range";
        next += c.triangles;
    }
    return next == s.triangles.size() ? "" : "the clusters do not cover the triangles";
}

}  // namespace

std::vector<std::byte> background_chunk(const BackgroundContent& s) {
    const BackgroundRecord record{s.positions.size(), s.triangles.size(), s.clusters.size(),
                                  s.coverage.size(), s.hidden.size()};
    std::vector<std::byte> out;
    out.reserve(size_of(record));
    const auto head = bytes_of_one(record);
    out.assign(head.begin(), head.end());
    for (const auto& bits : s.visible) put(out, bits, 2 * package::visible_words(record.triangles));
    put(out, s.positions, s.positions.size());
    put(out, s.triangles, s.triangles.size());
    put(out, s.hidden, s.hidden.size());
    put(out, s.clusters, s.clusters.size());
    put(out, s.colors, s.colors.size());
    put(out, s.corrections, s.colors.size());
    put(out, s.labels, s.coverage.size());
    for (const auto& photo : s.coverage) put(out, photo, s.clusters.size());
    return out;
}

std::optional<BackgroundContent> read_background(const PackageReader& package) {
    const auto raw = package.records<std::byte>(package::Type::background, package::scene_wide, false);
    if (raw.empty()) return std::nullopt;
    const auto fail = [&](const char* why) {
        return Error(Exit::damaged, package.path().string() + ": SURR: " + why);
    };
    BackgroundRecord r{};
    constexpr std::uint64_t most = std::uint64_t(1) << 32;
    if (raw.size() >= sizeof r) std::memcpy(&r, raw.data(), sizeof r);
    if (raw.size() < sizeof r || r.vertices > most || r.triangles > most || r.clusters > r.triangles ||
        r.photos != package.photos().size() || r.photos > most || r.hidden > most || size_of(r) != raw.size())
        throw fail("length does not match its counts");
    std::span<const std::byte> rest = raw.subspan(sizeof r);
    BackgroundContent s;
    for (std::uint64_t p = 0; p < r.photos; ++p)
        s.visible.push_back(take<std::uint64_t>(rest, 2 * package::visible_words(r.triangles)));
    s.positions = take<Eigen::Vector3f>(rest, r.vertices);
    s.triangles = take<std::array<std::uint32_t, 3>>(rest, r.triangles);
    s.hidden = take<std::uint32_t>(rest, r.hidden);
    s.clusters = take<ClusterRecord>(rest, r.clusters);
    s.colors = take<std::array<std::uint8_t, 4>>(rest, r.vertices);
    s.corrections = take<std::array<std::int8_t, 4>>(rest, r.vertices);
    s.labels = take<std::uint8_t>(rest, r.photos);
    for (std::uint64_t p = 0; p < r.photos; ++p) s.coverage.push_back(take<CoverageRecord>(rest, r.clusters));
    if (const char* why = problem(s); *why) throw fail(why);
    if (!s.hidden.empty() && std::ranges::max(s.hidden) >= package.scene().triangles)
        throw fail("a hidden triangle is out of range");
    return s;
}

}  // namespace vantage
