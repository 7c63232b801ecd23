// What relief.glsl and stack_relief.glsl read: the relief of the coarsest scale.
uniform sampler2D height_plane;   // RGBA32F  W x H: height; x, y, z of the normal
uniform sampler2D height_levels;  // RGBA32F  4096 x n: their levels, as base_levels
uniform vec4 relief_range;        // greatest height, least height, height of the plane that is drawn, 0
uniform ivec2 relief_steps;       // steps of the linear search, at most, and of the binary one
uniform float relief_depth;       // texels of the coarsest scale between height 0 and 1; 0: flat and unlit
uniform vec4 relief_light;        // light.x / light.z, light.y / light.z, share of light from everywhere, 0
uniform int relief_kind;          // of height_plane: kPlaneReliefOpengl, kPlaneReliefDirectx or kUnlit
int relief_level;                 // at which heights are read
