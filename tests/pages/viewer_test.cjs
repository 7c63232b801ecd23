// usage: node viewer_test.cjs CHROMIUM GOLDEN_FOLDER PAGES_FOLDER: the exported pages in a real browser. They render, a
// click and a drag work, and the shader's decisions and colors are the golden vectors.
'use strict';

const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const {pathToFileURL} = require('node:url');
const {chromium} = require('playwright-core');

const [executablePath, goldenFolder, pagesFolder] = process.argv.slice(2);
const kSwitches = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-first-run',
                   '--disable-background-networking', '--disable-component-update', '--disable-sync'];
// Shaders are compiled and run by the processor here, beside other tests: a page that takes minutes is not wrong.
const kPatience_ms = 600000;

async function open(browser, tile, width = 640, height = 480) {
  const page = await browser.newPage({viewport: {width, height}});
  page.setDefaultTimeout(kPatience_ms);
  page.setDefaultNavigationTimeout(kPatience_ms);
  const problems = [];
  page.on('pageerror', (error) => problems.push(String(error)));
  page.on('request', (request) => {
    if (!request.url().startsWith('file:')) problems.push(`asked for ${request.url()}`);
  });
  await page.goto(pathToFileURL(path.join(pagesFolder, tile, 'index.html')).href);
  await page.waitForFunction(() => texbake.texture && !texbake.waiting);
  return {page, problems};
}

// The pixels of the canvas, as drawn last.
function pixels(page) {
  return page.evaluate(async () => {
    await new Promise(requestAnimationFrame);
    const {canvas} = texbake;
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    copy.drawImage(canvas, 0, 0);
    return Array.from(copy.getImageData(0, 0, canvas.width, canvas.height).data);
  });
}
const settle = (page) => page.waitForFunction(() => !texbake.waiting);

async function checkGolden(browser, tile) {
  const golden = JSON.parse(fs.readFileSync(path.join(goldenFolder, `${tile}.json`)));
  const {page, problems} = await open(browser, tile);
  const found = await page.evaluate((points) => texbake.texture.evaluate(points), golden.points);
  let inexact = 0;
  // Levels travel as half floats, those of texels on soft borders too: half a step of values up to 8, and of the two that a
  // fraction lies between.
  const leveled = 2 ** -8;
  const is_soft = (golden.scales || []).some((scale) => scale.soft_border);
  golden.points.forEach((point, i) => {
    const where = `${tile} point ${i}`;
    assert.strictEqual(found[i].patch, point.patch, where);
    assert.strictEqual(found[i].content, point.content, where);
    assert.deepStrictEqual(found[i].source, point.source, where);
    for (const filter of ['nearest', 'bilinear', 'faded', 'lit'])
      (point[filter] || []).forEach((expected, c) => {
        const difference = Math.abs(found[i][filter][c] - Math.fround(expected));
        // ES 3.00 has no `precise`: a driver may fuse. A point's eight lerps may each be off by a unit of values up to 1.
        assert.ok(difference <= (is_soft ? leveled : 8 * 2 ** -24), `${where}: ${filter} differs by ${difference}`);
        if (difference !== 0) ++inexact;
      });
    (point.trilinear || []).forEach((expected, c) =>
      assert.ok(Math.abs(found[i].trilinear[c] - expected) <= leveled, `${where}: trilinear`));
    // What the ray met, and the light there: exact, since every number of the vectors is short.
    if (point.lit) {
      const light = Math.imul(point.light_4096 - 4096, 2654435769) >>> 0;
      const [x, y, , stirred] = found[i].found;
      assert.deepStrictEqual([x, y & 0x3fffff, stirred], [...point.met_256, light], `${where}: relief`);
    }
  });
  assert.deepStrictEqual(problems, []);
  await page.close();
  console.log(`${tile}: ${golden.points.length} points, decisions equal, ${inexact} colour values inexact`);
}

async function checkHandling(browser) {
  const {page, problems} = await open(browser, 'moved');
  await settle(page);
  const first = await pixels(page);
  assert.ok(new Set(first).size > 16, 'the page shows more than a flat colour');

  // A drag by whole pixels moves the picture: what stood at (100, 80) stands at (160, 120).
  await page.mouse.move(300, 300);
  await page.mouse.down();
  await page.mouse.move(360, 340);
  await page.mouse.up();
  await settle(page);
  const dragged = await pixels(page);
  const at = (image, x, y) => image.slice(4 * (y * 640 + x), 4 * (y * 640 + x) + 3);
  for (const [x, y] of [[100, 80], [7, 201], [500, 400]]) {
    assert.deepStrictEqual(at(dragged, x + 60, y + 40), at(first, x, y));
  }

  // A click draws another seed: other contents of the same patches.
  const seedBefore = await page.evaluate(() => texbake.view.seed);
  await page.selectOption('#show', '1');
  await settle(page);
  const patches = await pixels(page);
  await page.click('#another');
  await settle(page);
  assert.strictEqual(await page.evaluate(() => texbake.view.seed), seedBefore + 1);
  assert.deepStrictEqual(await pixels(page), patches);
  await page.selectOption('#show', '0');
  await settle(page);
  assert.notDeepStrictEqual(await pixels(page), dragged);

  // The wheel zooms about the pointer.
  await page.mouse.move(320, 240);
  await page.mouse.wheel(0, 800);
  await settle(page);
  assert.ok(await page.evaluate(() => texbake.view.step_256) > 256);
  assert.deepStrictEqual(problems, []);
  if (process.env.TEXBAKE_SCREENSHOT) await page.screenshot({path: process.env.TEXBAKE_SCREENSHOT});
  await page.close();
}

// Near the finest scale shows alone, at the ratio the coarser one; both are drawn.
async function checkScales(browser) {
  const {page, problems} = await open(browser, 'stack', 160, 120);
  const views = await page.evaluate(() => [256, 1280].map((step) => texbake.texture.viewOf(step)));
  assert.deepStrictEqual(views.map(({scale, fading, texels}) => [scale, fading, texels]), [[1, 0, 1], [0, 0, 1]]);
  let before = [];
  for (const step of [64, 600, 1280]) {
    await page.evaluate((step_256) => { texbake.view.step_256 = step_256; texbake.redraw(); }, step);
    await settle(page);
    const now = await pixels(page);
    assert.ok(new Set(now).size > 16, `step ${step}`);
    assert.notDeepStrictEqual(now, before);
    before = now;
  }
  assert.deepStrictEqual(problems, []);
  await page.close();
}

// The handle moves what stands out: a stack with heights has it, and without it the page is flat and unlit.
async function checkRelief(browser) {
  const flat = await open(browser, 'stack', 160, 120);
  assert.ok(await flat.page.isHidden('#aslant'));
  const {page, problems} = await open(browser, 'stack_relief', 160, 120);
  const units = await page.evaluate(() => {
    const {gl, viewer} = texbake.texture;
    const samplers = [gl.SAMPLER_2D, gl.INT_SAMPLER_2D, gl.UNSIGNED_INT_SAMPLER_2D];
    const uniforms = Array.from({length: gl.getProgramParameter(viewer, gl.ACTIVE_UNIFORMS)}, (_, i) => gl.getActiveUniform(viewer, i));
    return uniforms.filter(({type}) => samplers.includes(type)).length;
  });
  assert.ok(units <= 16, `a browser need not have ${units} textures`);
  await page.evaluate(() => { texbake.view.step_256 = 64; texbake.redraw(); });
  await settle(page);
  const above = await pixels(page);
  await page.fill('#slant', '50');
  await settle(page);
  const aside = await pixels(page);
  assert.notDeepStrictEqual(aside, above);
  await page.evaluate(() => { texbake.view.viewer = null; texbake.redraw(); });
  await settle(page);
  assert.notDeepStrictEqual(await pixels(page), above);
  assert.deepStrictEqual([...problems, ...flat.problems], []);
  console.log(`relief: ${units} textures`);
  await flat.page.close();
  await page.close();
}

async function main() {
  const browser = await chromium.launch({executablePath, args: kSwitches});
  try {
    for (const tile of ['plain', 'moved', 'turned', 'levels', 'noise_levels', 'stack', 'stack_turned',
                        'stack_three', 'stack_soft', 'stack_relief', 'stack_noise']) await checkGolden(browser, tile);
    await checkHandling(browser);
    await checkScales(browser);
    await checkRelief(browser);
  } finally {
    await browser.close();
  }
}
main().catch((error) => {
  console.error(error);
  process.exit(1);
});
