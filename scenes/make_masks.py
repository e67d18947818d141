#!/usr/bin/env python3
"""Writes scenes/masks.gltf: a leaf as a texture's alpha, with MASK at three cutoffs and with BLEND,
before a wall under a light that casts no shadow."""

import base64
import json
import math
import os
import struct
import zlib

SIDE = 32


def alpha(x, y):
    """0 far outside a leaf of five lobes, 1 far inside; x, y from -1 to 1."""
    angle, distance = math.atan2(x, y), math.hypot(x, y)
    edge = 0.62 + 0.24 * math.cos(5 * angle)
    return min(max(0.5 + 2 * (edge - distance), 0), 1)


def leaf():
    rows = b""
    for j in range(SIDE):
        rows += b"\0"
        for i in range(SIDE):
            x, y = 2 * (i + 0.5) / SIDE - 1, 1 - 2 * (j + 0.5) / SIDE
            green = 150 + int(60 * (1 - math.hypot(x, y) / 1.5))
            rows += bytes([110, green, 60, round(255 * alpha(x, y))])

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(
            ">I", zlib.crc32(kind + data))
    header = struct.pack(">2I5B", SIDE, SIDE, 8, 6, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(
        b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


def uri(kind, data):
    return f"data:{kind};base64," + base64.b64encode(data).decode()


def document():
    corners = struct.pack("<12f", -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0)
    texcoords = struct.pack("<8f", 0, 1, 1, 1, 1, 0, 0, 0)
    indices = struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    data = corners + texcoords + indices
    painted = {"metallicFactor": 0, "roughnessFactor": 1, "baseColorTexture": {"index": 0}}
    materials = [{"name": "wall", "doubleSided": True, "pbrMetallicRoughness": {
        "metallicFactor": 0, "roughnessFactor": 1, "baseColorFactor": [0.6, 0.3, 0.2, 1]}}]
    for cutoff in (0.25, 0.5, 0.75):
        materials.append({"name": f"cutoff {cutoff}", "alphaMode": "MASK", "doubleSided": True,
                          "alphaCutoff": cutoff, "pbrMetallicRoughness": painted})
    materials.append({"name": "blend", "alphaMode": "BLEND", "doubleSided": True,
                      "pbrMetallicRoughness": painted})
    attributes = {"POSITION": 0, "TEXCOORD_0": 1}
    meshes = [{"primitives": [{"attributes": attributes, "indices": 2, "material": i}]}
              for i in range(len(materials))]
    nodes = [{"name": "wall", "mesh": 0, "scale": [4, 1, 1], "translation": [0, 0, -0.5]}]
    for i in range(1, len(materials)):
        nodes.append({"name": materials[i]["name"], "mesh": i, "translation": [2 * i - 5, 0, 0],
                      "scale": [0.9, 0.9, 1]})
    nodes.append({"name": "eye", "camera": 0, "translation": [0, 0, 4]})
    nodes.append({"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 0}}})
    return {
        "asset": {"version": "2.0", "generator": "scenes/make_masks.py"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "directional", "intensity": math.pi}]}},
        "scene": 0, "scenes": [{"nodes": list(range(len(nodes)))}],
        "nodes": nodes, "meshes": meshes, "materials": materials,
        "textures": [{"source": 0, "sampler": 0}],
        "samplers": [{"wrapS": 33071, "wrapT": 33071}],
        "images": [{"uri": uri("image/png", leaf())}],
        "cameras": [{"type": "orthographic", "orthographic": {
            "xmag": 4, "ymag": 1, "znear": 1, "zfar": 9}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
             "min": [-1, -1, 0], "max": [1, 1, 0]},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
            {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 32},
            {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "buffers": [{"byteLength": len(data), "uri": uri("application/octet-stream", data)}],
    }


here = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(here, "masks.gltf"), "w", encoding="utf-8") as out:
    json.dump(document(), out, separators=(",", ":"))
    out.write("\n")
