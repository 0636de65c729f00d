// Definitions that C++ code and shaders share. The definitions are valid as GLSL and as C++
// (shaders/contract.h includes this file). The file contains only constants and structs whose layouts in
// blocks and buffers are the same in C++.

// Attributes of the model.
const int position_attribute = 0;
const int normal_attribute = 1;
const int color_attribute = 2;
const int draw_attribute = 3;  // per draw: first triangle; one bit per photo of the pass to draw
const int value_attribute = 4;  // value of the displayed scalar field; then 1, or 0 for a vertex without a value
const int cell_attribute = 0;  // per point: cell in the node's cube, 21 bits per axis
const int cube_attribute = 5;  // per draw: low corner and size of the node's cube
const int node_attribute = 6;  // per draw: index among the drawn nodes
const int texture_attribute = 1;  // per panel vertex: texture coordinates; position and color are as above
const int points_attribute = 0;   // per mark: four positions
const int sizes_attribute = 4;
const int colors_attribute = 5;   // per mark: two colors
const int kind_attribute = 7;
const int layer_attribute = 8;
const uint background_bit = 0x80000000u;  // in addition to the photos' bits: draws the background

// Uniform block.
const int photos_block = 0;

// Shader storage buffers.
const int pages_buffer = 1;
const int fragment_heads_buffer = 2;
const int fragments_buffer = 3;
const int coordinates_buffer = 4;
const int touched_buffer = 5;
const int point_sizes_buffer = 6;
// The model, which is read pixel by pixel: three vertices per triangle; positions and normals of three floats
// each; colors of four bytes each; the cluster of each triangle; and the photo bits of each cluster.
const int indices_buffer = 7;
const int positions_buffer = 8;
const int normals_buffer = 9;
const int colors_buffer = 10;
const int triangle_clusters_buffer = 11;
const int cluster_photos_buffer = 12;
const int blend_buffers = 8;  // maximum number that a blending program reads

// Texture units. Units 0 to 3 hold the photos; 4 and 5 hold the other inputs of a program.
const int color_tiles_unit = 0;
const int weight_tiles_unit = 1;
const int depth_tiles_unit = 2;
const int best_so_far_unit = 4;  // blend
const int first_sums_unit = 5;
const int color_map_unit = 4;  // surface
const int shadows_unit = 5;
const int sums_unit = 4;  // resolve
const int surface_unit = 5;
const int before_unit = 6;
const int points_unit = 7;
const int depth_unit = 8;
const int transparent_sums_unit = 12;
const int transmitted_unit = 13;
const int wire_unit = 14;
const int places_unit = 6;  // blend, for point clouds or surfaces behind them
const int triangles_unit = 7;  // blend
const int accumulated_unit = 4;  // show
const int filled_unit = 5;
const int other_unit = 6;
const int veil_unit = 7;
const int filled_behind_unit = 8;
const int shown_surface_unit = 9;
const int object_colors_unit = 4;  // compose
const int object_depths_unit = 5;
const int finer_unit = 4;  // average_holes, with surface_unit
const int finer_behind_unit = 6;
const int coarser_unit = 4;  // fill_holes
const int coarser_behind_unit = 5;
const int small_unit = 4;    // enlarge
const int eyes_unit = 4;     // stereo
const int faces_unit = 4;    // panorama
const int field_unit = 4;    // panel
const int letters_unit = 5;
const int shown_picture_unit = 6;  // panel, mark; depth_unit has the depth that hides them

// Uniforms of surface and blend.
const int clip_from_origin_uniform = 0;
const int vertex_count_uniform = 1;
const int pass_count_uniform = 2;
const int eye_uniform = 3;
const int view_direction_uniform = 4;
const int switches_uniform = 5;
const int border_width_uniform = 6;
const int sharpness_uniform = 7;
const int lod_bias_uniform = 8;
const int blend_show_uniform = 9;
const int first_layers_uniform = 10;
const int weight_eye_uniform = 11;
const int background_triangles_uniform = 12;
const int near_distance_uniform = 14;
const int nearest_bits_uniform = 15;
const int label_bits_uniform = 32;  // an array
const int background_distance_uniform = 13;
const int viewer_away_uniform = 31;
const int field_scale_uniform = 14;
const int isolines_uniform = 15;
// Uniforms of surface: the kind of light, and arrays of EYES elements.
const int light_uniform = 3;
const int clip_from_eye_uniform = 5;
const int surface_eye_uniform = 7;
const int lamp_uniform = 9;
const int camera_rows_uniform = 11;
const int shadows_from_origin_uniform = 16;
const int shadow_width_uniform = 17;
const int pass_slots_uniform = 16;  // an array, PASS_PHOTOS long
const int nearness_uniform = 24;    // surface, for transparent surfaces
const int frame_width_uniform = 25;
const int capacity_uniform = 26;
const int own_field_share_uniform = 27;
const int own_light_on_photos_uniform = 28;
const int own_light_scale_uniform = 29;
const int section_planes_uniform = 30;  // surface, an array, SECTION long
const int frame_uniform = 1;  // blend, for point clouds
const int frame_axes_uniform = 14;

// The size of the frame (in pixels) or level (in texels) that blend, resolve, show, average_holes,
// fill_holes, compose, enlarge, stereo and panorama read. The texture may be larger than this.
const int frame_size_uniform = 29;
// For blend, background, resolve, show and average_holes: samples per side of a pixel. Each sample has a
// texel in surface and sums.
const int fine_uniform = 22;

// Uniforms of resolve.
const int takes_one_uniform = 0;
const int fill_uniform = 1;
const int plain_background_uniform = 2;
const int max_uniform = 3;
const int exposure_uniform = 4;
const int vignetting_uniform = 5;
const int lens_uniform = 6;
const int progress_uniform = 7;
const int background_light_uniform = 8;
const int hole_weight_uniform = 9;
const int plain_background_weight_uniform = 10;
const int field_share_uniform = 11;
const int light_on_photos_uniform = 12;
const int light_scale_uniform = 13;
const int shows_points_uniform = 14;
const int eye_dome_uniform = 15;
const int points_alone_uniform = 16;
const int photos_on_points_uniform = 17;
const int shows_transparent_uniform = 24;
const int veils_holes_uniform = 25;

const int fill_background_uniform = 26;
const int plain_background_bottom_uniform = 27;

// Uniforms of object_depth and of compose, for several objects in one picture. The last two constants are the
// distances given to the background and to pixels without a surface.
const int depth_terms_uniform = 0;
const int objects_uniform = 0;
const int nearest_shown_uniform = 1;  // nearest_object
const int compose_flip_uniform = 1;
const int compose_fill_uniform = 2;
const int compose_plain_background_uniform = 3;
const int compose_opacity_uniform = 4;  // one per object, in the order of the layers
const int compose_plain_background_bottom_uniform = 20;
const int compose_soft_edges_uniform = 21;
const float background_away = 1e30f;
const float nothing_away = 2e30f;

// Uniforms of point, in addition to clip_from_origin_uniform.
const int point_size_uniform = 1;
const int depth_per_w_uniform = 2;
const int nearer_uniform = 3;

// The number of the point at a pixel is 1 + the point's index in its node + points_per_node times the index
// of the node among the drawn nodes; 0 means no point.
const uint points_per_node = 16384u;

// Uniforms of show.
const int samples_uniform = 0;
const int flip_uniform = 1;
const int compare_uniform = 2;
const int swipe_uniform = 3;
const int photo_from_frame_uniform = 4;
const int lod_uniform = 5;
const int fills_uniform = 6;
const int image_sets_uniform = 7;
const int image_set_share_uniform = 8;
const int other_fills_uniform = 9;
const int veils_uniform = 24;
const int soft_edges_uniform = 25;
const int show_plain_background_uniform = 26;
const int show_plain_background_bottom_uniform = 27;
const int edges_opaque_uniform = 28;

// Uniform of enlarge.
const int enlarged_size_uniform = 0;

// Uniforms of panorama.
const int face_focal_uniform = 0;
const int face_overlap_uniform = 1;
const int face_half_uniform = 8;
const int face_count_uniform = 9;
const int first_face_uniform = 10;
const int face_from_panorama_uniform = 2;  // an array
const int max_faces = 6;

// Uniforms of stereo, and the values of its mode.
const int stereo_mode_uniform = 0;
const int stereo_flip_uniform = 1;
const uint stereo_side_by_side = 1u;
const uint stereo_over_under = 2u;
const uint stereo_anaglyph = 3u;
const uint stereo_checkerboard = 4u;

// Uniforms of vignette.
const int vignette_lens_uniform = 0;
const int vignette_uniform = 1;

// Uniforms of panel and mark, in addition to clip_from_origin_uniform. Behind the model, panels and marks
// keep `share_behind` of their opacity. The model hides an overlay only if it is nearer by the fraction
// `hiding_slack` of the distance, because marks lie on surfaces.
const int hides_uniform = 1;
const int hiding_terms_uniform = 2;
const int hiding_scale_uniform = 3;
const int hiding_rows_uniform = 4;
const int clip_rectangle_uniform = 5;  // panel
const int panel_fill_uniform = 6;
const int spread_uniform = 7;
const int half_frame_uniform = 5;  // mark
const int mark_focal_uniform = 6;
const int mark_eye_uniform = 7;
const int nearest_uniform = 8;
const int picture_decodes_uniform = 9;
const float share_behind = 0.25f;
const float hiding_slack = 0.005f;
// Fill of a panel's triangles.
const uint fill_letters = 0u;
const uint fill_picture = 1u;
// Kinds of marks.
const uint mark_line = 0u;
const uint mark_ring = 1u;
const uint mark_ball = 2u;
const uint mark_picture = 3u;

// Uniforms of average_holes.
const int average_samples_uniform = 0;

// Uniforms and outputs of photo_geometry.
const int clip_from_model_uniform = 0;
const int cam_from_world_uniform = 1;
const int focal_center_uniform = 2;
const int linear_z_output = 0;
const int angle_output = 1;
const int triangle_output = 2;

// Uniform, image units and work group of jump_flood.
const int stride_uniform = 0;
const int known_seeds_image = 0;
const int improved_seeds_image = 1;
const int flood_group_texels = 16;  // per side

// Bits of the uniform `switches`.
const uint angle_weight_switch = 1u;
const uint depth_weight_switch = 2u;
const uint border_weight_switch = 4u;
const uint angle_switch = 8u;
const uint transient_weight_switch = 16u;

// Kinds of surface, stored in the alpha channel of the bare surface; 1 means the mesh.
const float shows_background = 2.0f;
const float shows_value = 3.0f;
const float shows_light = 4.0f;

// Light on the geometry.
const uint light_lamp = 1u;    // at the viewer
const uint light_raking = 2u;  // from a direction
const uint light_normals = 3u;
const float light_ambient = 0.08f;
const float light_diffuse = 0.8f;
const float light_specular = 0.12f;
const float light_in_shadow = 0.3f;  // fraction of the raking light that remains, so that relief shows there too
const float light_gray = 0.3f;  // brightness of a surface that faces the viewer, in linear light

// Transparent surfaces.
const int max_sorted_fragments = 64;  // per sample; fragments behind them are approximated
const float bare_gray = 0.47f;         // brightness of a bare white surface that faces the viewer

// Display modes: the photos' colors, one false color per photo, or the number of photos that see each point.
const uint show_colors = 0u;
const uint show_sources = 1u;
const uint show_coverage = 2u;

// Comparison with a photo.
const uint compare_nothing = 0u;
const uint compare_side_by_side = 1u;
const uint compare_swipe = 2u;
const uint compare_difference = 3u;

// Comparison of two image sets.
const uint image_sets_one = 0u;
const uint image_sets_mixed = 1u;
const uint image_sets_side_by_side = 2u;
const uint image_sets_swipe = 3u;

// Sizes in tiles: texels per side, including a border on each side that repeats the neighbors.
const int tile_texels = 256;
const int tile_border_texels = 4;
const int tile_content_texels = 248;
const int first_weight_level = 1;  // weight maps and depth have no finer level
const int lens_cells = 64;       // cells of a lens table, per side

// Constants of the lumigraph's weight (docs/method.md), which shaders/blend.frag and pipeline/refine compute.
const float default_sharpness = 0.07f;  // radians: the angle between rays at which the weight is 1/e
// Lengths of ramps, in reference pixels. Reference pixels are the pixels of a photo that is scaled to this
// width.
const float reference_width = 3072.0f;
const float frame_ramp = 16.0f;  // from the photo's frame inward, to avoid a seam
const float frame_least = 0.001f;
const float edge_ramp = 24.0f;  // from the nearest depth discontinuity, where pose and mesh errors show most
const float edge_least = 0.2f;  // at a discontinuity itself: other photos may not see the surface at all
// Within about this angle of a photo's own camera, in radians, the picture becomes that photo (the epipole
// consistency of Buehler et al. 2001). Ramps and weight maps that prefer other photos must not apply there.
const float own_angle = 0.01f;
const float own_least = 0.00001f;  // lower limit on the angle; bounds the factor at 10^6
// Photos are gradually treated as overexposed where all channels are at least this bright, in linear light,
// because exposure correction must not turn white into gray.
const float overexposed = 0.9f;
// A photo sees a surface that lies behind its depth map by less than this fraction of the depth, or by less
// than the depth changes over one texel of the map along a surface slanted by at most 84 degrees. If only
// some of the four depths around the pixel satisfy this, the photo's pixel may show a nearer surface instead.
const float depth_slack = 0.004f;
const float least_cosine = 0.1f;
const float beside = 0.03f;  // the weight in that case

// The background's colors are taken only from pixels that certainly show it.
const float background_margin = 8.0f;    // reference pixels per depth texel that must not show the mesh
const float background_least = 0.001f;   // the weight next to the mesh, whose silhouette is inexact
// The photo with which a direction is labeled outweighs the photos nearest to the viewer by this factor, but
// less so as the angle between the rays at the background grows. Near objects are shown by photos taken near
// the viewer, while distant ones never depend on the viewer.
const float label_weight = 2.0f;
const float background_sharpness = 0.1f;  // radians: the angle at which a weight is 1/e
const float near_reach = 4.0f;  // labels decide beyond this times the cameras' spread
const int nearest_photos = 3;
const int background_labels = 32;    // 0: none
const int hidden_background = 7;     // label and trust of hidden vertices, which no photo colors
const float mesh_behind = 1.0f / 64.0f;  // weight of the mesh's colors for holes of the background
const float near_ramp = 0.1f;   // fraction of a photo's width over which the nearest photos fade in from their frame
const float negligible = 0.3f;  // photos below this fraction of the best photo's weight are not shown
// The background fades to its mean color as the viewer moves away from all cameras. The fade starts and ends
// at these distances from the nearest camera, multiplied by the trust, in units of the distance at which
// angles are measured.
const float calm_from = 0.5f, calm_to = 1.0f;
// Beyond this multiple of the distance at which angles are measured, the background is sky. This distance is
// a third of that of the sky's vertices, so that triangles between a hill and the sky have the sky's mean
// color where they show sky.
const float sky_distance = 700.0f;
const float sky_spread = 0.15f;     // square root of light: half the weight at this distance from the mean color

const uint not_resident = 0xffffffffu;  // instead of a page entry
const int level_count = 12;             // maximum number of pyramid levels; a multiple of 4
const int pass_photos = 16;             // maximum number of photos in a pass
const int levels_of_base = 2;           // displayed photos always have the finest of this many coarsest levels

// One photo of a pass.
struct Photo {
    mat4 cam_from_origin;
    vec4 focal_center;        // fx fy cx cy, pixels
    vec4 size_weight;         // width, height, number of levels, dynamic weight for this view
    vec4 center_hull;         // camera center relative to the origin; fraction of the photo that the model fills
    vec4 direction;           // corrected viewing direction [P]; index of the lens table in `pages`, or -1
    vec4 false_color;         // linear; background label, 0: none
    vec4 gain;                // factors that convert to the mean photo's exposure, linear light; 2 / diagonal, 1/pixels
    vec4 vignetting;             // ln of the lens's loss, times r^2, r^4, r^6; square of its range (scene/package/contents/lens_table.h)
    uvec4 color_base[level_count / 4];  // index of each level's first tile in `pages`, four levels per vector
    uvec4 weight_base[level_count / 4];
};

// A drawn node of a point cloud: the children that are drawn (bit i stands for octant i), the index of the
// first of these among the drawn nodes, the spacing of the node's points, and the index of its first vertex.
struct PointSizes {
    uint children;
    uint first;
    float spacing;
    uint vertex;
};

// A fragment of a transparent surface: the number of the next fragment at its pixel, from 1 (0: none); its
// triangle; its depth; and its color in linear light, as half floats, with alpha times 65535 in the upper
// half of `blue_alpha`.
struct TransparentFragment {
    uint next;
    uint triangle;
    float depth;
    uint red_green;
    uint blue_alpha;
};
