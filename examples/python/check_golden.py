#!/usr/bin/env python3
"""Draws the golden frames of tests/golden/bundles and counts the samples whose bits differ.

usage: check_golden.py GOLDEN TEXBAKE WORK    GOLDEN: tests/golden, TEXBAKE: the program, WORK: a folder to fill
"""

import json
import os
import subprocess
import sys
import time

try:
    import numpy as np
except ImportError:
    print("SKIPPED: the reference reader needs numpy (Debian: python3-numpy)", file=sys.stderr)
    sys.exit(77)

from exr import read_exr
from planes import Planes
from view import draw


def frame_of(path):
    (part,) = read_exr(path).values()
    names = "RGB" if "R" in part.planes else [name for name, _ in part.channels]
    return np.stack([part.planes[name] for name in names], axis=-1).astype(np.float32)


def exporter(texbake, bundle, camera, work):
    """Exports when it is first called."""
    def planes():
        folder = os.path.join(work, os.path.basename(bundle) + ".planes")
        with open(camera, encoding="utf-8") as file:
            relief = list(json.load(file).values())[0].get("relief", 0)
        subprocess.run([texbake, "export", bundle, "--planes", "--relief", str(relief), "-o", folder, "-q"], check=True,
                       stdout=subprocess.DEVNULL)
        return Planes(folder)

    return planes


def main(golden, texbake, work):
    os.makedirs(work, exist_ok=True)
    folder, failed, count = os.path.join(golden, "bundles"), 0, 0
    print(f"{'frame':34} {'from':7} {'pixels':>9} {'differing samples':>18} {'seconds':>8}")
    for name in sorted(os.listdir(folder)):
        if not name.endswith(".json"):
            continue
        stem, camera = name[:-len(".json")], os.path.join(folder, name)
        bundle = os.path.join(folder, stem.split("-")[0] + ".texbundle")
        expected = frame_of(os.path.join(folder, stem + ".exr"))
        size = (expected.shape[1], expected.shape[0])
        begin = time.monotonic()
        found, source = draw(bundle, exporter(texbake, bundle, camera, work), camera, size)
        found = found[..., :expected.shape[2]]
        differing = int((found.view(np.uint32) != np.ascontiguousarray(expected).view(np.uint32)).sum())
        print(f"{stem:34} {source:7} {size[0]:4} x{size[1]:3} {differing:18} {time.monotonic() - begin:8.2f}")
        if differing:
            y, x, c = np.argwhere(found.view(np.uint32) != np.ascontiguousarray(expected).view(np.uint32))[0]
            print(f"  first: pixel ({x}, {y}), channel {c}: expected {expected[y, x]}, found {found[y, x]}")
        failed, count = failed + (differing > 0), count + 1
    if failed or not count:
        print(f"FAILED: {failed} of {count} frames differ", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:4]) if len(sys.argv) == 4 else print(__doc__, file=sys.stderr) or 2)
