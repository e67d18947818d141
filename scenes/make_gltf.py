#!/usr/bin/env python3
"""Writes scenes/materials.gltf: spheres from smooth to rough, of a dielectric (above) and of a
metal (below), under one directional light, seen without perspective. --reference PICTURE.ppm
draws the same spheres by glTF's own formula (metallic-roughness, GGX, sRGB), pixel by pixel.
--compare A B prints the root mean square difference of two such pictures, for each sphere."""

import base64
import json
import math
import os
import struct
import sys

ROUGHNESS = [0.2, 0.35, 0.5, 0.7, 1.0]
BASE = {0: (0.8, 0.25, 0.05), 1: (1.0, 0.71, 0.29)}
TO_LIGHT = (2 / 7, 3 / 7, 6 / 7)
LUX = math.pi
SIDE = 96  # pixels for each sphere
RADIUS = 0.9  # half of a sphere's square is 1


def sphere(slices=64, stacks=32):
    points, indices = [], []
    for j in range(stacks + 1):
        for i in range(slices + 1):
            a, b = 2 * math.pi * i / slices, math.pi * j / stacks
            points.append((math.sin(b) * math.sin(a), math.cos(b), math.sin(b) * math.cos(a)))
    for j in range(stacks):
        for i in range(slices):
            k = j * (slices + 1) + i
            indices += [k, k + slices + 1, k + 1, k + 1, k + slices + 1, k + slices + 2]
    return points, indices


def spheres():
    for metallic in (0, 1):
        for i, roughness in enumerate(ROUGHNESS):
            yield metallic, roughness, 2.0 * i - len(ROUGHNESS) + 1, 1.0 - 2 * metallic


def quaternion_to(z):
    """Turns +z to z."""
    q = [-z[1], z[0], 0, 1 + z[2]]
    size = math.sqrt(sum(c * c for c in q))
    return [c / size for c in q]


def document():
    points, indices = sphere()
    vertices = b"".join(struct.pack("<3f", *p) for p in points)
    corners = struct.pack(f"<{len(indices)}H", *indices)
    turns = struct.pack("<3f", 0, 1, 2) + struct.pack(
        "<12f", 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0, -1)
    data = vertices + corners + turns
    at = len(vertices) + len(corners)
    materials, meshes, nodes = [], [], []
    for metallic, roughness, x, y in spheres():
        kind = "metal" if metallic else "dielectric"
        materials.append({"name": f"{kind} {roughness}", "pbrMetallicRoughness": {
            "baseColorFactor": [*BASE[metallic], 1], "metallicFactor": metallic,
            "roughnessFactor": roughness}})
        # A sphere's positions are its normals.
        meshes.append({"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 0}, "indices": 1,
                                       "material": len(materials) - 1}]})
        nodes.append({"name": f"{kind} {roughness}", "mesh": len(meshes) - 1,
                      "translation": [x, y, 0], "scale": [RADIUS] * 3})
    balls = list(range(len(nodes)))
    nodes.append({"name": "balls", "children": balls})
    nodes.append({"name": "sun", "rotation": quaternion_to(TO_LIGHT),
                  "extensions": {"KHR_lights_punctual": {"light": 0}}})
    nodes.append({"name": "eye", "translation": [0, 0, 10], "camera": 0})
    view = lambda begin, size: {"buffer": 0, "byteOffset": begin, "byteLength": size}
    return {
        "asset": {"version": "2.0", "generator": "make_gltf.py"},
        "extensionsUsed": ["KHR_lights_punctual"],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "directional", "intensity": LUX}]}},
        "scene": 0, "scenes": [{"nodes": [len(balls), len(balls) + 1, len(balls) + 2]}],
        "nodes": nodes, "meshes": meshes, "materials": materials,
        "cameras": [{"type": "orthographic", "orthographic": {
            "xmag": len(ROUGHNESS), "ymag": 2, "znear": 1, "zfar": 20}}],
        "animations": [{"channels": [{"sampler": 0, "target": {
            "node": len(balls), "path": "rotation"}}],
            "samplers": [{"input": 2, "output": 3}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(points), "type": "VEC3",
             "min": [-1, -1, -1], "max": [1, 1, 1]},
            {"bufferView": 1, "componentType": 5123, "count": len(indices), "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5126, "count": 3, "type": "SCALAR",
             "min": [0], "max": [2]},
            {"bufferView": 3, "componentType": 5126, "count": 3, "type": "VEC4"}],
        "bufferViews": [view(0, len(vertices)), view(len(vertices), len(corners)),
                        view(at, 12), view(at + 12, 48)],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64,"
                     + base64.b64encode(data).decode()}],
    }


def brdf_times_pi(base, metallic, roughness, n_l, n_v, n_h, v_h):
    """[GLTF2 B.3]"""
    a2 = roughness ** 4
    d = a2 / (n_h * n_h * (a2 - 1) + 1) ** 2  # times pi
    v = 0.5 / (n_l * math.sqrt(n_v * n_v * (1 - a2) + a2)
               + n_v * math.sqrt(n_l * n_l * (1 - a2) + a2))
    out = []
    for b in base:
        f0 = 0.04 * (1 - metallic) + b * metallic
        f = f0 + (1 - f0) * (1 - v_h) ** 5
        out.append((1 - f) * b * (1 - metallic) + f * d * v)
    return out


def srgb(c):
    c = min(max(c, 0), 1)
    return round(255 * (12.92 * c if c <= 0.0031308 else 1.055 * c ** (1 / 2.4) - 0.055))


def reference():
    width, height = SIDE * len(ROUGHNESS), SIDE * 2
    half = [c for c in TO_LIGHT]
    half[2] += 1
    size = math.sqrt(sum(c * c for c in half))
    half = [c / size for c in half]
    v_h = half[2]
    rows = bytearray(width * height * 3)
    for metallic, roughness, x0, y0 in spheres():
        for j in range(SIDE):
            for i in range(SIDE):
                x = ((i + 0.5) / SIDE * 2 - 1) / RADIUS
                y = (1 - (j + 0.5) / SIDE * 2) / RADIUS
                if x * x + y * y >= 1:
                    continue
                n = (x, y, math.sqrt(1 - x * x - y * y))
                n_l = sum(a * b for a, b in zip(n, TO_LIGHT))
                if n_l <= 0:
                    continue
                n_h = sum(a * b for a, b in zip(n, half))
                color = brdf_times_pi(BASE[metallic], metallic, roughness, n_l, n[2], n_h, v_h)
                column = int((x0 + len(ROUGHNESS) - 1) / 2) * SIDE + i
                row = metallic * SIDE + j
                at = (row * width + column) * 3
                rows[at:at + 3] = bytes(srgb(c * n_l * LUX / math.pi) for c in color)
    return width, height, bytes(rows)


def read_ppm(name):
    kind, width, height, _, rows = open(name, "rb").read().split(maxsplit=4)
    assert kind == b"P6"
    return int(width), int(height), rows


def compare(a, b):
    width, _, rows_a = read_ppm(a)
    _, _, rows_b = read_ppm(b)
    for metallic, roughness, x0, _ in spheres():
        left, top = int((x0 + len(ROUGHNESS) - 1) / 2) * SIDE, metallic * SIDE
        total = count = 0
        for j in range(SIDE):
            for i in range(SIDE):
                if math.hypot(2 * (i + 0.5) / SIDE - 1, 2 * (j + 0.5) / SIDE - 1) >= RADIUS - 0.02:
                    continue
                at = ((top + j) * width + left + i) * 3
                for k in range(3):
                    total += (rows_a[at + k] - rows_b[at + k]) ** 2
                    count += 1
        kind = "metal" if metallic else "dielectric"
        print(f"{kind:10} roughness {roughness}: {math.sqrt(total / count):.1f}")


def main(arguments):
    if arguments[:1] == ["--reference"]:
        width, height, rows = reference()
        with open(arguments[1], "wb") as out:
            out.write(b"P6\n%d %d\n255\n" % (width, height) + rows)
    elif arguments[:1] == ["--compare"]:
        compare(arguments[1], arguments[2])
    else:
        here = os.path.dirname(os.path.abspath(__file__))
        with open(os.path.join(here, "materials.gltf"), "w", encoding="utf-8") as out:
            json.dump(document(), out, separators=(",", ":"))
            out.write("\n")


main(sys.argv[1:])
