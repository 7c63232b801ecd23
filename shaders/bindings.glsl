// What the reference reads: textures and uniforms, as README.md specifies them.
uniform usampler2D patch_plane;  // RG16UI   W x H    idx, (owner.x + 1) | (owner.y + 1) << 2
uniform isampler2D contents;     // RGBA32I  N_t x P  t.x + 65536 t.y, 65536 lambda, a, b
uniform isampler2D centers;      // RGBA32I  P x 1    c.x, c.y, 0, 0
uniform sampler2D base;          // RGBA32F or RGBA16F  W x H
uniform usampler2D masks;        // RGBA16UI W x H    weights of four noises in 1/2048
uniform sampler2D noise_tiles;   // RGBA32F or RGBA16F  3T x K R: the noises, one below the other, and their levels
uniform ivec2 noise_log2;        // log2 of T and R
uniform int noise_step;          // values from a row of texels to the next, odd; 0 without noise
uniform int noise_root;          // 1: added to the square root of light, 0: to light
uniform ivec2 tile_size;         // W, H
uniform uint content_count;      // N_t
uniform uint seed;
uniform int deformed;            // 1 where the structure is deformed; the rest is then read
uniform ivec4 deform_matrix;     // structure from picture: xx, xy, yx, yy in 1/65536
uniform uvec2 deform_from_tile;  // a texel of the picture, within 2^24 texels of those drawn
uniform ivec2 deform_from;
uniform uvec2 deform_to_tile;    // where its center is taken from
uniform ivec4 deform_to;         // texel x, y; 1/65536 texel x, y
uniform ivec2 deform_axis_256;   // what a pixel sees of the structure: the longer axis, in 1/256 texel
uniform ivec2 deform_probes;     // level of detail in 1/256, and log2 of the number of points
uniform ivec2 turbulence;        // amplitude in 1/256 texel, log2 of the cells' side in texels
uniform isampler2D level_table;    // RGBA32I   3 x (L + 1)  blocks.x, blocks.y, corner.x, corner.y; side_256.x, .y, shift.x, .y;
                                   //   level of the noises, 0, 0, 0
uniform usampler2D level_blocks;   // RG32UI    first entry; idx | owner << 16 | entries that follow << 20
uniform usampler2D level_entries;  // RG16UI    4096 x n   idx, owner of each entry
uniform sampler2D base_levels;     // RGBA32F   4096 x n   what each content of each entry shows, times its cover
uniform usampler2D level_weights;  // RGBA16UI  as base_levels: weights of the noises in 1/2048, times the cover
uniform int level_count;           // levels 1 ... level_count are there
uniform int first_level;           // 0 where borders of patches are soft: level_blocks then has level 0; else 1
// One scale: its planes and levels begin at the first row, its patches at the first entry.
const int plane_row = 0;
const int first_patch = 0;
const int level_row = 0;
const int block_row = 0;
const int entry_row = 0;
const int value_row = 0;
