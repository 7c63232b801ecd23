"""The meaning of shaders/deform.glsl, in numpy."""

import numpy as np

from evaluate import (BILINEAR, NEAREST, Probes, blended_weights, column, content_hash, filled, floats_of, lerp, stacked,
                      u32, weight_of, where, zeros)


def scaled(a, i):
    high, low = a * (i >> 12), a * (i & 4095)
    rest = (high & 15) * 4096 + (low & 65535)
    return (high >> 4) + (low >> 16) + (rest >> 16), rest & 65535


def smooth_weight(t):
    return u32(t * t * (3072 - 2 * t)) >> 15


def blended_lattice(a, b, weight):
    return a + (((b - a) * weight[:, None]) >> 15)


class Deformed:
    """A tile whose structure is deformed, as its uniforms say."""

    def __init__(self, tile):
        self.tile = tile

    def lattice_vector(self, x, y, octave, amplitude):
        drawn = content_hash(np.int64(4294901760 + octave), x, y, self.tile.seed)
        return stacked((((drawn & 65535) - 32768) * amplitude) >> 15, (((drawn >> 16) - 32768) * amplitude) >> 15)

    def lattice_noise(self, x, y, octave, amplitude, cell_log2):
        cell_x, cell_y, last = x >> cell_log2, y >> cell_log2, (1 << cell_log2) - 1
        weight_x, weight_y = (smooth_weight((place & last) << (10 - cell_log2)) for place in (x, y))
        last_cell = 4294967295 >> cell_log2
        next_x, next_y = (cell_x + 1) & last_cell, (cell_y + 1) & last_cell
        corners = [self.lattice_vector(i, j, octave, amplitude)
                   for i, j in ((cell_x, cell_y), (next_x, cell_y), (cell_x, next_y), (next_x, next_y))]
        return blended_lattice(blended_lattice(corners[0], corners[1], weight_x),
                               blended_lattice(corners[2], corners[3], weight_x), weight_y)

    def texel_turbulence(self, at):
        amplitude, cells = self.tile.turbulence
        x = u32(at[:, 0] * self.tile.tile_size[0] + at[:, 2])
        y = u32(at[:, 1] * self.tile.tile_size[1] + at[:, 3])
        return sum(self.lattice_noise(x, y, o, amplitude >> o, cells - o) for o in range(3))

    def turbulence_at(self, at):
        if self.tile.turbulence[0] == 0:
            return np.zeros((len(at), 2), np.int64)
        corner = self.tile.upper_left_center(at)
        texel = self.tile.texel_at(corner)
        x, y = (corner[:, 2] & 255) << 7, (corner[:, 3] & 255) << 7
        around = [self.texel_turbulence(self.tile.neighbor(texel, i)) for i in range(4)]
        return blended_lattice(blended_lattice(around[0], around[1], x), blended_lattice(around[2], around[3], x), y)

    def deformed_position(self, at):
        t = self.tile
        i, j = (((u32(at[:, axis] - t.deform_from_tile[axis]) * t.tile_size[axis] + (at[:, 2 + axis] >> 8) -
                  t.deform_from[axis] + 0x80000000) & 0xFFFFFFFF) - 0x80000000 for axis in range(2))
        part_i, part_j = (at[:, 2] & 255) - 128, (at[:, 3] & 255) - 128
        stirred, axes = self.turbulence_at(at), []
        for axis in range(2):
            to_i, to_j = t.deform_matrix[2 * axis], t.deform_matrix[2 * axis + 1]
            by_i, by_j = scaled(to_i, i), scaled(to_j, j)
            rest = t.deform_to[2 + axis] + by_i[1] + by_j[1] + ((to_i * part_i + to_j * part_j) >> 8)
            whole, part = t.deform_to[axis] + by_i[0] + by_j[0], (rest >> 8) + stirred[:, axis]
            n = t.tile_size[axis]
            repetitions = 67108864 // n + 1
            moved = u32(whole + (part >> 8) + repetitions * n)
            axes.append((u32(t.deform_to_tile[axis] + moved // n - repetitions), moved % n * 256 + (part & 255)))
        return stacked(axes[0][0], axes[1][0], axes[0][1], axes[1][1])

    # Structure and weights together.

    def no_weights(self, count):
        return np.tile(np.array([2048, 0, 0, 0]), (count, 1))

    def block_shares(self, plane, kind, values, block, grid):
        t = self.tile
        if grid.corner is not None:
            return t.shares_of(values, t.found_block(block, grid), block, t.noise_step != 0)
        source = t.texel_source(block)
        weights = t.source_weights(source) if t.noise_step else self.no_weights(len(block))
        return t.hard_or_shared(plane, kind, values, block, source), weights

    def level_shares(self, plane, kind, values, at, level):
        t, count = self.tile, len(at)
        if level > t.level_count:
            value, weights = zeros(count), self.no_weights(count)
            value[:] = t.fetch(values, 0, t.value_row)
            if t.noise_step:
                weights[:] = t.fetch("level_weights", 0, t.value_row)
            return value, weights
        grid = t.grid_of(level)
        first, x, y = t.block_corner(at, grid)
        around = [self.block_shares(plane, kind, values, t.neighbor(first, i, grid.blocks), grid) for i in range(4)]
        value = [one[0] for one in around]
        value = lerp(lerp(value[0], value[1], weight_of(x)), lerp(value[2], value[3], weight_of(x)), weight_of(y))
        return value, blended_weights(*[one[1] for one in around], x, y)

    def probes_shares(self, plane, kind, values, probes):
        """All pixels have one level and one number of probes."""
        t = self.tile
        total, weights = zeros(len(probes.at)), np.zeros((len(probes.at), 4), np.int64)
        level, part = int(probes.level_256[0]) >> 8, int(probes.level_256[0]) & 255
        for _, at in t.each_probe(probes):
            value, one = self.level_shares(plane, kind, values, at, level)
            weights += one * (256 - part)
            if part:
                beyond, other = self.level_shares(plane, kind, values, at, level + 1)
                value = lerp(value, beyond, weight_of(part))
                weights += other * part
            total = total + value
        halvings = probes.halvings
        value = total * column(floats_of((127 - halvings) << 23))
        return value, filled(weights >> (8 + halvings)[:, None])

    def block_before(self, x, part, level):
        if level == 0:
            moved = part - 128
            whole = u32(x - (moved < 0))
        else:
            moved, whole = part, u32(x - (1 << (level - 1)))
        rest = ((whole & ((1 << level) - 1)) << 8) | (moved & 255)
        return whole >> level, rest >> level

    def with_noise_around(self, shares, at, level):
        t = self.tile
        used = min(level, t.noise_log2[1])
        (x, part_x), (y, part_y) = (self.block_before(
            u32(at[:, axis] * t.tile_size[axis] + (at[:, 2 + axis] >> 8)), at[:, 2 + axis] & 255, used) for axis in range(2))
        around = []
        for corner in range(4):
            place = t.noise_place_of(u32(x + (corner & 1)), u32(y + (corner >> 1)), used)
            around.append((t.with_noise_level if used else t.with_noise)(*shares, place))
        return lerp(lerp(around[0], around[1], weight_of(part_x)), lerp(around[2], around[3], weight_of(part_x)),
                    weight_of(part_y))

    def value(self, plane, kind, values, at, smooth_filter, picture_level_256):
        t = self.tile
        texel, middle = t.texel_at(at), at
        if smooth_filter == NEAREST:
            middle = at.copy()
            middle[:, 2:] = texel[:, 2:] * 256 + 128
        probes = Probes(self.deformed_position(middle), t.deform_axis_256, t.deform_probes[1], t.deform_probes[0])
        shares = self.probes_shares(plane, kind, values, probes)
        if t.noise_step == 0:
            return shares[0]
        if smooth_filter == NEAREST:
            return t.with_noise(*shares, t.noise_level_place(texel, 0))
        level = picture_level_256 >> 8
        value = self.with_noise_around(shares, at, level)
        if picture_level_256 & 255:
            value = lerp(value, self.with_noise_around(shares, at, level + 1), weight_of(picture_level_256 & 255))
        return value
