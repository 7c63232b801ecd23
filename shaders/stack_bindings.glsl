// What a stack of scales reads, in place of bindings.glsl, as README.md specifies it under "Several scales". The planes of the scales
// stand one below the other, their patches, contents and classes one after the other.
uniform usampler2D patch_plane;     // RG16UI
uniform isampler2D contents;        // RGBA32I
uniform sampler2D base;             // RGBA32F or RGBA16F
uniform usampler2D masks;           // RGBA16UI  of the finest scale, as are the next two
uniform sampler2D noise_tiles;      // RGBA32F or RGBA16F
uniform usampler2D level_weights;   // RGBA16UI  of its values of base_levels, with their gains
uniform ivec2 noise_log2;
uniform int noise_root;
uniform int finest_noise_step;      // noise_step of the finest scale; 0 without noise
uniform isampler2D fragment_plane;  // RGBA16I  way to the fragment's center x, y; class of the fragment, of the texel
uniform sampler2D local_mean;       // RGBA32F  where a scale subtracts a local mean
uniform isampler2D scale_table;     // RGBA32I  row 0: centers as in bindings.glsl; then for each scale W, H, plane_row, first_patch;
                                    //          N_t, ratio, first_class, bits; level_row, block_row, entry_row, level_count;
                                    //          value_row, dominant_row, share_row, 256 variationFade; then level_table
uniform sampler2D color_table;      // RGBA32F  rows 0, 1, for each class: dominant color, gain; taking, giving, 0, 0; then for
                                    //          each scale the mean of the dominant part and that of the tile with its gains
uniform usampler2D level_blocks;    // RG32UI   as in bindings.glsl, as are the next two
uniform usampler2D level_entries;   // RG16UI   4096 x n
uniform sampler2D base_levels;      // RGBA32F  4096 x n  of the bases with their gains; of dominant colors; w: taking
uniform isampler2D fragment_shares; // RGBA32I  4096 x n  of each value of a block its first fragment, then the others: center x + 65536 y;
                                    //                  bits of its share times taking; source x + 65536 y; number of the next
uniform int scale_count;            // S
uniform uint stack_seed;
uniform uvec4 nesting[8];           // of each scale a repetition near what is drawn: x, y; where its corner lies in the
uniform ivec2 nesting_offset[8];    // scale before it: the repetition z, w there, and texels of this scale inside it
// Small tables share a texture: with relief there are 16, what every driver has.
#define centers scale_table
#define level_table scale_table
// The scale in use.
ivec2 tile_size;
int plane_row;
int first_patch;
uint content_count;
uint seed;
int noise_step;
int ratio;
int first_class;
int transfer_bits;
int level_row;
int block_row;
int entry_row;
int level_count;
int first_level;
int value_row;
int dominant_row;
int share_row;
// What coarser_color found last.
int kept_scale = -1;
uvec2 kept_tile;
ivec2 kept_p;
vec4 kept_color;
