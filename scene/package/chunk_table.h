#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace vantage {
namespace package {

struct SceneRecord;
struct PhotoRecord;

constexpr std::uint32_t fourcc(const char (&s)[5]) {
    return std::uint32_t(std::uint8_t(s[0])) | std::uint32_t(std::uint8_t(s[1])) << 8 |
           std::uint32_t(std::uint8_t(s[2])) << 16 | std::uint32_t(std::uint8_t(s[3])) << 24;
}

enum class Type : std::uint32_t {
    meta = fourcc("META"),             ///< JSON: tool, configuration, effects with evidence, inputs, names
    scene = fourcc("SCEN"),            ///< one SceneRecord
    photos = fourcc("PHOT"),           ///< PhotoRecord[photos]
    states = fourcc("STAT"),           ///< PhotoState[photos]: inputs of each photo's artifacts
    pose_refinement = fourcc("REGI"),  ///< PoseRefinementRecord[photos]: input poses, and residuals
    pose_refinement_without = fourcc("REGW"),  ///< LeaveOneOutPoseRecord[]: leave-one-out poses; optional
    pairs = fourcc("PAIR"),                    ///< PairRecord[]: how well overlapping photos agree
    positions = fourcc("VPOS"),                ///< float[3][vertices], relative to the origin
    normals = fourcc("VNRM"),                  ///< float[3][vertices], unit length
    colors = fourcc("VCOL"),                   ///< u8[4][vertices], sRGB and alpha; optional
    scalars = fourcc("VSCL"),                  ///< float[vertices] per field, names in META; optional
    indices = fourcc("INDX"),                  ///< u32[3][triangles], ordered by cluster
    clusters = fourcc("CLUS"),                 ///< ClusterRecord[clusters]
    background = fourcc("SURR"),               ///< BackgroundRecord and a backdrop; optional
    point_nodes = fourcc("PNOD"),              ///< PointNode[]: an octree over a point cloud; optional
    points = fourcc("PNTS"),                   ///< blocks of PackedPoint[point_block]; optional
    image_sets = fourcc("BAND"),               ///< ImageSetRecord[]: sets of photos; optional
    lenses = fourcc("LENS"),                   ///< LensRecord[photos]; optional
    thumbnail = fourcc("THMB"),                ///< per photo: RGBA8
    coverage = fourcc("COVR"),                 ///< per photo: CoverageRecord[clusters]
    visible =
        fourcc("VISB"),  ///< per photo: u64[], one bit per triangle: first fully visible, then partly visible
    samples = fourcc("SAMP"),      ///< per photo: SampleRecord[discs of the surface]
    coordinates = fourcc("TEXC"),  ///< per photo: float[2][vertices]; (-1,-1) where not visible
    tiles = fourcc("TILE"),        ///< per photo and level: blocks of RGBA8 tiles
    weight_maps =
        fourcc("MASK"),      ///< per photo and level: RGBA8 tiles: angle, depth, border, transient masking
    depth = fourcc("DPTH"),  ///< per photo and level: R32F tiles: linear z, +inf where no surface is visible
};

/// The stages that produce a photo's artifacts; at most `max_stages`.
enum class Stage : std::uint32_t { thumbnail, tiles, weight_maps, coordinates, coverage, samples, count };
inline constexpr std::uint32_t max_stages = 8;  ///< number of stages that a photo's state has

}  // namespace package

/// The levels of a photo's pyramid at which it has chunks of a type.
enum class ChunkLevels { single, tiles, weight_maps };

/// When a scene-wide chunk is written: with the other chunks; after all photos are done; or later still, at
/// the end of the file, because its size is not known earlier.
enum class ChunkWrite { planned, last, appended };

/// A type of chunk, as a row of the chunk table.
struct ChunkRow {
    package::Type type;
    const char* name = nullptr;  ///< name of the content; null for chunks that only describe the package
    package::Stage stage = package::Stage::count;  ///< the stage that makes the chunk for each photo; `count`
                                                   ///< if the chunk is scene-wide
    ChunkLevels levels = ChunkLevels::single;  ///< levels that have such a chunk; unless this is `single`,
                                               ///< the chunk holds tiles
    bool compact = false;                      ///< coded if the effect `compact` is on
    std::uint64_t record = 0;                  ///< bytes per record
    /// Returns the number of records; null if that number does not follow from SCEN and PHOT. For a
    /// scene-wide chunk, the photo record is empty.
    std::uint64_t (*count)(const package::SceneRecord&, const package::PhotoRecord&) = nullptr;
    const char* counted = "";  ///< the number of records in words
    ChunkWrite write = ChunkWrite::planned;

    bool per_photo() const { return stage != package::Stage::count; }
    /// Length of the content in bytes, for the scene or for a photo; `count` must not be null.
    std::uint64_t length(const package::SceneRecord& scene) const;
    std::uint64_t length(const package::SceneRecord& scene, const package::PhotoRecord& photo) const;
};

/// All types, in the order of their chunks in the file.
std::span<const ChunkRow> chunk_table();
const ChunkRow& chunk_row(package::Type type);

/// Whether a photo with `levels` pyramid levels has such a chunk at `level`.
bool has_chunk(const ChunkRow& row, int level, int levels);

struct LeveledChunk {
    const ChunkRow* row;
    std::uint32_t level;
};
/// The chunks of a photo with `levels` pyramid levels, sorted by level, then in the order of the table.
std::vector<LeveledChunk> chunks_of_photo(int levels);

}  // namespace vantage
