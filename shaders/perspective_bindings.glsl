// What perspective.glsl reads beside bindings.glsl. Directions are right and down in the texture, and towards it.
uniform vec3 view_corner;   // of the ray through the view's upper left corner
uniform vec3 view_right;    // what one pixel to the right adds
uniform vec3 view_down;     // what one pixel down adds
uniform float view_height;  // of the camera above the texture, in texels
uniform int view_filter;    // kFilterNearest ... kFilterAnisotropic
