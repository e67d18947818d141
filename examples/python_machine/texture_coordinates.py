"""Chapter 10, first section: texture coordinates at a vertex."""
import math

from .numbers import bounded, dot3, dot4, transform, unit
from .state import NO_TEXGEN, CoordinateMode, Plane, TexGen, identity


def at_vertex(state, own, p, p_eye, point, n):
    """[R10.1], [R10.5] (s, t, r, q)"""
    texture = state.texture
    if texture.gen == TexGen.SphereMap:
        c = sphere_map(reflected(unit(point), n)) + (0.0, 1.0)
    elif texture.gen == TexGen.RefractionMap:
        c = sphere_map(refracted(unit(point), n, texture.eta)) + (0.0, 1.0)
    elif texture.gen == TexGen.EyeLinear:
        c = transform(texture.eye_linear, p_eye)
    elif texture.gen == TexGen.PerCoordinate:
        c = tuple(by_rule(state.coordinates[k], k, own[k], p, p_eye, point, n) for k in range(4))
    else:
        c = tuple(own)
    if state.texture_matrix != identity():
        c = transform(state.texture_matrix, c)
    return tuple(bounded(v, 2.0**200) for v in c)


def by_rule(rule, k, own, p, p_eye, point, n):
    """[R10.20] Coordinate k of s, t, r, q."""
    if rule.mode == CoordinateMode.ObjectLinear:
        return dot4(rule.plane, p)
    if rule.mode == CoordinateMode.EyeLinear:
        return dot4(rule.plane, p_eye)
    if rule.mode == CoordinateMode.SphereMap:
        return sphere_map(reflected(unit(point), n))[k]
    if rule.mode == CoordinateMode.NormalMap:  # [R10.43]
        return n[k]
    if rule.mode == CoordinateMode.ReflectionMap:
        return reflected(unit(point), n)[k]
    return own


def divided_by_q(state, draw, texture_unit):
    """[R10.22], [R10.38]; state: of the unit"""
    image = draw.texture_of(texture_unit)
    if image is not None and image.needs_r():
        return True
    plane = draw.plane_of(texture_unit)
    if plane is not None and plane[1] == Plane.Depth:
        return True
    gen, m = state.texture.gen, state.texture_matrix
    if gen == TexGen.EyeLinear:
        return True
    if gen == TexGen.PerCoordinate and state.coordinates[3].mode != CoordinateMode.Given:
        return True
    if tuple(column[3] for column in m) != (0, 0, 0, 1):
        return True
    if gen not in (NO_TEXGEN, TexGen.PerCoordinate):
        return False
    st, rq = ((draw.mesh.texcoords, draw.mesh.texcoords_rq) if texture_unit == 0
              else draw.mesh.more_texcoords[texture_unit - 1])
    if st:
        return bool(rq)
    current = (draw.current.texcoord,) + draw.current.more_texcoords
    return current[texture_unit][3] != 1


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
