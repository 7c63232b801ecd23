// The infinite texture on WebGL 2: uploads what `texbake export --web` wrote and draws windows of it with the reference
// shader. What a window, a position and a decision are is told in shaders/README.md.
'use strict';

class InfiniteTexture {
  // `gl`: a WebGL2RenderingContext. `texture`: the object in texture.js. `shaders`: the texts in shaders.js. `viewer` and
  // `reference` name those that are drawn with.
  constructor(gl, texture, shaders, viewer = 'viewer', reference = 'reference') {
    if (texture.semantics !== shaders.semantics)
      throw new Error(`expected semantics ${shaders.semantics}, found ${texture.semantics}: export the bundle again`);
    this.gl = gl;
    this.texture = texture;
    this.size = texture.size;
    this.farthest_step_256 = 256 * 64;
    this.viewer = this.link(shaders.vertex, shaders[viewer]);
    this.reference = this.link(shaders.vertex, shaders[reference]);
    this.planes = {};
    for (const [name, plane] of Object.entries(texture.planes)) this.planes[name] = this.upload(plane);
    gl.bindVertexArray(gl.createVertexArray());
  }

  // Draws the window into the canvas: origin {x, y} as BigInt in 1/256 texel, step in 1/256 texels to a pixel; `viewer`,
  // [x, y, z], is the direction towards which a surface with relief is seen.
  draw({origin, step_256, seed, show, viewer}) {
    const gl = this.gl;
    const view = this.viewOf(step_256);
    // Colours have levels of detail; what is a label has none, and is sampled.
    const samples = show === 0 ? 1 : Math.max(1, Math.min(8, Math.floor(view.step_256 / 256)));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    const uniform = this.use(this.viewer, origin, seed, {...view, viewer});
    gl.uniform1ui(uniform('step_256'), Math.max(1, Math.floor(view.step_256 / samples)));
    gl.uniform1i(uniform('samples'), samples);
    gl.uniform1i(uniform('height_px'), gl.drawingBufferHeight);
    gl.uniform1i(uniform('show'), show);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // How a window with that step is seen: its step, and its level of detail.
  viewOf(step_256) {
    const last_256 = 256 * (this.texture.level_count + 1);
    return {step_256, level_256: Math.max(0, Math.min(last_256, Math.round(256 * Math.log2(step_256 / 256))))};
  }

  // What the reference shader decides and shows at points {tile: [x, y], offset_256: [x, y], seed, …}: for each the patch,
  // the content, the source texel, and the linear colours of pointViews.
  evaluate(points) {
    const gl = this.gl;
    if (!gl.getExtension('EXT_color_buffer_float')) throw new Error('expected WebGL 2 with EXT_color_buffer_float');
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    [gl.RGBA32F, gl.RGBA32UI].forEach((format, i) => {
      gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
      gl.texStorage2D(gl.TEXTURE_2D, 1, format, 1, 1);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D,
                              gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    });
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
    gl.viewport(0, 0, 1, 1);
    const results = points.map((point) => this.evaluatePoint(point));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    return results;
  }

  evaluatePoint(point) {
    const gl = this.gl;
    const origin = this.placeOf(point);
    const value = {};
    for (const [name, filter, view] of this.pointViews(point)) {
      const uniform = this.use(this.reference, origin, point.seed, view);
      gl.uniform1ui(uniform('step_256'), 1);
      gl.uniform2i(uniform('first_row'), 0, 1);
      gl.uniform1i(uniform('filter_kind'), filter);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const color = new Float32Array(4);
      const decided = new Uint32Array(4);
      gl.readBuffer(gl.COLOR_ATTACHMENT0);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.FLOAT, color);
      gl.readBuffer(gl.COLOR_ATTACHMENT1);
      gl.readPixels(0, 0, 1, 1, gl.RGBA_INTEGER, gl.UNSIGNED_INT, decided);
      value[name] = Array.from(color.subarray(0, 3));
      if (name === 'nearest') Object.assign(value, {patch: decided[0], content: decided[1], source: [decided[2], decided[3]]});
      if (name === 'lit') value.found = Array.from(decided);
    }
    return value;
  }

  // A point from the origin of the infinite texture, in 1/256 texel.
  placeOf(point) {
    const [x, y] = this.size.map((side, axis) => BigInt(point.tile[axis]) * BigInt(side) * 256n + BigInt(point.offset_256[axis]));
    return {x, y};
  }

  // The colours of a point, by name: the filter, and how it is seen: at the level that the point names.
  pointViews(point) {
    return [['nearest', 0, {level_256: 0}], ['bilinear', 1, {level_256: 0}], ['trilinear', 1, {level_256: point.level_256 || 0}]];
  }

  // Binds a program and the planes; returns how its uniforms are found.
  bind(program) {
    const gl = this.gl;
    const uniform = (name) => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    Object.entries(this.planes).forEach(([name, texture], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
      gl.uniform1i(uniform(name), unit);
    });
    return uniform;
  }

  // The same with what every window has.
  use(program, origin, seed, view) {
    const gl = this.gl;
    const uniform = this.bind(program);
    gl.uniform2i(uniform('tile_size'), this.size[0], this.size[1]);
    gl.uniform1ui(uniform('content_count'), this.texture.content_count);
    gl.uniform2i(uniform('noise_log2'), this.texture.noise_log2[0], this.texture.noise_log2[1]);
    gl.uniform1i(uniform('noise_step'), this.texture.noise_step);
    gl.uniform1i(uniform('noise_root'), this.texture.noise_root);
    gl.uniform1i(uniform('plane_kind'), this.texture.noise_step ? 4 : 0);
    gl.uniform1i(uniform('level_count'), this.texture.level_count);
    gl.uniform1i(uniform('first_level'), this.texture.first_level);
    gl.uniform1i(uniform('level_256'), view.level_256);
    gl.uniform1ui(uniform('seed'), seed);
    this.setOrigin(uniform, origin, this.size);
    return uniform;
  }

  // Where a window begins, on a tile of `size`.
  setOrigin(uniform, origin, size) {
    const [x, y] = [splitCoordinate(origin.x, size[0]), splitCoordinate(origin.y, size[1])];
    this.gl.uniform2ui(uniform('origin_tile'), x.tile, y.tile);
    this.gl.uniform2i(uniform('origin_offset'), x.offset, y.offset);
  }

  link(vertexText, fragmentText) {
    const gl = this.gl;
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexText], [gl.FRAGMENT_SHADER, fragmentText]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  upload({format, width, height, data}) {
    const gl = this.gl;
    const kinds = {
      RG16UI: [gl.RG_INTEGER, gl.UNSIGNED_SHORT, Uint16Array],
      RGBA16UI: [gl.RGBA_INTEGER, gl.UNSIGNED_SHORT, Uint16Array],
      RG32UI: [gl.RG_INTEGER, gl.UNSIGNED_INT, Uint32Array],
      R32UI: [gl.RED_INTEGER, gl.UNSIGNED_INT, Uint32Array],
      RGBA16I: [gl.RGBA_INTEGER, gl.SHORT, Int16Array],
      RGBA32I: [gl.RGBA_INTEGER, gl.INT, Int32Array],
      RGBA16F: [gl.RGBA, gl.HALF_FLOAT, Uint16Array],
      RGBA32F: [gl.RGBA, gl.FLOAT, Float32Array],
    };
    const limit = gl.getParameter(gl.MAX_TEXTURE_SIZE);
    if (width > limit || height > limit)
      throw new Error(`this device draws textures of up to ${limit} texels a side; the tile has ${width} x ${height}`);
    const [layout, type, TexelArray] = kinds[format];
    const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl[format], width, height, 0, layout, type, new TexelArray(bytes.buffer));
    for (const [parameter, value] of [[gl.TEXTURE_MIN_FILTER, gl.NEAREST], [gl.TEXTURE_MAG_FILTER, gl.NEAREST],
                                      [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
      gl.texParameteri(gl.TEXTURE_2D, parameter, value);
    return texture;
  }
}

// A coordinate in 1/256 texel, any BigInt: the repetition of the tile modulo 2^32, and the place there.
function splitCoordinate(coordinate, side) {
  const period = BigInt(side) * 256n;
  let offset = coordinate % period;
  if (offset < 0n) offset += period;
  return {tile: Number(BigInt.asUintN(32, (coordinate - offset) / period)), offset: Number(offset)};
}
