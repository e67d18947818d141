"""Chapter 1: a machine's profile."""
from dataclasses import dataclass


@dataclass
class Profile:
    """[R1.3]"""
    name: str = ""
    color_bits: int = 0
    depth_bits: int = 0
    stencil_bits: int = 0
    accum_bits: int = 0
    subpixel_bits: int = 0
    lit_bits: int = 0
    max_lights: int = 0
    fragment_fog: bool = False
    perspective_color: bool = False
    polygon_offset: bool = False
    shadow_texture: bool = False
    stencil_wrap: bool = False
    two_sided_stencil: bool = False
    texel_bits: int = 0
    texture_border: bool = False
    texture_formats: bool = False
    stipple: bool = False
    two_sided_polygon_mode: bool = False
    logic_op: bool = False
    blend_color: bool = False
    blend_minmax: bool = False
    blend_subtract: bool = False
    draw_pixels: bool = False
    coverage_bits: int = 0
    color_planes: int = 1
    blend_separate: bool = False
    blend_square: bool = False
    texture_sizes: bool = False
    texture_wraps: bool = False
    texture_lod: bool = False
    texture_combine: bool = False
    texture_srgb: bool = False
    secondary_color: bool = False
    fog_coordinate: bool = False
    occlusion_query: bool = False
    clip_control: bool = False
    texture_units: bool = False
    texture_depth: bool = False
    texture_cube: bool = False
    texture_seamless: bool = False
    texture_3d: bool = False
    surfaces: bool = False
    point_parameters: bool = False
    point_sprite: bool = False
    multisample: bool = False
