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
    this.uniforms = new Map();
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
    // Colors have levels of detail; what is a label has none, and is sampled.
    const samples = show === 0 ? 1 : Math.max(1, Math.min(8, Math.floor(view.texels)));
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight);
    this.use(this.viewer, {
      ...this.windowUniforms(origin, seed, {...view, viewer}),
      step_256: Math.max(1, Math.floor(step_256 / samples)),
      samples,
      height_px: gl.drawingBufferHeight,
      show,
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  // How a window with that step is seen: its step, the texels along a pixel, and its level of detail.
  viewOf(step_256) {
    const last_256 = 256 * (this.texture.level_count + 1);
    const texels = step_256 / 256;
    return {step_256, texels, level_256: Math.max(0, Math.min(last_256, Math.round(256 * Math.log2(texels))))};
  }

  // What the reference shader decides and shows at points {tile: [x, y], offset_256: [x, y], seed, …}: for each the patch,
  // the content, the source texel, and the linear colors of pointViews.
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
      const uniforms = this.windowUniforms(origin, point.seed, view);
      this.use(this.reference, {...uniforms, step_256: 1, first_row: [0, 1], filter_kind: filter});
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

  // The colors of a point, by name: the filter, and how it is seen: at the level that the point names.
  pointViews(point) {
    return [['nearest', 0, {level_256: 0}], ['bilinear', 1, {level_256: 0}], ['trilinear', 1, {level_256: point.level_256 || 0}]];
  }

  // What every window has, by the names of shaders/README.md: what texture.js tells, and how it is seen.
  windowUniforms(origin, seed, {level_256}) {
    const {size, texture} = this;
    const kPlanePlain = 0, kPlaneStructure = 4;
    const plane_kind = texture.noise_step ? kPlaneStructure : kPlanePlain;
    return {...texture, tile_size: size, plane_kind, level_256, seed, ...originUniforms(origin, size)};
  }

  // Makes a program current with the planes, and sets those of its uniforms that `values` names.
  use(program, values) {
    const gl = this.gl;
    gl.useProgram(program);
    Object.values(this.planes).forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    const units = Object.fromEntries(Object.keys(this.planes).map((name, unit) => [name, unit]));
    const all = {...values, ...units};
    for (const {name, location, setter} of this.uniforms.get(program))
      if (all[name] !== undefined) gl[setter](location, typeof all[name] === 'number' ? [all[name]] : all[name]);
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
    this.uniforms.set(program, this.uniformsOf(program));
    return program;
  }

  // The uniforms that a linked program uses, and how each is set.
  uniformsOf(program) {
    const gl = this.gl;
    const setters = {
      [gl.FLOAT]: 'uniform1fv', [gl.FLOAT_VEC3]: 'uniform3fv', [gl.FLOAT_VEC4]: 'uniform4fv',
      [gl.INT]: 'uniform1iv', [gl.INT_VEC2]: 'uniform2iv', [gl.INT_VEC4]: 'uniform4iv',
      [gl.UNSIGNED_INT]: 'uniform1uiv', [gl.UNSIGNED_INT_VEC2]: 'uniform2uiv', [gl.UNSIGNED_INT_VEC4]: 'uniform4uiv',
      [gl.SAMPLER_2D]: 'uniform1iv', [gl.INT_SAMPLER_2D]: 'uniform1iv', [gl.UNSIGNED_INT_SAMPLER_2D]: 'uniform1iv',
    };
    return Array.from({length: gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS)}, (_, i) => {
      const {name, type} = gl.getActiveUniform(program, i);
      return {name: name.replace('[0]', ''), location: gl.getUniformLocation(program, name), setter: setters[type]};
    });
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

// Where a window begins, on a tile of `size`.
function originUniforms(origin, size) {
  const [x, y] = [splitCoordinate(origin.x, size[0]), splitCoordinate(origin.y, size[1])];
  return {origin_tile: [x.tile, y.tile], origin_offset: [x.offset, y.offset]};
}

// A coordinate in 1/256 texel, any BigInt: the repetition of the tile modulo 2^32, and the place there.
function splitCoordinate(coordinate, side) {
  const period = BigInt(side) * 256n;
  let offset = coordinate % period;
  if (offset < 0n) offset += period;
  return {tile: Number(BigInt.asUintN(32, (coordinate - offset) / period)), offset: Number(offset)};
}
