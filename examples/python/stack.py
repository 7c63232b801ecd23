"""The meaning of shaders/scales.glsl, stack_levels.glsl, stack_probes.glsl, relief.glsl, stack_relief.glsl and
stack_perspective.glsl, in numpy."""

import numpy as np

from evaluate import (F, HEIGHT, NEAREST, RELIEF_OPENGL, TRILINEAR, Probes, Tile, column, entries_after, floats_of, i32,
                      lerp, list_place, log2_256, stacked, u32, weight_of, where, zeros)
from perspective import Ellipse, axis_of, ground_position, sum_of_squares, truncated, within_reach

TRANSFER_MODE, FRAGMENT, TEXEL, BETWEEN = 3, 0, 1, 2
LOCAL_MEAN, NO_VARIATION, NO_COARSER_VARIATION, COARSEST_LABELS, SOFT_BORDERS = 4, 8, 16, 32, 64


def without_w(color):
    color = color.copy()
    color[:, 3] = 0
    return color


def of_labels(table, row, first, labels):
    return table[row, first + labels]


def in_proportion(whole, dominant, share):
    """lerp(dominant, whole, share), and exactly one of them at the ends."""
    return where(share == 1, whole, where(share == 0, dominant, lerp(dominant, whole, share)))


class Scale(Tile):
    """A scale in use, with its levels: what use_scale and use_levels set."""

    def __init__(self, stack, number):
        super().__init__(stack.textures, stack.uniforms)
        table = stack.textures["scale_table"][number + 1]
        self.textures = dict(stack.textures, centers=stack.textures["scale_table"],
                             level_table=stack.textures["scale_table"])
        self.number, self.stack = number, stack
        self.tile_size = (int(table[0, 0]), int(table[0, 1]))
        self.plane_row, self.first_patch = int(table[0, 2]), int(table[0, 3])
        self.content_count, self.ratio, self.first_class, self.bits = (int(n) for n in table[1])
        self.level_row, self.block_row, self.entry_row, self.level_count = (int(n) for n in table[2])
        self.value_row, self.dominant_row, self.share_row, self.fade_256 = (int(n) for n in table[3])
        self.first_level = 0 if self.bits & SOFT_BORDERS else 1
        is_finest = number == stack.scale_count - 1
        self.noise_step = stack.finest_noise_step if is_finest else 0
        self.seed = u32(stack.stack_seed + (stack.scale_count - 1 - number) * 2654435769)

    @property
    def mode(self):
        return self.bits & TRANSFER_MODE

    def own_share(self, variation):
        return np.zeros_like(variation) if self.bits & NO_VARIATION else variation

    def coarser_share(self, count):
        return np.full(count, 0 if self.bits & NO_COARSER_VARIATION else 1, F)


class Stack:
    def __init__(self, textures, uniforms):
        self.textures, self.uniforms = textures, uniforms
        for name, value in uniforms.items():
            setattr(self, name, value)
        self.scales = [Scale(self, s) for s in range(self.scale_count)]

    # scales.glsl

    def coarser_origin(self, scale, at):
        nest, offset = self.nesting[scale.number], self.nesting_offset[scale.number]
        coarse, axes = self.scales[scale.number - 1], []
        for axis in range(2):
            side = coarse.tile_size[axis] * scale.ratio
            repetition = i32(at[:, axis] - nest[axis])
            distance = i32(offset[axis] + repetition * scale.tile_size[axis] + at[:, 2 + axis])
            beyond = distance // side
            axes.append((u32(nest[2 + axis] + beyond), distance - beyond * side))
        return stacked(axes[0][0], axes[1][0], axes[0][1], axes[1][1])

    def coarser_texel(self, scale, at):
        place = self.coarser_origin(scale, at)
        place[:, 2:] //= scale.ratio
        return place

    def coarser_position(self, scale, at):
        place = self.coarser_origin(scale, scale.texel_at(at))
        place[:, 2:] = (place[:, 2:] * 256 + (at[:, 2:] & 255)) // scale.ratio
        return place

    def position_in_scale(self, at, start, end):
        for number in range(start, end, -1):
            at = self.coarser_position(self.scales[number], at)
        return at

    def texels_in(self, number):
        size = F(1)
        for scale in reversed(self.scales[number + 1:]):
            size = size * F(scale.ratio)
        return size

    def fragment_center(self, scale, at, decision, source, labels):
        p, (w, h) = at[:, 2:], scale.tile_size
        moved = p + labels[:, :2]
        patch = scale.fetch("centers", decision.patch + scale.first_patch, 0)[:, :2] + decision.owner * np.array([w, h])
        d = p - patch
        a, b = source.matrix[:, 0], source.matrix[:, 1]
        x = ((a * d[:, 0] - b * d[:, 1] + 32768) >> 16) + labels[:, 0]
        y = ((b * d[:, 0] + a * d[:, 1] + 32768) >> 16) + labels[:, 1]
        square = ((source.scale >> 1) * (source.scale >> 1)) >> 15
        back_a, back_b = ((a >> 2) * square) >> 15, ((b >> 2) * square) >> 15
        turned = stacked(patch[:, 0] + ((back_a * x + back_b * y + 8192) >> 14),
                         patch[:, 1] + ((back_a * y - back_b * x + 8192) >> 14))
        return where((a == 65536) & (b == 0), moved, turned)

    def with_variation(self, scale, color, classes, share):
        entry = self.textures["color_table"][0, scale.first_class + classes]
        kept = share * entry[:, 3]
        return where(kept == 1, color, lerp(without_w(entry), color, kept))

    def detail_mean(self, scale, p, share):
        table = self.textures["color_table"][scale.number + 2]
        mean = where(share == 1, table[1][None, :], lerp(table[0], table[1], share))
        if not scale.bits & LOCAL_MEAN:
            return mean
        around = self.textures["local_mean"][p[:, 1] + scale.plane_row, p[:, 0]]
        return around + (mean - table[1])

    def shared_color(self, scale, at, share, alone):
        found = scale.shared_texel(at)
        these = np.flatnonzero(entries_after(found))
        if not len(these):
            return alone
        found, at, color = found[these], at[these], alone.copy()
        whole, _ = scale.shares_of("base_levels", found, at, False)
        dominant, _ = scale.with_members(value_row=scale.dominant_row).shares_of("base_levels", found, at, False)
        color[these] = in_proportion(whole, dominant, share[these])
        return color

    def shown_texel(self, scale, at, variation):
        share = scale.own_share(variation)
        decision = scale.decide(at)
        source = scale.source_of(at, decision)
        labels = np.zeros((len(at), 4), np.int64)
        if scale.number > 0 or scale.bits & COARSEST_LABELS:
            labels = scale.fetch("fragment_plane", source.nearest[:, 0], source.nearest[:, 1] + scale.plane_row)
        color = self.with_variation(scale, scale.layered_value("base", at, source), labels[:, 3], share)
        if scale.first_level == 0:
            color = self.shared_color(scale, at, share, color)
        weights = self.textures["color_table"][1]
        giving, taking = weights[scale.first_class + labels[:, 3], 1], weights[scale.first_class + labels[:, 2], 0]
        if scale.number == 0:
            return color, color, giving, taking, at
        anchor, middle = at.copy(), source.nearest
        if scale.mode == FRAGMENT:
            anchor[:, 2:] = self.fragment_center(scale, at, decision, source, labels)
            middle = (middle + labels[:, :2]) % np.array(scale.tile_size)
        return color, self.detail_mean(scale, middle, share), giving, taking, anchor

    def stacked_texel(self, finest, place, variation):
        at, share, weight = place, variation, np.ones(len(place), F)
        for number in range(finest, -1, -1):
            scale = self.scales[number]
            color, shown_mean, shown_giving, taking, anchor = self.shown_texel(scale, at, share)
            if number == finest:
                total, giving = color, shown_giving
            else:
                weight = weight * shown_giving
                total = total + (color - mean) * column(weight)
            if number == 0:
                break
            weight = weight * taking
            mean, share = shown_mean, scale.coarser_share(len(at))
            at = self.coarser_texel(scale, anchor)
        total = total.copy()
        total[:, 3] = giving
        return total

    def coarser_between(self, scale, at, coarser_share):
        coarse = self.scales[scale.number - 1]
        corner = coarse.upper_left_center(self.coarser_position(scale, at))
        start = coarse.texel_at(corner)
        around = [self.stacked_texel(coarse.number, coarse.neighbor(start, i), coarser_share) for i in range(4)]
        x, y = weight_of(corner[:, 2] & 255), weight_of(corner[:, 3] & 255)
        return lerp(lerp(around[0], around[1], x), lerp(around[2], around[3], x), y)

    def hard_texel(self, scale, at, variation):
        if scale.number == 0 or scale.mode != BETWEEN:
            return without_w(self.stacked_texel(scale.number, at, variation))
        color, mean, _, taking, _ = self.shown_texel(scale, at, variation)
        center = at.copy()
        center[:, 2:] = at[:, 2:] * 256 + 128
        coarse = self.coarser_between(scale, center, scale.coarser_share(len(at)))
        return color + (without_w(coarse) - mean) * column(taking * coarse[:, 3])

    def coarser_color(self, scale, center, coarser_share):
        return self.stacked_texel(scale.number - 1, self.coarser_texel(scale, center), coarser_share)

    # stack_levels.glsl

    def taken_by_fragments(self, scale, number, tile, share, coarser_share):
        total, i, active = zeros(len(number)), number + scale.share_row * 4096, np.arange(len(number))
        while len(active):
            fragment = self.textures["fragment_shares"][list_place(i, 0)[::-1]]
            mean = self.detail_mean(scale, stacked(fragment[:, 2] & 65535, fragment[:, 2] >> 16), share[active])
            center = tile[active].copy()
            center[:, 2], center[:, 3] = i32(fragment[:, 0] << 16) >> 16, fragment[:, 0] >> 16
            coarse = self.coarser_color(scale, center, coarser_share[active])
            part = (without_w(coarse) - mean) * column(coarse[:, 3] * floats_of(fragment[:, 1]))
            total[active] = total[active] + part
            more = fragment[:, 3] > 0
            active, i = active[more], fragment[more, 3]
        return total

    def coarser_mean(self, scale, corner, side, coarser_share):
        start, ratio, count = self.coarser_origin(scale, corner)[:, 2:], scale.ratio, len(corner)
        mean, y = zeros(count), np.zeros(count, np.int64)
        while (y < side[1]).any():
            rows = np.flatnonzero(y < side[1])
            height = np.minimum(ratio - (start[rows, 1] + y[rows]) % ratio, side[1] - y[rows])
            row, x = mean[rows], np.zeros(len(rows), np.int64)
            while (x < side[0]).any():
                these = np.flatnonzero(x < side[0])
                width = np.minimum(ratio - (start[rows[these], 0] + x[these]) % ratio, side[0] - x[these])
                texel = corner[rows[these]].copy()
                texel[:, 2] += x[these]
                texel[:, 3] += y[rows[these]]
                value = self.coarser_color(scale, texel, coarser_share[rows[these]])
                row[these] = lerp(row[these], value, weight_of(width * 256 // (x[these] + width)))
                x[these] += width
            mean[rows] = lerp(mean[rows], row, weight_of(height * 256 // (y[rows] + height)))
            y[rows] += height
        return mean

    def taken_as_whole(self, scale, block, grid, share, coarser_share):
        side = np.array([grid.side_256[0] >> 8, grid.side_256[1] >> 8])
        corner, middle = block.copy(), block.copy()
        corner[:, 2:] = block[:, 2:] * side
        middle[:, 2:] = corner[:, 2:] * 256 + np.array([grid.side_256[0] >> 1, grid.side_256[1] >> 1])
        around = np.zeros((len(block), 2), np.int64)
        if scale.bits & LOCAL_MEAN:
            around = scale.texel_source(scale.texel_at(middle)).nearest
        mean = self.detail_mean(scale, around, share)
        if scale.mode == TEXEL:
            coarse = self.coarser_mean(scale, corner, side, coarser_share)
        else:
            coarse = self.coarser_between(scale, middle, coarser_share)
        taken = without_w(coarse) - mean
        taken[:, 3] = coarse[:, 3]
        return taken

    def scale_block(self, scale, block, grid, variation):
        if grid.corner is not None:
            return self.listed_block(scale, block, grid, scale.found_block(block, grid), variation)
        if scale.first_level == 1:
            return self.hard_texel(scale, block, variation)
        found, value = scale.shared_texel(block), zeros(len(block))
        hard = entries_after(found) == 0
        if hard.any():
            value[hard] = self.hard_texel(scale, block[hard], variation[hard])
        if not hard.all():
            value[~hard] = self.listed_block(scale, block[~hard], grid, found[~hard], variation[~hard])
        return value

    def listed_block(self, scale, block, grid, found, variation):
        count, share = len(block), scale.own_share(variation)
        coarser_share = scale.coarser_share(count)
        by_fragment = scale.number > 0 and scale.mode == FRAGMENT
        whole, dominant, taken, weights = zeros(count), zeros(count), zeros(count), np.zeros((count, 4), np.int64)
        levels = self.textures["base_levels"]
        has_noise = scale.noise_step != 0 and grid.noise >= 0
        for _, has, number in scale.entries_of(found, block):
            for total, row in ((whole, scale.value_row), (dominant, scale.dominant_row)):
                x, y = list_place(number, row)
                total[has] = total[has] + levels[np.minimum(y, len(levels) - 1), x]
            if has_noise:
                weights[has] += scale.fetch("level_weights", *list_place(number, 0))
            if by_fragment:
                taken[has] = taken[has] + self.taken_by_fragments(scale, number, block[has], share[has], coarser_share[has])
        if has_noise:
            if grid.corner is None:
                whole = scale.with_noise(whole, weights, scale.noise_level_place(block, 0))
            else:
                place = scale.noise_level_place(scale.middle_of(block, grid), grid.noise)
                whole = scale.with_noise_level(whole, weights, place)
        own = in_proportion(whole, dominant, share)
        if scale.number > 0 and not by_fragment:
            coarse = self.taken_as_whole(scale, block, grid, share, coarser_share)
            taken = without_w(coarse) * column(own[:, 3] * coarse[:, 3])
        return without_w(own) + taken

    # stack_probes.glsl

    def scale_level(self, scale, at, level, variation, smooth_filter):
        value = zeros(len(at))
        for one in np.unique(level):
            these = np.flatnonzero(level == one)
            if one > scale.level_count:
                value[these] = without_w(scale.fetch("base_levels", np.array([0]), scale.value_row))
                continue
            grid, points, share = scale.grid_of(int(one)), at[these], variation[these]
            if smooth_filter == NEAREST:
                block = points.copy()
                for axis in range(2):
                    block[:, 2 + axis] //= grid.side_256[axis]
                value[these] = self.scale_block(scale, block, grid, share)
            else:
                value[these] = scale.between_blocks(
                    points, grid, lambda block, grid=grid, share=share: self.scale_block(scale, block, grid, share))
        return value

    def scale_probes(self, scale, probes, variation, smooth_filter):
        def value_of(at, these):
            level_256, share = probes.level_256[these], variation[these]
            value = self.scale_level(scale, at, level_256 >> 8, share, smooth_filter)
            between = np.flatnonzero(level_256 & 255)
            if len(between):
                beyond = self.scale_level(scale, at[between], (level_256[between] >> 8) + 1, share[between], smooth_filter)
                value[between] = lerp(value[between], beyond, weight_of(level_256[between] & 255))
            return value

        return scale.mean_of_probes(probes, value_of)

    def probes_value(self, number, probes, coarser_halvings, fading, variation, smooth_filter):
        """Of pixels that see one scale."""
        scale, count = self.scales[number], len(probes.at)
        value = zeros(count)
        near, far = np.flatnonzero(fading != 1), np.flatnonzero(fading != 0)
        if len(near):
            value[near] = self.scale_probes(scale, part_of(probes, near), variation[near], smooth_filter)
        if len(far):
            row = Probes(self.coarser_position(scale, probes.at[far]), probes.axis_256[far] // scale.ratio,
                         coarser_halvings[far], 0)
            coarse = self.scale_probes(self.scales[number - 1], row, np.ones(len(far), F), smooth_filter)
            value[far] = where(fading[far] == 1, coarse, lerp(value[far], coarse, fading[far]))
        return value

    # relief.glsl, stack_relief.glsl

    def height_at(self, at, level):
        scale = self.scales[0].with_members(value_row=0)
        return scale.level_value("height_plane", HEIGHT, "height_levels", at, level)[:, 0]

    def ray_point(self, at, slope, level):
        fallen = F(self.relief_range[2]) - level
        return ground_position(self.scales[0], at, slope[0] * fallen, slope[1] * fallen)

    def relief_height(self, at, slope, steps, level):
        top, bottom, drawn = (F(x) for x in self.relief_range[:3])
        still = np.full(len(at), drawn, F)
        moving = np.flatnonzero((top > bottom) & ((slope[0] != 0) | (slope[1] != 0)))
        if not len(moving):
            return still
        at, slope, steps, level = at[moving], [s[moving] for s in slope], steps[moving], level[moving]
        count = len(at)
        stride = (top - bottom) / steps.astype(F)
        above, below, searching = np.full(count, top, F), np.full(count, bottom, F), np.ones(count, bool)
        for i in range(1, int(steps.max()) + 1):
            these = np.flatnonzero(searching & (i <= steps))
            if not len(these):
                break
            height = np.where(i == steps[these], bottom, top - stride[these] * F(i))
            met = self.height_at(self.ray_point(at[these], [s[these] for s in slope], height), level[these]) >= height
            below[these[met]] = height[met]
            searching[these[met]] = False
            above[these[~met]] = height[~met]
        for _ in range(self.relief_steps[1]):
            middle = (above + below) * F(0.5)
            met = self.height_at(self.ray_point(at, slope, middle), level) >= middle
            below, above = np.where(met, middle, below), np.where(met, above, middle)
        still[moving] = below
        return still

    def relief_at(self, pixel, way, width):
        coarsest = self.scales[0]
        most, least, drawn, _ = (F(x) for x in self.relief_range)
        left = np.clip(F(self.relief_depth) * (most - least) / width - F(1), F(0), F(1))
        depth = F(self.relief_depth) * left
        slope = [np.clip(w * depth, F(-2048), F(2048)) for w in way]
        passed = np.sqrt(sum_of_squares(*slope)) * (most - least)
        wanted = passed * F(2) / np.maximum(width, F(1)) + F(1)
        steps = np.where(wanted < F(self.relief_steps[0]), truncated(wanted), self.relief_steps[0])
        level_256 = log2_256(width)
        level = np.where(level_256 < 0, 0, level_256 >> 8)
        fallen = drawn - self.relief_height(pixel.at, slope, steps, level)
        moved = [s * fallen for s in slope]
        light = np.full(len(width), 4096, np.int64)
        if self.relief_kind:
            at = ground_position(coarsest, pixel.at, *moved)
            probes = Probes(at, pixel.axis_256, pixel.halvings,
                            np.clip(level_256, 0, 256 * (coarsest.level_count + 1)))
            mean = coarsest.with_members(value_row=0).probes_value("height_plane", self.relief_kind, "height_levels", probes)
            light = truncated(self.shade(mean) * F(4096) + F(0.5))
        return moved, light

    def shade(self, mean):
        x, y, everywhere, _ = (F(v) for v in self.relief_light)
        up = F(1 if self.relief_kind == RELIEF_OPENGL else -1)
        facing = mean[:, 3] + mean[:, 1] * x - mean[:, 2] * up * y
        return everywhere + (F(1) - everywhere) * np.where(facing > 0, facing, F(0))

    def moved_in_scale(self, number, at, moved):
        finer = self.texels_in(0) / self.texels_in(number)
        return ground_position(self.scales[number], at, moved[0] * finer, moved[1] * finer)

    # Whole pictures.

    def window(self, at, view, smooth_filter, slant):
        """`at` are positions of the finest scale."""
        number, count = view["scale"], len(at)
        probes = Probes(self.position_in_scale(at, self.scale_count - 1, number), (0, 0), 0, view["level_256"])
        light = np.full(count, 4096, np.int64)
        if self.relief_depth:
            pixel = Probes(self.position_in_scale(probes.at, number, 0), (0, 0), 0, 0)
            width = np.full(count, slant[2], F)
            moved, light = self.relief_at(pixel, [np.full(count, s, F) for s in slant[:2]], width)
            probes = Probes(self.moved_in_scale(number, probes.at, moved), (0, 0), 0, view["level_256"])
        value = self.probes_value(number, probes, np.zeros(count, np.int64), np.full(count, view["fading"], F),
                                  np.full(count, view["variation"], F), smooth_filter)
        return lit(value, light)

    def stack_scale(self, width):
        """As the text's: the scale of each pixel, level_256, fading and variation in 1/256."""
        count = len(width)
        number, level = np.full(count, self.scale_count - 1), log2_256(width)
        fading, variation, searching = np.zeros(count, np.int64), np.full(count, 256), np.ones(count, bool)
        for scale in reversed(self.scales[1:]):
            ratio_256 = int(log2_256(np.array([scale.ratio], F))[0])
            stops = searching & (level < ratio_256)
            fades = stops & (level > 0)
            faded = level * 256 // ratio_256
            fading = np.where(fades, faded, fading)
            variation = np.where(fades, np.maximum(256 - scale.fade_256 * faded // 256, 0), variation)
            searching = searching & ~stops
            level = np.where(searching, level - ratio_256, level)
            number = np.where(searching, scale.number - 1, number)
        return number, level, fading, variation

    def plane(self, eye, below, ground, height):
        """`below` is the position under the camera, once for each pixel; those that hit nothing have any color."""
        ellipse = Ellipse(ground.right, ground.down)
        width = eye.probe_width(ellipse)
        found = self.stack_scale(np.where(ground.hits, width, F(1)))
        value = zeros(len(below))
        for number in np.unique(found[0][ground.hits]):
            these = np.flatnonzero(ground.hits & (found[0] == number))
            value[these] = self.plane_of_scale(int(number), eye, below[these], rows(ground, these), rows(ellipse, these),
                                               width[these], [f[these] for f in found], height)
        return value

    def plane_of_scale(self, number, eye, below, ground, ellipse, width, found, height):
        scale, size, count = self.scales[number], self.texels_in(number), len(below)
        last_256 = 256 * scale.level_count if number > 0 else 256 * (scale.level_count + 1)
        level = np.zeros(count, np.int64) if eye.filter < TRILINEAR else np.clip(found[1], 0, last_256)
        to = [part / size for part in ground.to]
        reached = within_reach(*to)
        level = np.where(reached, level, last_256)
        to = [np.where(reached, part, F(0)) for part in to]
        at = ground_position(scale, self.position_in_scale(below, self.scale_count - 1, number), *to)
        light, halvings, coarser = np.full(count, 4096, np.int64), np.zeros(count, np.int64), np.zeros(count, np.int64)
        axis, small = np.zeros((count, 2), np.int64), reached & ~(ellipse.squared < F(1e-30))
        if self.relief_depth and reached.any():
            whole = self.texels_in(0)
            to_coarsest = [np.where(reached, part / whole, F(0)) for part in ground.to]
            point = ground_position(self.scales[0], self.position_in_scale(below, self.scale_count - 1, 0), *to_coarsest)
            major, wide = ellipse.major / whole, width / whole
            in_row = reached & (major < F(65535)) & (ellipse.squared > F(1e-30))
            pixel = Probes(point, np.where(in_row[:, None], axis_of(ellipse, whole), 0),
                           np.where(in_row, eye.halvings_of(major, np.maximum(wide, F(1))), 0), 0)
            r = np.flatnonzero(reached)
            moved, lights = self.relief_at(part_of(pixel, r), [ground.to[i][r] / height for i in range(2)], wide[r])
            at[r] = self.moved_in_scale(number, at[r], moved)
            light[r] = lights
        if eye.filter >= TRILINEAR:
            major, wide = ellipse.major / size, width / size
            small &= ~(major > F(65535))
            least = F(scale.ratio if number > 0 else 1)
            halvings = np.where(small, eye.halvings_of(major, np.maximum(wide, F(1))), 0)
            coarser = np.where(small, eye.halvings_of(major, np.maximum(wide, least)), 0)
            axis = np.where(small[:, None], axis_of(ellipse, size), 0)
        value = self.probes_value(number, Probes(at, axis, halvings, level), coarser, weight_of(found[2]),
                                  weight_of(found[3]), eye.filter)
        return lit(value, light)


def lit(value, light_4096):
    return value * column(light_4096.astype(F) * F(0.000244140625))


def part_of(probes, these):
    return Probes(probes.at[these], probes.axis_256[these], probes.halvings[these], probes.level_256[these])


def rows(record, these):
    """Some pixels of a Ground or an Ellipse."""
    part = object.__new__(type(record))
    for name, value in vars(record).items():
        setattr(part, name, tuple(v[these] for v in value) if isinstance(value, tuple) else value[these])
    return part
