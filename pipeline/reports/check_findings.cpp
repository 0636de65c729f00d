#include "pipeline/reports/check_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vantage {
namespace {

/// Identifiers are stable, because scripts match them.
constexpr std::array table{
    FindingRow{Finding::cannot_open, "cannot-open", Severity::error, Exit::input,
               "the file cannot be opened or mapped"},
    FindingRow{Finding::not_a_package, "not-a-package", Severity::error, Exit::damaged,
               "the file is not a Vantage package or ends within the header"},
    FindingRow{Finding::unfinished_package, "unfinished-package", Severity::error, Exit::damaged,
               "the file is a shard that must be merged, or its preparation was interrupted"},
    FindingRow{Finding::header_checksum, "header-checksum", Severity::error, Exit::damaged,
               "the header does not match its checksum"},
    FindingRow{Finding::format_version, "format-version", Severity::error, Exit::input,
               "the package has a format version that this program does not read"},
    FindingRow{Finding::truncated, "truncated", Severity::error, Exit::damaged,
               "the file size differs from that in the header"},
    FindingRow{Finding::damaged_directory, "damaged-directory", Severity::error, Exit::damaged,
               "the directory does not match its checksum or points outside the file"},
    FindingRow{Finding::chunk_missing, "chunk-missing", Severity::error, Exit::damaged,
               "a required chunk is missing"},
    FindingRow{Finding::chunk_checksum, "chunk-checksum", Severity::error, Exit::damaged,
               "a chunk, or the head of a chunk of tiles, does not match its checksum"},
    FindingRow{Finding::tile_checksum, "tile-checksum", Severity::error, Exit::damaged,
               "a tile does not match its checksum (only with --deep)"},
    FindingRow{Finding::invalid_record, "invalid-record", Severity::error, Exit::damaged,
               "a record of the scene or of a photo is out of range, or the number of records is wrong"},
    FindingRow{Finding::invalid_meta, "invalid-meta", Severity::error, Exit::damaged,
               "META cannot be parsed or lacks an entry"},
    FindingRow{Finding::misshapen, "misshapen", Severity::error, Exit::damaged,
               "a chunk contradicts the records: it is missing, has the wrong size, or contains an index out "
               "of range"},
    FindingRow{Finding::non_finite_position, "non-finite-position", Severity::error, Exit::damaged,
               "a vertex position is NaN or infinite"},
    FindingRow{Finding::normal_length, "normal-length", Severity::error, Exit::damaged,
               "the length of a vertex normal differs from 1 by more than 0.001"},
    FindingRow{Finding::level_flag_mismatch, "level-flag-mismatch", Severity::error, Exit::damaged,
               "a photo's flags contradict its number of pyramid levels"},
    FindingRow{Finding::coordinate_range, "coordinate-range", Severity::error, Exit::damaged,
               "a texture coordinate is outside [0,1] but not marked as unseen"},
    FindingRow{Finding::chunk_length, "chunk-length", Severity::error, Exit::damaged,
               "a chunk does not have the expected number of entries"},
    FindingRow{Finding::weight_depth_mismatch, "weight-depth-mismatch", Severity::error, Exit::damaged,
               "a weight map contradicts the depth at the same texel (only with --deep)"},
    FindingRow{Finding::state_record_mismatch, "state-record-mismatch", Severity::error, Exit::damaged,
               "an entry in STAT does not match its own checksum or that of the photo's record"},
    FindingRow{Finding::input_unreadable, "input-unreadable", Severity::error, Exit::input,
               "the input folder or a file in it cannot be read (only with --against)"},
    FindingRow{Finding::input_changed, "input-changed", Severity::warning, Exit::stale,
               "an input file has changed since the package was prepared (only with --against)"},
    FindingRow{Finding::input_new, "input-new", Severity::warning, Exit::stale,
               "an input file has been added since the package was prepared (only with --against)"},
    FindingRow{Finding::input_missing, "input-missing", Severity::warning, Exit::stale,
               "an input file of the package no longer exists (only with --against)"},
    FindingRow{Finding::photo_skipped, "photo-skipped", Severity::warning, Exit::incomplete,
               "a photo was skipped when the package was prepared"},
    FindingRow{Finding::story_unreadable, "story-unreadable", Severity::error, Exit::input,
               "the story beside the package cannot be read or breaks a rule of its format"},
    FindingRow{Finding::story_reference, "story-reference", Severity::warning, Exit::incomplete,
               "the story names a note or a tour that does not exist, or stops at a note without a view"},
    FindingRow{Finding::story_picture, "story-picture", Severity::warning, Exit::incomplete,
               "a picture in the story does not exist or is not a PNG or JPEG file"},
    FindingRow{Finding::story_anchor, "story-anchor", Severity::warning, Exit::incomplete,
               "an anchor in the story is outside the model by more than a tenth of the model's diagonal"},
    FindingRow{Finding::story_unknown_key, "story-unknown-key", Severity::warning, Exit::incomplete,
               "the story contains an unknown key, which is ignored"},
};
static_assert(table.size() == std::size_t(Finding::story_unknown_key) + 1);
static_assert(std::ranges::is_sorted(table, {}, &FindingRow::finding),
              "the rows are not in the order of Finding");

}  // namespace

const char* severity_name(Severity severity) { return severity == Severity::error ? "error" : "warning"; }

std::span<const FindingRow> finding_table() { return table; }
const FindingRow& finding_row(Finding finding) { return table[std::size_t(finding)]; }

Finding finding_of(Defect defect) {
    switch (defect) {
        case Defect::not_a_package:
            return Finding::not_a_package;
        case Defect::unfinished:
            return Finding::unfinished_package;
        case Defect::header_checksum:
            return Finding::header_checksum;
        case Defect::format_version:
        case Defect::newer_format:
            return Finding::format_version;
        case Defect::truncated:
            return Finding::truncated;
        case Defect::directory:
            return Finding::damaged_directory;
        case Defect::chunk_missing:
            return Finding::chunk_missing;
        case Defect::chunk_checksum:
            return Finding::chunk_checksum;
        case Defect::tile_checksum:
            return Finding::tile_checksum;
        case Defect::invalid_record:
            return Finding::invalid_record;
    }
    return Finding::invalid_record;
}

const char* kind_name(const FindingRow& row) {
    if (row.finding == Finding::input_unreadable) return "inputs unreadable";
    if (row.finding < Finding::story_unreadable) return kind_name(row.kind);
    return row.kind == Exit::input ? "story unreadable" : "story incomplete";
}

const char* kind_name(Exit kind) {
    if (kind == Exit::input) return "unreadable";
    if (kind == Exit::damaged) return "damaged";
    return kind == Exit::stale ? "stale" : "incomplete";
}

std::string markdown_row(const FindingRow& row) {
    return fmt::format("| `{}` | {} | {}, {} | {} |", row.id, severity_name(row.severity), kind_name(row),
                       int(row.kind), row.meaning);
}

}  // namespace vantage
