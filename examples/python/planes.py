"""Reads what `texbake export --planes` wrote: pages/planes.schema.json."""

import json
import os

import numpy as np

from evaluate import Tile
from exr import read_exr
from stack import Stack


class Planes:
    def __init__(self, folder):
        self.folder, self.files = folder, {}
        with open(os.path.join(folder, "planes.json"), encoding="utf-8") as file:
            listed = json.load(file)
        if listed["kind"] != "texbake.planes" or listed["semantics"] != 1:
            raise ValueError(f"{folder}: not planes of semantics 1")
        self.bindings = listed["bindings"]

    def texture(self, listed):
        name = listed["file"]
        if name not in self.files:
            (part,) = read_exr(os.path.join(self.folder, name)).values()
            components = np.stack([part.planes[c] for c in "RGBA" if c in part.planes], axis=-1)
            if "F" in listed["format"]:
                self.files[name] = components.astype(np.float32)
            else:
                is_signed = not listed["format"].endswith("UI")
                self.files[name] = (components.astype(np.int32) if is_signed else components).astype(np.int64)
        return self.files[name]

    def binding(self, name=None, map_name=None):
        found = [b for b in self.bindings if (b["name"] == name if name else b["map"] == map_name)][0]
        return {n: self.texture(t) for n, t in found["textures"].items()}, dict(found["uniforms"])

    def has(self, name):
        return any(b["name"] == name for b in self.bindings)

    def tile(self, map_name, uniforms, deformed=False):
        """A Tile and the kind of its base."""
        name = "deformed" if deformed and self.has("deformed") else None if map_name else "color"
        textures, bound = self.binding(name, map_name)
        bound.update(uniforms)
        return Tile(textures, bound), bound["plane_kind"]

    def stack(self, uniforms):
        textures, bound = self.binding("stack")
        bound.update(uniforms)
        for decided in ("tile_size", "content_count", "seed", "noise_step"):
            bound.pop(decided, None)
        return Stack(textures, bound)
