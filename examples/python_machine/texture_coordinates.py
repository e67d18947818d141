"""Chapter 10, first section: texture coordinates at a vertex."""
import math

from .numbers import bounded, dot3, transform, unit
from .state import TexGen


def at_vertex(texture, own, p_eye, n):
    """[R10.1], [R10.5] (s, t, r, q)"""
    if texture.gen == TexGen.SphereMap:
        c = sphere_map(reflected(unit(p_eye[:3]), n)) + (0.0, 1.0)
    elif texture.gen == TexGen.RefractionMap:
        c = sphere_map(refracted(unit(p_eye[:3]), n, texture.eta)) + (0.0, 1.0)
    elif texture.gen == TexGen.EyeLinear:
        c = transform(texture.eye_linear, p_eye)
    else:
        c = tuple(own) + (0.0, 1.0)
    return tuple(bounded(v, 2.0**200) for v in c)


def reflected(u, n):
    """[R10.2]"""
    k = 2 * dot3(n, u)
    return tuple(a - k * b for a, b in zip(u, n))


def sphere_map(d):
    """[R10.2]"""
    z = d[2] + 1
    m = 2 * math.sqrt((d[0] * d[0] + d[1] * d[1]) + z * z)
    return (d[0] / m + 0.5, d[1] / m + 0.5) if m > 0 else (0.5, 0.5)


def refracted(u, n, eta):
    """[R10.3]"""
    c = -dot3(n, u)
    root = 1 - (eta * eta) * (1 - c * c)
    if root < 0:
        return reflected(u, n)
    k = eta * c - (math.sqrt(root) if not math.isnan(root) else root)
    return tuple(eta * a + k * b for a, b in zip(u, n))
