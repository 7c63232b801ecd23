// Numbers that planes, tables and uniforms hold, by name. C++ includes this text too, in the namespace texbake::glsl; the
// README says what they mean.

// plane_kind: how values change with the content that shows them.
const int kPlanePlain = 0;
const int kPlaneNormalOpengl = 1;   // +y up
const int kPlaneNormalDirectx = 2;  // +y down
const int kPlaneHeight = 3;
const int kPlaneStructure = 4;      // the base, where noise is added to it
const int kPlaneReliefOpengl = 5;   // a height, and a normal with +y up
const int kPlaneReliefDirectx = 6;  // the same, +y down
// relief_kind is one of the last two, or this.
const int kUnlit = 0;

// filter_kind and smooth_filter (the first two), view_filter (all).
const int kFilterNearest = 0;
const int kFilterBilinear = 1;
const int kFilterTrilinear = 2;
const int kFilterAnisotropic = 3;

// Lists of entries, of values and of fragments: 4096 to a row.
const int kListWidth = 4096;
const int kListWidthLog2 = 12;

// A texel of level_blocks, second channel: patch idx, owner from this bit on, number of entries that follow from that bit on.
const uint kBlockOwnerBit = 16u;
const uint kBlockFollowingBit = 20u;

// The bits of scale_table.
const int kTransferMode = 3;  // where the coarser color is read: one of the next three
const int kTransferFragment = 0;
const int kTransferTexel = 1;
const int kTransferBilinear = 2;
const int kLocalMean = 4;            // of a scale's detail, in place of the tile's mean
const int kNoVariation = 8;          // of the scale's own
const int kNoCoarserVariation = 16;  // the coarser scale without its variation
const int kCoarsestLabels = 32;      // classes are read in scale 0 too
const int kSoftBorders = 64;
