"""Chapter 8: lighting at a vertex, in eye space."""
import math
from dataclasses import replace

from .elementary import power
from .numbers import divide, dot3, quantize, rescale, unit
from .state import ColorMaterial, Face


def material_at(state, draw, i, face, color):
    """[R8.9], [R8.10] The material of one side of vertex i, which has this colour."""
    material = draw.material
    if face == Face.Back and draw.back_material is not None:
        material = draw.back_material
    if draw.mesh.material_indices:
        own = draw.mesh.materials[draw.mesh.material_indices[i]]
        material = own[0 if face == Face.Front else 1]
    follows = state.color_material
    if not follows.enable or follows.face not in (face, Face.FrontAndBack):
        return material
    names = {ColorMaterial.Emission: ("Ke",), ColorMaterial.Ambient: ("Ka",),
             ColorMaterial.Diffuse: ("Kd", "alpha"), ColorMaterial.Specular: ("Ks",),
             ColorMaterial.AmbientAndDiffuse: ("Ka", "Kd", "alpha")}[follows.mode]
    return replace(material, **{name: color[3] if name == "alpha" else color[:3]
                                for name in names})


def lit_colors(profile, state, material, lights, p, n):
    """[R8.1], [R8.2], [R8.11] p: the vertex; n: its normal. Integers of color_bits: four of the
    colour, three of the secondary one."""
    ambient = state.lighting.model_ambient
    total = [material.Ke[c] + ambient[c] * material.Ka[c] for c in range(3)]
    highlights = [0.0] * 3
    for light in lights:
        direction, strength = towards(light, p)
        diffuse, specular = reflection(state, material, p, n, direction)
        for c in range(3):
            own = light.Ia[c] * material.Ka[c] + (light.Id[c] * material.Kd[c]) * diffuse
            highlight = (light.Is[c] * material.Ks[c]) * specular
            if state.separate_specular:
                total[c] = total[c] + strength * own
                highlights[c] = highlights[c] + strength * highlight
            else:
                total[c] = total[c] + strength * (own + highlight)
    total.append(material.alpha)
    return tuple(tuple(rescale(quantize(v, profile.lit_bits), profile.lit_bits,
                               profile.color_bits) for v in values)
                 for values in (total, highlights))


def towards(light, p):
    """[R8.3], [R8.4] The direction towards a light, and its strength there."""
    x, y, z, w = light.position
    if w == 0:
        return unit((x, y, z)), 1.0
    v = tuple(divide(a, w) - b for a, b in zip((x, y, z), p))
    direction = unit(v)
    d = math.sqrt(dot3(v, v))
    a = ((light.constant_attenuation + light.linear_attenuation * d)
         + light.quadratic_attenuation * (d * d))
    return direction, divide(spot(light, direction), a if a > 1e-30 else 1e-30)


def spot(light, direction):
    """[R8.5]"""
    if light.spot_cos_cutoff <= -1:
        return 1.0
    c = dot3(tuple(-x for x in direction), unit(light.spot_direction))
    if c < light.spot_cos_cutoff or c <= 0:
        return 0.0
    return power(c if c < 1 else 1.0, light.spot_exponent)


def reflection(state, material, p, n, direction):
    """[R8.6], [R8.7] The factors diffuse and specular."""
    eye = unit(tuple(-x for x in p)) if state.lighting.local_viewer else (0.0, 0.0, 1.0)
    cosine = dot3(n, direction)
    if not cosine > 0:
        return 0.0, 0.0
    if all(k == 0 for k in material.Ks):
        return cosine, 0.0
    c = dot3(n, unit(tuple(a + b for a, b in zip(direction, eye))))
    return cosine, power((c if c < 1 else 1.0) if c > 0 else 0.0, material.Ns)
