#pragma once
#include <span>
#include <string>

#include "base/text/error.h"
#include "scene/package/damaged_package.h"

namespace vantage {

/// All findings of `vantage check`.
enum class Finding {
    cannot_open,
    not_a_package,
    unfinished_package,
    header_checksum,
    format_version,
    truncated,
    damaged_directory,
    chunk_missing,
    chunk_checksum,
    tile_checksum,
    invalid_record,
    invalid_meta,
    misshapen,
    non_finite_position,
    normal_length,
    level_flag_mismatch,
    coordinate_range,
    chunk_length,
    weight_depth_mismatch,
    state_record_mismatch,
    input_unreadable,
    input_changed,
    input_new,
    input_missing,
    photo_skipped,
    story_unreadable,
    story_reference,
    story_picture,
    story_anchor,
    story_unknown_key
};

enum class Severity {
    warning,  ///< the package is intact
    error     ///< the package cannot be trusted or cannot be checked
};
const char* severity_name(Severity severity);

/// A row of the table of findings.
struct FindingRow {
    Finding finding;
    const char* id;  ///< in kebab-case; stable, for scripts
    Severity severity;
    Exit kind;  ///< one of the exit codes input (unreadable), damaged, stale and incomplete
    const char* meaning;
};
/// The rows are in the order of Finding.
std::span<const FindingRow> finding_table();
const FindingRow& finding_row(Finding finding);
Finding finding_of(Defect defect);

/// "unreadable", "damaged", "stale" or "incomplete".
const char* kind_name(Exit kind);
/// The kind of a finding. For findings that do not concern the package itself: "inputs unreadable", "story
/// unreadable" or "story incomplete".
const char* kind_name(const FindingRow& row);

/// The row as a line in the table of docs/check-findings.md.
std::string markdown_row(const FindingRow& row);

}  // namespace vantage
