"""The meaning of shaders/perspective.glsl and stack_perspective.glsl up to the exact path, in numpy float32."""

import numpy as np

from evaluate import ANISOTROPIC, F, TRILINEAR, Probes, log2_256, stacked, zeros


def sum_of_squares(a, b):
    return a * a + b * b


def crossed(a, b, c, d):
    return a * b - c * d


def truncated(x):
    return x.astype(np.int64)


class Ground:
    """What pixels see of the plane."""

    def __init__(self, camera, x, y):
        corner, right, down = camera["corner"], camera["right"], camera["down"]
        dx, dy, dz = (corner[i] + (right[i] * x + down[i] * y) for i in range(3))
        self.hits = dz > F(0.000001)
        depth = np.where(self.hits, dz, F(1))
        reach = camera["height"] / depth
        self.to = (dx * reach, dy * reach)
        change = reach / depth
        self.right = tuple(crossed(right[i], dz, d, right[2]) * change for i, d in ((0, dx), (1, dy)))
        self.down = tuple(crossed(down[i], dz, d, down[2]) * change for i, d in ((0, dx), (1, dy)))


class Ellipse:
    def __init__(self, right, down):
        xx, yy = sum_of_squares(right[0], down[0]), sum_of_squares(right[1], down[1])
        xy = crossed(right[0], right[1], -down[0], down[1])
        half_difference = (xx - yy) * F(0.5)
        root = np.sqrt(sum_of_squares(half_difference, xy))
        self.major = np.sqrt((xx + yy) * F(0.5) + root)
        self.minor = np.abs(crossed(right[0], down[1], right[1], down[0])) / self.major
        self.direction = (np.where(xx < yy, xy, half_difference + root), np.where(xx < yy, root - half_difference, xy))
        self.squared = sum_of_squares(*self.direction)


class Eye:
    """The functions that depend on the filter."""

    def __init__(self, view_filter):
        self.filter = view_filter
        self.most_halvings = 4 if view_filter == ANISOTROPIC else 0

    def probe_width(self, ellipse):
        least = ellipse.major / F(1 << self.most_halvings)
        return np.where(ellipse.minor < least, least, ellipse.minor)

    def halvings_of(self, major, width):
        halvings, seen = np.zeros(len(major), np.int64), width.copy()
        for _ in range(self.most_halvings):
            more = seen < major * F(0.999)
            seen = np.where(more, seen * F(2), seen)
            halvings += more
        return halvings


def axis_of(ellipse, size):
    with np.errstate(divide="ignore", invalid="ignore"):
        scale = ellipse.major * F(256) / np.sqrt(ellipse.squared) / size
        return stacked(*(truncated(np.nan_to_num(d * scale)) for d in ellipse.direction))


def within_reach(x, y):
    return (np.abs(x) < F(4000000)) & (np.abs(y) < F(4000000))


def ground_position(tile, below, x, y):
    return tile.moved_position(below, truncated(np.floor(x * F(256) + F(0.5))), truncated(np.floor(y * F(256) + F(0.5))))


def plane_probes(tile, eye, below, ground):
    """Of the pixels that hit the plane and those that do not, as sight_at."""
    count = len(ground.hits)
    last_256 = 256 * (tile.level_count + 1)
    reached = ground.hits & within_reach(*ground.to)
    by = [np.where(reached, part, F(0)) for part in ground.to]
    at = np.where(reached[:, None], ground_position(tile, below, *by), below)
    level, halvings, axis = np.where(reached, 0, last_256), np.zeros(count, np.int64), np.zeros((count, 2), np.int64)
    if eye.filter >= TRILINEAR:
        ellipse = Ellipse(ground.right, ground.down)
        width = eye.probe_width(ellipse)
        level = np.where(reached, np.clip(log2_256(width), 0, last_256), level)
        rows = reached & ~((ellipse.major > F(65535)) | (ellipse.squared < F(1e-30)))
        halvings = np.where(rows, eye.halvings_of(ellipse.major, np.maximum(width, F(1))), 0)
        axis = np.where(rows[:, None], axis_of(ellipse, F(1)), 0)
    return Probes(at, axis, halvings, level)
