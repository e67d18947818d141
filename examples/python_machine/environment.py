"""Chapter 10: how texels change the fragments' colours."""
import numpy as np

from .numbers import mul, one, quantize
from .state import CombineFunc, CombineOperand, CombineSource, TexEnv, TextureFormat


def environments(colors, texels, state, bits):
    """[R10.37] texels: by unit, with their formats; state: the whole."""
    primary = colors
    for unit in sorted(texels):
        colors = environment(colors, primary, texels, unit, state.of_unit(unit), bits)
    return colors


def environment(f, primary, texels, unit, state, bits):
    """[R10.17], [R10.24], [R10.32] f: the fragments' colours; state: of the unit."""
    if state.texture.env == TexEnv.Combine:
        return combined(f, primary, texels, unit, state, bits)
    t, form = texels[unit]
    return np.stack([environment_channel(f, t, state.texture, form, c, bits) for c in range(4)],
                    axis=1)


def environment_channel(f, t, state, form, c, bits):
    env, fragment, texel = state.env, f[:, c], t[:, c]
    lacks_alpha = form in (TextureFormat.RGB, TextureFormat.Luminance)
    if c == 3 and (lacks_alpha or env == TexEnv.Decal):
        return fragment
    if c < 3 and form == TextureFormat.Alpha:
        return fragment
    if env == TexEnv.Replace:
        return texel
    if env == TexEnv.Modulate or (c == 3 and form != TextureFormat.Intensity):
        return mul(fragment, texel, bits)
    if env == TexEnv.Add:
        return np.minimum(one(bits), fragment + texel)
    weight = t[:, 3] if env == TexEnv.Decal else texel
    other = texel if env == TexEnv.Decal else quantize(state.env_color[c], bits)
    return mul(fragment, one(bits) - weight, bits) + mul(other, weight, bits)


def arguments(rule, inputs, bits):
    """[R10.33] Three arrays of R, G, B, A."""
    result = []
    for k in range(3):
        value = inputs[getattr(rule, f"source{k}")]
        operand = getattr(rule, f"operand{k}")
        if operand in (CombineOperand.Alpha, CombineOperand.OneMinusAlpha):
            value = np.repeat(value[:, 3:], 4, axis=1)
        if operand in (CombineOperand.OneMinusColor, CombineOperand.OneMinusAlpha):
            value = one(bits) - value
        result.append(value)
    return result


def combine_function(rule, inputs, bits):
    """[R10.34], [R10.35] All four channels."""
    a, b, c = arguments(rule, inputs, bits)
    half, most = 2**(bits - 1), one(bits)
    if rule.func == CombineFunc.Replace:
        v = a
    elif rule.func == CombineFunc.Modulate:
        v = mul(a, b, bits)
    elif rule.func == CombineFunc.Add:
        v = a + b
    elif rule.func == CombineFunc.AddSigned:
        v = a + b - half
    elif rule.func == CombineFunc.Interpolate:
        v = mul(a, c, bits) + mul(b, most - c, bits)
    elif rule.func == CombineFunc.Subtract:
        v = a - b
    else:
        dot = ((a[:, :3] - half) * (b[:, :3] - half)).sum(axis=1, keepdims=True)
        v = np.repeat((8 * np.maximum(dot, 0) + most) // (2 * most), 4, axis=1)
    return np.clip(rule.scale * v, 0, most)


def argument_texel(t, form):
    """[R10.33]"""
    if form == TextureFormat.Alpha:
        t = t.copy()
        t[:, :3] = 0
    return t


def sources_used(rule):
    """[R10.39]"""
    count = {CombineFunc.Replace: 1, CombineFunc.Interpolate: 3}.get(rule.func, 2)
    return [getattr(rule, f"source{k}") for k in range(count)]


def combined(f, primary, texels, unit, state, bits):
    """[R10.32], [R10.39]"""
    constant = np.array([quantize(v, bits) for v in state.texture.env_color], np.int64)
    inputs = {CombineSource.Texture0 + k: argument_texel(*texels[k]) for k in texels}
    inputs |= {CombineSource.Texture: inputs[CombineSource.Texture0 + unit],
               CombineSource.PrimaryColor: primary, CombineSource.Previous: f,
               CombineSource.Constant: np.repeat(constant[None, :], len(f), axis=0)}
    own_alpha = state.combine_rgb.func != CombineFunc.Dot3Rgba
    rules = [state.combine_rgb, state.combine_alpha] if own_alpha else [state.combine_rgb]
    reads_off = any(source not in inputs for rule in rules for source in sources_used(rule))
    if reads_off:
        return f
    for source in CombineSource:  # those that no argument uses
        inputs.setdefault(source, f)
    result = combine_function(state.combine_rgb, inputs, bits)
    if own_alpha:
        result[:, 3] = combine_function(state.combine_alpha, inputs, bits)[:, 3]
    return result
