"""Reads OpenEXR files as bundles and exports of planes have them: scan lines, ZIP or uncompressed, one part or several."""

import struct
import zlib

import numpy as np

MAGIC = 20000630
MULTI_PART = 0x1000
LINES_OF = {0: 1, 2: 1, 3: 16}  # of a chunk: uncompressed, ZIPS, ZIP
TYPES = {0: np.dtype("<u4"), 1: np.dtype("<f2"), 2: np.dtype("<f4")}


class Part:
    """Header of a part: its name, channels as (name, type) in the order of the file, size."""

    def __init__(self, attributes):
        self.name = attributes.get("name", b"").decode()
        self.compression = attributes["compression"][0]
        left, top, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
        self.left, self.top = left, top
        self.width, self.height = right - left + 1, bottom - top + 1
        self.channels = []
        text, at = attributes["channels"], 0
        while text[at]:
            end = text.index(b"\0", at)
            kind = struct.unpack_from("<i", text, end + 1)[0]
            self.channels.append((text[at:end].decode(), TYPES[kind]))
            at = end + 17
        self.planes = {name: np.zeros((self.height, self.width), kind) for name, kind in self.channels}
        lines = LINES_OF[self.compression]
        self.chunks = (self.height + lines - 1) // lines

    def add_chunk(self, y, data):
        first = y - self.top
        lines = min(LINES_OF[self.compression], self.height - first)
        size = lines * self.width * sum(kind.itemsize for _, kind in self.channels)
        if self.compression and len(data) < size:
            data = unpacked(data)
        at = 0
        for line in range(first, first + lines):
            for name, kind in self.channels:
                self.planes[name][line] = np.frombuffer(data, kind, self.width, at)
                at += self.width * kind.itemsize


def unpacked(data):
    """Undoes ZIP: deflate, differences of bytes, halves apart."""
    steps = np.frombuffer(zlib.decompress(data), np.uint8).astype(np.int64)
    steps[1:] -= 128
    mixed = (np.cumsum(steps) & 255).astype(np.uint8)
    half = (len(mixed) + 1) // 2
    whole = np.empty_like(mixed)
    whole[0::2] = mixed[:half]
    whole[1::2] = mixed[half:]
    return whole.tobytes()


def read_exr(path):
    """The parts by their names, each with `planes`, arrays of height x width by the names of channels."""
    with open(path, "rb") as file:
        data = file.read()
    magic, version = struct.unpack_from("<ii", data)
    if magic != MAGIC:
        raise ValueError(f"{path}: not OpenEXR")
    is_multi, at, parts = bool(version & MULTI_PART), 8, []
    while data[at]:
        attributes = {}
        while data[at]:
            end = data.index(b"\0", at)
            name = data[at:end].decode()
            at = data.index(b"\0", end + 1) + 1  # after the name of the type
            size = struct.unpack_from("<i", data, at)[0]
            attributes[name] = data[at + 4:at + 4 + size]
            at += 4 + size
        at += 1
        parts.append(Part(attributes))
        if not is_multi:
            break
    at += is_multi
    for part in parts:
        for _ in range(part.chunks):
            place = struct.unpack_from("<Q", data, at)[0]
            at += 8
            if is_multi:
                place += 4
            y, size = struct.unpack_from("<ii", data, place)
            part.add_chunk(y, data[place + 8:place + 8 + size])
    return {part.name: part for part in parts}
