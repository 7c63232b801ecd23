"""The meaning of shaders/*.glsl for one scale, in numpy: all pixels at once, integers as int64 and colors as float32.

A texel (of the texture, or a block of it) and a position are rows (tile.x, tile.y, x, y) of an array; a source is a
row of the columns below. Colors are rows of four. The names are those of the texts.
"""

import copy

import numpy as np

F = np.float32
PLAIN, NORMAL_OPENGL, NORMAL_DIRECTX, HEIGHT, STRUCTURE, RELIEF_OPENGL, RELIEF_DIRECTX = range(7)
NEAREST, BILINEAR, TRILINEAR, ANISOTROPIC = range(4)
LIST_WIDTH, LIST_LOG2 = 4096, 12


def u32(x):
    return x & 0xFFFFFFFF


def i32(x):
    return ((x + 0x80000000) & 0xFFFFFFFF) - 0x80000000


# hash.glsl


def pcg(value):
    state = u32(value * 747796405 + 2891336453)
    word = u32(((state >> ((state >> 28) + 4)) ^ state) * 277803737)
    return (word >> 22) ^ word


def content_hash(patch, x, y, seed):
    return pcg(u32(patch + pcg(u32(x + pcg(u32(y + pcg(np.int64(seed))))))))


# Numbers.


def floats_of(bits):
    return u32(np.asarray(bits, np.int64)).astype(np.uint32).view(F)


def bits_of(x):
    return np.ascontiguousarray(x, F).view(np.uint32).astype(np.int64)


def column(weight):
    return np.asarray(weight, F)[..., None]


def weight_of(fraction):
    return np.asarray(fraction).astype(F) * F(0.00390625)


def lerp(a, b, weight):
    return a + (b - a) * column(weight)


def bilinear(upper_left, upper_right, lower_left, lower_right, x, y):
    x, y = weight_of(x), weight_of(y)
    return lerp(lerp(upper_left, upper_right, x), lerp(lower_left, lower_right, x), y)


def where(mask, a, b):
    """By rows."""
    return np.where(mask[:, None], a, b)


def stacked(*columns):
    return np.stack(np.broadcast_arrays(*columns), axis=-1).astype(np.int64)


def zeros(count):
    return np.zeros((count, 4), F)


def log2_256(x):
    bits = bits_of(x)
    exponent = (bits >> 23) - 127
    t = floats_of((bits & 8388607) | 1065353216) - F(1)
    fraction = t * ((F(1) - t) * F(0.3466) + F(1))
    return exponent * 256 + (fraction * F(256)).astype(np.int64)


def twice_root(x):
    positive = x > 0
    safe = np.where(positive, x, F(1))
    half_x = F(0.5) * safe
    y = floats_of(1597463007 - (bits_of(safe) >> 1))
    for _ in range(2):
        y = y * (F(1.5) - half_x * y * y)
    root = safe * y
    return np.where(positive, root + root, F(0))


def twice_roots(light):
    roots = twice_root(light)
    roots[:, 3] = 0
    return roots


def blended_weights(upper_left, upper_right, lower_left, lower_right, x, y):
    x, y = np.asarray(x)[:, None], np.asarray(y)[:, None]
    upper = upper_left * (256 - x) + upper_right * x
    lower = lower_left * (256 - x) + lower_right * x
    return filled((upper * (256 - y) + lower * y) >> 16)


def filled(weights):
    """The first noise takes what the others leave over."""
    weights[:, 0] = 2048 - weights[:, 1] - weights[:, 2] - weights[:, 3]
    return weights


def list_place(number, row):
    return number & (LIST_WIDTH - 1), (number >> LIST_LOG2) + row


def first_owned(found):
    return stacked(found[:, 1] & 65535, (found[:, 1] >> 16) & 15)


def entries_after(found):
    return found[:, 1] >> 20


def block_and_fraction(place, side_256):
    # The texts shift where the side is a power of two, which gives the same.
    return place // side_256, place % side_256 * 256 // side_256


class Grid:
    """How a level cuts the tile into blocks."""

    def __init__(self, blocks, corner, side_256, noise):
        self.blocks, self.corner, self.side_256, self.noise = blocks, corner, side_256, noise


class Source:
    """Where texels are taken from: columns of equal length."""

    def __init__(self, nearest, texel, fraction, matrix, scale):
        self.nearest, self.texel, self.fraction, self.matrix, self.scale = nearest, texel, fraction, matrix, scale


class Decision:
    def __init__(self, patch, content, owner):
        self.patch, self.content, self.owner = patch, content, owner


class Tile:
    """One scale: `textures` are arrays of rows x columns x components, `uniforms` are those of the texts."""

    plane_row = first_patch = level_row = block_row = entry_row = value_row = 0

    def __init__(self, textures, uniforms):
        self.textures = textures
        for name, value in uniforms.items():
            setattr(self, name, value)

    def fetch(self, name, x, y):
        return self.textures[name][y, x]

    def with_members(self, **members):
        other = copy.copy(self)
        for name, value in members.items():
            setattr(other, name, value)
        return other

    # content.glsl

    def wrap_once(self, x, n):
        return np.where(x < n, x, x - n)

    def drawn_content(self, patch, x, y):
        return ((content_hash(patch, x, y, self.seed) >> 16) * self.content_count) >> 16

    def decide(self, at):
        owned = self.fetch("patch_plane", at[:, 2], at[:, 3] + self.plane_row)
        patch, owner = owned[:, 0], self.owner_of(owned[:, 1])
        content = self.drawn_content(patch, u32(at[:, 0] + owner[:, 0]), u32(at[:, 1] + owner[:, 1]))
        return Decision(patch, content, owner)

    def owner_of(self, bits):
        return stacked((bits & 3) - 1, (bits >> 2) - 1)

    def source_of(self, at, decision):
        w, h = self.tile_size
        p = at[:, 2:]
        content = self.fetch("contents", decision.content, decision.patch + self.first_patch)
        is_moved = (content[:, 2] == 65536) & (content[:, 3] == 0)
        t = stacked(content[:, 0] & 65535, content[:, 0] >> 16)
        moved = stacked(self.wrap_once(p[:, 0] + t[:, 0], w), self.wrap_once(p[:, 1] + t[:, 1], h))
        center = self.fetch("centers", decision.patch + self.first_patch, 0)[:, :2]
        dx = p[:, 0] - decision.owner[:, 0] * w - center[:, 0]
        dy = p[:, 1] - decision.owner[:, 1] * h - center[:, 1]
        a, b = content[:, 2], content[:, 3]
        offset = stacked(a * dx - b * dy, b * dx + a * dy)
        size = np.array([w, h])
        middle = center + t
        nearest = (middle + ((offset + 32768) >> 16)) % size
        blended = (offset + 128) >> 8
        texel = (middle + (blended >> 8)) % size
        return Source(where(is_moved, moved, nearest), where(is_moved, moved, texel),
                      where(is_moved, np.zeros_like(blended), blended & 255), content[:, 2:4], content[:, 1])

    def texel_source(self, at):
        return self.source_of(at, self.decide(at))

    # sample.glsl

    def pixel_position(self, origin, step_256, x, y):
        axes = []
        for axis, pixel in enumerate((x, y)):
            side = self.tile_size[axis] * 256
            place = u32(origin[2 + axis] + pixel * step_256 + (step_256 >> 1))
            axes.append((u32(origin[axis] + place // side), place % side))
        return stacked(axes[0][0], axes[1][0], axes[0][1], axes[1][1])

    def texel_at(self, at):
        texel = at.copy()
        texel[:, 2:] >>= 8
        return texel

    def moved_back(self, at, by):
        moved = at.copy()
        for axis in range(2):
            moved[:, 2 + axis] -= by[axis]
            before = moved[:, 2 + axis] < 0
            moved[:, 2 + axis] += np.where(before, self.tile_size[axis] * 256, 0)
            moved[:, axis] = u32(moved[:, axis] - before)
        return moved

    def upper_left_center(self, at):
        return self.moved_back(at, (128, 128))

    def neighbor(self, texel, corner, blocks=None):
        """0: itself, 1: to the right, 2: below, 3: both."""
        size = self.tile_size if blocks is None else blocks
        next_one = texel.copy()
        for axis, is_moved in enumerate((corner & 1, corner >> 1)):
            if is_moved:
                place = texel[:, 2 + axis] + 1
                wraps = place == size[axis]
                next_one[:, 2 + axis] = np.where(wraps, 0, place)
                next_one[:, axis] = u32(texel[:, axis] + wraps)
        return next_one

    def four_around(self, plane, source):
        """Of a turned source: its texel, and those to the right, below, and both."""
        w, h = self.tile_size
        x, y = source.texel[:, 0], source.texel[:, 1]
        right, lower = self.wrap_once(x + 1, w), self.wrap_once(y + 1, h)
        row = 0 if plane == "masks" else self.plane_row
        return [self.fetch(plane, i, j + row) for i, j in ((x, y), (right, y), (x, lower), (right, lower))]

    def source_value(self, plane, source):
        around = self.four_around(plane, source)
        blended = bilinear(*around, source.fraction[:, 0], source.fraction[:, 1])
        return where((source.fraction == 0).all(axis=1), around[0], blended)

    def turned_normal(self, normal, source, up):
        a, b = source.matrix[:, 0], source.matrix[:, 1]
        x, y = normal[:, 0], normal[:, 1] * F(up)
        by_eighth = (a != 0) & (b != 0)
        x, y = (np.where(by_eighth, (x - y) * F(0.70710678), x), np.where(by_eighth, (x + y) * F(0.70710678), y))
        cases = [(a > 0) & (b >= 0), (a <= 0) & (b > 0), a < 0]
        turned = normal.copy()
        turned[:, 0] = np.select(cases, [x, -y, -x], y)
        turned[:, 1] = np.select(cases, [y * F(up), x * F(up), -y * F(up)], -x * F(up))
        return where((a > 0) & (b == 0), normal, turned)

    def scaled_height(self, value, source):
        height = zeros(len(value))
        height[:, 0] = value[:, 0] * (source.scale.astype(F) * F(0.0000152587890625))
        return height

    # noise.glsl

    def noise_place_of(self, x, y, level):
        """`level` may differ from texel to texel."""
        n = u32(x + self.noise_step * y)
        columns, rows = 1 << self.noise_log2[0], 1 << self.noise_log2[1]
        level = np.asarray(level)
        is_whole = level == 0
        left = np.where(is_whole, 0, columns)
        top = np.where(is_whole, 0, rows - (rows >> np.maximum(level - 1, 0)))
        return stacked(left + (n & (columns - 1)), top + ((n >> self.noise_log2[0]) & ((rows >> level) - 1)))

    def noise_level_place(self, at, level):
        x = u32(at[:, 0] * self.tile_size[0] + at[:, 2]) >> level
        y = u32(at[:, 1] * self.tile_size[1] + at[:, 3]) >> level
        return self.noise_place_of(x, y, level)

    def source_weights(self, source):
        around = self.four_around("masks", source)
        blended = blended_weights(*around, source.fraction[:, 0], source.fraction[:, 1])
        return where((source.fraction == 0).all(axis=1), around[0], blended)

    def weighed_noise(self, weights, place):
        total = zeros(len(place))
        for k in range(4):
            weighed = weights[:, k] != 0
            if weighed.any():
                x, y = place[weighed, 0], place[weighed, 1] + (k << self.noise_log2[1])
                share = weights[weighed, k].astype(F) * F(0.00048828125)
                total[weighed] = total[weighed] + self.fetch("noise_tiles", x, y) * column(share)
        return total

    def with_noise(self, structure, weights, place):
        change = self.weighed_noise(weights, place)
        if self.noise_root:
            change = change * (twice_roots(structure) + change)
        return structure + change

    def with_noise_level(self, mean, weights, place):
        change = self.weighed_noise(weights, place)
        if self.noise_root:
            change = change * twice_roots(mean)
            change = change + self.weighed_noise(weights, place + np.array([1 << self.noise_log2[0], 0]))
        return mean + change

    def layered_value(self, plane, at, source):
        structure = self.source_value(plane, source)
        if self.noise_step == 0:
            return structure
        return self.with_noise(structure, self.source_weights(source), self.noise_level_place(at, 0))

    # levels.glsl

    def kind_value(self, plane, kind, source):
        value = self.source_value(plane, source)
        if kind in (PLAIN, STRUCTURE):
            return value
        if kind == HEIGHT:
            return self.scaled_height(value, source)
        if kind in (RELIEF_OPENGL, RELIEF_DIRECTX):
            normal = np.concatenate([value[:, 1:], zeros(len(value))[:, :1]], axis=1)
            turned = self.turned_normal(normal, source, 1 if kind == RELIEF_OPENGL else -1)
            return np.concatenate([self.scaled_height(value, source)[:, :1], turned[:, :3]], axis=1)
        return self.turned_normal(value, source, 1 if kind == NORMAL_OPENGL else -1)

    def value_number(self, entry, owned, tile):
        owner = self.owner_of(owned[:, 1])
        content = self.drawn_content(owned[:, 0], u32(tile[:, 0] + owner[:, 0]), u32(tile[:, 1] + owner[:, 1]))
        return entry * self.content_count + content

    def entries_of(self, found, tile):
        """For each entry of the longest list: which blocks have it, and the numbers of their values."""
        count = entries_after(found)
        for i in range(int(count.max(initial=0)) + 1):
            has = np.flatnonzero(count >= i)
            entry = found[has, 0] + i
            owned = first_owned(found[has])
            if i:
                owned = self.fetch("level_entries", *list_place(entry, self.entry_row))
            yield i, has, self.value_number(entry, owned, tile[has])

    def shares_of(self, values, found, tile, weighed):
        total, weights = zeros(len(found)), np.zeros((len(found), 4), np.int64)
        for i, has, number in self.entries_of(found, tile):
            place = list_place(number, self.value_row)
            value = self.fetch(values, *place)
            total[has] = value if i == 0 else total[has] + value
            if weighed:
                weights[has] += self.fetch("level_weights", *place)
        return total, weights

    def shared_texel(self, at):
        return self.fetch("level_blocks", at[:, 2], at[:, 3] + self.block_row)

    def hard_or_shared(self, plane, kind, values, at, source):
        """What shows at texels, whose borders may be soft, without noise."""
        value = self.kind_value(plane, kind, source)
        if self.first_level == 0:
            found = self.shared_texel(at)
            shared = np.flatnonzero(entries_after(found))
            if len(shared):
                value[shared] = self.shares_of(values, found[shared], at[shared], False)[0]
        return value

    def texel_value(self, plane, kind, values, at):
        source = self.texel_source(at)
        value = self.hard_or_shared(plane, kind, values, at, source)
        if kind == STRUCTURE and self.noise_step:
            return self.with_noise(value, self.source_weights(source), self.noise_level_place(at, 0))
        return value

    def grid_of(self, level):
        if level == 0:
            return Grid(self.tile_size, None, (256, 256), 0)
        table = self.textures["level_table"][level + self.level_row]
        blocks, corner = table[0, :2], table[0, 2:]
        corner = None if corner[0] < 0 else (corner[0], corner[1] + self.block_row)
        return Grid(blocks, corner, table[1, :2], int(table[2, 0]))

    def middle_of(self, block, grid):
        texel = block.copy()
        for axis in range(2):
            side = grid.side_256[axis]
            texel[:, 2 + axis] = (block[:, 2 + axis] * side + (side >> 1)) >> 8
        return texel

    def found_block(self, block, grid):
        return self.fetch("level_blocks", grid.corner[0] + block[:, 2], grid.corner[1] + block[:, 3])

    def block_value(self, plane, kind, values, block, grid):
        if grid.corner is None:
            return self.texel_value(plane, kind, values, block)
        has_noise = kind == STRUCTURE and self.noise_step != 0 and grid.noise >= 0
        value, weights = self.shares_of(values, self.found_block(block, grid), block, has_noise)
        if not has_noise:
            return value
        return self.with_noise_level(value, weights, self.noise_level_place(self.middle_of(block, grid), grid.noise))

    def block_corner(self, at, grid):
        side = grid.side_256
        first = self.moved_back(at, (side[0] >> 1, side[1] >> 1))
        x, fraction_x = block_and_fraction(first[:, 2], side[0])
        y, fraction_y = block_and_fraction(first[:, 3], side[1])
        return stacked(first[:, 0], first[:, 1], x, y), fraction_x, fraction_y

    def between_blocks(self, at, grid, value_of):
        first, x, y = self.block_corner(at, grid)
        return bilinear(*[value_of(self.neighbor(first, corner, grid.blocks)) for corner in range(4)], x, y)

    def level_value(self, plane, kind, values, at, level):
        """`level` may differ from position to position."""
        value, level = zeros(len(at)), np.broadcast_to(level, len(at))
        for one in np.unique(level):
            these = level == one
            if one > self.level_count:
                value[these] = self.fetch(values, 0, self.value_row)
            else:
                grid = self.grid_of(int(one))
                value[these] = self.between_blocks(
                    at[these], grid, lambda block, grid=grid: self.block_value(plane, kind, values, block, grid))
        return value

    def trilinear_value(self, plane, kind, values, at, level_256):
        level_256 = np.broadcast_to(level_256, len(at))
        value = self.level_value(plane, kind, values, at, level_256 >> 8)
        between = np.flatnonzero(level_256 & 255)
        if len(between):
            level, part = (level_256[between] >> 8) + 1, weight_of(level_256[between] & 255)
            value[between] = lerp(value[between], self.level_value(plane, kind, values, at[between], level), part)
        return value

    def moved_position(self, at, by_x, by_y):
        axes = []
        for axis, by in enumerate((by_x, by_y)):
            period = self.tile_size[axis] * 256
            repetitions = 1073741824 // period + 1
            place = u32(at[:, 2 + axis] + by) + repetitions * period
            place = u32(place)
            axes.append((u32(at[:, axis] + place // period - repetitions), place % period))
        return stacked(axes[0][0], axes[1][0], axes[0][1], axes[1][1])

    def probes_value(self, plane, kind, values, probes):
        return self.mean_of_probes(
            probes, lambda at, these: self.trilinear_value(plane, kind, values, at, probes.level_256[these]))

    def mean_of_probes(self, probes, value_of):
        total = zeros(len(probes.at))
        for these, at in self.each_probe(probes):
            total[these] = total[these] + value_of(at, these)
        return total * column(floats_of((127 - probes.halvings) << 23))

    def each_probe(self, probes):
        count = 1 << probes.halvings
        for i in range(int(count.max(initial=1))):
            these = np.flatnonzero(i < count)
            place = 2 * i + 1 - count[these]
            shift = probes.halvings[these] + 1
            axis = probes.axis_256[these]
            yield these, self.moved_position(probes.at[these], (axis[:, 0] * place) >> shift,
                                             (axis[:, 1] * place) >> shift)


class Probes:
    """Points in a row, for each pixel."""

    def __init__(self, at, axis_256, halvings, level_256):
        self.at = at
        self.axis_256 = np.broadcast_to(np.asarray(axis_256, np.int64), (len(at), 2))
        self.halvings = np.broadcast_to(np.asarray(halvings, np.int64), len(at))
        self.level_256 = np.broadcast_to(np.asarray(level_256, np.int64), len(at))
