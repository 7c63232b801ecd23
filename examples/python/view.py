"""What a camera file (cli/camera.schema.json) shows, as uniforms, and pictures of that."""

import json
import math
from fractions import Fraction

import numpy as np

from bundle import Bundle
from deform import Deformed
from evaluate import ANISOTROPIC, BILINEAR, F, NEAREST, TRILINEAR, u32, zeros
from perspective import Eye, Ground, plane_probes

FILTERS = {"nearest": NEAREST, "bilinear": BILINEAR, "trilinear": TRILINEAR, "anisotropic": ANISOTROPIC}
SKY = [0.45, 0.55, 0.7, 0]


def rounded(x):
    """To the nearest integer, halves away from zero."""
    return math.floor(x + 0.5) if x >= 0 else -math.floor(-x + 0.5)


def read_camera(path):
    """Numbers of "origin" keep all their digits."""
    with open(path, encoding="utf-8") as file:
        text = file.read()
    camera, exact = json.loads(text), json.loads(text, parse_int=str, parse_float=str)
    (kind, view), = camera.items()
    view["origin"] = [Fraction(n) for n in exact[kind].get("origin", ["0", "0"])]
    return kind, view


def origin_of(view, tile_size):
    """Repetition and offset in 1/256 texel, halves up."""
    tiles, offsets = [], []
    for texels, side in zip(view["origin"], tile_size):
        place = math.floor(texels * 256 + Fraction(1, 2))
        tiles.append(place // (side * 256) % 2**32)
        offsets.append(place % (side * 256))
    return tiles + offsets


def level_256_of(texels, view_filter, level_count):
    if view_filter < TRILINEAR or texels <= 1:
        return 0
    return min(rounded(256 * math.log2(texels)), 256 * (level_count + 1))


def matrix_of(view):
    turn = view.get("rotate", 0) * 0.017453292519943295
    across, down = view.get("stretch", [1, 1])
    c, s = math.cos(turn), math.sin(turn)
    return [rounded(x * 65536) for x in (c / across, s / across, -s / down, c / down)]


def footprint_of(matrix, texels, most_halvings, level_count):
    """deform_axis_256 and deform_probes of a pixel."""
    size = max(1.0, texels) / 65536
    xx, xy, yx, yy = (m * size for m in matrix)
    across, along, both = xx * xx + xy * xy, yx * yx + yy * yy, xx * yx + xy * yy
    half_difference = (across - along) / 2
    root = math.sqrt(half_difference * half_difference + both * both)
    major = math.sqrt((across + along) / 2 + root)
    minor = abs(xx * yy - xy * yx) / major if major > 0 else 0
    width = max(minor, major / (1 << most_halvings))
    level_256 = min(rounded(256 * math.log2(width)), 256 * (level_count + 1)) if width > 1 else 0
    halvings, seen = 0, max(1.0, width)
    while halvings < most_halvings and seen < major * 0.999:
        halvings, seen = halvings + 1, seen * 2
    if halvings == 0:
        return [0, 0], [level_256, 0]
    x, y = (both, root - half_difference) if across < along else (half_difference + root, both)
    scale = 256 * major / math.sqrt(x * x + y * y)
    return [rounded(x * scale), rounded(y * scale)], [level_256, halvings]


def deformation_of(view, tile_size, level_count):
    """The uniforms of section 8; nothing where the window is not deformed."""
    matrix, amplitude = matrix_of(view), rounded(view.get("turbulence", 0) * 256)
    if matrix == [65536, 0, 0, 65536] and amplitude == 0:
        return {}
    origin = origin_of(view, tile_size)
    corner = [offset >> 8 for offset in origin[2:]]
    at = [(tile - 2**32 if tile >= 2**31 else tile) * side + p for tile, side, p in zip(origin, tile_size, corner)]
    to_tile, to_texel, to_rest = [], [], []
    for axis in range(2):
        to_x, to_y = matrix[2 * axis:2 * axis + 2]
        place = to_x * at[0] + to_y * at[1] + ((to_x + to_y) >> 1)
        to_tile.append((place >> 16) // tile_size[axis] % 2**32)
        to_texel.append((place >> 16) % tile_size[axis])
        to_rest.append(place & 65535)
    view_filter = FILTERS[view.get("filter", "trilinear")]
    axis_256, probes = [0, 0], [0, 0]
    if view_filter >= TRILINEAR:
        axis_256, probes = footprint_of(matrix, step_of(view) / 256, 4 if view_filter == ANISOTROPIC else 0, level_count)
    return {"deformed": 1, "deform_matrix": matrix, "deform_from_tile": origin[:2], "deform_from": corner,
            "deform_to_tile": to_tile, "deform_to": to_texel + to_rest, "deform_axis_256": axis_256,
            "deform_probes": probes, "turbulence": [amplitude, view.get("turbulence-cell", 64).bit_length() - 1]}


def step_of(view):
    return rounded(view.get("step", 1) * 256)


def is_deformed(view):
    return matrix_of(view) != [65536, 0, 0, 65536] or rounded(view.get("turbulence", 0) * 256) != 0


def pixels_of(size):
    y, x = np.mgrid[0:size[1], 0:size[0]]
    return x.ravel().astype(np.int64), y.ravel().astype(np.int64)


def draw_window(tile, kind, view, size):
    """Of one scale."""
    view_filter = FILTERS[view.get("filter", "trilinear")]
    tile = tile.with_members(seed=view.get("seed", 0))
    at = tile.pixel_position(origin_of(view, tile.tile_size), step_of(view), *pixels_of(size))
    level_256 = level_256_of(step_of(view) / 256, view_filter, tile.level_count)
    deformation = deformation_of(view, tile.tile_size, tile.level_count)
    if deformation:
        smooth_filter = NEAREST if view_filter == NEAREST else BILINEAR
        return Deformed(tile.with_members(**deformation)).value("base", kind, "base_levels", at, smooth_filter, level_256)
    if view_filter == NEAREST:
        return tile.texel_value("base", kind, "base_levels", tile.texel_at(at))
    return tile.trilinear_value("base", kind, "base_levels", at, level_256)


def camera_of(view, size):
    """The uniforms of perspective_bindings.glsl."""
    degree = 0.017453292519943295
    pitch, yaw = view.get("pitch", 20) * degree, view.get("yaw", 0) * degree
    half = view.get("fov", 50) * 0.5 * degree
    pixel = 2 * math.sin(half) / math.cos(half) / size[1]
    ahead = [math.sin(yaw), -math.cos(yaw)]
    cos_pitch, sin_pitch = math.cos(pitch), math.sin(pitch)
    right = [-ahead[1] * pixel, ahead[0] * pixel, 0]
    down = [-sin_pitch * ahead[0] * pixel, -sin_pitch * ahead[1] * pixel, cos_pitch * pixel]
    forward = [cos_pitch * ahead[0], cos_pitch * ahead[1], sin_pitch]
    corner = [forward[i] - right[i] * size[0] * 0.5 - down[i] * size[1] * 0.5 for i in range(3)]
    return {"corner": [F(n) for n in corner], "right": [F(n) for n in right], "down": [F(n) for n in down],
            "height": F(view.get("camera-height", 1024))}


def ground_of(view, size):
    x, y = pixels_of(size)
    camera = camera_of(view, size)
    return camera, Ground(camera, x.astype(F) + F(0.5), y.astype(F) + F(0.5))


def below(view, tile_size, count):
    return np.tile(np.array(origin_of(view, tile_size), np.int64), (count, 1))


def with_sky(value, hits, sky):
    return np.where(hits[:, None], value, np.array(sky, F))


def draw_plane(tile, kind, view, size):
    """Of one scale."""
    eye = Eye(FILTERS[view.get("filter", "trilinear")])
    tile = tile.with_members(seed=view.get("seed", 0))
    _, ground = ground_of(view, size)
    probes = plane_probes(tile, eye, below(view, tile.tile_size, len(ground.hits)), ground)
    if eye.filter == NEAREST:
        value = tile.texel_value("base", kind, "base_levels", tile.texel_at(probes.at))
    else:
        value = tile.probes_value("base", kind, "base_levels", probes)
    return with_sky(value, ground.hits, zeros(1)[0] if view.get("map") else SKY)


def nesting_at(stack, reference):
    """nesting and nesting_offset."""
    nesting, offsets, tile = [[0] * 4] * 8, [[0] * 2] * 8, list(reference)
    for scale in reversed(stack.scales[1:]):
        outer, inside = [], []
        for axis in range(2):
            repetition = tile[axis] - 2**32 if tile[axis] >= 2**31 else tile[axis]
            side = stack.scales[scale.number - 1].tile_size[axis] * scale.ratio
            corner = repetition * scale.tile_size[axis]
            outer.append(corner // side % 2**32)
            inside.append(corner % side)
        nesting[scale.number], offsets[scale.number], tile = tile + outer, inside, outer
    return {"nesting": nesting, "nesting_offset": offsets}


def scale_view(stack, view):
    """Which scale a window shows."""
    texels, finest = step_of(view) / 256, stack.scale_count - 1
    number, wide = finest, texels
    while number > 0 and wide >= stack.scales[number].ratio:
        wide /= stack.scales[number].ratio
        number -= 1
    scale, shown = stack.scales[number], {"scale": number, "fading": F(0), "variation": F(1)}
    if number > 0 and wide > 1:
        shown["fading"] = F(math.log(wide) / math.log(scale.ratio))
        shown["variation"] = max(F(0), F(1) - F(scale.fade_256 / 256) * shown["fading"])
    level = level_256_of(wide, FILTERS[view.get("filter", "trilinear")], scale.level_count)
    shown["level_256"] = min(level, 256 * scale.level_count) if number > 0 else level
    return shown


def draw_stack(planes, kind, view, size):
    plain = planes.stack({"stack_seed": view.get("seed", 0)})
    finest = plain.scales[-1].tile_size
    origin = origin_of(view, finest)
    uniforms = {"stack_seed": view.get("seed", 0), **nesting_at(plain, origin[:2])}
    if not view.get("relief"):
        uniforms["relief_depth"] = 0.0
    stack = planes.stack(uniforms)
    view_filter = FILTERS[view.get("filter", "trilinear")]
    if kind == "plane":
        camera, ground = ground_of(view, size)
        value = stack.plane(Eye(view_filter), below(view, finest, len(ground.hits)), ground, camera["height"])
        return with_sky(value, ground.hits, SKY)
    at = stack.scales[-1].pixel_position(origin, step_of(view), *pixels_of(size))
    way = [F(n) for n in view.get("view-direction", [0, 0, 1])]
    slant = [-way[0] / way[2], -way[1] / way[2], F(step_of(view) / (256 * float(stack.texels_in(0))))]
    return stack.window(at, scale_view(stack, view), NEAREST if view_filter == NEAREST else BILINEAR, slant)


def from_bundle(bundle, kind, view):
    """Whether what is prepared from the bundle alone is enough: no levels, no soft borders, one scale."""
    near = step_of(view) <= 256 or FILTERS[view.get("filter", "trilinear")] < TRILINEAR
    hard = bundle.scale.get("softBorder", 0) == 0
    one = len(bundle.manifest["scales"]) == 1 or view.get("map")
    deformed = kind == "window" and is_deformed(view)
    return kind == "window" and near and hard and bool(one) and not view.get("relief") and not deformed


def draw(bundle_path, planes, camera_path, size):
    """The picture, rows x columns x 3, and what it was drawn from. `planes` is called where the bundle is not enough."""
    kind, view = read_camera(camera_path)
    bundle = Bundle(bundle_path)
    if from_bundle(bundle, kind, view):
        tile, plane_kind = bundle.tile(view.get("map"), view.get("seed", 0))
        return shaped(draw_window(tile, plane_kind, view, size), size), "bundle"
    exported = planes()
    if not view.get("map") and (len(bundle.manifest["scales"]) > 1 or view.get("relief")):
        return shaped(draw_stack(exported, kind, view, size), size), "planes"
    deformed = kind == "window" and is_deformed(view)
    tile, plane_kind = exported.tile(view.get("map"), {}, deformed)
    drawn = draw_plane if kind == "plane" else draw_window
    return shaped(drawn(tile, plane_kind, view, size), size), "planes"


def shaped(value, size):
    return value[:, :3].reshape(size[1], size[0], 3)
