// A stack of several scales on WebGL 2, as infinite_texture.js does it for one tile, with relief where it has heights.
// Places count in texels of the finest scale; what a scale, its nesting, its fading and relief are is told in
// shaders/README.md, "Several scales" and "Relief".
'use strict';

class InfiniteStack extends InfiniteTexture {
  constructor(gl, texture, shaders) {
    super(gl, texture, shaders, 'stack_viewer', 'stack_reference');
    this.scales = texture.scales;
    this.finest = this.scales.length - 1;
    this.size = this.scales[this.finest].size;
    // Places of 4096 pixels, in 1/256 texel of the finest scale, fit the shader's 32 bits.
    this.farthest_step_256 = Math.min(this.farthest_step_256 * this.texelsIn(0), 2 ** 20 - 2 ** 10);
  }

  // Texels of the finest scale along one texel of `scale`.
  texelsIn(scale) {
    return this.scales.slice(scale + 1).reduce((texels, finer) => texels * finer.ratio, 1);
  }

  // The scale that shows where a pixel is `step_256` of the finest scale, how far it has faded, its level,
  // and how many of its texels lie along a pixel.
  viewOf(step_256) {
    let texels = step_256 / 256;
    let scale = this.finest;
    while (scale > 0 && texels >= this.scales[scale].ratio) texels /= this.scales[scale--].ratio;
    const {ratio, variation_fade, level_count} = this.scales[scale];
    const fading = scale > 0 && texels > 1 ? Math.log(texels) / Math.log(ratio) : 0;
    const last_level = scale > 0 ? level_count : level_count + 1;
    return {
      scale, fading,
      variation: fading > 0 ? Math.max(0, 1 - variation_fade * fading) : 1,
      step_256, texels,
      level_256: Math.max(0, Math.min(256 * last_level, Math.round(256 * Math.log2(texels)))),
    };
  }

  // Repetitions count from -2^31.
  placeOf(point) {
    return super.placeOf({...point, tile: point.tile.map((tile) => tile | 0)});
  }

  // Beside nearest and bilinear: at the fading and at the level that the point names, and with relief.
  pointViews(point) {
    const alone = {scale: this.finest, fading: 0, variation: 1, level_256: 0, step_256: 1};
    const {fading, variation, level_256, way} = point;
    const views = [['nearest', 0, alone], ['bilinear', 1, alone], ['faded', 1, {...alone, fading, variation}],
                   ['trilinear', 1, {...alone, variation, level_256}]];
    return way ? [...views, ['lit', 1, {...alone, viewer: [-way[0], -way[1], 1]}]] : views;
  }

  windowUniforms(origin, seed, view) {
    const {scales, texture} = this;
    const {scale, level_256, fading, variation} = view;
    return {
      ...texture,
      scale_count: scales.length, stack_seed: seed, finest_noise_step: texture.noise_step,
      ...this.nestingNear(origin),
      ...originUniforms(origin, this.size),
      view_scale: scale, level_256, fading, variation,
      ...this.reliefUniforms(view),
    };
  }

  // Towards a viewer; flat without one.
  reliefUniforms({viewer, step_256}) {
    const {relief} = this.texture;
    if (!relief || !viewer) return {relief_depth: 0};
    const [x, y, z] = viewer;
    const slant = [-x / z, -y / z, step_256 / 256 / this.texelsIn(0)];
    const uniforms = Object.entries(relief).map(([name, value]) => [`relief_${name}`, value]);
    return {slant, ...Object.fromEntries(uniforms)};
  }

  // Of each scale the repetition in which `origin` lies, and where its corner is in the scale before it. Repetitions
  // count from -2^31.
  nestingNear(origin) {
    const tiles = new Uint32Array(4 * 8);
    const offsets = new Int32Array(2 * 8);
    [origin.x, origin.y].forEach((at, axis) => {
      let tile = BigInt.asIntN(32, floorDivided(at, 256n * BigInt(this.size[axis])));
      for (let scale = this.finest; scale > 0; --scale) {
        const corner = tile * BigInt(this.scales[scale].size[axis]);
        const coarse = BigInt(this.scales[scale - 1].size[axis] * this.scales[scale].ratio);
        const outer = floorDivided(corner, coarse);
        tiles[4 * scale + axis] = Number(BigInt.asUintN(32, tile));
        tiles[4 * scale + 2 + axis] = Number(BigInt.asUintN(32, outer));
        offsets[2 * scale + axis] = Number(corner - outer * coarse);
        tile = outer;
      }
    });
    return {nesting: tiles, nesting_offset: offsets};
  }
}

// a / b, rounded down, for BigInt and b > 0.
function floorDivided(a, b) {
  return a >= 0n ? a / b : -((-a + b - 1n) / b);
}
