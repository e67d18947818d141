"""Chapter 15: recordings, read with the classes that flatc makes of the schema."""
import importlib
from dataclasses import dataclass, fields, is_dataclass
from typing import Any

import numpy as np

from .images import image_of
from .indices import color_map_of
from .profile import Profile
from .state import Box, State, float32, identity

NONE = 2**32 - 1


def generated(name):
    """A class or enumeration of flatc's; T classes hold plain members."""
    module = importlib.import_module(f"gw.gwt.{name.removesuffix('T')}")
    return getattr(module, name)


def names_of(enumeration):
    return {v: k for k, v in vars(generated(enumeration)).items() if not k.startswith("_")}


# ---- Values ---------------------------------------------------------------------------------


def member_name(name):
    """What flatc calls a member; `is`, a word of Python's, gets a `_` by scripts of ours."""
    head, *rest = name.split("_")
    made = head[0].lower() + head[1:] + "".join(part.capitalize() for part in rest)
    return "is_" if made == "is" else made


def vector(v):
    """A structure x, y, z, w as a tuple, as far as it goes."""
    return tuple(getattr(v, c) for c in "xyzw" if hasattr(v, c))


def matrix(m):
    """[R15.2]"""
    return [vector(getattr(m, f"column{k}")) for k in range(4)]


def filled(value, given):
    """Fills a dataclass from an object with members of the same names; absent ones stay."""
    for member in fields(value):
        part = getattr(given, member_name(member.name), None)
        current = getattr(value, member.name)
        if part is None: continue  # [R15.1]
        if is_dataclass(current):
            filled(current, part)
        elif member.name == "more_textures":
            value.more_textures = [filled(State(), unit) for unit in part] or None
        elif member.name == "polygon_stipple":
            value.polygon_stipple = tuple(int(row) for row in part)
        elif isinstance(current, tuple):
            setattr(value, member.name, vector(part))
        elif isinstance(current, list) and is_dataclass(current[0]):
            if len(part):
                setattr(value, member.name, [filled(type(current[0])(), p) for p in part])
        elif isinstance(current, list):
            setattr(value, member.name, matrix(part))
        else:
            setattr(value, member.name, part)
    return value


@dataclass
class Material:
    """[R5.5]"""
    Ka: tuple = (float32(0.2),) * 3
    Kd: tuple = (float32(0.8),) * 3
    Ks: tuple = (0.0,) * 3
    Ke: tuple = (0.0,) * 3
    Ns: float = 0.0
    alpha: float = 1.0


ORIGINS = ((0.0, 0.0, 0.0, 1.0),) * 3


@dataclass
class CurrentValues:
    """[R5.9]"""
    color: tuple = (1.0,) * 4
    normal: tuple = (0.0, 0.0, 1.0)
    texcoord: tuple = (0.0, 0.0, 0.0, 1.0)
    secondary_color: tuple = (0.0,) * 3
    fog_coordinate: float = 0.0
    more_texcoords: tuple = ORIGINS


@dataclass
class RasterPosition:
    """[R5.1] Of DrawPixels."""
    x: float = 0.0
    y: float = 0.0
    depth: int = 0
    color: Any = None
    texcoord: tuple = (0.0, 0.0, 0.0, 1.0)
    distance: float = 0.0
    secondary_color: Any = None
    fog_coordinate: float = 0.0
    more_texcoords: tuple = ORIGINS


def raster_of(c):
    """Some members are the command's own."""
    given = c.raster
    position = filled(RasterPosition(), given) if given is not None else RasterPosition()
    position.color = channels(position.color)
    position.secondary_color = channels(c.rasterSecondaryColor)
    position.fog_coordinate = c.rasterFogCoordinate
    position.more_texcoords = texcoords_of(c)
    return position


def channels(c):
    return (c.r, c.g, c.b, c.a) if c is not None else (0, 0, 0, 0)


def current_of(c):
    """[R5.9] Some values are the command's own."""
    current = filled(CurrentValues(), c.current) if c.current else CurrentValues()
    current.more_texcoords = texcoords_of(c)
    if c.currentSecondaryColor:
        current.secondary_color = vector(c.currentSecondaryColor)
    current.fog_coordinate = c.currentFogCoordinate
    return current


@dataclass
class Light:
    """[R5.6]"""
    position: tuple = (0.0, 0.0, 1.0, 0.0)
    Ia: tuple = (0.0,) * 3
    Id: tuple = (1.0,) * 3
    Is: tuple = (1.0,) * 3
    spot_direction: tuple = (0.0, 0.0, -1.0)
    spot_exponent: float = 0.0
    spot_cos_cutoff: float = -1.0
    constant_attenuation: float = 1.0
    linear_attenuation: float = 0.0
    quadratic_attenuation: float = 0.0


@dataclass
class Mesh:
    """[R5.3]"""
    primitive: str
    positions: list
    normals: list
    texcoords: list
    colors: list
    indices: list
    polygon_sizes: list
    polygon_ids: list
    w: list
    texcoords_rq: list
    edge_flags: list
    materials: list
    material_indices: list
    secondary_colors: list
    fog_coordinates: list
    more_texcoords: list

    def texcoords_of(self, unit, i):
        """[R10.37] (s, t, r, q); None if the mesh has none."""
        st, rq = ((self.texcoords, self.texcoords_rq) if unit == 0
                  else self.more_texcoords[unit - 1])
        return st[i] + (rq[i] if rq else (0.0, 1.0)) if st else None


def mesh_of(table):
    data = generated("MeshT").InitFromObj(table)

    def vectors(name):
        return [vector(v) for v in (getattr(data, name) or [])]

    def integers(name):
        given = getattr(data, name)
        return [] if given is None else [int(v) for v in given]

    return Mesh(names_of("Primitive")[data.primitive], vectors("positions"), vectors("normals"),
                vectors("texcoords"), vectors("colors"), integers("indices"),
                integers("polygonSizes"), integers("polygonIds"),
                [] if data.w is None else [float(v) for v in data.w], vectors("texcoordsRq"),
                integers("edgeFlags"),
                [(filled(Material(), m.front), filled(Material(), m.back))
                 for m in data.materials or []],
                integers("materialIndices"), vectors("secondaryColors"),
                [] if data.fogCoordinates is None else [float(v) for v in data.fogCoordinates],
                [tuple([vector(v) for v in part or []] for part in (unit.st, unit.rq))
                 for unit in data.moreTexcoords or []] or [([], [])] * 3)


# ---- Commands -------------------------------------------------------------------------------


@dataclass
class Command:
    """A command of [R5.1]: its name, and its members by the manual's words."""
    kind: str
    members: dict
    color_map: Any = None  # of its list [R18.4]

    def __getattr__(self, name):
        try:
            return self.members[name]
        except KeyError:
            raise AttributeError(name) from None

    def is_textured(self, unit=0):
        """[R5.2]"""
        return any(of(unit) is not None for of in (self.texture_of, self.slot_of, self.plane_of))

    def texture_of(self, unit):
        return self.textures[unit]

    def slot_of(self, unit):
        return self.slots[unit]

    def plane_of(self, unit):
        """[R16.5] A surface's number and the plane."""
        return self.planes_of_surfaces[unit]

    def units(self):
        """[R10.37] Those that are on."""
        return [unit for unit in range(4) if self.is_textured(unit)]


def box(given):
    return filled(Box(), given) if given is not None else Box()


def texcoords_of(c):
    """Current ones of units 1 to 3."""
    return tuple(vector(v) for v in c.moreTexcoords or []) or ORIGINS


def rgba(colors):
    return np.array([(c.r, c.g, c.b, c.a) for c in colors or []], dtype=np.int64).reshape(-1, 4)


def state_of(given):
    """[R4.1] Sizes that are not whole are in a member of their own."""
    state = filled(State(), given)
    if given.sizes is not None:
        state.point_size, state.line_width = given.sizes.point, given.sizes.line
    return state


class Values:
    """[R15.3] The meshes and textures of a file; of a stream, those of its parts so far."""

    def __init__(self):
        self.meshes, self.textures = [], []

    def add(self, table):
        self.meshes += [mesh_of(table.Meshes(i)) for i in range(table.MeshesLength())]
        self.textures += [image_of(table.Textures(i)) for i in range(table.TexturesLength())]


class Reader:
    """A machine's profile, window and commands [R15.3], [R15.4]."""

    def __init__(self, window, table, values):
        self.window, self.values, self.parts = window, values, []
        self.width, self.height = table.Width(), table.Height()
        self.profile = filled(Profile(), generated("ProfileT").InitFromObj(table.Profile()))
        self.states, self.light_sets = [], []

    @property
    def meshes(self):
        return self.values.meshes

    @property
    def textures(self):
        return self.values.textures

    def begin(self, table):
        """States and lights are those of a part."""
        self.states = [state_of(generated("StateT").InitFromObj(table.States(i)))
                       for i in range(table.StatesLength())]
        self.light_sets = [
            [filled(Light(), light) for light in
             generated("LightsT").InitFromObj(table.LightSets(i)).lights or []]
            for i in range(table.LightSetsLength())]

    def commands(self):
        """Of all lists, in order: how they are cut changes nothing [R1.2]."""
        color_map = None
        for table in self.parts:
            self.begin(table)
            for i in range(table.ListsLength()):
                given = table.Lists(i).ColorMap()
                if given is not None:
                    given = generated("ColorMapT").InitFromObj(given)
                color_map = color_map_of(given, color_map)
                for command in self.commands_of(table.Lists(i)):
                    command.color_map = color_map
                    yield command

    def commands_of(self, commands):
        kinds = names_of("CommandType")
        for k in range(commands.CommandsLength()):
            place = commands.Commands(k)._tab
            kind = kinds[commands.CommandsType(k)]
            table = generated(kind)()
            table.Init(place.Bytes, place.Pos)
            given = generated(kind + "T").InitFromObj(table)
            yield Command(kind, getattr(self, "read_" + kind)(given))

    def read_BeginPass(self, c):
        return {"name": (c.name or b"").decode() if isinstance(c.name, bytes) else c.name or ""}

    def read_SetState(self, c):
        return {"state": self.states[c.state]}

    def read_Clear(self, c):
        return {"planes": c.planes, "color": vector(c.color) if c.color else (0.0,) * 4,
                "depth": c.depth, "stencil": c.stencil,
                "accum": vector(c.accum) if c.accum else (0.0,) * 4}

    def read_Draw(self, c):
        return {"mesh": self.meshes[c.mesh],
                "eye_from_object": matrix(c.eyeFromObject) if c.eyeFromObject else identity(),
                "material": filled(Material(), c.material) if c.material else Material(),
                "lights": [] if c.lights == NONE else self.light_sets[c.lights],
                **self.maps_of(c), "id_base": c.idBase, "id_shift": c.idShift,
                "back_material": filled(Material(), c.backMaterial) if c.backMaterial else None,
                "current": current_of(c)}

    def maps_of(self, c):
        """[R10.37] By unit."""
        def more(given, absent=NONE):
            return [absent] * 3 if given is None or len(given) == 0 else list(given)

        surfaces = [c.surface] + more(c.moreSurfaces)
        planes = [c.surfacePlane] + more(c.moreSurfacePlanes, 0)

        return {"textures": [None if place == NONE else self.textures[place]
                             for place in [c.texture] + more(c.moreTextures)],
                "slots": [None if slot == NONE else slot for slot in [c.slot] + more(c.moreSlots)],
                "planes_of_surfaces": [None if number == NONE else (number, plane)
                                       for number, plane in zip(surfaces, planes)]}

    def read_WriteSpans(self, c):
        return {"spans": c.spans or [], "colors": rgba(c.colors), "depth": c.depth}

    def read_WritePixels(self, c):
        values: Any = [] if c.values is None else c.values
        return {"rect": box(c.rect), "plane": c.plane, "colors": rgba(c.colors),
                "values": np.array(values, dtype=np.int64), "depth": c.depth}

    def read_Accumulate(self, c):
        return {"op": names_of("AccumOp")[c.op], "value": c.value}

    def read_Copy(self, c):
        return {"plane": c.plane, "source": box(c.source), "x": c.x, "y": c.y}

    def read_CopyTexture(self, c):
        return {"slot": c.slot, "plane": c.plane, "rect": box(c.rect)}

    def read_SwapBuffers(self, _):
        return {}

    def read_Query(self, c):
        return {"key": c.key, "begin": c.begin}

    def read_MakeSurface(self, c):
        return {"number": c.number, "width": c.width, "height": c.height, "planes": c.planes,
                "depth_bits": c.depthBits, "samples": c.samples}

    def read_UseSurface(self, c):
        return {"number": c.number}

    def read_Blit(self, c):
        return {"from_surface": c.fromSurface, "planes": c.planes, "source": box(c.source),
                "target": box(c.target), "flip_x": c.flipX, "flip_y": c.flipY,
                "filter": c.filter}

    def read_Read(self, c):
        return {"key": c.key, "plane": c.plane, "rect": box(c.rect), "packed": c.packed}

    def read_DrawPixels(self, c):
        def integers(given):
            return None if given is None or len(given) == 0 else np.array(given, dtype=np.int64)

        return {"width": c.width, "height": c.height, "raster": raster_of(c),
                "zoom_x": c.zoomX, "zoom_y": c.zoomY,
                "colors": rgba(c.colors) if c.colors else None, "depths": integers(c.depths),
                "stencils": integers(c.stencils), "bits": integers(c.bits), "source": c.source,
                **self.maps_of(c)}
