#!/usr/bin/env python3
"""A client of the geometry module, in one file and with nothing but Python's standard library (3.9 or newer).

This is the larger part of the package `robosim`, and works without the rest: copied beside a program as robosim.py.

    import robosim
    from robosim import box, cylinder

    with robosim.connect("localhost:7575") as module:
        module.init([box([3, 0, 0], 0.2, 2, 4, name="wall"), cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)])
        print(module.sonar("robot"))                # 2.9: ahead, along a line
        print(module.move("robot", x=5).obstacle)   # wall
        print(module.scan("robot", count=360)[90])  # inf: nothing to the left

against a module that listens, such as `robosim-geometry serve 7575`; `robosim.accept(port)` waits for one that connects. Run by
itself it carries out the lines above: python3 robosim.py localhost:7575

Lengths are world units, Y is up, forward is an object's own +X, and to its right is its +Z. Every angle is in radians;
headings, turns `ry` and the beams of a fan are counter-clockwise seen from above, so that a positive one is to the left.
Only the direction of a sonar is given by two lengths, ahead and to the right: (0, 1) looks right.

Many numbers come as array.array, which numpy.asarray takes without copying; NumPy is not needed. docs/guide-python.md shows more, and
docs/protocol.md says what goes over the wire.
"""

import array
import base64
import html
import importlib
import itertools
import json
import math
import os
import pathlib
import re
import selectors
import socket
import struct
import sys
import time
import urllib.parse
import zlib
from typing import Any, Callable, Dict, Iterable, Iterator, List, NamedTuple, Optional, Sequence, Tuple, Union

__all__ = [
    "Module", "connect", "accept", "box", "cylinder", "sphere", "capsule", "mesh", "group", "grid", "fan", "layers",
    "pinhole", "directions", "sense", "picture", "poses", "edges", "measure", "pose", "place", "add", "remove", "go", "go_to_contact", "drive_for",
    "go_and_slide", "separate", "attach", "detach", "prove", "scene", "mixing", "world", "listed", "named", "body", "drive_settings", "swerve", "command", "push", "Move", "Sonar", "Moves", "Went", "Slid",
    "SlideContact", "Obstacle", "Listed", "Page", "Change", "Evidence", "Pose", "World", "LeftOut", "Scan", "Picture", "Velocity", "Body", "Contact", "Step",
    "Error", "NotDone", "ProtocolFault", "RequestError",
]

Json = Dict[str, Any]
Vector = Sequence[float]


class Error(Exception):
    """What this library raises."""


class NotDone(Error):
    """The connection failed, or the module ended it and said why, or no answer came in time."""


class ProtocolFault(Error):
    """The module said what the protocol does not allow."""


class RequestError(Error):
    """A request is wrong, or has no answer, as where no object has its name; the connection goes on."""


class LeftOut(NamedTuple):
    """An object of an init that is not in the world."""

    index: int  # type: ignore[assignment]  # of what a file has and `load` could not read: the number of its objects
    name: str  # empty for an object without one
    reason: str


class World(NamedTuple):
    """What became of an init."""

    added: int
    left_out: List[LeftOut]
    width: float
    height: float
    length: float
    dimension: str
    accuracy: str


class Pose(NamedTuple):
    """Where an object is: its centre, nine numbers whose columns are its axes, and its heading in radians."""

    center: List[float]
    rotation: List[float]
    heading: float


class Obstacle(NamedTuple):
    """An object that is in the way, told so that it is known without a name too."""

    index: int  # type: ignore[assignment]  # in the init's list, from 0; objects that were added later are counted on from its end
    name: str  # empty for an object without one
    kind: str  # "box", "cylinder", "sphere", "capsule", "mesh", "group" or "grid"
    center: List[float]


class Listed(NamedTuple):
    """An object of the world, where it is now."""

    index: int  # type: ignore[assignment]  # in the init's list, from 0; objects that were added later are counted on from its end
    name: str  # empty for an object without one
    kind: str  # "box", "cylinder", "sphere", "capsule", "mesh", "group" or "grid"
    center: List[float]
    heading: float  # radians about the vertical
    moveable: bool
    low: List[float]  # the lower corner of the box along the world's axes that holds it
    high: List[float]


class Page(NamedTuple):
    """Objects of the world, and the index from which to go on."""

    objects: List[Listed]
    next: Optional[int]  # None at the end


class Evidence(NamedTuple):
    """A proof of an answer as docs/proofs.md describes it, or why there is none. It is true where there is one."""

    proof: Optional[Json]
    reason: str = ""

    def __bool__(self) -> bool:
        return self.proof is not None


class Change(NamedTuple):
    """Whether a change was made. It is true where it was: `if module.place(...)`."""

    done: bool
    obstacle: Optional[str]  # what is in the way, "" for an object without a name; None for the border, or where done
    obstacles: Sequence[Obstacle] = ()  # with identify=True: all that are in the way, at most 16, the first added first

    def __bool__(self) -> bool:
        return self.done


class Went(NamedTuple):
    """What became of a move. It is true where the move was made: `if module.move(...)`."""

    made: bool
    fraction: float = 1.0  # the free share of the translation
    turn_fraction: float = 1.0  # the free share of the turn after it
    obstacle: Optional[str] = None  # what blocks, "" for an object without a name; None for the border, or where made
    contact: Optional[List[float]] = None
    normal: Optional[List[float]] = None  # from what blocks towards the object
    obstacles: Sequence[Obstacle] = ()  # of move_to_contact, and with identify=True: what blocks, none for the border

    def __bool__(self) -> bool:
        return self.made


class SlideContact(NamedTuple):
    """A contact of a move that slides."""

    obstacle: Optional[Obstacle]  # None for the border
    point: List[float]
    normal: List[float]  # from what blocks towards the object


class Slid(NamedTuple):
    """What became of a move that slides. It is true where nothing was in its way."""

    displacement: List[float]  # of the centre along the world's axes
    length: float  # of the way made
    left: List[float]  # what was still to go where the object stopped, along the world's axes
    turn_fraction: float  # the share of the turn that was made
    contacts: List[SlideContact]  # in the order in which they were met

    def __bool__(self) -> bool:
        return not self.contacts


class Move(NamedTuple):
    """A move of one object: along its own axes, then a turn about its own Y by `ry` radians, then about
    its own X by `rx` radians."""

    name: str
    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rx: float = 0.0
    ry: float = 0.0


class Moves(NamedTuple):
    """What became of several moves: those that were made, and why each of the others was not, by its index."""

    made: List[Move]
    refused: Dict[int, str]


class Sonar(NamedTuple):
    """A sonar at the centre of an object, towards `x` ahead and `z` to its right, of any length but zero; `width`, its full opening
    angle, is in radians."""

    name: str
    x: float = 1.0
    z: float = 0.0
    min: float = 0.0
    max: float = math.inf
    width: float = 0.0


class Velocity(NamedTuple):
    """Along an object's own axes, world units a second, and a turn about its own Y, radians a second to the left."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    ry: float = 0.0


class Body(NamedTuple):
    """Where a body is after a step, and its velocity."""

    center: List[float]
    heading: float  # radians about the vertical
    velocity: Velocity
    rotation: Optional[List[float]] = None  # nine numbers, for a body that does not stand upright


class Contact(NamedTuple):
    """A body and what it touches or has collided with in a step, or has parted from; one for each two.

    Of a mesh, a group, a grid and the border there is one for each normal along which it is touched.
    """

    name: str
    other: Optional[str]  # None for an object without a name, and for the border; `named` gives all of them one
    point: List[float]  # of several touches in the step that of the greatest impulse
    normal: List[float]  # at that point, towards the body
    impulse: float  # the sum over the step, newton seconds; 0 where they only touch, or part
    phase: str  # "BEGIN"; "LAST" for a contact that lasts from the step before, and goes on; "END"
    fall: float = 0.0  # world units: how far the body fell before it landed here, if more than its own height; else 0


class Stop(NamedTuple):
    """Why a body was stopped in a step."""

    name: str
    reason: str  # "COLLISIONS": too many of them; "BLOCKED": it could not be moved; "OVERLAP": when the step began
    other: Optional[str]  # what stopped it; None for an object without a name, for the border, and if it is unknown


class Step(NamedTuple):
    """What became of a step."""

    bodies: Dict[str, Body]  # all that the world has, by their names
    contacts: List[Contact]
    stopped: List[str]  # whose motion could not be decided; they stand still
    refused: Dict[int, str]  # why bodies, counted first, commands and pushes were left out, by their index
    stops: List[Stop] = []  # why each body in `stopped` was; empty from a server that gives no reasons

    @property
    def falls(self) -> Dict[str, float]:
        """By name, how far bodies fell that have landed in this step: where it is the ground, mostly a floor is missing."""
        return {contact.name: contact.fall for contact in self.contacts if contact.fall > 0}


def _png(width: int, height: int, channels: int, pixels: bytes) -> bytes:
    """An image of 8 bits a channel, grey or red, green and blue, as PNG; each row follows a filter byte of 0."""
    rows = b"".join(b"\0" + pixels[at:at + channels * width] for at in range(0, len(pixels), channels * width))

    def chunk(kind: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, {1: 0, 3: 2}[channels], 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def _numpy() -> Any:
    try:
        return importlib.import_module("numpy")
    except ImportError:
        raise ImportError("arrays of NumPy need it: pip install numpy; without it use distances, labels and so on, which are"
                          " array.array") from None


class Picture(NamedTuple):
    """A picture in colour, which notebooks show."""

    width: int
    height: int
    rgb: bytes
    """Red, green and blue of each pixel, a byte each, row by row from the top."""

    def png(self) -> bytes:
        """The picture as a PNG file has it."""
        return _png(self.width, self.height, 3, self.rgb)

    def _repr_png_(self) -> bytes:
        return self.png()

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes the picture as a PNG file."""
        pathlib.Path(path).write_bytes(self.png())

    def array(self) -> Any:
        """A NumPy array of bytes: height, width and 3 colours."""
        return _numpy().frombuffer(self.rgb, "uint8").reshape(self.height, self.width, 3)


class Scan:
    """What a sensor measured: a sequence of distances, one for each beam in order; inf where nothing echoes.

    `numpy.asarray` of it has the distances in its `shape`. Notebooks show a camera's frame as an image, the nearer the
    lighter, and a scan as a drawing."""

    def __init__(self, answer: Json, pattern: Json) -> None:
        #: World units, along each beam.
        self.distances: "array.array[float]" = _unpacked("d", answer["distances"])
        #: X, Y and Z of the surface's normal for each beam; empty unless asked for.
        self.normals: "array.array[float]" = _unpacked("d", answer.get("normals", ""))
        #: The names of the objects that are seen, "" for one without a name.
        self.names: List[str] = answer.get("names", [])
        #: For each beam the index in `names` of what it met, -1 for nothing; empty unless asked for.
        self.objects: "array.array[int]" = _unpacked("i", answer.get("objects", ""))
        #: For each beam the label of the material that it met, 0 for none; empty unless objects were asked for.
        self.labels: "array.array[int]" = _unpacked("i", answer.get("labels", ""))
        #: The beams, as `fan`, `layers`, `pinhole` or `directions` made them.
        self.pattern = pattern

    @property
    def shape(self) -> Tuple[int, ...]:
        """Rows and columns of a frame, layers and columns of a lidar, else the number of beams."""
        if self.pattern["kind"] == "pinhole":
            return self.pattern["height"], self.pattern["width"]
        if self.pattern["kind"] == "layers":
            return len(self.pattern["elevations"]), self.pattern["count"]
        return (len(self.distances),)

    @property
    def angles(self) -> "array.array[float]":
        """Of a fan, or of each layer: the radians of each beam to the left of the sensor's forward."""
        if "step" not in self.pattern:
            raise ValueError(f"only a fan and layers have angles (got: {self.pattern['kind']})")
        first, step = self.pattern["first"], self.pattern["step"]
        return array.array("d", (first + k * step for k in range(self.pattern["count"])))

    def array(self, of: str = "distances") -> Any:
        """A NumPy array in this `shape`, without a copy: of "distances", "normals" (with 3 numbers for each beam),
        "objects" or "labels"."""
        if of not in ("distances", "normals", "objects", "labels"):
            raise ValueError(f"of must be distances, normals, objects or labels (got: {of})")
        numbers = getattr(self, of)
        if not numbers:
            raise ValueError(f"the sensor was not asked for {of}; give {'normals' if of == 'normals' else 'objects'}=True")
        return _numpy().asarray(numbers).reshape(*self.shape, *([3] if of == "normals" else []))

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> Any:
        numbers = self.array()
        made = numbers if dtype is None else numbers.astype(dtype, copy=False)
        return made.copy() if copy else made

    def png(self) -> bytes:
        """Of a camera's frame: a PNG image of the distances, from near (light) to far (dark); black where nothing echoes."""
        if self.pattern["kind"] != "pinhole":
            raise ValueError(f"only a camera's frame is an image (got: {self.pattern['kind']})")
        echoes = [d for d in self.distances if math.isfinite(d)] or [0.0]
        near, scale = min(echoes), 215 / (max(echoes) - min(echoes) or 1.0)
        grey = bytes(round(255 - (d - near) * scale) if math.isfinite(d) else 0 for d in self.distances)
        return _png(self.pattern["width"], self.pattern["height"], 1, grey)

    def _repr_png_(self) -> Optional[bytes]:
        return self.png() if self.pattern["kind"] == "pinhole" else None

    def _repr_svg_(self) -> Optional[str]:
        if self.pattern["kind"] != "fan":
            return None
        ends = [(d * math.cos(a), -d * math.sin(a)) for d, a in zip(self.distances, self.angles) if math.isfinite(d)]
        reach = max([math.hypot(*end) for end in ends] + [1e-9]) * 1.05
        lines = "".join(f'<line x2="{x:.6g}" y2="{z:.6g}"/><circle cx="{x:.6g}" cy="{z:.6g}" r="{reach / 100:.6g}"/>'
                        for x, z in ends)
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="320" height="320" viewBox="{-reach:.6g} {-reach:.6g}'
                f' {2 * reach:.6g} {2 * reach:.6g}" stroke="#d03020" stroke-width="{reach / 400:.6g}" fill="#d03020">'
                f"{lines}</svg>")

    def __len__(self) -> int:
        return len(self.distances)

    def __getitem__(self, beam: int) -> float:
        return self.distances[beam]

    def __iter__(self) -> Iterator[float]:
        return iter(self.distances)

    def name(self, beam: int) -> Optional[str]:
        """The name of what a beam met; None for nothing."""
        seen = self.objects[beam]
        return None if seen < 0 else self.names[seen]


def _unpacked(code: str, text: str) -> "array.array[Any]":
    numbers: "array.array[Any]" = array.array(code)
    numbers.frombytes(base64.b64decode(text))
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers


def _packed(numbers: Iterable[float]) -> str:
    packed = array.array("d", getattr(numbers, "ravel", lambda: numbers)())  # arrays of NumPy have any shape
    if sys.byteorder == "big":
        packed.byteswap()
    return base64.b64encode(packed.tobytes()).decode("ascii")


# Objects. Each may have a name=, be moveable=True, and have a heading= or a rotation= of nine numbers, row by row, whose
# columns are its own axes in the world; a material=, as docs/materials.md has it in JSON: {"color": "#ff8000"}; and layers=, names
# without spaces, by which queries leave out all objects of a layer.

def _object(kind: str, fields: Json, rest: Json) -> Json:
    for field in rest:
        if field not in ("name", "moveable", "heading", "rotation", "material", "layers", "center"):
            raise TypeError(f"a {kind} has no {field}; it may have a name, moveable, heading, rotation, material and layers")
    made = {"kind": kind, **fields, **{field: value for field, value in rest.items() if value is not None}}
    if "center" in made:
        made["center"] = list(made["center"])
    return made


def box(center: Vector, width: float, height: float, length: float, **rest: Any) -> Json:
    """A box: its extents along X, Y and Z."""
    return _object("box", {"center": center, "width": width, "height": height, "length": length}, rest)


def cylinder(center: Vector, radius: float, height: float, **rest: Any) -> Json:
    """A cylinder about its own Y."""
    return _object("cylinder", {"center": center, "radius": radius, "height": height}, rest)


def sphere(center: Vector, radius: float, **rest: Any) -> Json:
    """A sphere."""
    return _object("sphere", {"center": center, "radius": radius}, rest)


def capsule(center: Vector, radius: float, segment: float, **rest: Any) -> Json:
    """All points within a radius of a segment along its own Y."""
    return _object("capsule", {"center": center, "radius": radius, "segment": segment}, rest)


def mesh(vertices: Iterable[Vector], faces: Iterable[Sequence[int]], solid: bool = False, **rest: Any) -> Json:
    """Triangles and quads, as indices of vertices; solid where they are closed and the inside counts too."""
    fields = {"vertices": [list(v) for v in vertices], "faces": [list(f) for f in faces]}
    return _object("mesh", {**fields, "solid": True} if solid else fields, rest)


def group(members: Iterable[Json], **rest: Any) -> Json:
    """Several objects as one, in its own frame."""
    return _object("group", {"members": list(members)}, rest)


def grid(center: Vector, cell: float, height: float, rows: Sequence[Sequence[Any]], **rest: Any) -> Json:
    """A map: the true cells of equally long rows are occupied; the first row lies at the least Z."""
    columns = len(rows[0])
    occupied = bytearray((columns * len(rows) + 7) // 8)
    for k, cell_value in enumerate(itertools.chain.from_iterable(rows)):
        if cell_value:
            occupied[k >> 3] |= 1 << (k & 7)
    return _object("grid", {"center": center, "cell": cell, "height": height, "columns": columns, "rows": len(rows),
                            "occupied": base64.b64encode(bytes(occupied)).decode("ascii")}, rest)


def named(objects: Iterable[Json]) -> List[Json]:
    """The same objects, of which those without a name are given one by their kind and index, as in "box 3": an answer
    can then tell what is in the way, and what a body touches."""
    given = list(objects)
    taken = {thing["name"] for thing in given if "name" in thing}
    made = []
    for k, thing in enumerate(given):
        name = f"{thing['kind']} {k}"
        while "name" not in thing and name in taken:
            name += "'"
        made.append(thing if "name" in thing else {**thing, "name": name})
        taken.add(made[-1]["name"])
    return made


# Bodies, their drives and commands: what Module.step takes. Units are SI, a world unit is a metre. Fields may be written
# as in docs/protocol.md, maxSpeed, or as max_speed.

_BODY = ("mass", "inertia", "restitution", "staticFriction", "slidingFriction", "damping", "turnDamping", "maxSpeed",
         "maxTurn", "floorFriction", "drag", "rolling")
_LIMITS = ("base", "maxSpeed", "maxAcceleration", "maxTurn", "maxTurnAcceleration")
_DRIVES = {"DIFFERENTIAL": _LIMITS[:3], "OMNIDIRECTIONAL": _LIMITS[1:], "ACKERMANN": (*_LIMITS[:4], "centreAhead"),
           "SWERVE": ("swerve",), "VELOCITY": (), "FORCE": (), "NONE": ()}
_MOTOR = ("stallTorque", "freeTurns", "stallCurrent", "gearRatio", "wheelRadius", "currentLimit", "supplyResistance")


def _fields(what: str, given: Json, known: Sequence[str]) -> Json:
    told = {}
    for field, value in given.items():
        first, *rest = field.split("_")
        wire = first + "".join(word.capitalize() for word in rest)
        if wire.endswith("Radians") and wire[:-7] in ("maxTurn", "maxTurnAcceleration"):
            wire = wire[:-7]  # with or without its unit
        if wire not in known:
            raise TypeError(f"{what} has no {field}; it may have: {', '.join(known) or 'nothing'}")
        if value != math.inf:  # no limit is a field that is left out
            told[wire] = value
    return told


def body(name: str, *, drive: Union[str, Json, None] = None, velocity: Optional[Sequence[float]] = None,
         ignored: Sequence[str] = (), **fields: float) -> Json:
    """A body for a moveable object: mass in kg and inertia in kg m^2, restitution, static_friction, sliding_friction and
    floor_friction without units, damping and turn_damping in shares a second, max_speed in m/s and max_turn in radians a
    second, drag in kg/m and rolling (a share of the load); of a static object the surface alone. A drive is the name of its kind or
    of `drive_settings`; a velocity has x, y and z in m/s along the object's own axes, and ry in radians a second. `ignored`
    has names of objects or layers that it passes through, and they through it."""
    told = {"objectName": name, **_fields("a body", fields, _BODY)}
    if drive is not None:
        told["drive"] = drive_settings(drive) if isinstance(drive, str) else drive
    if velocity is not None:
        told["velocity"] = Velocity(*velocity)._asdict()
    if ignored:
        told["ignored"] = list(ignored)
    return told


def drive_settings(kind: str, **limits: float) -> Json:
    """A drive: "differential", "omnidirectional", "ackermann" (a car, which turns about its rear axle, at the centre of
    the object), "velocity", "force" (for wheels at given places see `swerve`) or "none", which takes the drive from a body; with base in metres, max_speed in m/s, max_acceleration
    in m/s^2, max_turn in radians a second (of a car the radians of its front wheels to each side) and max_turn_acceleration
    in radians a second each second, as far as its kind has them; and of a car `centre_ahead`, metres from its rear axle
    forward to the object's centre."""
    word = kind.upper()
    if word not in _DRIVES:
        raise TypeError(f"a drive must be one of {', '.join(_DRIVES)}, in small letters too (got: {kind})")
    return {"kind": word, **_fields(f"a drive of kind {word}", limits, _DRIVES[word])}


def swerve(wheels: Iterable[Sequence[float]], grip: float = 1.0, max_steering: float = math.inf, **motor: float) -> Json:
    """A drive of wheels at given places, each forward and to the right of the object's centre in metres, with the friction of
    a wheel as `grip`. `max_steering` is in radians a second; 0 is for wheels that are not steered. A motor for each wheel has
    stall_torque in newton metres and stall_current in amperes at 12 V, free_turns a minute, gear_ratio, wheel_radius in
    metres, current_limit in amperes and supply_resistance in ohms times the number of motors; without one, friction alone
    limits the wheels."""
    told: Json = {"wheels": [[float(x), 0, float(z)] for x, z in wheels], "grip": grip}
    if max_steering != math.inf:
        told["maxSteering"] = max_steering
    if motor:
        told["motor"] = _fields("a motor", motor, _MOTOR)
    return {"kind": "SWERVE", "swerve": told}


def command(name: str, forward: float = 0.0, turn: float = 0.0, right: float = 0.0) -> Json:
    """What a robot is to do until it is told otherwise: `forward` in m/s, `turn` in radians (not degrees) a second to the
    left, and `right` in m/s for a drive that is omnidirectional, swerve, velocity or force. Of a car `turn` is the angle of its
    front wheels in radians; of a force they are newtons and newton metres."""
    return {"objectName": name, "forward": forward, "right": right, "turnRadians": turn}


def push(name: str, impulse: Optional[Vector] = None, force: Optional[Vector] = None, at: Optional[Vector] = None) -> Json:
    """A push from outside, along the world's axes: an impulse in newton seconds before a step, and a force in newtons all
    through it. Both act at a point of the world, or through the centre of the object."""
    if impulse is None and force is None:
        raise TypeError(f"a push must have an impulse or a force (got: neither, for {name})")
    given = {"impulse": impulse, "force": force, "at": at}
    return {"objectName": name, **{field: list(value) for field, value in given.items() if value is not None}}


def mixing(restitution: str = "geometric_mean", friction: str = "geometric_mean") -> Json:
    """How the numbers of two surfaces make that of their contact: "geometric_mean", "mean", "larger" (dyn4j and Box2D have
    it for restitution), "smaller" (Gazebo has it for friction) or "product" (Bullet has it for both)."""
    return {"restitution": restitution.upper(), "friction": friction.upper()}


# The beams of a sensor.

def fan(first: float, step: float, count: int) -> Json:
    """Beam k points first + k * step radians counter-clockwise from forward."""
    return {"kind": "fan", "first": first, "step": step, "count": count}


def layers(elevations: Iterable[float], first: float, step: float, count: int) -> Json:
    """A fan for each elevation; all angles in radians."""
    return {"kind": "layers", "elevations": list(elevations), "first": first, "step": step, "count": count}


def pinhole(width: int, height: int, field_of_view: float) -> Json:
    """A camera: a beam through the middle of each pixel, row by row from the top left. Its field of view is the angle in
    radians from the left edge to the right one."""
    return {"kind": "pinhole", "width": width, "height": height, "fieldOfView": field_of_view}


def directions(numbers: Iterable[float]) -> Json:
    """X, Y and Z of each beam, one after the other."""
    return {"kind": "directions", "directions": _packed(numbers)}


def _mount(at: Vector, heading: float, rotation: Optional[Vector]) -> Json:
    mount: Json = {"place": list(at)}
    if rotation is not None:
        mount["rotation"] = list(rotation)
    elif heading != 0:
        mount["headingRadians"] = heading
    return mount


# The requests of a batch; Module.batch sends many of them at once, and the methods of Module one each.

def sense(name: str, pattern: Json, *, at: Vector = (0, 0, 0), heading: float = 0.0,
          rotation: Optional[Vector] = None, min: float = 0.0, max: float = math.inf, width: float = 0.0,
          sees_carrier: bool = False, normals: bool = False, objects: bool = False,
          motion: Optional[Json] = None, rep117: bool = False, ignored: Iterable[str] = ()) -> Json:
    """All beams of a sensor on an object: `at` a place of its own frame, facing a heading there or with a rotation.
    Without a name, "", those of a sensor that nothing carries: `at` is a place of the world. An echo nearer than `min` is
    reported as `min`; with `rep117` as -inf, as in ROS. Objects in `ignored`, named themselves or by a layer, do not
    echo. Distances are in world units, `heading` and `width`, the full opening angle of each beam, in radians."""
    request: Json = {"kind": "sense", "mount": _mount(at, heading, rotation), "pattern": pattern, "min": min,
               "max": None if math.isinf(max) else max, "width": width, "seesCarrier": sees_carrier,
               "normals": normals, "objects": objects}
    if name:
        request["objectName"] = name
    if rep117:
        request["rep117"] = True
    names = list(ignored)
    if names:
        request["ignored"] = names
    return request if motion is None else {**request, "motion": motion}


def picture(name: str, width: int, height: int, field_of_view: float, *, at: Vector = (0, 0, 0), heading: float = 0.0,
            rotation: Optional[Vector] = None, samples: int = 1, mirrors: int = 3, sees_carrier: bool = False,
            light: Optional[Json] = None) -> Json:
    """A picture by a camera that an object carries; without a name, by one that stands in the world. The field of view and
    the heading are in radians; a rotation of nine numbers takes the place of a heading."""
    request: Json = {"kind": "picture", "pattern": pinhole(width, height, field_of_view), "samples": samples,
                     "mirrors": mirrors, "seesCarrier": sees_carrier, "mount": _mount(at, heading, rotation)}
    if name:
        request["objectName"] = name
    if light is not None:
        request["light"] = light
    return request


def poses(name: str, numbers: Iterable[float]) -> Json:
    """Whether an object would touch nothing at each pose: X, Y, Z and heading in radians, one after the other."""
    return {"kind": "poses", "objectName": name, "poses": _packed(numbers)}


def edges(name: str, numbers: Iterable[float]) -> Json:
    """Whether it would touch nothing on the way between two poses, eight numbers each."""
    return {"kind": "edges", "objectName": name, "edges": _packed(numbers)}


def measure(name: str, question: str, numbers: Iterable[float] = (), *, max: float = math.inf, margin: float = 0.0,
            ignored: Iterable[str] = (), other: Optional[str] = None) -> Json:
    """Numbers about many poses ("DISTANCES", "CLEARANCES"), edges ("EDGES") or drives ("DRIVES"), or about the object and
    an `other` ("SIGNED"); see the methods clearances, edge_fractions, drive_fractions and signed_distance of a Module."""
    request: Json = {"kind": "measure", "objectName": name, "question": question, "numbers": _packed(numbers),
                     "margin": margin, "ignored": list(ignored)}
    if other is not None:
        request["other"] = other
    return request if max == math.inf else {**request, "max": max}


def pose(name: str) -> Json:
    """Where an object is."""
    return {"kind": "pose", "objectName": name}


def place(name: str, center: Vector, heading: float = 0.0, identify: bool = False) -> Json:
    """Puts an object upright at a place where it touches nothing, without a way to it; the heading is in radians."""
    return _identified({"kind": "place", "objectName": name, "center": list(center), "headingRadians": heading}, identify)


def add(thing: Json, overlapping: bool = False, identify: bool = False) -> Json:
    """Adds an object; only where it touches nothing, unless it may overlap."""
    return _identified({"kind": "add", "object": thing, "overlapping": overlapping}, identify)


def _identified(request: Json, identify: bool) -> Json:
    return {**request, "identify": True} if identify else request


def remove(name: str) -> Json:
    """Removes an object."""
    return {"kind": "remove", "objectName": name}


def go(name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, rx: float = 0.0, ry: float = 0.0,
       identify: bool = False) -> Json:
    """A move whose answer says what blocks it: world units, and turns in radians."""
    return _identified({"kind": "move", "objectName": name, "x": x, "y": y, "z": z, "rxRadians": rx, "ryRadians": ry}, identify)


def go_to_contact(name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, rx: float = 0.0, ry: float = 0.0,
                  clearance: float = 0.0) -> Json:
    """A move as far as the way is free, and so far from what blocks it: world units, and turns in radians."""
    return {**go(name, x, y, z, rx, ry), "kind": "moveToContact", "clearance": clearance}


def drive_for(name: str, seconds: float, x: float = 0.0, y: float = 0.0, z: float = 0.0, ry: float = 0.0,
              clearance: Optional[float] = None) -> Json:
    """A motion with a velocity that stays constant in the object's own frame: world units and radians a second. Without a
    clearance it is all or nothing; with one it stops so far from what blocks it."""
    request: Json = {"kind": "drive", "objectName": name, "x": x, "y": y, "z": z, "ryRadians": ry, "seconds": seconds}
    return request if clearance is None else {**request, "clearance": clearance}


def go_and_slide(name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, rx: float = 0.0, ry: float = 0.0,
                 clearance: float = 0.0, bends: int = 4, step_height: float = 0.0, max_slope: float = math.pi / 2,
                 snap: float = 0.0) -> Json:
    """A move that goes on along what blocks it, at so many contacts: world units, and turns in radians. In a SPATIAL world it may walk: it climbs sills up to
    `step_height`, treats surfaces steeper than `max_slope` radians as walls, and is put down on ground within `snap`."""
    walk = {"stepHeight": step_height, "maxSlopeRadians": max_slope, "snap": snap}
    usual = {"stepHeight": 0.0, "maxSlopeRadians": math.pi / 2, "snap": 0.0}
    return {**go(name, x, y, z, rx, ry), "kind": "moveAndSlide", "clearance": clearance, "bends": bends,
            **{field: value for field, value in walk.items() if value != usual[field]}}


def separate(name: str, max: float) -> Json:
    """Frees an object that touches or overlaps others, by the smallest displacement found, of at most `max` world units."""
    return {"kind": "separate", "objectName": name, "max": max}


def attach(name: str, carrier: str, at: Optional[Vector] = None, heading: float = 0.0,
           rotation: Optional[Vector] = None) -> Json:
    """Attaches an object to another one, which carries it from then on: where it is now, or at a place in the frame of the
    carrier, with a heading in radians or nine numbers of a rotation, if nothing else is there."""
    request: Json = {"kind": "attach", "objectName": name, "carrier": carrier}
    if at is not None:
        request["mount"] = _mount(at, heading, rotation)
    return request


def detach(name: str) -> Json:
    """Detaches an object from what carries it; it stays where it is."""
    return {"kind": "detach", "objectName": name}


def prove(request: Json) -> Json:
    """Proofs of the answer that a request made by `go`, `pose` or `sense` would have now; nothing is moved."""
    return {"kind": "prove", "request": request}


def scene() -> Json:
    """The objects that proofs are about, as they are now."""
    return {"kind": "scene"}


def world() -> Json:
    """What became of the last init."""
    return {"kind": "world"}


def listed(first: int = 0, count: int = 65536) -> Json:
    """So many objects of the world from an index on; its answer has where to go on, None at the end."""
    return {"kind": "list", "first": first, "count": count}


Answer = Union[Scan, Picture, List[bool], Pose, Change, Went, Slid, World, Page, List[Evidence], Json, List[float], None, RequestError]


def _not_finite(value: Any, path: str = "") -> str:
    """Which number of a message is none that JSON has; empty if all are."""
    if isinstance(value, float) and not math.isfinite(value):
        return f"{value} at {path}"
    items: Iterable[Tuple[Any, Any]] = ()
    if isinstance(value, dict):
        items = value.items()
    elif isinstance(value, (list, tuple)):
        items = enumerate(value)
    return next(filter(None, (_not_finite(each, f"{path}/{key}") for key, each in items)), "")


class Module:
    """A connection to the geometry module; `connect` and `accept` make one.

    It belongs to one thread at a time: give each thread its own connection, which has a world of its own, or a lock. After
    an interrupt (Ctrl-C) or a timeout the connection can be used again: each request has an id that its answer repeats, so
    that a late answer is dropped and never taken for that of a later call. The interrupted request may have been carried
    out. Only an interrupt in the instant in which bytes are sent or taken over ends the connection; each later call says
    so, and a new connection begins with a new `init`, unless the session is kept: see `resume`.
    """

    def __init__(self, sock: socket.socket, secret: Optional[str] = None, resume: bool = False,
                 dial: Optional[Callable[[], socket.socket]] = None) -> None:
        self._secret = secret
        self._dial = dial
        #: What identifies the session for `resume`; None if the module does not keep it.
        self.token: Optional[str] = None
        self._last = 0  # the id of the last request
        self._open(sock, "" if resume else None)

    def _open(self, sock: socket.socket, resume: Optional[str]) -> Any:
        """Says hello, and returns the id of the last request that was carried out in a session that is resumed."""
        self._sock = sock
        self._waiting = selectors.DefaultSelector()
        self._received = bytearray()
        self._searched = 0  # so many of the bytes received have no line feed
        self._torn = ""  # what an interrupt has broken; set while bytes may be lost
        self._refusal = ""
        self._ahead: List[Any] = []  # the ids of requests that were sent ahead, whose answers are still to be received
        self._kept: Dict[Any, Json] = {}  # answers to those that came before they were asked for
        self._silent: Dict[Any, None] = {}  # the ids of inits, which have no answer unless they are wrong
        hello: Json = {"type": "hello", "version": 1}
        if self._secret is not None:
            hello["secret"] = self._secret
        if resume is not None:
            hello["resume"] = resume
        try:
            sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)  # messages are small and wait for their answers
            self._waiting.register(sock, selectors.EVENT_READ)
            # At once: who is silent for 300 ms is taken for a Java peer that waits for a stream header.
            self._write(hello)
            deadline = self._deadline()
            line = self._line(deadline)
            if line and not line.startswith(b"{"):  # we were late: the header for Java peers, on a line of its own
                self._consume(line)
                line = self._line(deadline)
            welcome = self._parsed(line)
            self._consume(line)
            if welcome["type"] != "hello":
                self._refuse(welcome)
                raise ProtocolFault(f"the answer must be hello (got: {welcome['type']})")
        except BaseException:
            self.close()
            raise
        #: The module's name and version.
        self.version: str = welcome["module"]
        #: What the module takes at most, by the names of docs/protocol.md.
        self.limits: Dict[str, int] = welcome["limits"]
        self.token = welcome.get("token")
        return welcome.get("id")

    def resume(self) -> bool:
        """Goes on after the connection has dropped: connects again to the session that the module keeps, with its world and
        bodies, where it was started with `--resume` and this connection was made with `resume=True`. Answers that had not
        been received are lost. Returns whether the last request was carried out; if not, it has to be sent again.

        Fails with `NotDone` if the session is not kept, or no longer; then connect anew and begin with an `init`."""
        if self._dial is None or self.token is None:
            raise NotDone("this session is not kept; connect with resume=True to a module that was started with --resume")
        self.close()
        return bool(self._open(self._dial(), self.token) == self._last)

    def __enter__(self) -> "Module":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """Ends the connection."""
        self._waiting.close()
        self._sock.close()

    def send(self, message: Json) -> None:
        """Sends one message as it is; for what has no method here, and for several requests ahead of their answers, which
        `receive` returns in order. Other calls may come between."""
        self._send(message, ahead=True)

    def _send(self, message: Json, ahead: bool) -> Any:
        """Sends a message with its id, or with one that is given to it; returns the id."""
        self._check()
        number = message.get("id")
        if number is None:
            self._last += 1
            number = self._last
        self._write({**message, "id": number}, number, ahead)
        return number

    def _write(self, message: Json, number: Any = None, ahead: bool = False) -> None:
        # json writes the shortest digits that mean a double, and reads them back to the same bits.
        try:
            line = json.dumps(message, allow_nan=False, separators=(",", ":")).encode() + b"\n"
        except ValueError:
            raise ValueError(f"numbers must be finite (got: {_not_finite(message)})") from None
        is_silent = message.get("type") == "init" and not message.get("answer")
        self._torn = "while a request was being sent"
        if is_silent:
            self._silent[number] = None
        elif ahead:
            self._ahead.append(number)
        try:
            self._sock.sendall(line)
        except ConnectionError:
            pass  # the module ended the conversation, and its last line says why
        except OSError as e:
            raise NotDone(f"the connection failed: {e}") from None
        self._torn = ""

    def _check(self) -> None:
        if self._torn:
            raise NotDone(f"this connection was interrupted {self._torn}, and cannot be used any more; connect again")

    def _deadline(self) -> Optional[float]:
        timeout = self._sock.gettimeout()
        return None if timeout is None else time.monotonic() + timeout

    def _line(self, deadline: Optional[float]) -> bytes:
        """The next line, which is left where it is until it is consumed; without a line feed where the stream ends. An
        interrupt loses nothing while this waits."""
        while True:
            end = self._received.find(b"\n", self._searched)
            if end >= 0:
                return bytes(self._received[:end + 1])
            self._searched = len(self._received)
            pending = getattr(self._sock, "pending", None)  # of a socket with TLS
            while not (pending and pending()):
                left = None if deadline is None else deadline - time.monotonic()
                if left is not None and left <= 0:
                    raise NotDone(f"no answer came within {self._sock.gettimeout():g} s; the connection can be used further,"
                                  " and the answer is dropped when it comes")
                if self._waiting.select(left):
                    break
            self._torn = "while an answer was being read"
            try:
                got = self._sock.recv(1 << 18)
            except ConnectionError:
                got = b""
            except socket.timeout:
                self._torn = ""
                continue  # of a socket with TLS, of which a part has come
            except OSError as e:
                raise NotDone(f"the connection failed: {e}") from None
            self._received += got
            self._torn = ""
            if not got:
                return bytes(self._received)

    def _consume(self, line: bytes) -> None:
        self._searched = 0
        del self._received[:len(line)]

    def _parsed(self, line: bytes) -> Json:
        if not line.endswith(b"\n"):
            raise NotDone("the module ended the conversation"
                          + (f" when it refused this: {self._refusal}" if self._refusal else self._last_words()))
        try:
            answer = json.loads(line)
            answer["type"]
        except (ValueError, KeyError, TypeError):
            raise ProtocolFault(f"an answer must be a JSON object with a type (got: {line[:100]!r}); is it the"
                                " geometry module that listens there?") from None
        return answer

    def _last_words(self) -> str:
        return "; its log tells why"

    def _refuse(self, answer: Json) -> None:
        if answer["type"] == "error" and answer.get("continues"):
            raise RequestError(answer["message"])
        if answer["type"] == "error":
            self._refusal = answer["message"]
            raise NotDone(f"the module refused it: {answer['message']}")

    def receive(self, kind: str) -> Json:
        """The answer to the first request that was sent ahead and has none yet; it must be of a type."""
        if not self._ahead:
            raise Error("each request that was sent has its answer; send another first")
        return self._answer(self._ahead[0], kind)

    def _answer(self, number: Any, kind: str) -> Json:
        """The answer to the request with an id. Those to requests that were sent ahead are kept, the rest, which
        interrupted calls have left, dropped."""
        self._check()
        deadline = self._deadline()
        answer = self._kept.get(number)
        while answer is None:
            line = self._line(deadline)
            came = self._parsed(line)
            of = came.get("id")
            if of is None and came["type"] != "error":
                raise ProtocolFault(f"an answer must repeat the id of its request (got: {line[:100]!r}); is the module older"
                                    " than this file?")
            if of == number or of is None or of in self._silent:
                answer = came
            elif of in self._ahead:
                self._kept[of] = came
            if of == number and number in self._ahead:
                self._ahead.remove(number)
            self._silent.pop(of, None)
            self._consume(line)  # last: where that is interrupted, the line comes again, and is dropped
        if number in self._kept:
            self._ahead.remove(number)
            del self._kept[number]
        self._refuse(answer)
        if answer["type"] != kind:
            raise ProtocolFault(f"the answer must be {kind} (got: {answer['type']})")
        return answer

    def ask(self, message: Json, kind: str) -> Tuple[Json, float]:
        """Sends a message; the answer as it is, and the seconds that it took."""
        begin = time.perf_counter()
        answer = self._answer(self._send(message, ahead=False), kind)
        return answer, time.perf_counter() - begin

    def ping(self) -> float:
        """The seconds of a round trip."""
        return self.ask({"type": "ping"}, "pong")[1]

    def init(self, objects: Iterable[Json], *, width: Optional[float] = None, height: Optional[float] = None,
             length: Optional[float] = None, dimension: Optional[str] = None,
             accuracy: Optional[str] = None) -> World:
        """A new world in place of the one before. What is left out is the module's own: a size that holds all objects,
        PLANAR and EXACT unless it was started otherwise."""
        given = {"width": width, "height": height, "length": length, "dimension": dimension, "accuracy": accuracy}
        settings = {name: value for name, value in given.items() if value is not None}
        asked = {"type": "init", "objects": list(objects), "settings": settings, "answer": True}
        return self._one(world(), self.ask(asked, "answers")[0])

    def load(self, path: str, *, on_server: bool = False, **settings: Any) -> World:
        """A new world from a file that the module reads, with its bodies: a world of docs/world-format.md, SDFormat, URDF, a
        ROS map, a mesh. Objects without a name are given one, as by `named`. The file is sent with all files of its folder
        that it names, directly or through others; `on_server` it is a path within the folder given to `serve --worlds`, of
        which nothing is sent. Settings are those of `init`, and come before the file's."""
        message: Json = {"type": "load", "file": path, "named": True}
        if not on_server:
            message["file"], message["files"] = _with_its_files(path)
        given = {name: value for name, value in settings.items() if value is not None}
        if given:
            message["settings"] = given
        return self._one(world(), self.ask(message, "answers")[0])

    def step(self, seconds: float, bodies: Iterable[Json] = (), commands: Iterable[Json] = (),
             mixing: Optional[Json] = None, pushes: Iterable[Json] = ()) -> Step:
        """Gives bodies and commands, as `body` and `command` make them, and lets time pass. Robots keep their commands:
        `module.step(0.1)` goes on with them. A step of 0 seconds moves nothing, and tells where all bodies are. A `mixing`
        holds for this step and all later ones of the world; pushes, as `push` makes them, act once."""
        message: Json = {"type": "step", "seconds": seconds, "bodies": list(bodies), "commands": list(commands)}
        if mixing is not None:
            message["mixing"] = mixing
        pushed = list(pushes)
        if pushed:
            message["pushes"] = pushed
        for given in message["bodies"]:
            # The module would close the connection on a field that it does not know.
            rest = {field: value for field, value in given.items() if field not in ("objectName", "drive", "velocity")}
            _fields("a body", rest, _BODY)
            if "drive" in given:
                drive_settings(**given["drive"])
        for given in message["commands"]:
            _fields("a command", given, ("objectName", "forward", "right", "turn", "turnRadians"))
        answer = self.ask(message, "bodies")[0]
        try:
            return Step({b["objectName"]: Body(b["center"], b["heading"], Velocity(**b["velocity"]), b.get("rotation"))
                         for b in answer["bodies"]},
                        [Contact(c["objectName"], c.get("other"), c["point"], c["normal"], c["impulse"], c["phase"],
                                 c.get("fall", 0.0))
                         for c in answer["contacts"]],
                        answer["stopped"], {problem["index"]: problem["reason"] for problem in answer["refused"]},
                        [Stop(s["objectName"], s["reason"], s.get("other")) for s in answer.get("stops", [])])
        except (KeyError, TypeError) as e:
            raise ProtocolFault(f"bodies must have their fields (got: {str(answer)[:100]}): {e!r}") from None

    def drive(self, name: str, forward: float = 0.0, turn: float = 0.0, right: float = 0.0) -> Body:
        """Tells a robot what to do from now on, in m/s and radians a second; it moves with the next `step`. One without a body gets one, of a robot
        with two wheels, which cannot go to the right: a RequestError says so."""
        told = self.step(0, commands=[command(name, forward, turn, right)])
        if told.refused:
            raise RequestError(told.refused[0])
        return told.bodies[name]

    def moves(self, moves: Iterable[Move]) -> Moves:
        """Several moves in order, each in the world that the earlier ones left. A tuple such as ("cart", 1) is a `Move`."""
        asked = [Move(*move) for move in moves]
        lines = [{"objectName": m.name, "x": m.x, "y": m.y, "z": m.z, "rx": m.rx, "ry": m.ry} for m in asked]
        answer = self.ask({"type": "moves", "moves": lines}, "moves")[0]
        refused = {problem["index"]: problem["reason"] for problem in answer["refused"]}
        made = [move for k, move in enumerate(asked) if k not in refused]
        if len(made) != len(answer["moves"]):
            raise ProtocolFault(f"there must be {len(made)} moves that were made (got: {len(answer['moves'])})")
        return Moves(made, refused)

    def sonars(self, sonars: Iterable[Sonar]) -> List[Union[float, RequestError]]:
        """Several sonars; inf where nothing echoes, a RequestError in place of a distance that there is not. A tuple such as
        ("cart", 0, 1) is a `Sonar`."""
        lines = [{"objectName": s.name, "xOffset": s.x, "zOffset": s.z,
                  "beam": {"min": s.min, "max": None if math.isinf(s.max) else s.max, "width": s.width}}
                 for s in (Sonar(*sonar) for sonar in sonars)]
        answer = self.ask({"type": "sonars", "requests": lines}, "distances")[0]["distances"]
        if len(answer) != len(lines):
            raise ProtocolFault(f"there must be {len(lines)} distances (got: {len(answer)})")
        return [math.inf if d is None else RequestError(d["error"]) if isinstance(d, dict) else d for d in answer]

    def sonar(self, name: str, x: float = 1.0, z: float = 0.0, *, min: float = 0.0, max: float = math.inf,
              width: float = 0.0) -> float:
        """The distance that one sonar measures, towards `x` ahead and `z` to the right; `width`, its full opening angle, is in
        radians."""
        distance = self.sonars([Sonar(name, x, z, min, max, width)])[0]
        if isinstance(distance, RequestError):
            raise distance
        return distance

    def batch(self, requests: Iterable[Json]) -> List[Answer]:
        """Requests of any kinds in one round trip, carried out in order; a RequestError in place of an answer that there
        is not. The functions of this module, from `sense` to `world`, make requests."""
        asked = list(requests)
        answers = self.ask({"type": "batch", "requests": asked}, "answers")[0]["answers"]
        if len(answers) != len(asked):
            raise ProtocolFault(f"there must be {len(asked)} answers (got: {len(answers)})")
        return [_read(request, answer) for request, answer in zip(asked, answers)]

    def _one(self, request: Json, bundle: Optional[Json] = None) -> Any:
        if bundle is None:
            bundle = self.ask({"type": "batch", "requests": [request]}, "answers")[0]
        answer = _read(request, bundle["answers"][0])
        if isinstance(answer, RequestError):
            raise answer
        return answer

    def move(self, name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, *, rx: float = 0.0,
             ry: float = 0.0, identify: bool = False) -> Went:
        """Moves an object along its own axes, then turns it by radians; all or nothing. With `identify` the answer's `obstacles` tell
        what blocks by its index too, for objects without a name."""
        return self._one(go(name, x, y, z, rx, ry, identify))

    def move_to_contact(self, name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, *, rx: float = 0.0,
                        ry: float = 0.0, clearance: float = 0.0) -> Went:
        """Moves an object as far as the way is free, up to a clearance from what blocks it; turns are in radians. The answer's fractions are
        the shares that were made; it is true where all of the move was."""
        return self._one(go_to_contact(name, x, y, z, rx, ry, clearance))

    def drive_for(self, name: str, seconds: float, x: float = 0.0, y: float = 0.0, z: float = 0.0, *, ry: float = 0.0,
                  clearance: Optional[float] = None) -> Went:
        """Moves an object with a velocity that stays constant in its own frame, so that it turns while it translates: along an
        arc. World units and radians a second. All or nothing; with a clearance it goes as far as it can, and the answer's
        fractions are the shares of the time that were made."""
        return self._one(drive_for(name, seconds, x, y, z, ry, clearance))

    def move_and_slide(self, name: str, x: float = 0.0, y: float = 0.0, z: float = 0.0, *, rx: float = 0.0,
                       ry: float = 0.0, clearance: float = 0.0, bends: int = 4, step_height: float = 0.0,
                       max_slope: float = math.pi / 2, snap: float = 0.0) -> Slid:
        """Moves an object and, where it is blocked, on along what blocks it, at so many contacts; then turns it by radians. In a
        SPATIAL world it may walk, as the function `go_and_slide` describes."""
        return self._one(go_and_slide(name, x, y, z, rx, ry, clearance, bends, step_height, max_slope, snap))

    def separate(self, name: str, max: float) -> Optional[List[float]]:
        """Frees an object that touches or overlaps others by the smallest displacement found, of at most `max` world units.
        That displacement, zero if it touched nothing; None if none was found, and the object stays where it is."""
        return self._one(separate(name, max))

    def attach(self, name: str, carrier: str, at: Optional[Vector] = None, heading: float = 0.0,
               rotation: Optional[Vector] = None) -> Change:
        """Attaches an object to another one, which carries it from then on: where it is now, or at a place in the frame of the
        carrier, with a heading in radians or nine numbers of a rotation; not done if something is in the way there."""
        return self._one(attach(name, carrier, at, heading, rotation))

    def detach(self, name: str) -> Change:
        """Detaches an object from what carries it; it stays where it is and goes on as fast as its place went."""
        return self._one(detach(name))

    def prove(self, request: Json) -> List[Evidence]:
        """Proofs of the answer that a request made by `go`, `pose` or `sense` would have now: of a pose that the object touches no
        other, of a move one for each part and one for its end, of a sensor one for each beam. Nothing is moved."""
        return self._one(prove(request))

    def scene(self) -> Json:
        """The objects that proofs are about, as they are now."""
        return self._one(scene())

    def sense(self, name: str, pattern: Json, **options: Any) -> Scan:
        """All beams of a sensor on an object, with the options of the function `sense`; without a name, "", of one that
        stands in the world."""
        return self._one(sense(name, pattern, **options))

    def scan(self, name: str, first: float = 0.0, step: Optional[float] = None, count: int = 360,
             **options: Any) -> Scan:
        """A laser scan, its angles in radians; without a step, a whole turn counter-clockwise."""
        if count < 1:
            raise ValueError(f"count must be at least 1 (got: {count})")
        return self.sense(name, fan(first, math.tau / count if step is None else step, count), **options)

    def frame(self, name: str, width: int, height: int, field_of_view: float, **options: Any) -> Scan:
        """A camera's frame, row by row from the top left: distances along the rays, objects and labels. The field of view is
        in radians."""
        return self.sense(name, pinhole(width, height, field_of_view), **{"objects": True, **options})

    def picture(self, name: str, width: int, height: int, field_of_view: float, **options: Any) -> Picture:
        """A picture in colour, by a camera that an object carries; without a name, by one that stands in the world. The field
        of view is in radians."""
        return self._one(picture(name, width, height, field_of_view, **options))

    def plan(self, size: int = 640, samples: int = 1) -> Picture:
        """A picture of the whole world from straight above: X to the right, Z downwards; its longer side has `size` pixels."""
        return self._from_above(self.objects(), size, samples)[0]

    def _from_above(self, objects: List[Listed], size: int, samples: int) -> Tuple[Picture, Tuple[float, ...]]:
        """The picture, and what it shows: the least X and Z, and the extents along them."""
        if not objects:
            raise ValueError("an empty world has no plan; send objects by init, load or add")
        low = [min(thing.low[axis] for thing in objects) for axis in range(3)]
        high = [max(thing.high[axis] for thing in objects) for axis in range(3)]
        margin = 0.02 * max(high[0] - low[0], high[2] - low[2], 1e-6)
        left, top = low[0] - margin, low[2] - margin
        across, down = high[0] + margin - left, high[2] + margin - top
        distance = 100 * max(across, down)  # so far away that no wall hides what is beside it
        scale = size / max(across, down)
        taken = self.picture("", max(1, round(across * scale)), max(1, round(down * scale)), 2 * math.atan(across / 2 / distance),
                             at=[left + across / 2, high[1] + distance, top + down / 2],
                             rotation=[0, 0, 1, -1, 0, 0, 0, -1, 0], samples=samples)
        return taken, (left, top, across, down)

    def _repr_html_(self) -> str:
        """The plan, with the names of what is moveable."""
        objects = self.objects()
        if not objects:
            return "<p>a world without objects</p>"
        taken, (left, top, across, down) = self._from_above(objects, 640, 1)
        size = across / 50
        names = "".join(f'<text x="{thing.center[0]:.6g}" y="{thing.low[2] - size / 3:.6g}">{html.escape(thing.name)}</text>'
                        for thing in objects if thing.moveable)
        image = base64.b64encode(taken.png()).decode("ascii")
        return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{taken.width}" height="{taken.height}" viewBox="{left:.9g}'
                f' {top:.9g} {across:.9g} {down:.9g}"><image x="{left:.9g}" y="{top:.9g}" width="{across:.9g}" height="{down:.9g}"'
                f' preserveAspectRatio="none" href="data:image/png;base64,{image}"/><g font-family="sans-serif"'
                f' font-size="{size:.6g}" text-anchor="middle">{names}</g></svg>')

    def free_poses(self, name: str, numbers: Iterable[float]) -> List[bool]:
        """Whether an object would touch nothing at each pose: X, Y, Z and heading in radians, one after the other."""
        return self._one(poses(name, numbers))

    def free_edges(self, name: str, numbers: Iterable[float]) -> List[bool]:
        """Whether it would touch nothing on the way between two poses, eight numbers each."""
        return self._one(edges(name, numbers))

    def clearances(self, name: str, numbers: Iterable[float], max: float = math.inf, ignored: Iterable[str] = (),
                   points: bool = False) -> "array.array[float]":
        """The signed distance of an object at each pose to the nearest other: below 0 where it overlaps one, infinite if nothing
        is within max. With points, ten numbers for each pose: the distance, a point on the object, one on the other, and the
        direction from that. Objects in `ignored`, named themselves or by a layer, do not count."""
        question = "CLEARANCES" if points else "DISTANCES"
        return self._one(measure(name, question, numbers, max=max, ignored=ignored))

    def signed_distance(self, name: str, other: str) -> "array.array[float]":
        """The signed distance of two objects where they are, below 0 where they overlap. Eleven numbers: a lower bound, an upper
        bound, a point on the first, one on the other, and the direction from that."""
        return self._one(measure(name, "SIGNED", other=other))

    def edge_fractions(self, name: str, numbers: Iterable[float], margin: float = 0.0,
                       ignored: Iterable[str] = ()) -> "array.array[float]":
        """The fractions of the translation and of the turn of each edge that are free, two numbers each, while the object keeps
        a margin from everything."""
        return self._one(measure(name, "EDGES", numbers, margin=margin, ignored=ignored))

    def drive_fractions(self, name: str, numbers: Iterable[float], margin: float = 0.0,
                        ignored: Iterable[str] = ()) -> "array.array[float]":
        """The fraction of the time of each drive that is free: nine numbers each, a pose, a velocity forward, up and to the right,
        one of the heading in radians a second, and seconds."""
        return self._one(measure(name, "DRIVES", numbers, margin=margin, ignored=ignored))

    def pose(self, name: str) -> Pose:
        """Where an object is."""
        return self._one(pose(name))

    def place(self, name: str, center: Vector, heading: float = 0.0, identify: bool = False) -> Change:
        """Puts an object upright at a place where it touches nothing, without a way to it; the heading is in radians. With
        `identify` the answer's `obstacles` are all that it would touch there."""
        return self._one(place(name, center, heading, identify))

    def add(self, thing: Json, overlapping: bool = False, identify: bool = False) -> Change:
        """Adds an object; only where it touches nothing, unless it may overlap."""
        return self._one(add(thing, overlapping, identify))

    def remove(self, name: str) -> Change:
        """Removes an object; not done where there is none of that name."""
        return self._one(remove(name))

    def world(self) -> World:
        """What became of the last init."""
        return self._one(world())

    def objects(self) -> List[Listed]:
        """What is in the world, in the order in which it was added."""
        found: List[Listed] = []
        first: Optional[int] = 0
        while first is not None:
            page = self._one(listed(first))
            found += page.objects
            first = page.next
        return found


_WORDS = re.compile(r"""[^\s"'<>,;=()\[\]{}|]+""")


def _with_its_files(path: str) -> Tuple[str, Dict[str, str]]:
    """A file's name and, in base64, it and what it names in its own folder, by any word or line; what they are, the module
    knows."""
    main = pathlib.Path(path)
    folder, found = main.parent, {}
    left = [main]
    while left:
        file = left.pop()
        name = file.relative_to(folder).as_posix()
        if name in found:
            continue
        try:
            content = file.read_bytes()
        except OSError as e:
            raise NotDone(f"{file} cannot be read; check the path ({e.strerror})") from None
        found[name] = base64.b64encode(content).decode("ascii")
        if b"\0" in content or len(content) > 1 << 24:
            continue  # no text, or too much to be anything but numbers
        text = content.decode("utf-8", "replace")
        quoted = re.findall(r"""["'>]([^"'<>\n]+)["'<]""", text)
        values = [line.split(None, 1)[-1] for line in text.splitlines() if len(line) < 300 and line.strip()]
        for word in {*_WORDS.findall(text), *quoted, *values}:
            word = urllib.parse.unquote(word.strip().rpartition("file://")[2])
            if not (word and len(word) < 256 and "." in word and set(word) - set("0123456789+-.eE")):
                continue
            for beside in (file.parent / word, folder / word):
                inside = pathlib.Path(os.path.normpath(beside))
                if beside.is_file() and os.path.normpath(folder) in map(str, [*inside.parents, inside.parent]):
                    left.append(folder / os.path.relpath(inside, folder))
    return main.name, found


def _obstacle(told: Json) -> Obstacle:
    return Obstacle(told["index"], told.get("name", ""), told["kind"], told["center"])


def _obstacles(answer: Json) -> Sequence[Obstacle]:
    return tuple(_obstacle(told) for told in answer.get("obstacles", ()))


def _read(request: Json, answer: Json) -> Answer:
    kind = request["kind"]
    if "error" in answer:
        return RequestError(answer["error"])
    try:
        if kind == "sense":
            return Scan(answer, request["pattern"])
        if kind == "picture":
            return Picture(answer["width"], answer["height"], base64.b64decode(answer["rgb"]))
        if kind in ("poses", "edges"):
            bits = base64.b64decode(answer["free"])
            return [bool(bits[k >> 3] >> (k & 7) & 1) for k in range(answer["count"])]
        if kind == "measure":
            return _unpacked("d", answer["numbers"])
        if kind == "pose":
            return Pose(answer["center"], answer["rotation"], answer["heading"])
        if kind in ("move", "moveToContact", "drive"):
            return Went(answer["made"], answer.get("fraction", 1.0), answer.get("turnFraction", 1.0),
                        answer.get("obstacle"), answer.get("contact"), answer.get("normal"), _obstacles(answer))
        if kind == "moveAndSlide":
            contacts = [SlideContact(_obstacle(c["obstacle"]) if "obstacle" in c else None, c["point"], c["normal"])
                        for c in answer["contacts"]]
            return Slid(answer["displacement"], answer["length"], answer["left"], answer["turnFraction"], contacts)
        if kind == "separate":
            return answer["displacement"] if answer["done"] else None
        if kind == "scene":
            found: Json = json.loads("".join(answer["scene"]))
            return found
        if kind == "prove":
            return [Evidence(json.loads("".join(e["proof"])) if "proof" in e else None, e.get("reason", ""))
                    for e in answer["proofs"]]
        if kind == "world":
            left = [LeftOut(o["index"], o.get("name", ""), o["reason"]) for o in answer["leftOut"]]
            return World(answer["added"], left, answer["width"], answer["height"], answer["length"],
                         answer["dimension"], answer["accuracy"])
        if kind == "list":
            return Page([Listed(o["index"], o.get("name", ""), o["kind"], o["center"], o["heading"], o["moveable"],
                                o["low"], o["high"]) for o in answer["listed"]], answer.get("next"))
        return Change(answer["done"], answer.get("obstacle"), _obstacles(answer))
    except (KeyError, TypeError, ValueError, IndexError) as e:
        raise ProtocolFault(f"an answer to {kind} must have its fields (got: {str(answer)[:100]}): {e!r}") from None


def _place(text: str) -> Tuple[str, int]:
    host, _, port = text.rpartition(":")
    if not port.isdigit() or not 0 <= int(port) <= 65535:
        raise NotDone(f"a place must be HOST:PORT or a port (got: {text})")
    return host or "localhost", int(port)


def connect(to: str, secret: Optional[str] = None, timeout: Optional[float] = None, resume: bool = False) -> Module:
    """Connects to a module that listens at "HOST:PORT".

    With a timeout, each answer may take so many seconds at most. With `resume`, the module may keep the session after the
    connection has dropped: see `Module.resume`."""
    def dial() -> socket.socket:
        try:
            return socket.create_connection(_place(to), timeout)
        except OSError as e:
            raise NotDone(f"no module listens at {to}: {e}; start one with `robosim-geometry serve {to.rpartition(':')[2]}`") from None
    return Module(dial(), secret, resume, dial)


def accept(port: int, secret: Optional[str] = None, timeout: Optional[float] = None) -> Module:
    """Waits on a port of this machine for a module that connects, as RoboSim's environment does.

    With a timeout, it waits so many seconds at most, and so does each answer."""
    try:
        with socket.create_server(("127.0.0.1", port)) as listening:
            listening.settimeout(timeout)
            sock = listening.accept()[0]
            sock.settimeout(timeout)
    except socket.timeout:
        raise NotDone(f"no module connected to port {port} within {timeout:g} s; start one with `robosim-geometry connect"
                      f" localhost {port}`, or wait longer") from None
    except OSError as e:
        raise NotDone(f"no module connected to port {port}: {e}") from None
    return Module(sock, secret)


def _main(arguments: List[str]) -> int:
    if len(arguments) != 1:
        print("usage: client.py HOST:PORT", file=sys.stderr)
        return 2
    try:
        with connect(arguments[0]) as module:
            module.init([box([3, 0, 0], 0.2, 2, 4, name="wall"),
                         cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)])
            print(module.sonar("robot"))
            print(module.move("robot", x=5).obstacle)
            print(module.scan("robot", count=360)[90])
        return 0
    except Error as e:
        print(f"Not done: {e}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(_main(sys.argv[1:]))
