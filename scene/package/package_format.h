#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "scene/package/chunk_table.h"

/// The layout of a `.vantage` file, little-endian; FORMAT.md describes it in full.
namespace vantage::package {

inline constexpr char magic[8] = {'V', 'A', 'N', 'T', 'A', 'G', 'E', '\n'};
inline constexpr char part_magic[8] = {'V', 'N', 'T', 'G', 'P', 'A', 'R', 'T'};  ///< during preparation
inline constexpr std::uint32_t version = 8;
inline constexpr std::uint64_t alignment = 4096;  ///< alignment of raw chunks and their blocks, in bytes
constexpr std::uint64_t aligned(std::uint64_t n) { return (n + alignment - 1) / alignment * alignment; }
inline constexpr std::uint64_t coded_alignment = 8;  ///< alignment of all other chunks, in bytes
inline constexpr std::uint32_t scene_wide = 0xffffffffu;

/// The storage form of a chunk's content; codec/ implements the forms of tiles.
enum class Form : std::uint32_t {
    raw,     ///< uncompressed
    zstd,    ///< for chunks without blocks: u64 length of the content, then a zstd frame
    jpeg,    ///< tiles of color, each a JPEG without the header, which all tiles share
    cells,   ///< a level of color: the photo's original JPEG, divided into cells
    planes,  ///< tiles with four bytes per texel, lossless
    depth    ///< tiles of rounded depth
};

/// The maximum ratio of the content's length to the length of a zstd chunk. This limit prevents a small file
/// from claiming much memory. A chunk may be padded with zeros to stay within it.
inline constexpr std::uint64_t max_expansion = 32;
/// Bytes per block in the head of a coded chunk, for the block's checksum and end.
inline constexpr std::uint64_t coded_block_entry = 16;

struct Header {
    char magic[8];
    std::uint32_t version;
    std::uint32_t directory_count;
    std::uint64_t directory_offset;
    std::uint64_t file_size;
    std::uint64_t directory_checksum;  ///< XXH3-64 of the directory
    std::uint64_t layout;              ///< XXH3-64 of the photos' names and the positions of their chunks
    std::uint32_t share, shares;       ///< shard number, from 1, and number of shards; 0 and 0: not a shard
    std::uint64_t header_checksum;     ///< XXH3-64 of the preceding bytes
};

/// The location of a chunk, which is a head followed by blocks. `checksum` covers the head. In a raw chunk,
/// blocks have equal length, and the head holds a u64 checksum for each block, padded with zeros to the
/// alignment. In a coded chunk, the head holds the u64 checksums, then the u64 end of each block, measured
/// from the end of the head, and then data shared by all blocks.
struct DirectoryEntry {
    std::uint32_t type;
    std::uint32_t version;
    std::uint32_t photo;  ///< scene_wide if the chunk belongs to no photo
    std::uint32_t level;
    std::uint64_t offset;
    std::uint64_t length;  ///< head and blocks
    std::uint64_t head_length;
    std::uint64_t block_length;  ///< for raw chunks; 0 if there are no blocks
    std::uint64_t checksum;      ///< XXH3-64 of the head
    Form form;
    std::uint32_t coded_blocks;  ///< number of blocks if the form is not raw
};

struct SceneRecord {
    double origin[3];
    double bounds_min[3],
        bounds_max[3];  ///< bounds of the input without strays (base/values/main_box.h), in input units
    std::uint64_t vertices, triangles, clusters, photos;
    double reference_density;  ///< pixels per unit at which the depth weight is 255
    double border_width;    ///< distance at which the border weight is 255, in pixels of a photo 3072 px wide
    std::uint64_t effects;  ///< bit i: Effect i is on
    std::uint64_t scalar_fields;
    double up[3]{0, 0, 1};  ///< unit vector
    double shade[3]{};      ///< linear light of the background in the median photo; 0, 0, 0: unknown
    /// The player's first view, from the position of a photo toward a target, whose coordinates are relative
    /// to the origin. If `first_photo` is not the number of a photo, the view shows the whole model.
    std::uint64_t first_photo = ~0ull;
    double first_target[3]{};
    double first_fov = 45;    ///< vertical angle that must fit into the frame, degrees
    double first_aspect = 1;  ///< aspect ratio of the content that must fit into the frame
};

enum PhotoFlags : std::uint32_t {
    photo_held_out = 1,
    photo_has_alpha = 4,
    photo_skipped = 8,     ///< unreadable: only the camera is stored; PhotoState has the reason
    photo_registered = 16  ///< the photo's pose was refined; REGI holds the input pose
};

struct PhotoRecord {
    char name[192];  ///< the file name without folders: UTF-8, zero-terminated
    std::uint32_t width, height;
    std::uint32_t flags;
    std::uint32_t levels;  ///< levels of the tile pyramid; 0 if the photo is held out or skipped
    std::uint32_t thumbnail_width, thumbnail_height;
    std::uint32_t weight_map_width, weight_map_height;  ///< at pyramid level `weight_map_level`
    double fx, fy, cx, cy;
    double R[9];                    ///< row-major, cam_from_world
    double t[3];                    ///< for positions relative to the origin
    double corrected_direction[3];  ///< unit vector in world space; [P] 2.3.3
    double hull_area;  ///< area of the visible vertices' convex hull as a fraction of the photo's area, [0,1]
    double seen_distance;     ///< median linear depth of the visible surface; 0 if the photo sees none
    double z_min, z_max;      ///< range of the depth map; 0 and 0 if the photo sees no surface
    double visible_vertices;  ///< fraction of the vertices that this photo sees, [0,1]
    double gain[3];           ///< factors that match the photo's linear light to the mean photo's
    std::uint64_t source_bytes, source_checksum;  ///< length and XXH3-64 of the photo's file
    float vignetting[3];      ///< loss at radius r (see SampleRecord): -ln(light) = f0 r^2 + f1 r^4 + f2 r^6
    std::uint32_t image_set;  ///< number of the photo's image set in BAND; 0 if there is no BAND
};

/// Identifies the inputs of a photo's artifacts, so that a later run can decide which artifacts to keep.
struct PhotoState {
    struct Made {
        std::uint64_t key;      ///< hash of settings, version, and inputs except the pose; 0: not made
        std::uint64_t content;  ///< XXH3-64 of the checksums of the stage's chunks
    };
    Made stages[max_stages];             ///< indexed by Stage; 0 for unused entries
    std::uint64_t photo, camera, model;  ///< XXH3-64 of these inputs, to report which one changed
    std::uint64_t pose;                  ///< XXH3-64 of the pose used for visibility
    std::uint64_t transients;            ///< XXH3-64 of the transient weights; 0 if all are 255
    char skipped[192];                   ///< the reason why the photo could not be read, or empty
    std::uint64_t record;                ///< XXH3-64 of the photo's PhotoRecord
    std::uint64_t checksum;              ///< XXH3-64 of the preceding bytes
};

struct ClusterRecord {
    float center[3], radius;          ///< bounding sphere, relative to the origin
    float cone_axis[3], cone_cutoff;  ///< meshoptimizer's normal cone; a cutoff of 1 means no culling
    std::uint32_t first_triangle, triangles;
};

/// The head of SURR; see scene/package/contents/background.h for the rest.
struct BackgroundRecord {
    std::uint64_t vertices, triangles, clusters, photos;
    std::uint64_t hidden;  ///< triangles of the mesh
};

/// A point of a cloud. Its coordinates x, y and z follow one another from the lowest bit. They are in units
/// of 1/2^21 of the side of the node's cube, and are rounded down to a cell, whose center represents the
/// point. `color` is sRGB, followed by 255.
struct PackedPoint {
    std::uint32_t low, high;
    std::uint8_t color[4];
};
inline constexpr std::uint32_t point_block = 32768;  ///< points per block of PNTS
inline constexpr std::uint32_t point_node = 16384;   ///< maximum number of points per node

/// A node of the octree over a point cloud: its cube and the points that it adds to those of its ancestors.
/// All of these points are about `spacing` apart; the node's descendants add the points between them. Nodes
/// are stored in breadth-first order.
struct PointNode {
    float low[3], size;                 ///< lowest corner and side of the cube, relative to the origin
    float spacing;                      ///< in input units
    std::uint32_t block, first, count;  ///< its points: block, index of the first one in the block, count
    std::uint32_t children;             ///< index of the node's first child; the other children follow
    std::uint8_t child_octants;         ///< bit i: there is a child in octant i = x + 2 y + 4 z
    std::uint8_t reserved[3];
};

/// A set of photos that is shown separately, such as infrared photos, or photos taken before a restoration.
struct ImageSetRecord {
    char name[56];          ///< UTF-8, zero-terminated
    std::uint64_t effects;  ///< bit i: Effect i is on for these photos
};
inline constexpr std::size_t max_image_sets = 64;

/// A photo's lens, as in scene/camera/lens.h.
struct LensRecord {
    std::uint32_t model;  ///< LensModel
    std::uint32_t reserved;
    double p[12];
};

/// The visibility of one cluster in one photo.
struct CoverageRecord {
    std::uint16_t seen;  ///< fraction of the cluster's triangles that are at least partly visible, unorm16
    std::uint16_t u0, v0, u1, v1;  ///< bounds of its texture coordinates with a margin for filtering, unorm16
    std::int16_t log2_density;     ///< log2(pixels per unit at the cluster's center) * 256
};

/// The number of discs on each model's surface. Photos are compared within these discs.
inline constexpr std::size_t surface_discs = 8192;

/// The mean color of a disc of the surface in a photo, in linear light, as unorm16; all 0 if the disc is not
/// clearly visible. `radius` is the disc's distance from the principal point, divided by half the photo's
/// diagonal, as unorm16.
struct SampleRecord {
    std::uint16_t linear[3];
    std::uint16_t radius;
};

/// The result of pose refinement for a photo.
struct PoseRefinementRecord {
    double R[9], t[3];     ///< the input pose, in the form of PhotoRecord
    double motion_px;      ///< median displacement of the photo's content in px; 0 if the pose is unchanged
    double before, after;  ///< median residual, in px, of corners that were held out of the fit
    std::uint64_t key;     ///< XXH3-64 of all inputs, the same for all photos
};

/// The pose of a refined camera, fitted as if another photo were not in the scene.
struct LeaveOneOutPoseRecord {
    std::uint32_t without;  ///< the photo held out of the fit
    std::uint32_t photo;    ///< the photo whose pose this is
    double R[9], t[3];      ///< in the form of PhotoRecord
};
/// Maximum number of leave-one-out poses stored per held-out photo.
inline constexpr std::size_t poses_without_photo = 24;

/// Maximum number of pairs measured and stored per photo.
inline constexpr std::uint64_t stored_pairs_per_photo = 2;
/// The size of a pair's displacement map, in cells.
inline constexpr int pair_columns = 12, pair_rows = 8;

/// The disagreement between two overlapping photos, which are matched through the model with the input
/// cameras. Pixels are those of photo `a` at full size.
struct PairRecord {
    std::uint32_t a, b;              ///< a < b; 0 and 0 if there is no pair
    std::uint32_t shared;            ///< number of discs seen by both photos
    std::uint32_t corners, matches;  ///< number of comparable corners in `a`, and of those found in `b`
    float angle;        ///< median angle between the two cameras' directions to that surface, radians
    float color;        ///< median |ln ratio| of the discs' linear light, mean of the channels
    float median, p90;  ///< distance of the matches from their predicted positions, px
    float shift[2];     ///< median displacement to the right and down, px
    std::uint32_t reserved;
    std::uint64_t key;  ///< XXH3-64 of all inputs
    struct Cell {
        std::int16_t moved[2];  ///< median displacement in this part of photo `a`, in 1/64 px
        std::uint16_t matches;
    } cells[pair_columns * pair_rows];
};

/// The number of words in each of VISB's two bit sets.
inline constexpr std::uint64_t visible_words(std::uint64_t triangles) { return (triangles + 63) / 64; }

static_assert(sizeof(Header) == 64 && sizeof(DirectoryEntry) == 64 && sizeof(ClusterRecord) == 40);
static_assert(sizeof(PointNode) == 40 && sizeof(PackedPoint) == 12 &&
              point_block * sizeof(PackedPoint) % alignment == 0);
static_assert(sizeof(PhotoState) == 376 && std::is_trivially_copyable_v<PhotoState>);
static_assert(sizeof(ImageSetRecord) == 64 && sizeof(LensRecord) == 104);
static_assert(sizeof(CoverageRecord) == 12 && sizeof(SampleRecord) == 8 && sizeof(SceneRecord) == 232 &&
              sizeof(PhotoRecord) % 8 == 0);
static_assert(sizeof(PoseRefinementRecord) == 128 && sizeof(LeaveOneOutPoseRecord) == 104 &&
              sizeof(PairRecord) == 56 + 6 * pair_columns * pair_rows);
static_assert(std::is_trivially_copyable_v<PhotoRecord> && std::numeric_limits<float>::is_iec559);

}  // namespace vantage::package
