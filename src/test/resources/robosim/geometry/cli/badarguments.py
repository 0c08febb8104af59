"""Every kind of bad argument of python/robosim against a module, whose place is the argument; PythonClientTest runs it.

Each is refused with words that name it, the connection goes on, and the world is as it was.
"""

import math
import sys

import robosim
from robosim import box, capsule, cylinder, fan, grid, group, mesh, sphere

CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SIDES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]
NAN, INF = math.nan, math.inf


def raw(module, kind, **fields):
    return module.ask({"type": kind, **fields}, {"moves": "moves", "sonars": "distances", "batch": "answers",
                                                 "step": "bodies", "init": "answers"}.get(kind, "pong"))


def add(thing):
    return lambda m: m.add(thing)


def of(shape, **changed):
    return add({**shape, **changed})


BOX = box([9, 0, 9], 1, 1, 1)
MESH = mesh(CORNERS, SIDES, center=[9, 0, 9])

# What is done, and words of the refusal.
BAD = [
    # numbers
    (lambda m: m.move("robot", x=NAN), "numbers must be finite"),
    (lambda m: m.move("robot", x=INF), "numbers must be finite"),
    (lambda m: m.move("robot", x=2.0**101), "x must be"),
    (lambda m: m.move("robot", rx=1e31), "rx must be"),
    (lambda m: m.move("robot", x="1"), "must be a number"),
    (lambda m: m.move("robot", x=None), "must be a number"),
    (lambda m: m.moves([("robot", 1e40)]), "x must be"),
    # names
    (lambda m: m.move("nobody", x=1), "no moveable object"),
    (lambda m: m.move("wall", x=1), "no moveable object"),
    (lambda m: m.move(7, x=1), "must be a string"),
    (lambda m: m.pose(""), "no object"),
    (lambda m: m.pose("x" * 70_000), "at most 65535 bytes"),
    (lambda m: m.pose("\ud800"), "surrogate"),
    # sonars and beams
    (lambda m: m.sonar("robot", 0, 0), "must not both be zero"),
    (lambda m: m.sonar("robot", min=2, max=1), "max must be at least min"),
    (lambda m: m.sonar("robot", min=-1), "min must be"),
    (lambda m: m.sonar("robot", width=math.pi), "width must be"),
    (lambda m: m.sonar("robot", width=-0.1), "width must be"),
    (lambda m: m.sonars([("robot", 1, 0), ("robot", 0, 0)]), "must not both be zero"),
    # sensors
    (lambda m: m.scan("robot", count=0), "count must be at least 1"),
    (lambda m: m.scan("robot", count=2_000_000), "beams together"),
    (lambda m: m.scan("robot", count=1.5), "must be a whole number"),
    (lambda m: m.scan("robot", min=3, max=1), "max must be at least min"),
    (lambda m: m.scan("robot", width=math.pi), "width must be"),
    (lambda m: m.scan("robot", width=0.1, normals=True), "width must be 0 for normals"),
    (lambda m: m.sense("robot", robosim.layers([2], 0, 0, 1)), "elevations"),
    (lambda m: m.sense("robot", robosim.directions([0, 0, 0])), "must not be zero"),
    (lambda m: m.sense("robot", robosim.directions([1, 0])), "24 bytes"),
    (lambda m: m.sense("robot", {"kind": "spiral"}), "must be fan, layers"),
    (lambda m: m.sense("robot", {"kind": "fan", "first": 0, "step": 0}), "must have the field"),
    (lambda m: m.sense("robot", fan(0, 0, 1), rotation=[1, 0, 0, 0, 1, 0, 0, 0, 2]), "rotation must be"),
    (lambda m: m.sense("robot", fan(0, 0, 1), rotation=[1, 0, 0]), "list of 9 numbers"),
    (lambda m: m.sense("robot", fan(0, 0, 1), at=(0, 0)), "list of 3 numbers"),
    (lambda m: m.sense("robot", fan(0, 0, 1), at=(0, 0, 0, 0)), "at most 3 items"),
    (lambda m: m.sense("robot", fan(0, 0, 1), motion={"duration": -1}), "duration must be"),
    (lambda m: m.frame("robot", 0, 4, 1.0), "from 1 to"),
    (lambda m: m.frame("robot", 4, 4, 4.0), "fieldOfView must be"),
    (lambda m: m.frame("robot", 4096, 4096, 1.0), "beams"),
    (lambda m: m.picture("robot", 4, 4, 1.0, samples=17), "from 1 to 16"),
    (lambda m: m.picture("robot", 4096, 4096, 1.0), "pixels"),
    (lambda m: m.picture("robot", 4, 4, 1.0, light={"zenith": "blue", "horizon": "#000000", "ground": "#000000",
                                                    "strength": 1}), "#"),
    # planning
    (lambda m: m.free_poses("robot", [0, 0, 0]), "32 bytes"),
    (lambda m: m.free_edges("robot", [0, 0, 0, 0]), "64 bytes"),
    (lambda m: m.free_poses("robot", [NAN, 0, 0, 0]), "poses["),
    (lambda m: m.free_poses("robot", [0.0] * 4 * 300_000), "at most"),
    # moves up to and along
    (lambda m: m.move_to_contact("robot", x=1, clearance=-1), "clearance must be"),
    (lambda m: m.move_and_slide("robot", x=1, bends=65), "from 0 to 64"),
    (lambda m: m.move_and_slide("robot", x=1, bends=-1), "from 0 to 64"),
    # shapes
    (add(box([0, 0, 0], -1, 1, 1)), "width must be"),
    (add(cylinder([0, 0, 0], 1, 2.0**101)), "height must be"),
    (add(sphere([0, 0, 0], -1e-300)), "radius must be"),
    (add(capsule([0, 0], 1, 1)), "list of 3 numbers"),
    (add(mesh(CORNERS, [(0, 1, 4)])), "must have indices from 0 to 3"),
    (add(mesh(CORNERS, [(0, 1, -1)])), "whole number"),
    (add(mesh(CORNERS, [(0, 1)])), "3 or 4"),
    (add(mesh(CORNERS, [(0, 1, 2)], solid=True)), "must be closed"),
    (add(mesh([], [])), "at least"),
    (of(MESH, vertices=[[0, 0]]), "list of 3 numbers"),
    (add(group([])), "at least"),
    (add(group([{"kind": "cone"}])), "must be box, cylinder"),
    (of(BOX, boundingVolume=BOX), "must not have the field"),
    (add(grid([0, 0, 0], 0, 1, [[1]])), "cell must be"),
    (of(grid([0, 0, 0], 1, 1, [[1]]), columns=9), "occupied must have"),
    (of(BOX, rotation=[1, 0, 0, 0, 1, 0, 0, 0, 2]), "rotation must be"),
    (of(BOX, rotation=[1, 0, 0, 0, 1, 0, 0, 0, 1], heading=1), "heading and rotation must not both"),
    (of(BOX, moveable="yes"), "must be true or false"),
    (of(BOX, name=" ", moveable=True), "visible character"),
    (of(BOX, moveable=True), "name"),
    (of(BOX, material={"color": "orange"}), "#"),
    (of(BOX, colour="red"), "a field must be one of"),
    (lambda m: m.add([BOX]), "must be an object"),
    (lambda m: m.init([BOX, {"kind": "box"}]), "must have the field"),
    (lambda m: m.init([BOX], width=-1), "width must be"),
    (lambda m: m.init([BOX], dimension="FLAT"), "must be one of [PLANAR, SPATIAL]"),
    # steps
    (lambda m: m.step(-1), "seconds must be"),
    (lambda m: m.step(3601), "seconds must be"),
    (lambda m: m.step(1, [robosim.body("robot", mass=-1)]), "mass must be"),
    (lambda m: m.step(1, [robosim.body("robot", restitution=2)]), "restitution must be"),
    (lambda m: m.step(1, [robosim.body("robot", static_friction=0.1, sliding_friction=0.2)]), "slidingFriction must be"),
    (lambda m: m.step(1, [robosim.body("robot", drive=robosim.drive_settings("ackermann", max_turn=2))]), "maxTurn of a car"),
    (lambda m: m.step(1, [robosim.body("robot", weight=1)]), "a body has no weight"),
    (lambda m: m.step(1, [], [robosim.command("robot", forward="fast")]), "must be a number"),
    (lambda m: m.drive("robot", right=1), "right must be 0"),
    (lambda m: m.drive("wall", 1), "moveable object"),
    # messages of one's own
    (lambda m: m.ask({"type": "teleport"}, "moves"), "a request's type must be"),
    (lambda m: m.ask({"type": ["moves"]}, "moves"), "must be a string"),
    (lambda m: m.ask({"kind": "moves"}, "moves"), "must have the field \"type\""),
    (lambda m: m.ask({"type": "hello", "version": 1}, "hello"), "a hello must come once"),
    (lambda m: raw(m, "moves"), "must have the field"),
    (lambda m: raw(m, "moves", moves=[], speed=1), "a field must be one of"),
    (lambda m: raw(m, "moves", moves={}), "must be a list"),
    (lambda m: raw(m, "step", seconds="1"), "must be a number"),
    (lambda m: raw(m, "batch", requests=[{"kind": "fly"}]), "must be sense, poses"),
    (lambda m: raw(m, "sonars", requests=[{"objectName": "robot", "xOffset": 1, "zOffset": 0, "beam": None}]), "must be an object"),
    (lambda m: raw(m, "ping", id=1.5), "whole number"),
]


def main():
    with robosim.connect(sys.argv[1], timeout=60) as module:
        module.init([box([3, 0, 0], 0.2, 2, 4, name="wall"), cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)],
                    width=40, height=10, length=40, dimension="SPATIAL")
        before = module.objects()
        local = 0
        for k, (what, words) in enumerate(BAD):
            try:
                got = what(module)
            except (ValueError, TypeError) as e:
                told = str(e)
                local += 1
            except robosim.RequestError as e:
                told = str(e)
            else:
                raise AssertionError(f"number {k} must be refused with {words!r} (got: {got!r})")
            assert words in told, f"number {k} must be refused with {words!r} (got: {told!r})"
            assert "Exception" not in told, told
            assert module.sonar("robot") == 2.9, k
        assert module.objects() == before
        assert len(BAD) >= 41 and local < 12, (len(BAD), local)
    print("all done")


main()
