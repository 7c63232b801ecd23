// The page around the infinite texture: drag to move, wheel or two fingers to zoom, a seed, and what to show.
'use strict';

const texbake = {
  shaders: null,
  view: {origin: {x: 0n, y: 0n}, step_256: 256, seed: 0, show: 0, viewer: null},
  texture: null,

  // Called by texture.js, the last script of the page.
  open(texture) {
    const canvas = document.getElementById('view');
    try {
      const gl = canvas.getContext('webgl2', {antialias: false, preserveDrawingBuffer: true});
      if (!gl) throw new Error('expected a browser with WebGL 2');
      this.canvas = canvas;
      this.texture = new (texture.scales ? InfiniteStack : InfiniteTexture)(gl, texture, this.shaders);
    } catch (error) {
      const failure = document.getElementById('failure');
      failure.textContent = `This page cannot show the texture: ${error.message}`;
      failure.style.display = 'grid';
      return;
    }
    if (!texture.planes.fragments && !texture.planes.fragment_plane) document.querySelector('#show option[value="2"]').remove();
    if (texture.relief) document.getElementById('aslant').hidden = false;
    this.listen();
    this.resize();
  },

  // Draws at the next frame, once, however many changes come before it.
  redraw() {
    if (this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.texture.draw(this.view);
      this.describe();
    });
  },

  describe() {
    const {origin, step_256} = this.view;
    const texels = (coordinate) => (coordinate >> 8n).toString();
    const zoom = 256 / step_256;
    document.getElementById('place').textContent =
        `(${texels(origin.x)}, ${texels(origin.y)}) × ${zoom >= 1 ? zoom.toFixed(1) : '1/' + (1 / zoom).toFixed(1)}`;
  },

  resize() {
    this.canvas.width = Math.round(this.canvas.clientWidth * devicePixelRatio);
    this.canvas.height = Math.round(this.canvas.clientHeight * devicePixelRatio);
    this.redraw();
  },

  move(dx_px, dy_px) {
    const step = this.view.step_256;
    this.view.origin.x -= BigInt(Math.round(dx_px * devicePixelRatio * step));
    this.view.origin.y -= BigInt(Math.round(dy_px * devicePixelRatio * step));
    this.redraw();
  },

  // Zooms by `factor` (above 1: farther away) about a point of the page, which keeps its place.
  zoom(factor, x_px, y_px) {
    const before = this.view.step_256;
    let after = Math.min(this.texture.farthest_step_256, Math.max(4, Math.round(before * factor)));
    if (after === before) after += factor > 1 ? 1 : -1;
    // Several samples to a pixel need a step that they divide.
    const samples = Math.max(1, Math.min(8, Math.floor(after / 256)));
    after = Math.max(4, Math.round(after / samples) * samples);
    const shift = (place) => BigInt(Math.round(place * devicePixelRatio * (before - after)));
    this.view.origin.x += shift(x_px);
    this.view.origin.y += shift(y_px);
    this.view.step_256 = after;
    this.redraw();
  },

  listen() {
    const canvas = this.canvas;
    const pointers = new Map();
    window.addEventListener('resize', () => this.resize());
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      canvas.classList.add('dragged');
      pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    });
    const release = (event) => {
      pointers.delete(event.pointerId);
      if (pointers.size === 0) canvas.classList.remove('dragged');
    };
    canvas.addEventListener('pointerup', release);
    canvas.addEventListener('pointercancel', release);
    canvas.addEventListener('pointermove', (event) => {
      const last = pointers.get(event.pointerId);
      if (!last) return;
      const other = [...pointers.entries()].find(([id]) => id !== event.pointerId);
      if (other) {
        const apart = (p) => Math.hypot(p.x - other[1].x, p.y - other[1].y);
        const now = {x: event.clientX, y: event.clientY};
        if (apart(now) > 0) this.zoom(apart(last) / apart(now), other[1].x, other[1].y);
      } else {
        this.move(event.clientX - last.x, event.clientY - last.y);
      }
      pointers.set(event.pointerId, {x: event.clientX, y: event.clientY});
    });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.pow(2, event.deltaY / 400), event.clientX, event.clientY);
    }, {passive: false});

    const seed = document.getElementById('seed');
    const take = () => {
      this.view.seed = Math.min(4294967295, Math.max(0, Math.floor(Number(seed.value) || 0)));
      this.redraw();
    };
    seed.addEventListener('input', take);
    document.getElementById('another').addEventListener('click', () => {
      seed.value = this.view.seed + 1;
      take();
    });
    const slant = document.getElementById('slant');
    const look = () => {
      const angle = Number(slant.value) * Math.PI / 180;
      this.view.viewer = this.texture.texture.relief ? [Math.sin(angle), 0, Math.cos(angle)] : null;
      this.redraw();
    };
    slant.addEventListener('input', look);
    look();
    document.getElementById('show').addEventListener('change', (event) => {
      this.view.show = Number(event.target.value);
      this.redraw();
    });
  },
};
