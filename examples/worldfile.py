"""World files in XML (docs/world-format.md) as what an init message takes.

For programs that need what the module does not tell: which sonars a file gives its robots. Everything else is simpler with
`robosim.Module.load`, by which the module reads the file, of any format, with what it includes.

`World` has the objects, the bodies and the rings of sonars of a file. A fault is told with its line. Of meshes in files it
reads OBJ of triangles and quads alone; an object of another mesh is left out, with a note. Materials are not sent.
"""

import base64
import math
import pathlib
import re
import xml.parsers.expat as expat

from robosim import NotDone, attach, drive_settings, swerve

SPACE = "urn:robosim:world:1"
SCHEMA_HINTS = "http://www.w3.org/2001/XMLSchema-instance "
METRES = {"km": 1000.0, "m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}
NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,3})?")
SIZES = {"box": ["width", "height", "length"], "cylinder": ["radius", "height"], "sphere": ["radius"],
         "capsule": ["radius", "segment"], "grid": ["cell", "height"]}
SHAPES = ["box", "cylinder", "sphere", "capsule", "mesh", "group"]
MOST_CELLS = 1 << 24
LOOKS = ["color", "diffuse", "specular", "shininess", "mirror", "emission", "reflectance", "label"]
PLACED = ["name", "moveable", "attached", "layers", "center", "heading", "turned", "rotation", "material"]

# What only pictures show: whatever stands in it is passed over.
PICTURED = ["lighting", "scenery"]

# Of each element: the attributes that it needs, those that it may have, and what may stand in it.
GRAMMAR = {
    "world": (["width", "height", "length"], ["unit", "dimension", "accuracy"], SHAPES + ["grid", "material"] + PICTURED),
    # Looks are checked by who draws, and not sent: the robots here go by their sonars.
    "material": (["name"], LOOKS, ["checker", "stripes", "image"]),
    "lighting": ([], [], []),
    "scenery": ([], [], []),
    "checker": (["first", "second", "size"], [], []),
    "stripes": (["first", "second", "size"], ["degrees"], []),
    "image": ([], ["file", "columns", "rows", "width", "height"], []),
    "box": (SIZES["box"], PLACED, []),
    "cylinder": (SIZES["cylinder"], PLACED, []),
    "sphere": (SIZES["sphere"], PLACED, []),
    "capsule": (SIZES["capsule"], PLACED, []),
    "grid": (SIZES["grid"] + ["columns", "rows"], ["name", "layers", "center", "heading", "rotation", "material"], []),
    "mesh": ([], PLACED + ["solid", "file", "scale"], ["bounds", "vertices", "triangles", "quads"]),
    "group": ([], PLACED, ["bounds"] + SHAPES),
    "bounds": ([], [], ["box", "cylinder", "sphere"]),
    "vertices": ([], [], []),
    "triangles": ([], [], []),
    "quads": ([], [], []),
    "sonar": (["count"], ["first", "step", "min", "max", "width"], []),
    "body": ([], ["mass", "inertia", "restitution", "friction", "slidingFriction", "floorFriction", "damping",
                  "turnDamping", "maxSpeed", "maxTurn", "drag", "rolling", "ignored"], ["drive"]),
    "drive": (["kind"], ["base", "maxSpeed", "maxAcceleration", "maxTurn", "maxTurnAcceleration", "wheels", "grip",
                         "maxSteering", "stallTorque", "freeTurns", "stallCurrent", "gearRatio", "wheelRadius",
                         "currentLimit", "supplyResistance"], []),
}
# What a static object may have of a body.
SURFACE = ["restitution", "friction", "slidingFriction"]
WORDS = {
    "unit": list(METRES),
    "dimension": ["PLANAR", "SPATIAL"],
    "accuracy": ["SPHERE", "AABB", "OBB", "DOP", "EXACT"],
    "moveable": ["true", "false", "1", "0"],
    "solid": ["true", "false", "1", "0"],
}


class LeftOut(NotDone):
    """An object that this program cannot read, and the module itself can."""


class Element:
    """An element of a world file: what is taken from it is checked, and a fault told with its line."""

    def __init__(self, place, tag, attributes, parent):
        self.place = place
        self.tag = tag
        self.attributes = attributes
        self.parent = parent
        self.children = []
        self.text = ""

    def fault(self, problem):
        return NotDone(f"{self.place}: {problem}")

    def check(self):
        """Nothing may stand here that would not be understood."""
        needed, allowed, children = GRAMMAR[self.tag]
        if self.parent is not None and self.parent.tag == "world" and self.tag != "material":
            allowed, children = allowed + ["color"], children + (["sonar", "body"] if self.tag != "grid" else [])
        for name in needed:
            if name not in self.attributes:
                raise self.fault(f"<{self.tag}> needs the attribute {name}")
        for name, value in self.attributes.items():
            if name not in needed + allowed:
                names = ", ".join(needed + allowed) or "none"
                raise self.fault(f"<{self.tag}> has no attribute {name}; it can have: {names}")
            if name in WORDS and value.strip() not in WORDS[name]:
                raise self.fault(f"{name} must be one of {', '.join(WORDS[name])} (got: {value})")
        for child in self.children:
            if child.tag not in children:
                inside = ", ".join(f"<{name}>" for name in children) or "nothing"
                raise child.fault(f"<{child.tag}> cannot stand in <{self.tag}>; there can be: {inside}")
            child.check()

    def named(self, tag):
        return [child for child in self.children if child.tag == tag]

    def flag(self, name):
        return self.attributes.get(name, "false").strip() in ("true", "1")

    def number(self, text, name, unit=None):
        """A number; where the world has a unit, a length may have one of its own."""
        suffix = text.lstrip("0123456789.eE+-")
        plain = text[: len(text) - len(suffix)]
        if not NUMBER.fullmatch(plain) or suffix and (suffix not in METRES or unit is None):
            like = "0.25" if unit is None else "0.25 or 25cm"
            raise self.fault(f"{name} of <{self.tag}> must be a number like {like} (got: {text})"
                             + ('; a length with a unit needs unit="m" or another at <world>' if suffix in METRES else ""))
        value = float(plain) * METRES[suffix] / METRES[unit] if suffix else float(plain)
        if abs(value) > 2.0**100:
            raise self.fault(f"{name} of <{self.tag}> must be at most 2^100 (got: {text})")
        return value

    def numbers(self, name, count, unit=None):
        words = self.attributes[name].split()
        if len(words) != count:
            raise self.fault(f"{name} of <{self.tag}> must be {count} numbers (got: {len(words)})")
        return [self.number(word, name, unit) for word in words]

    def one(self, name, default, least=-math.inf, below=math.inf, unit=None):
        """An attribute that is a number within bounds."""
        if name not in self.attributes:
            return default
        value = self.number(self.attributes[name].strip(), name, unit)
        if not least <= value < below:
            bounds = f"at least {least:g}" + ("" if below == math.inf else f" and below {below:g}")
            raise self.fault(f"{name} of <{self.tag}> must be {bounds} (got: {self.attributes[name]})")
        return value

    def indices(self):
        words = self.text.split()
        if not all(word.isascii() and word.isdigit() for word in words):
            of = "run lengths" if self.tag == "grid" else "indices of vertices"
            raise self.fault(f"<{self.tag}> must hold {of}, whole numbers from 0")
        return [int(word) for word in words]


def parse(path):
    """The root element of a world file."""
    parser = expat.ParserCreate(namespace_separator=" ")
    opened, roots = [], []

    def refuse_doctype(*_):
        raise NotDone(f"{path}:{parser.CurrentLineNumber}: a world has no document type; remove the DOCTYPE")

    def start(name, attributes):
        space, _, tag = name.rpartition(" ")
        place = f"{path}:{parser.CurrentLineNumber}"
        if not opened and (space, tag) != (SPACE, "world"):
            raise NotDone(f'{place}: the root must be <world xmlns="{SPACE}" ...> (got: <{tag}>)')
        if opened and opened[-1].tag in PICTURED:
            opened.append(opened[-1])
            return
        if space != SPACE or tag not in GRAMMAR:
            raise NotDone(f"{place}: there is no <{tag}> in a world (namespace: {space or 'none'})")
        own = {name: value for name, value in attributes.items() if not name.startswith(SCHEMA_HINTS)}
        element = Element(place, tag, own, opened[-1] if opened else None)
        (opened[-1].children if opened else roots).append(element)
        opened.append(element)

    def characters(text):
        opened[-1].text += text

    parser.StartDoctypeDeclHandler = refuse_doctype
    parser.StartElementHandler = start
    parser.EndElementHandler = lambda _: opened.pop()
    parser.CharacterDataHandler = characters
    parser.buffer_text = True
    try:
        parser.Parse(pathlib.Path(path).read_bytes(), True)
    except expat.ExpatError as e:
        raise NotDone(f"{path}:{e.lineno}: this is no well-formed XML: {expat.ErrorString(e.code)}") from None
    except OSError as e:
        raise NotDone(f"{path}: the world cannot be read; check the path ({e.strerror})") from None
    roots[0].check()
    return roots[0]


class World:
    """A world file, as objects for an init message, the bodies for a step and the sonars of its robots."""

    def __init__(self, path):
        self.folder = pathlib.Path(path).parent
        root = parse(path)
        #: The settings that the file has, of dimension and accuracy.
        self.settings = {word: root.attributes[word].strip() for word in ("dimension", "accuracy")
                         if word in root.attributes}
        #: What robosim.Module.step takes as bodies.
        self.bodies = []
        #: Requests for robosim.Module.batch, by which objects are attached to others.
        self.attached = []
        #: What was left out: its name, "" for none, and why.
        self.notes = []
        self.unit = root.attributes.get("unit", "").strip() or None
        self.size = [root.one(side, 0.0, least=0, unit=self.unit) for side in SIZES["box"]]
        if 0.0 in self.size:
            raise root.fault(f"width, height and length of <world> must be above 0 (got: {self.size})")
        self.objects = []
        self.places = []
        self.robots = []
        names = {}
        for element in root.children:
            if element.tag in ["material"] + PICTURED:
                continue
            try:
                made = self.read(element)
            except LeftOut as e:
                self.notes.append((element.attributes.get("name", ""), str(e)))
                continue
            self.check_border(element, made)
            self.objects.append(made)
            self.places.append(element.place)
            name = made.get("name")
            if name is not None and names.setdefault(name, element) is not element:
                raise element.fault(f"names must be unique in a world; {names[name].place} has this one too (got: {name})")
            if "attached" in element.attributes:
                if not made.get("moveable"):
                    raise element.fault(f"<{element.tag}> must be moveable to be attached")
                self.attached.append(attach(name, element.attributes["attached"]))
            rings = element.named("sonar")
            if rings and name is None:
                raise element.fault(f"<{element.tag}> with a sonar needs a name")
            for body in element.named("body"):
                if name is None or len(element.named("body")) > 1:
                    raise body.fault(f"<{element.tag}> must have one <body> at most, and a name with it")
                self.bodies.append(self.body(body, name, bool(made.get("moveable"))))
            # What lies on its side has no level sensors, and stays.
            sensors = [self.ring(ring) for ring in rings]
            is_robot = made.get("moveable") and "attached" not in element.attributes
            if is_robot and made.get("rotation", [0, 0, 0, 0, 1])[4] == 1:
                self.robots.append((made, sensors))

    def check_border(self, element, made):
        """The module would leave out what is not in the world; seen from above, as that is what it is sent as."""
        if made["kind"] == "grid":
            return  # of its cells only the occupied ones count
        width, _, length = self.size
        for size, axis in ((width, 0), (length, 2)):
            for sign in (1.0, -1.0):
                direction = [0.0, 0.0, 0.0]
                direction[axis] = sign
                # Not by the last bits: on them the module decides.
                if reach(made, direction) > size / 2 * (1 + 1e-9):
                    raise element.fault(f"this <{element.tag}> reaches beyond the world; move it or enlarge the world")

    def read(self, element):
        kind = element.tag
        made = {"kind": kind, "center": [0.0, 0.0, 0.0]}
        if "center" in element.attributes:
            made["center"] = element.numbers("center", 3, self.unit)
        if "name" in element.attributes:
            made["name"] = element.attributes["name"]
            if not made["name"].strip():
                raise element.fault(f"name of <{kind}> must not be blank")
        if "layers" in element.attributes:
            made["layers"] = element.attributes["layers"].split()
        if element.flag("moveable"):
            made["moveable"] = True
            if "name" not in made:
                raise element.fault(f'<{kind}>: a moveable object needs a name; add name="..."')
        rotation = self.rotation(element)
        if rotation:
            made["rotation"] = rotation
        for side in SIZES.get(kind, []):
            made[side] = element.one(side, 0.0, least=0, unit=self.unit)
        if kind == "mesh":
            self.mesh(element, made)
        elif kind == "grid":
            self.grid(element, made)
        elif kind == "group":
            made["members"] = [self.read(member) for member in element.children if member.tag in SHAPES]
            if not made["members"]:
                raise element.fault("<group> must have a member")
        for bounds in element.named("bounds"):
            if len(bounds.children) != 1 or len(element.named("bounds")) != 1:
                raise bounds.fault("there must be one <bounds> at most, with one <box>, <cylinder> or <sphere>")
            made["boundingVolume"] = self.read(bounds.children[0])
        return made

    @staticmethod
    def rotation(element):
        """Nine numbers, row by row; its columns are the object's own axes."""
        given = [name for name in ("heading", "turned", "rotation") if name in element.attributes]
        if len(given) > 1:
            raise element.fault(f"<{element.tag}> must have at most one of heading, turned and rotation"
                                f" (got: {' and '.join(given)})")
        if given == ["rotation"]:
            return element.numbers("rotation", 9)
        rx, ry = element.numbers("turned", 2) if given == ["turned"] else (0.0, element.one("heading", 0.0))
        if rx == 0 and ry == 0:
            return None
        c, s = turn(ry)
        cx, sx = turn(rx)
        return [c, s * sx, s * cx, 0.0, cx, -sx, -s, c * sx, c * cx]

    def mesh(self, element, made):
        vertices, faces = [], []
        if ("file" in element.attributes) == bool(element.named("vertices")):
            raise element.fault("<mesh> must have either a file or <vertices> and faces")
        if "file" in element.attributes:
            self.obj(element, vertices, faces)
        for part in element.children:
            if part.tag == "vertices":
                flat = [part.number(n, "a coordinate", self.unit) for n in part.text.split()]
                if len(flat) % 3 != 0:
                    raise part.fault(f"<vertices> must hold three numbers for each (got: {len(flat)})")
                vertices += [flat[k:k + 3] for k in range(0, len(flat), 3)]
            elif part.tag in ("triangles", "quads"):
                corners = 3 if part.tag == "triangles" else 4
                flat = part.indices()
                if len(flat) % corners != 0:
                    raise part.fault(f"<{part.tag}> must hold {corners} indices for each (got: {len(flat)})")
                faces += [flat[k:k + corners] for k in range(0, len(flat), corners)]
        if not faces:
            raise element.fault("<mesh> must have a face")
        for face in faces:
            if not all(0 <= corner < len(vertices) for corner in face):
                raise element.fault(f"an index must be from 0 to {len(vertices) - 1}, the last vertex (got: {face})")
        made["vertices"], made["faces"] = vertices, faces
        if element.flag("solid"):
            made["solid"] = True

    @staticmethod
    def grid(element, made):
        """The cells as bits, from the runs of free and of occupied ones in each row."""
        size = [element.one(name, 0.0, least=1) for name in ("columns", "rows")]
        if any(count != int(count) for count in size) or size[0] * size[1] > MOST_CELLS:
            raise element.fault(f"columns and rows of <grid> must be whole numbers, of {MOST_CELLS} cells at most")
        columns, rows = (int(count) for count in size)
        cells = bytearray((columns * rows + 7) // 8)
        runs = iter(element.indices())
        for row in range(rows):
            column, occupied = 0, False
            while column < columns:
                run = next(runs, -1)
                if not (1 if occupied or column else 0) <= run <= columns - column:
                    raise element.fault(f"the runs of row {row} of <grid> must add up to {columns} cells, in turn free and occupied")
                if occupied:
                    for cell in range(row * columns + column, row * columns + column + run):
                        cells[cell >> 3] |= 1 << (cell & 7)
                column, occupied = column + run, not occupied
        if next(runs, None) is not None:
            raise element.fault(f"the runs of <grid> must end with the last of {rows} rows")
        made["columns"], made["rows"] = columns, rows
        made["occupied"] = base64.b64encode(cells).decode("ascii")

    def obj(self, element, vertices, faces):
        name = element.attributes["file"]
        scale = element.one("scale", 1.0, least=0)
        if not name.lower().endswith(".obj"):
            raise element.fault(f"this program reads meshes of OBJ files alone (got: {name})")
        path = self.folder / name
        if self.folder.resolve() not in path.resolve().parents:
            raise element.fault(f"file must lead to a file under the folder of the world (got: {name})")
        try:
            lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError as e:
            raise element.fault(f"the mesh {path} cannot be read ({e.strerror})") from None
        for number, line in enumerate(lines, 1):
            words = line.split()
            try:
                if words and words[0] == "v":
                    x, y, z = (float(n) * scale for n in words[1:4])
                    vertices.append([x, y, z])
                elif words and words[0] == "f":
                    corners = [int(word.split("/")[0]) for word in words[1:]]
                    if len(corners) not in (3, 4):
                        raise LeftOut(f"{path}:{number}: a face must have 3 or 4 corners here (got: {len(corners)})")
                    faces.append([k - 1 if k > 0 else len(vertices) + k for k in corners])
            except ValueError:
                raise NotDone(f"{path}:{number}: this must be `v x y z` or `f i j k` (got: {line[:100]})") from None

    @staticmethod
    def body(body, name, moveable):
        """What a step is told of a body; every angle is in radians there."""
        for attribute in body.attributes:
            if not moveable and attribute not in SURFACE:
                raise body.fault(f"<body> of a static object must have a surface alone: {', '.join(SURFACE)}"
                                 f" (got: {attribute})")
        told = {"objectName": name}
        for attribute in body.attributes:
            if attribute == "ignored":
                told["ignored"] = body.attributes["ignored"].split()
                continue
            field = {"friction": "staticFriction"}.get(attribute, attribute)
            told[field] = body.one(attribute, 0.0, least=0)
        told.setdefault("slidingFriction", told.get("staticFriction", 0.0))
        if "maxTurn" in told:
            told["maxTurn"] = math.radians(told["maxTurn"])
        for drive in body.named("drive"):
            if not moveable or len(body.named("drive")) > 1:
                raise drive.fault("<body> must have one <drive> at most, and only that of a moveable object")
            limits = {attribute: drive.one(attribute, 0.0, least=0)
                      for attribute in drive.attributes if attribute not in ("kind", "wheels")}
            if drive.attributes["kind"].strip() == "swerve":
                told["drive"] = self.swerve(drive, limits)
                continue
            for angle in ("maxTurn", "maxTurnAcceleration"):
                if angle in limits:
                    limits[angle] = math.radians(limits[angle])
            try:
                told["drive"] = drive_settings(drive.attributes["kind"].strip(), **limits)
            except TypeError as e:
                raise drive.fault(str(e)) from None
        return told

    def swerve(self, drive, numbers):
        """A drive of wheels at given places, as the wire has it."""
        try:
            places = [float(word) for word in drive.attributes.get("wheels", "").split()]
        except ValueError:
            places = []
        if not places or len(places) % 2:
            raise drive.fault("<drive> of kind swerve must have wheels here, two numbers for each"
                              f" (got: {drive.attributes.get('wheels')})")
        steering = math.radians(numbers.pop("maxSteering")) if "maxSteering" in numbers else math.inf
        try:
            return swerve(zip(places[::2], places[1::2]), numbers.pop("grip", 1.0), steering, **numbers)
        except TypeError as e:
            raise drive.fault(str(e)) from None

    def ring(self, ring):
        """The bearing of each sensor of a ring, in radians, and what asks for all of them at once."""
        count = ring.one("count", 0.0, least=1, below=10001)
        if count != int(count):
            raise ring.fault(f"count of <sonar> must be a whole number (got: {ring.attributes['count']})")
        first = ring.one("first", 0.0)
        step = ring.one("step", 360 / count)
        # On the wire every angle is in radians, and no end is null.
        request = {
            "kind": "sense",
            "pattern": {
                "kind": "fan",
                "first": math.radians(first),
                "step": math.radians(step),
                "count": int(count),
            },
            "min": ring.one("min", 0.0, least=0, unit=self.unit),
            "max": ring.one("max", None, least=0, unit=self.unit),
            "width": math.radians(ring.one("width", 0.0, least=0, below=180)),
        }
        if request["max"] is not None and request["max"] < request["min"]:
            raise ring.fault(
                f"max of <sonar> must be at least its min (got: {request['max']:g} and {request['min']:g})")
        bearings = []
        for sensor in range(int(count)):
            c, s = turn(first + sensor * step)
            bearings.append(math.atan2(s, c))
        return bearings, request


def reach(made, direction):
    """How far an object reaches in a direction of length 1, from the origin of its frame."""
    r = made.get("rotation", [1, 0, 0, 0, 1, 0, 0, 0, 1])
    dx, dy, dz = (sum(r[3 * row + column] * direction[row] for row in range(3)) for column in range(3))
    kind = made["kind"]
    if kind == "box":
        own = (made["width"] * abs(dx) + made["height"] * abs(dy) + made["length"] * abs(dz)) / 2
    elif kind == "cylinder":
        own = made["radius"] * math.hypot(dx, dz) + made["height"] * abs(dy) / 2
    elif kind == "sphere":
        own = made["radius"]
    elif kind == "capsule":
        own = made["radius"] + made["segment"] * abs(dy) / 2
    elif kind == "mesh":
        own = max(x * dx + y * dy + z * dz for x, y, z in made["vertices"])
    else:
        own = max(reach(member, (dx, dy, dz)) for member in made["members"])
    return sum(c * d for c, d in zip(made["center"], direction)) + own


def turn(degrees):
    """Cosine and sine, exact at quarter turns."""
    quarter = round(degrees / 90)
    rest = math.radians(degrees - 90 * quarter)
    c, s = math.cos(rest), math.sin(rest)
    return [(c, s), (-s, c), (-c, -s), (s, -c)][quarter % 4]
