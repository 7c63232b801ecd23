"""Reads a bundle as formats/README.md specifies it, and prepares what a window with hard borders reads of level 0."""

import hashlib
import json
import os

import numpy as np

from evaluate import NORMAL_DIRECTX, NORMAL_OPENGL, HEIGHT, PLAIN, STRUCTURE, Tile
from exr import read_exr

XYZ_FROM_LINEAR = np.array([[0.41239079926595934, 0.357584339383878, 0.1804807884018343],
                            [0.21263900587151027, 0.715168678767756, 0.07219231536073371],
                            [0.01933081871559182, 0.11919477979462598, 0.9505321522496607]])
LINEAR_FROM_XYZ = [[3.2409699419045226, -1.537383177570094, -0.4986107602930034],
                   [-0.9692436362808796, 1.8759675015077202, 0.04155505740717559],
                   [0.05563007969699366, -0.20397695888897652, 1.0569715142428786]]


def linear_from_luv(luv):
    """Of float32 colors, in double, rounded to float32."""
    white_x, white_y, white_z = ((row[0] + row[1]) + row[2] for row in XYZ_FROM_LINEAR)
    denominator = white_x + 15 * white_y + 3 * white_z
    white_u, white_v = 4 * white_x / denominator, 9 * white_y / denominator
    l, u, v = (luv[..., i].astype(np.float64) for i in range(3))
    root = (l + 16) / 116
    y = np.where(l <= 8, l / (24389.0 / 27.0), root * root * root) * white_y
    with np.errstate(divide="ignore", invalid="ignore"):
        u = u / (13.0 * l) + white_u
        v = np.maximum(v / (13.0 * l) + white_v, 1 / 64)
        x = y * 9 * u / (4 * v)
        z = y * (12 - 3 * u - 20 * v) / (4 * v)
        rgb = [(row[0] * x + row[1] * y + row[2] * z).astype(np.float32) for row in LINEAR_FROM_XYZ]
    return np.where((luv[..., 0] == 0)[..., None], np.float32(0), np.stack(rgb, axis=-1))


class Bundle:
    def __init__(self, path):
        self.path = path
        with open(os.path.join(path, "bundle.json"), encoding="utf-8") as file:
            self.manifest = json.load(file)
        if self.manifest["asset"]["kind"] != "texbake.bundle" or self.manifest["asset"]["semantics"] != 1:
            raise ValueError(f"{path}: not a bundle of semantics 1")
        self.files = {}
        self.scale = self.manifest["scales"][-1]

    def plane(self, reference):
        """Channels in the order of the manifest, along the last axis. Checks the hash."""
        if reference["file"] not in self.files:
            self.files[reference["file"]] = read_exr(os.path.join(self.path, reference["file"]))
        part = self.files[reference["file"]][reference["part"]]
        channels = [part.planes[name] for name in reference["channels"]]
        canonical = np.stack(channels, axis=1)  # row by row, in each channel by channel
        if hashlib.sha256(canonical.tobytes()).hexdigest() != reference["pixelHash"]:
            raise ValueError(f"{self.path}: the pixels of {reference['part']} are not those that were written")
        return np.stack(channels, axis=-1)

    def scale_plane(self, name):
        return self.plane(self.scale["planes"][name])

    def base(self):
        planes, palette = self.scale["planes"], self.scale.get("palette")
        if "structure" in planes:
            return self.scale_plane("structure").astype(np.float32)
        if "exemplar" in planes:
            return self.scale_plane("exemplar").astype(np.float32)
        dominant = np.array([c["dominant"] for c in palette], np.float32)
        direction = np.array([c["variation"] for c in palette], np.float32)
        index = self.scale_plane("index")[..., 0].astype(np.int64)
        variation = self.scale_plane("variation")[..., 0].astype(np.float32)
        color = linear_from_luv(dominant[index] + direction[index] * variation[..., None])
        return np.maximum(color, np.float32(0)).astype(np.float16).astype(np.float32)

    def map_plane(self, name):
        """Its values and kind."""
        for one in self.scale.get("maps", []):
            if one["name"] == name:
                kinds = {"opengl": NORMAL_OPENGL, "directx": NORMAL_DIRECTX}
                return self.plane(one["plane"]).astype(np.float32), kinds.get(one["convention"], PLAIN)
        return self.scale_plane("height"), HEIGHT

    def tile(self, map_name, seed):
        """A Tile and the kind of its base. Levels of detail are not prepared: see planes.py."""
        width, height = self.scale["size"]
        values, kind = self.map_plane(map_name) if map_name else (self.base(), PLAIN)
        base = np.zeros((height, width, 4), np.float32)
        base[..., :values.shape[2]] = values
        textures = {"base": base, "patch_plane": np.zeros((height, width, 2), np.int64)}
        textures["patch_plane"][..., 1] = 5
        uniforms = {"tile_size": (width, height), "seed": seed, "noise_step": 0, "noise_root": 0, "noise_log2": (0, 0),
                    "first_level": 1, "level_count": 0}
        self.add_patches(textures)
        uniforms["content_count"] = textures["contents"].shape[1]
        if "noise" in self.manifest and not map_name:
            self.add_noise(textures, uniforms)
            kind = STRUCTURE
        return Tile(textures, uniforms), kind

    def add_patches(self, textures):
        width, height = self.scale["size"]
        if "patches" in self.scale:
            patch = self.scale_plane("patch").astype(np.int64)
            owner = patch[..., 1]
            textures["patch_plane"] = np.stack([patch[..., 0], owner % 3 + 4 * (owner // 3)], axis=-1)
        centers = [p["center"] for p in self.scale.get("patches", [{"center": [0, 0]}])]
        textures["centers"] = np.array([[[x, y, 0, 0] for x, y in centers]], np.int64)
        identity = {"translation": [0, 0], "scale": 1.0, "matrix": [65536, 0]}
        contents = self.scale.get("contents", [[identity]] * len(centers))
        textures["contents"] = np.array(
            [[[c["translation"][0] % width + 65536 * (c["translation"][1] % height), round(65536 * c["scale"]), *c["matrix"]]
              for c in row] for row in contents], np.int64)

    def add_noise(self, textures, uniforms):
        noise = self.manifest["noise"]
        textures["masks"] = np.zeros(textures["base"].shape[:2] + (4,), np.int64)
        masks = self.scale_plane("masks").astype(np.float32)
        textures["masks"][..., :masks.shape[2]] = masks * np.float32(2048)
        tiles = [self.plane(one["tile"]).astype(np.float32) for one in noise["noises"]]
        textures["noise_tiles"] = np.pad(np.concatenate(tiles), ((0, 0), (0, 0), (0, 1)))
        log2 = noise["tileSize"].bit_length() - 1
        uniforms.update(noise_step=noise["rowStep"], noise_root=int(noise["space"] == "root"), noise_log2=(log2, log2))
