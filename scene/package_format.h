#pragma once
#include <cstdint>
#include <limits>
#include <type_traits>

/// The bytes of a `.vantage` file, little-endian; FORMAT.md describes them in words.
namespace vantage::package {

inline constexpr char magic[8] = {'V', 'A', 'N', 'T', 'A', 'G', 'E', '\n'};
inline constexpr char part_magic[8] = {'V', 'N', 'T', 'G', 'P', 'A', 'R', 'T'};  ///< of one being prepared
inline constexpr std::uint32_t version = 3;
inline constexpr std::uint64_t alignment = 4096;  ///< of every chunk and every block
constexpr std::uint64_t aligned(std::uint64_t n) { return (n + alignment - 1) / alignment * alignment; }
inline constexpr std::uint32_t scene_wide = 0xffffffffu;

constexpr std::uint32_t fourcc(const char (&s)[5]) {
    return std::uint32_t(std::uint8_t(s[0])) | std::uint32_t(std::uint8_t(s[1])) << 8 |
           std::uint32_t(std::uint8_t(s[2])) << 16 | std::uint32_t(std::uint8_t(s[3])) << 24;
}

enum class Type : std::uint32_t {
    meta = fourcc("META"),          ///< JSON: tool, configuration, effects with evidence, inputs, names
    scene = fourcc("SCEN"),         ///< one SceneRecord
    photos = fourcc("PHOT"),        ///< PhotoRecord[photos]
    states = fourcc("STAT"),        ///< PhotoState[photos]: what each photo's artefacts were made from
    registration = fourcc("REGI"),  ///< RegistrationRecord[photos]: cameras as given, and what was found
    pairs = fourcc("PAIR"),         ///< PairRecord[]: how well photos of one surface fit each other
    positions = fourcc("VPOS"),     ///< float[3][vertices], relative to the origin
    normals = fourcc("VNRM"),       ///< float[3][vertices], unit length
    colors = fourcc("VCOL"),        ///< u8[4][vertices], sRGB and alpha; optional
    scalars = fourcc("VSCL"),       ///< float[vertices] a layer, names in META; optional
    indices = fourcc("INDX"),       ///< u32[3][triangles], ordered by cluster
    clusters = fourcc("CLUS"),      ///< ClusterRecord[clusters]
    thumbnail = fourcc("THMB"),     ///< RGBA8, 512 px on the long side at most
    coverage = fourcc("COVR"),      ///< CoverageRecord[clusters], a photo
    visible = fourcc("VISB"),       ///< u64 words, a photo: a bit a triangle seen whole, then seen in part
    samples = fourcc("SAMP"),       ///< SampleRecord a disc of the surface, a photo
    coordinates = fourcc("TEXC"),   ///< float[2][vertices], a photo; (-1,-1) where not visible
    tiles = fourcc("TILE"),         ///< blocks of RGBA8 tiles, a photo and level
    masks = fourcc("MASK"),         ///< blocks of RGBA8 tiles: angle, depth, border, consensus
    depth = fourcc("DPTH"),         ///< blocks of R32F tiles: linear z, +inf where nothing is seen
};

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t directory_count;
    std::uint64_t directory_offset;
    std::uint64_t file_size;
    std::uint64_t directory_checksum;  ///< XXH3-64 of the directory
    std::uint64_t layout;              ///< XXH3-64 of where photos' chunks lie and what photos are called
    std::uint32_t share, shares;       ///< of the photos, counted from 1, that a part holds; 0, 0: all
    std::uint64_t header_checksum;     ///< XXH3-64 of the bytes before it
};

/// Where a chunk is. A chunk is a head and then blocks of equal length. `checksum` covers the head; for a
/// chunk with blocks the head is the u64 checksum of each block, padded with zeros to the alignment.
struct DirectoryEntry {
    std::uint32_t type;
    std::uint32_t version;
    std::uint32_t photo;  ///< scene_wide where the chunk belongs to no photo
    std::uint32_t level;
    std::uint64_t offset;
    std::uint64_t length;  ///< head and blocks
    std::uint64_t head_length;
    std::uint64_t block_length;  ///< 0 where the chunk has no blocks
    std::uint64_t checksum;      ///< XXH3-64 of the head
    std::uint64_t reserved;
};

struct SceneRecord {
    double origin[3];
    double bounds_min[3], bounds_max[3];  ///< of the input, in its units
    std::uint64_t vertices, triangles, clusters, photos;
    double reference_density;  ///< pixels per unit at which the depth mask is 255
    double border_width;       ///< pixels of a full-size photo at which the border mask is 255
    std::uint64_t effects;     ///< bit i: Effect i is on
    std::uint64_t scalar_layers;
};

enum PhotoFlags : std::uint32_t {
    photo_held_out = 1,
    photo_undistorted = 2,
    photo_has_alpha = 4,
    photo_left_out = 8,    ///< it could not be read: camera only, the reason in its PhotoState
    photo_registered = 16  ///< its pose is not the one given, which stands in REGI
};

struct PhotoRecord {
    char name[192];  ///< UTF-8, zero-terminated: the file name without folders
    std::uint32_t width, height;
    std::uint32_t flags;
    std::uint32_t levels;  ///< of the tile pyramid; 0 for a photo held or left out
    std::uint32_t thumbnail_width, thumbnail_height;
    std::uint32_t mask_width, mask_height;  ///< at pyramid level `mask_level`
    double fx, fy, cx, cy;
    double R[9];                    ///< row by row, cam_from_world
    double t[3];                    ///< for positions relative to the origin
    double corrected_direction[3];  ///< unit, world; [P] 2.3.3
    double hull_area;               ///< of the projected vertices' convex hull, over the photo's area, [0,1]
    double seen_distance;           ///< median linear depth of what the photo sees; 0 where it sees nothing
    double z_min, z_max;            ///< range of the depth map; 0, 0 where it sees nothing
    double visible_vertices;        ///< share of vertices this photo sees, [0,1]
    double gain[3];                 ///< times which its colours are those of the mean photo, linear light
    std::uint64_t source_bytes, source_checksum;  ///< length and XXH3-64 of the photo's file
    float falloff[3];  ///< ln of what the lens loses at r: f0 r^2 + f1 r^4 + f2 r^6; see SampleRecord
    std::uint32_t reserved;
};

/// The stages that a photo goes through.
enum class Stage : std::uint32_t { thumbnail, tiles, masks, coordinates, coverage, samples, count };

/// What a photo's artefacts were made from, so that a later run knows which it may keep.
struct PhotoState {
    struct Made {
        std::uint64_t key;      ///< of all that went in: inputs, settings, the stage's version; 0: not made
        std::uint64_t content;  ///< XXH3-64 of the checksums of the stage's chunks
    };
    Made stages[std::size_t(Stage::count)];
    std::uint64_t photo, camera, model;  ///< XXH3-64 of these inputs, to say which of them has changed
    std::uint64_t pose;                  ///< XXH3-64 of the pose that the model was looked at from
    std::uint64_t consensus;             ///< XXH3-64 of the weights in the masks; 0 where all are 255
    char left_out[192];                  ///< why the photo could not be read; else empty
    std::uint64_t record;                ///< XXH3-64 of the photo's PhotoRecord
    std::uint64_t checksum;              ///< XXH3-64 of the bytes before
};

struct ClusterRecord {
    float center[3], radius;          ///< bounding sphere, relative to the origin
    float cone_axis[3], cone_cutoff;  ///< meshoptimizer's normal cone; cutoff 1 = no culling
    std::uint32_t first_triangle, triangles;
};

/// What one photo sees of one cluster. Rectangle in texture coordinates, unorm16; density in log2.
struct CoverageRecord {
    std::uint16_t seen;            ///< share of the cluster's triangles seen at least in part, unorm16
    std::uint16_t u0, v0, u1, v1;  ///< where its pixels lie, and all that a filter may mix with them
    std::int16_t log2_density;     ///< log2(pixels per unit at the centre) * 256
};

/// The mean colour of a disc of the surface in a photo, linear light, unorm16; all 0 where the photo does not
/// show it well. Radius: from the principal point, over half the photo's diagonal, unorm16.
struct SampleRecord {
    std::uint16_t linear[3];
    std::uint16_t radius;
};

/// How registration left a photo.
struct RegistrationRecord {
    double R[9], t[3];     ///< the pose as given, like PhotoRecord's
    double by;             ///< pixels by which what the photo shows has moved, median; 0 where it was left
    double before, after;  ///< how far its corners lie from where other photos show them, median px
    std::uint64_t key;     ///< XXH3-64 of all that went in, the same for all photos
};

/// Pairs that are measured and stored per photo, at most.
inline constexpr std::uint64_t stored_pairs_per_photo = 2;
/// Cells of a pair's displacement map.
inline constexpr int pair_columns = 12, pair_rows = 8;

/// How far two photos that see the same surface disagree, matched through the model with the cameras as
/// given. Pixels are full-size ones of photo `a`.
struct PairRecord {
    std::uint32_t a, b;              ///< a < b; both 0: no pair
    std::uint32_t shared;            ///< discs that both show
    std::uint32_t corners, matches;  ///< that could be compared, and that were found again
    float angle;                     ///< between their directions to that surface, radians, median
    float color;                     ///< median |ln ratio| of the discs' linear light, mean of the channels
    float median, p90;               ///< px by which matches lie from where the cameras expect them
    float shift[2];                  ///< median a coordinate: what all matches have in common
    std::uint32_t reserved;
    std::uint64_t key;  ///< XXH3-64 of all that went in
    struct Cell {
        std::int16_t moved[2];  ///< median displacement in this part of photo `a`, 1/64 px
        std::uint16_t matches;
    } cells[pair_columns * pair_rows];
};

/// Words of one of VISB's two bit sets.
inline constexpr std::uint64_t visible_words(std::uint64_t triangles) { return (triangles + 63) / 64; }

static_assert(sizeof(Header) == 64 && sizeof(DirectoryEntry) == 64 && sizeof(ClusterRecord) == 40);
static_assert(sizeof(PhotoState) == 344 && std::is_trivially_copyable_v<PhotoState>);
static_assert(sizeof(CoverageRecord) == 12 && sizeof(SampleRecord) == 8 && sizeof(SceneRecord) == 136 &&
              sizeof(PhotoRecord) % 8 == 0);
static_assert(sizeof(RegistrationRecord) == 128 && sizeof(PairRecord) == 56 + 6 * pair_columns * pair_rows);
static_assert(std::is_trivially_copyable_v<PhotoRecord> && std::numeric_limits<float>::is_iec559);

}  // namespace vantage::package
