"""Chapter 4: the state with its initial values."""
import importlib
import struct
from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any


def float32(v):
    """The nearest float32, as a float."""
    return struct.unpack("f", struct.pack("f", v))[0]


# ---- [R4.2] enumerations --------------------------------------------------------------------

def enumeration(name):
    """Of the schema, by the class that flatc makes; Python's word None has a _ there."""
    values = vars(getattr(importlib.import_module(f"gw.gwt.{name}"), name))
    return IntEnum(name, {k.rstrip("_"): v for k, v in values.items() if not k.startswith("_")})


CompareFunc = enumeration("CompareFunc")
StencilOp = enumeration("StencilOp")
BlendFactor = enumeration("BlendFactor")
BlendEquation = enumeration("BlendEquation")
LogicOp = enumeration("LogicOp")
ClipOrigin, ClipDepth = enumeration("ClipOrigin"), enumeration("ClipDepth")
Face = enumeration("Face")
Winding = enumeration("Winding")
PolygonMode = enumeration("PolygonMode")
ShadeModel = enumeration("ShadeModel")
ColorSource = enumeration("ColorSource")
FogMode = enumeration("FogMode")
FogCoordinate = enumeration("FogCoordinate")
FogSource = enumeration("FogSource")
MinFilter = enumeration("MinFilter")
MagFilter = enumeration("MagFilter")
Wrap = enumeration("Wrap")
TextureFormat = enumeration("TextureFormat")
TexEnv = enumeration("TexEnv")
CombineFunc = enumeration("CombineFunc")
CombineSource = enumeration("CombineSource")
CombineOperand = enumeration("CombineOperand")
TexGen = enumeration("TexGen")
CoordinateMode = enumeration("CoordinateMode")
ColorMaterial = enumeration("ColorMaterial")
DrawBuffer = enumeration("DrawBuffer")
ReadBuffer = enumeration("ReadBuffer")
NO_TEXGEN = TexGen["None"]
NO_DRAW_BUFFER = DrawBuffer["None"]
Plane = IntEnum("Plane", "Color Depth Stencil Accum Back", start=0)


def identity():
    """A matrix is a list of four columns [R2.7]."""
    return [tuple(1.0 if i == j else 0.0 for i in range(4)) for j in range(4)]


# ---- [R4.1] the state -----------------------------------------------------------------------


@dataclass
class Viewport:
    x: int = 0
    y: int = 0
    width: int = 0
    height: int = 0


@dataclass
class DepthRange:
    near_value: float = 0.0
    far_value: float = 1.0


@dataclass
class ClipControl:
    origin: int = ClipOrigin.LowerLeft
    depth: int = ClipDepth.NegativeOneToOne


@dataclass
class ClipPlane:
    enable: bool = False
    plane: tuple = (0.0, 0.0, 0.0, 0.0)


@dataclass
class Cull:
    enable: bool = False
    face: int = Face.Back
    front: int = Winding.CCW


@dataclass
class PolygonOffset:
    enable: bool = False
    factor: float = 0.0
    units: float = 0.0


@dataclass
class Jitter:
    x: int = 0
    y: int = 0


@dataclass
class Lighting:
    local_viewer: bool = False
    two_side: bool = False
    model_ambient: tuple = (0.0, 0.0, 0.0, 1.0)


@dataclass
class Fog:
    enable: bool = False
    mode: int = FogMode.Exp
    density: float = 1.0
    start: float = 0.0
    end: float = 1.0
    color: tuple = (0.0, 0.0, 0.0, 0.0)
    coordinate: int = FogCoordinate.Profile


@dataclass
class Texture:
    min_filter: int = MinFilter.Linear
    mag_filter: int = MagFilter.Linear
    wrap_s: int = Wrap.Repeat
    wrap_t: int = Wrap.Repeat
    env: int = TexEnv.Modulate
    env_color: tuple = (0.0, 0.0, 0.0, 0.0)
    gen: int = NO_TEXGEN
    eta: float = 1.0
    eye_linear: list = field(default_factory=identity)
    shadow_compare: bool = False


@dataclass
class Box:
    x: int = 0
    y: int = 0
    width: int = 0
    height: int = 0


@dataclass
class Scissor:
    test: bool = False
    box: Box = field(default_factory=Box)


@dataclass
class Alpha:
    test: bool = False
    func: int = CompareFunc.Always
    ref: float = 0.0


@dataclass
class StencilFace:
    func: int = CompareFunc.Always
    ref: int = 0
    mask: int = 2**32 - 1
    fail: int = StencilOp.Keep
    zfail: int = StencilOp.Keep
    zpass: int = StencilOp.Keep
    write_mask: int = 2**32 - 1


@dataclass
class Stencil:
    test: bool = False
    front: StencilFace = field(default_factory=StencilFace)
    two_side: bool = False
    back: StencilFace = field(default_factory=StencilFace)


@dataclass
class Depth:
    test: bool = False
    func: int = CompareFunc.Less
    mask: bool = True


@dataclass
class Blend:
    enable: bool = False
    src: int = BlendFactor.One
    dst: int = BlendFactor.Zero


@dataclass
class TextureLod:
    base_level: int = 0
    max_level: int = 1000
    bias: float = 0.0
    min: float = -1000.0
    max: float = 1000.0


@dataclass
class Combine:
    func: int = CombineFunc.Modulate
    source0: int = CombineSource.Texture
    source1: int = CombineSource.Previous
    source2: int = CombineSource.Constant
    operand0: int = CombineOperand.Color
    operand1: int = CombineOperand.Color
    operand2: int = CombineOperand.Alpha
    scale: int = 1


def combine_alpha():
    return Combine(operand0=CombineOperand.Alpha, operand1=CombineOperand.Alpha)


@dataclass
class BlendAlpha:
    separate: bool = False
    src: int = BlendFactor.One
    dst: int = BlendFactor.Zero
    equation: int = BlendEquation.Add


@dataclass
class LogicOperation:
    enable: bool = False
    op: int = LogicOp.Copy

    def reads_stored(self):
        """[R14.8] Whether the result depends on the stored bit."""
        return self.op not in (LogicOp.Clear, LogicOp.Copy, LogicOp.CopyInverted, LogicOp.Set)


@dataclass
class LineStipple:
    enable: bool = False
    factor: int = 1
    pattern: int = 0xFFFF


@dataclass
class PointParameters:
    constant: float = 1
    linear: float = 0
    quadratic: float = 0
    min_size: float = 1
    max_size: float = 128


@dataclass
class ColorMaterialUse:
    enable: bool = False
    face: int = Face.FrontAndBack
    mode: int = ColorMaterial.AmbientAndDiffuse


@dataclass
class CoordinateGen:
    mode: int = CoordinateMode.Given
    plane: tuple = (0.0, 0.0, 0.0, 0.0)


@dataclass
class ColorMask:
    r: bool = True
    g: bool = True
    b: bool = True
    a: bool = True


@dataclass
class ColorMaskBits:
    """[R12.19]"""
    r: int = 2**16 - 1
    g: int = 2**16 - 1
    b: int = 2**16 - 1
    a: int = 2**16 - 1


@dataclass
class Multisample:
    """[R17.2], [R17.4]"""
    enable: bool = True
    alpha_to_coverage: bool = False
    alpha_to_one: bool = False
    coverage_test: bool = False
    coverage: float = 1.0
    invert: bool = False


@dataclass
class State:
    projection: list = field(default_factory=identity)
    viewport: Viewport = field(default_factory=Viewport)
    depth_range: DepthRange = field(default_factory=DepthRange)
    clip_planes: list = field(default_factory=lambda: [ClipPlane() for _ in range(6)])
    cull: Cull = field(default_factory=Cull)
    polygon_mode: int = PolygonMode.Fill
    polygon_offset: PolygonOffset = field(default_factory=PolygonOffset)
    jitter: Jitter = field(default_factory=Jitter)
    point_size: float = 1
    line_width: float = 1
    shade_model: int = ShadeModel.Smooth
    color_source: int = ColorSource.Vertex
    lighting: Lighting = field(default_factory=Lighting)
    fog: Fog = field(default_factory=Fog)
    texture: Texture = field(default_factory=Texture)
    scissor: Scissor = field(default_factory=Scissor)
    alpha: Alpha = field(default_factory=Alpha)
    stencil: Stencil = field(default_factory=Stencil)
    depth: Depth = field(default_factory=Depth)
    blend: Blend = field(default_factory=Blend)
    color_mask: ColorMask = field(default_factory=ColorMask)
    blend_equation: int = BlendEquation.Add
    blend_color: tuple = (0.0, 0.0, 0.0, 0.0)
    logic_op: LogicOperation = field(default_factory=LogicOperation)
    normalize: bool = True
    color_material: ColorMaterialUse = field(default_factory=ColorMaterialUse)
    coordinates: list = field(default_factory=lambda: [CoordinateGen() for _ in range(4)])
    texture_matrix: list = field(default_factory=identity)
    border_color: tuple = (0.0, 0.0, 0.0, 0.0)
    offset_lines: bool = False
    offset_points: bool = False
    two_side_polygon_mode: bool = False
    back_polygon_mode: int = PolygonMode.Fill
    line_stipple: LineStipple = field(default_factory=LineStipple)
    polygon_stipple: tuple = ()
    point_smooth: bool = False
    line_smooth: bool = False
    polygon_smooth: bool = False
    draw_buffer: int = DrawBuffer.Front
    read_buffer: int = ReadBuffer.Front
    blend_alpha: BlendAlpha = field(default_factory=BlendAlpha)
    texture_lod: TextureLod = field(default_factory=TextureLod)
    combine_rgb: Combine = field(default_factory=Combine)
    combine_alpha: Combine = field(default_factory=combine_alpha)
    separate_specular: bool = False
    color_sum: bool = False
    fog_source: int = FogSource.Depth
    clip_control: ClipControl = field(default_factory=ClipControl)
    compare_func: int = CompareFunc.LEqual
    wrap_r: int = Wrap.Repeat
    seamless: bool = False
    point_parameters: PointParameters = field(default_factory=PointParameters)
    point_sprite: bool = False
    coord_replace: bool = False
    multisample: Multisample = field(default_factory=Multisample)
    diamond_lines: bool = False
    exact_rho: bool = False
    color_mask_bits: ColorMaskBits = field(default_factory=ColorMaskBits)
    more_textures: Any = None  # states that have the members of textures only [R10.37]

    def of_unit(self, unit):
        """[R10.37] A state whose texture is that of a unit."""
        if unit == 0:
            return self
        return self.more_textures[unit - 1] if self.more_textures else State()


# ---- Resolved state -------------------------------------------------------------------------


def viewport_of(state, width, height):
    """[R4.3]"""
    v = state.viewport
    return Viewport(0, 0, width, height) if v.width == 0 and v.height == 0 else v


def intersection(box, other):
    """Of boxes (left, bottom, right, top), right and top excluded; possibly empty."""
    left, bottom = max(box[0], other[0]), max(box[1], other[1])
    return left, bottom, max(left, min(box[2], other[2])), max(bottom, min(box[3], other[3]))


def corners_of(box):
    return box.x, box.y, box.x + box.width, box.y + box.height


def pixel_box(state, width, height):
    """[R4.4] The part of the window that anything may touch."""
    window = (0, 0, width, height)
    return intersection(window, corners_of(state.scissor.box)) if state.scissor.test else window


def draw_box(state, width, height):
    """[R4.4] The part in which primitives make fragments."""
    return intersection(pixel_box(state, width, height),
                        corners_of(viewport_of(state, width, height)))
