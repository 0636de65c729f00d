#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "scene/package/package_format.h"

namespace vantage {

/// The levels of a photo's pyramid at which it has chunks of a type.
enum class ChunkLevels { single, tiles, masks };

/// A type of chunk: a row of the chunk table.
struct ChunkRow {
    package::Type type;
    const char* name = nullptr;                    ///< of the content; null if it only describes the package
    package::Stage stage = package::Stage::count;  ///< makes it for each photo; count: one for the scene
    ChunkLevels levels = ChunkLevels::single;      ///< of a photo; all but `single` are blocks of tiles
    bool compact = false;                          ///< coded if the effect is on
    std::uint64_t record = 0;                      ///< bytes of one of its records
    /// Number of its records, if SCEN and PHOT tell; null otherwise. Of the scene, the photo is empty.
    std::uint64_t (*count)(const package::SceneRecord&, const package::PhotoRecord&) = nullptr;
    const char* counted = "";  ///< the same in words

    bool per_photo() const { return stage != package::Stage::count; }
    /// Bytes of the content, if `count` is not null.
    std::uint64_t length(const package::SceneRecord& scene, const package::PhotoRecord& photo = {}) const {
        return count(scene, photo) * record;
    }
};

/// All types, in the order of the file.
std::span<const ChunkRow> chunk_table();
const ChunkRow& chunk_row(package::Type type);

/// Whether a photo of `levels` pyramid levels has such a chunk at a level.
bool has_chunk(const ChunkRow& row, int level, int levels);

struct LeveledChunk {
    const ChunkRow* row;
    std::uint32_t level;
};
/// The chunks of a photo of `levels` pyramid levels, by level and then in the order of the table.
std::vector<LeveledChunk> chunks_of_photo(int levels);

}  // namespace vantage
