#include "scene/package/package_directory.h"

#include <algorithm>
#include <cstring>
#include <string>

#include "base/files/checksum.h"
#include "base/values/bytes_of.h"
#include "scene/package/damaged_package.h"

namespace vantage {

using package::DirectoryEntry;
using package::Form;
using package::Header;

Header make_header(const char (&magic)[8], const PackageLayout& layout, Share share) {
    Header h{};
    std::memcpy(h.magic, magic, sizeof h.magic);
    h.version = package::version;
    h.directory_count = std::uint32_t(layout.directory.size());
    h.directory_offset = sizeof h;
    h.file_size = layout.bytes;
    h.layout = layout.checksum;
    h.share = share.share;
    h.shares = share.shares;
    return h;
}

void seal_header(Header& h) {
    h.header_checksum = checksum(bytes_of_one(h).first(offsetof(Header, header_checksum)));
}

bool is_valid(const Header& h) {
    Header expected = h;
    seal_header(expected);
    return h.header_checksum == expected.header_checksum;
}

namespace {

bool raw_chunk_fits(const DirectoryEntry& e) {
    if (e.block_length == 0) return e.head_length == e.length;
    const std::uint64_t body = e.length - e.head_length;
    return body % e.block_length == 0 && e.head_length % package::alignment == 0 &&
           body / e.block_length <= e.head_length / sizeof(std::uint64_t);
}

/// Whether the lengths of a coded chunk are consistent. Unknown forms, which later programs may have written,
/// are accepted.
bool coded_chunk_fits(const DirectoryEntry& e) {
    if (e.form == Form::zstd) return e.head_length == e.length && e.length >= sizeof(std::uint64_t);
    return e.head_length / package::coded_block_entry >= e.coded_blocks;
}

bool chunk_fits(const DirectoryEntry& e, std::uint64_t file_size) {
    const bool raw = e.form == Form::raw;
    return e.offset % (raw ? package::alignment : package::coded_alignment) == 0 && e.offset <= file_size &&
           e.length <= file_size - e.offset && e.head_length <= e.length &&
           (raw ? raw_chunk_fits(e) : coded_chunk_fits(e));
}

class DirectoryReading {
  public:
    DirectoryReading(PackageSource& source, bool part_too, std::vector<Held>& held)
        : source_(source), bytes_(source.bytes()), part_too_(part_too), held_(held) {}

    const Header& header() {
        if (bytes_.size() < sizeof(Header))
            damaged(Defect::not_a_package, "not a Vantage package: " + std::to_string(bytes_.size()) +
                                               " bytes, but a header has 64");
        hold(0, sizeof(Header));
        const auto& h = *reinterpret_cast<const Header*>(bytes_.data());
        const bool part = is_part(h);
        if (part && !part_too_ && h.shares > 0 && h.directory_checksum != 0)
            damaged(Defect::unfinished, "header: this is shard " + std::to_string(h.share) + " of " +
                                            std::to_string(h.shares) +
                                            "; join the shards with 'vantage merge'");
        if (part && !part_too_)
            damaged(Defect::unfinished, "header: preparation of this package was not finished");
        if (!part && std::memcmp(h.magic, package::magic, sizeof h.magic) != 0)
            damaged(Defect::not_a_package, "header: not a Vantage package");
        if (!is_valid(h)) damaged(Defect::header_checksum, "header: checksum does not match");
        if (h.version != package::version) {
            const bool newer = h.version > package::version;
            damaged(newer ? Defect::newer_format : Defect::format_version,
                    "header: format version " + std::to_string(h.version) + ", this program reads " +
                        std::to_string(package::version) +
                        (newer ? "; made by a newer version of vantage" : "; prepare it again"));
        }
        if (h.file_size != bytes_.size())
            damaged(Defect::truncated, "header: the file has " + std::to_string(bytes_.size()) +
                                           " bytes, expected " + std::to_string(h.file_size));
        return h;
    }

    std::vector<DirectoryEntry> directory(const Header& h) {
        if (h.directory_offset % 8 || h.directory_offset > bytes_.size() ||
            h.directory_count > (bytes_.size() - h.directory_offset) / sizeof(DirectoryEntry))
            damaged(Defect::directory, "directory: lies outside the file");
        hold(h.directory_offset, h.directory_count * sizeof(DirectoryEntry));
        const auto* first = reinterpret_cast<const DirectoryEntry*>(bytes_.data() + h.directory_offset);
        std::vector<DirectoryEntry> entries(first, first + h.directory_count);
        const auto fits = [&](const DirectoryEntry& e) { return chunk_fits(e, bytes_.size()); };
        if (is_part(h) && h.directory_checksum == 0)  // it is still being written
            std::erase_if(entries, [&](const DirectoryEntry& e) { return e.type == 0 || !fits(e); });
        else if (checksum(bytes_of(entries)) != h.directory_checksum)
            damaged(Defect::directory, "directory: checksum does not match");
        if (const auto misplaced = std::ranges::find_if_not(entries, fits); misplaced != entries.end())
            damaged(Defect::directory, "directory: entry " + std::to_string(misplaced - entries.begin()) +
                                           " lies outside the file");
        return entries;
    }

    /// Fetches the header and the directory again. False for a file.
    bool discard() {
        const PackageSource::Part first = bytes_.first(std::min(bytes_.size(), sizeof(Header)));
        if (!source_.discard({&first, 1})) return false;
        const Header& h = header();
        if (h.directory_offset >= bytes_.size()) return true;
        const PackageSource::Part rest = bytes_.subspan(
            h.directory_offset, std::min<std::uint64_t>(bytes_.size() - h.directory_offset,
                                                        h.directory_count * sizeof(DirectoryEntry)));
        source_.discard({&rest, 1});
        return true;
    }

  private:
    static bool is_part(const Header& h) {
        return std::memcmp(h.magic, package::part_magic, sizeof h.magic) == 0;
    }
    [[noreturn]] void damaged(Defect defect, const std::string& what) const {
        throw DamagedPackage(defect, source_.name().string() + ": " + what);
    }
    void hold(std::uint64_t offset, std::uint64_t length) {
        const PackageSource::Part part = bytes_.subspan(offset, length);
        held_.push_back(source_.hold({&part, 1}, {}));
    }

    PackageSource& source_;
    PackageSource::Part bytes_;
    bool part_too_;
    std::vector<Held>& held_;
};

}  // namespace

std::vector<DirectoryEntry> read_directory(PackageSource& source, bool part_too, std::vector<Held>& held) {
    DirectoryReading reading(source, part_too, held);
    try {
        return reading.directory(reading.header());
    } catch (const DamagedPackage&) {
        if (!reading.discard()) throw;
    }
    return reading.directory(reading.header());
}

}  // namespace vantage
