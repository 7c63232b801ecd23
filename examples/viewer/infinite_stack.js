// A stack of several scales on WebGL 2, as infinite_texture.js does it for one tile. Places count in texels of the finest
// scale; what a scale, its nesting and its fading are is told in shaders/README.md, "Several scales".
'use strict';

class InfiniteStack extends InfiniteTexture {
  constructor(gl, texture, shaders) {
    super(gl, texture, shaders, 'stack_viewer', 'stack_reference');
    this.scales = texture.scales;
    this.finest = this.scales.length - 1;
    this.size = this.scales[this.finest].size;
    this.farthest_step_256 *= this.texelsIn(0);
  }

  // Texels of the finest scale along one texel of `scale`.
  texelsIn(scale) {
    return this.scales.slice(scale + 1).reduce((texels, finer) => texels * finer.ratio, 1);
  }

  // The scale that shows where a pixel is `step_256` of the finest scale, how far it has faded, and its step and level.
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
      step_256: Math.max(1, Math.round(step_256 / this.texelsIn(scale))),
      level_256: Math.max(0, Math.min(256 * last_level, Math.round(256 * Math.log2(texels)))),
    };
  }

  draw({origin, step_256, seed, show}) {
    const gl = this.gl;
    const view = this.viewOf(step_256);
    const samples = show === 0 ? 1 : Math.max(1, Math.min(8, Math.floor(view.step_256 / 256)));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    const uniform = this.use(this.viewer, origin, seed, view);
    gl.uniform1ui(uniform('step_256'), Math.max(1, Math.floor(view.step_256 / samples)));
    gl.uniform1i(uniform('samples'), samples);
    gl.uniform1i(uniform('height_px'), gl.drawingBufferHeight);
    gl.uniform1i(uniform('show'), show);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // As of InfiniteTexture, in the finest scale; `faded` is the bilinear colour at the fading that the point names.
  evaluatePoint(point) {
    const gl = this.gl;
    const place = (axis) => BigInt.asIntN(32, BigInt(point.tile[axis])) * BigInt(this.size[axis]) * 256n +
                            BigInt(point.offset_256[axis]);
    const origin = {x: place(0), y: place(1)};
    const alone = {scale: this.finest, fading: 0, variation: 1, level_256: 0};
    const value = {};
    const decided = new Uint32Array(4);
    for (const [name, filter, view] of [['nearest', 0, alone], ['bilinear', 1, alone],
                                        ['faded', 1, {...alone, fading: point.fading || 0}]]) {
      const uniform = this.use(this.reference, origin, point.seed, view);
      gl.uniform1ui(uniform('step_256'), 1);
      gl.uniform2i(uniform('first_row'), 0, 1);
      gl.uniform1i(uniform('filter_kind'), filter);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const color = new Float32Array(4);
      gl.readBuffer(gl.COLOR_ATTACHMENT0);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, color);
      gl.readBuffer(gl.COLOR_ATTACHMENT1);
      gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, decided);
      value[name] = Array.from(color.subarray(0, 3));
    }
    return {patch: decided[0], content: decided[1], source: [decided[2], decided[3]], ...value};
  }

  use(program, origin, seed, view) {
    const gl = this.gl;
    const uniform = this.bind(program);
    const texels = BigInt(this.texelsIn(view.scale));
    const size = this.scales[view.scale].size;
    const [x, y] = [origin.x, origin.y].map((at, axis) => splitCoordinate(floorDivided(at, texels), size[axis]));
    const nesting = this.nestingNear(origin);
    gl.uniform1i(uniform('scale_count'), this.scales.length);
    gl.uniform1ui(uniform('stack_seed'), seed);
    gl.uniform4uiv(uniform('nesting'), nesting.tiles);
    gl.uniform2iv(uniform('nesting_offset'), nesting.offsets);
    gl.uniform2ui(uniform('origin_tile'), x.tile, y.tile);
    gl.uniform2i(uniform('origin_offset'), x.offset, y.offset);
    gl.uniform1i(uniform('view_scale'), view.scale);
    gl.uniform1i(uniform('level_256'), view.level_256);
    gl.uniform1f(uniform('fading'), view.fading);
    gl.uniform1f(uniform('variation'), view.variation);
    return uniform;
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
    return {tiles, offsets};
  }
}

// a / b, rounded down, for BigInt and b > 0.
function floorDivided(a, b) {
  return a >= 0n ? a / b : -((-a + b - 1n) / b);
}
