// What the reference reads: textures and uniforms, as README.md specifies them.
uniform usampler2D patch_plane;  // RG16UI   W x H    idx, (owner.x + 1) | (owner.y + 1) << 2
uniform isampler2D contents;     // RGBA32I  N_t x P  t.x + 65536 t.y, 65536 lambda, a, b
uniform isampler2D centers;      // RGBA32I  P x 1    c.x, c.y, 0, 0
uniform sampler2D base;          // RGBA32F or RGBA16F  W x H
uniform ivec2 tile_size;         // W, H
uniform uint content_count;      // N_t
uniform uint seed;
uniform usampler2D level_blocks;   // RG32UI    W x (H/2 or 3H/2)  first entry; idx | owner << 16 | entries that follow << 20
uniform usampler2D level_entries;  // RG16UI    4096 x n   idx, owner of each entry
uniform sampler2D base_levels;     // RGBA32F   4096 x n   what each content of each entry shows, times its cover
uniform int level_count;           // levels 1 ... level_count are there
uniform int first_level;           // 0 where borders of patches are soft: level_blocks then has level 0; else 1
