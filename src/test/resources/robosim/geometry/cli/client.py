"""Every message of python/robosim against a module, whose place is the argument; PythonClientTest runs it."""

import inspect
import math
import pathlib
import sys
import tempfile

import robosim
from robosim import Move, RequestError, Sonar, box, capsule, cylinder, grid, group, mesh, sphere

INF = math.inf
CORNERS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
SIDES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def same(got, expected):
    if got != expected:
        raise AssertionError(f"expected {expected!r}, got {got!r}")


def near(got, expected):
    if not abs(got - expected) <= 1e-12 * max(1, abs(expected)):
        raise AssertionError(f"expected about {expected!r}, got {got!r}")


def refused(what, words):
    try:
        what()
    except RequestError as e:
        same(str(e), words)
    else:
        raise AssertionError(f"expected a RequestError: {words}")


def shapes(module):
    """One of each shape, with each way to place it."""
    turned = [0, 0, 1, 0, 1, 0, -1, 0, 0]
    everything = [
        box([3, 0, 0], 0.2, 2, 4, name="wall", material={"color": "#ff8000", "label": 7}),
        cylinder((0, 0, 0), 0.25, 1, name="robot", moveable=True),
        sphere([0, 0, 3], 0.5, name="ball"),
        capsule([-3, 0, 3], 0.3, 1, heading=1),
        mesh(CORNERS, SIDES, solid=True, center=[-4, 0, 0], name="rock"),
        mesh(CORNERS, SIDES, center=[-4, 0, -4], rotation=turned),
        group([box([0, 0, 0], 1, 1, 1), sphere([1, 0, 0], 0.5)], center=[4, 0, -4], heading=math.pi / 2),
        grid([0, 0, -6], 0.5, 1, [[1, 0, 0], [0, 0, 1]], name="map"),
        sphere([60, 0, 0], 1, name="far"),
        sphere([60, 0, 0], 1),
        box([0, 0, 6], 1, 1, 1, name="wall"),
    ]
    told = module.init(everything, width=40, height=10, length=40, dimension="SPATIAL")
    same(told.added, 8)
    same(told.left_out, [(8, "far", "it would leave the world"), (9, "", "it would leave the world"),
                         (10, "wall", "an earlier object has its name")])
    same(told[2:], (40.0, 10.0, 40.0, "SPATIAL", "EXACT"))
    same(module.world(), told)
    near(module.pose("map").center[2], -6)
    near(module.init(everything[:2], accuracy="OBB").width, 2 * (3.1 + 1))
    same(module.world().accuracy, "OBB")
    same(module.world().dimension, "PLANAR")
    module.init(everything, width=40, height=10, length=40, dimension="SPATIAL")


def moves(module):
    went = module.move("robot", x=1, ry=math.pi / 2)
    same((went.made, bool(went), went.obstacle), (True, True, None))
    pose = module.pose("robot")
    same((pose.center, pose.heading), ([1, 0, 0], math.pi / 2))  # exactly
    same(pose.rotation, [0, 0, 1, 0, 1, 0, -1, 0, 0])
    went = module.move("robot", z=4)  # to the right of a robot that looks along -Z: the wall
    same((went.made, bool(went), went.obstacle, went.turn_fraction), (False, False, "wall", 0))
    near(went.fraction, 1.65 / 4)
    near(went.contact[0], 2.9)
    same(went.normal, [-1, 0, 0])
    same(module.pose("robot"), pose)
    same(module.move("robot", y=20).obstacle, None)  # the border
    same(module.move("robot", y=20).made, False)
    made = module.moves([Move("robot", x=0.5), Move("robot", z=4), Move("wall", x=1), Move("robot", x=-0.5)])
    same(made.made, [Move("robot", x=0.5), Move("robot", x=-0.5)])
    same(made.refused, {1: 'blocked by "wall" after 0.412 of the way', 2: 'no moveable object "wall"'})
    refused(lambda: module.move("nobody", x=1), 'no moveable object "nobody"')


def changes(module):
    same(module.place("robot", [3, 0, 0]), (False, "wall", ()))
    same(module.place("robot", [-3, 0, 3]), (False, "", ()))
    same(module.place("robot", [19.9, 0, 0]), (False, None, ()))
    same(bool(module.place("robot", [0, 0, 0], heading=-math.pi / 2)), True)
    same(module.pose("robot").heading, -math.pi / 2)
    same(module.place("robot", [0, 0, 0]), (True, None, ()))
    ball = sphere([0.1, 0, 0.2], 0.1, name="ball 2", moveable=True)
    same(module.add(ball), (False, "robot", ()))
    same(module.add(ball, overlapping=True), (True, None, ()))
    same(module.pose("ball 2").center, [0.1, 0, 0.2])
    same(module.remove("ball 2"), (True, None, ()))
    same(module.remove("ball 2"), (False, None, ()))
    refused(lambda: module.pose("ball 2"), 'no object "ball 2"')
    refused(lambda: module.place("wall", [0, 0, 0]), 'no moveable object "wall"')


def blocked(module):
    """What blocks, by its index too; moves to a contact and along it."""
    posts = [box([3, 0, 0], 0.2, 2, 4), cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True),
             sphere([0, 0, 4], 0.5)]
    module.init(posts, width=20, height=10, length=20)
    wall = robosim.Obstacle(0, "", "box", [3, 0, 0])
    ball = robosim.Obstacle(2, "", "sphere", [0, 0, 4])
    new = robosim.Obstacle(3, "new", "sphere", [0, 0, 5])
    same(module.place("robot", [3, 0, 1], identify=True), (False, "", (wall,)))
    same(module.place("robot", [3, 0, 1]).obstacles, ())
    same(module.add(sphere([0, 0, 5], 0.6, name="new"), identify=True), (False, "", (ball,)))
    same(module.add(sphere([0, 0, 5], 0.6, name="new"), overlapping=True, identify=True), (True, None, ()))
    same(module.place("robot", [0, 0, 4.5], identify=True).obstacles, (ball, new))
    same(module.place("robot", [0, 0, 4.5], identify=False).obstacles, ())
    there = module.objects()
    same([o for o in there if o.kind == "grid"], [])
    same(sorted(o.index for o in there), [o.index for o in there])
    at = [o for o in there if o.name == "new"][0]
    same((at.index, at.kind, at.center, at.heading, at.moveable), (new.index, "sphere", [0, 0, 5], 0, False))
    near(at.high[0] - at.low[0], 1.2)
    some, rest = module.batch([robosim.listed(count=2), robosim.listed(first=there[2].index)])
    same((some.objects, some.next, rest.objects, rest.next), (there[:2], there[2].index, there[2:], None))
    same(module.place("robot", [9.9, 0, 0], identify=True), (False, None, ()))
    same(module.move("robot", x=5, identify=True).obstacles, (wall,))
    same(module.move("robot", x=5).obstacles, ())
    docked = module.move_to_contact("robot", x=5, clearance=0.25)
    same((docked.made, docked.obstacle, docked.obstacles), (False, "", (wall,)))
    near(module.pose("robot").center[0], 2.4)
    near(docked.fraction, 0.48)
    same(module.move_to_contact("robot", x=-2).made, True)
    slid = module.move_and_slide("robot", x=5, z=1)
    same((bool(slid), len(slid.contacts), slid.contacts[0].obstacle), (False, 1, wall))
    same(slid.contacts[0].normal, [-1, 0, 0])
    near(slid.displacement[2], 1)
    near(module.pose("robot").center[2], 1)
    same(bool(module.move_and_slide("robot", x=-1, ry=0.5)), True)
    out = module.move_and_slide("robot", x=-50, bends=0, clearance=0.1)
    same((len(out.contacts), out.contacts[0].obstacle, out.turn_fraction), (1, None, 1))
    same(bool(module.move_and_slide("robot", step_height=0.1, max_slope=0.5, snap=0.1)), True)
    found = module.prove(robosim.go("robot", 0.01))
    same([bool(each) for each in found], [True, True])
    same([each.proof["claim"]["kind"] for each in found], ["translation", "apart"])
    same(len(module.scene()["objects"]), len(module.objects()))
    refused(lambda: module.prove(robosim.go("nobody", 1)), 'no moveable object "nobody"')
    same(module.separate("robot", 1), [0, 0, 0])
    same(module.add(box([0, 0, -8], 1, 1, 1, name="crate", moveable=True)).done, True)
    same(module.add(box([0.75, 0, -8], 1, 1, 1, name="lid"), overlapping=True).done, True)
    same(module.separate("crate", 0.2), None)
    freed = module.separate("crate", 1)
    same((-0.26 < freed[0] < -0.25, freed[1:]), (True, [0, 0]))
    near(module.pose("crate").center[0], freed[0])
    refused_in(lambda: module.separate("crate", -1), "max must be a number from 0 to 2^100")
    refused(lambda: module.separate("nobody", 1), 'no moveable object "nobody"')
    answers = module.batch([robosim.go_to_contact("robot", x=1), robosim.go_and_slide("robot", z=1, bends=2),
                            robosim.go("robot", x=50, identify=True)])
    same((answers[0].made, answers[1].contacts, len(answers[2].obstacles)), (True, [], 1))
    tower = module.scan("", count=4, at=(0, 0, 0), objects=True)
    same((tower[0], tower.name(0), tower[3], tower.name(3)), (2.9, "", 3.5, ""))
    same(module.sense("", robosim.fan(0, 0, 1), at=(1, 0, 0), heading=math.pi)[0], INF)


def sensors(module):
    near(module.sonar("robot"), 2.9)
    same(module.sonar("robot", 0, 1), 2.5)  # (0, 1) is to the right, where the ball is
    same(module.sonar("robot", 0, 1, max=2), INF)
    same(module.sonar("robot", 0, 1, min=2.7), 2.7)
    near(module.sonar("robot", 0.1, 1, width=0.5), 2.5)
    several = module.sonars([Sonar("robot"), Sonar("robot", 0, -1, max=2), Sonar("nobody")])
    near(several[0], 2.9)
    same(several[1], INF)
    same(str(several[2]), 'no moveable object "nobody"')
    refused(lambda: module.sonar("nobody"), 'no moveable object "nobody"')
    scan = module.scan("robot", count=4, max=5)
    same(len(scan), 4)
    same(scan[3], 2.5)  # a fan turns to the left: its last quarter is to the right
    same(list(scan), list(scan.distances))
    same(memoryview(scan.distances).format, "d")
    same(list(module.scan("robot", count=4, min=2.7, max=5, rep117=True))[3], -INF)
    same(module.scan("robot", count=4, min=2.7, max=5)[3], 2.7)
    left = module.scan("robot", first=math.pi / 2, step=0, count=1, heading=math.pi)
    same(left[0], 2.5)
    frame = module.frame("robot", 8, 6, 1.0, normals=True)
    same((len(frame), len(frame.objects), len(frame.labels), len(frame.normals)), (48, 48, 48, 144))
    middle = 3 * 8 + 4
    same((frame.name(middle), frame.labels[middle]), ("wall", 7))
    same(list(frame.normals[3 * middle:3 * middle + 3]), [-1, 0, 0])
    up = module.sense("robot", robosim.directions([0, 1, 0, 1, 0, 0]), at=(0, 0.6, 0), objects=True)
    same((up[0], up.name(0), up.name(1)), (INF, None, "wall"))
    lidar = module.sense("robot", robosim.layers([-0.1, 0, 0.1], 0, 0.1, 5), motion={"duration": 0.1, "x": 1})
    same(len(lidar), 15)
    same(module.free_poses("robot", [0, 0, 0, 0, 3, 0, 0, 0, 1, 0, 1, 2]), [True, False, True])
    same(module.free_edges("robot", [0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 6, 0, 0, 0]), [True, False])
    distances = module.clearances("robot", [0, 0, 0, 0, 3, 0, 0, 0])
    same((distances[0] > 0, distances[1] < 0), (True, True))
    clear = module.clearances("robot", [0, 0, 0, 0], points=True)
    same((len(clear), clear[0]), (10, distances[0]))
    near(clear[1] - clear[4], clear[0] * clear[7])
    near(clear[3] - clear[6], clear[0] * clear[9])
    same(list(module.clearances("robot", [0, 0, 0, 0], max=1e-3)), [INF])
    same(list(module.edge_fractions("robot", [0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 6, 0, 0, 0]))[:2], [1, 1])
    blocked = module.edge_fractions("robot", [0, 0, 0, 0, 6, 0, 0, 0], margin=0.1)
    same((0 < blocked[0] < 1, blocked[1]), (True, 0))
    drives = [0, 0, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 3, 0, 0, 0, 2]
    same([part == 1 for part in module.drive_fractions("robot", drives)], [True, False])
    refused(lambda: module.clearances("robot", [0, 0, 0, 0], ignored=["nobody"]),
            'ignored must name an object or a layer in the world (got: "nobody")')
    refused(lambda: module.scan("nobody"), 'no moveable object "nobody"')


def units():
    """Whatever takes an angle says that it is in radians."""
    angles, seen = {"heading", "turn", "rx", "ry", "first", "field_of_view", "elevations", "max_slope"}, 0
    for owner in (robosim, robosim.Module):
        for name, what in inspect.getmembers(owner, callable):
            ours = not name.startswith("_") and getattr(what, "__module__", "").startswith(robosim.__name__) and name != "listed"
            if not ours or (inspect.isclass(what) and issubclass(what, Exception)):
                continue
            if angles & set(inspect.signature(what).parameters):
                seen += 1
                text = inspect.getdoc(what) or ""
                text += inspect.getsource(what) if inspect.isclass(what) else ""
                assert "radians" in text, f"{owner.__name__}.{name} must say that its angles are in radians"
    assert seen >= 18, seen


def together(module):
    answers = module.batch([
        robosim.place("robot", [1, 0, 0]), robosim.pose("robot"), robosim.sense("robot", robosim.fan(0, 0, 1)),
        robosim.go("robot", x=9), robosim.add(sphere([9, 0, 9], 1, name="new")), robosim.remove("new"),
        robosim.pose("new"), robosim.poses("robot", []), robosim.edges("robot", [0] * 8), robosim.world()])
    same(answers[0].done, True)
    same(answers[1].center, [1, 0, 0])
    near(answers[2][0], 1.9)
    same(answers[3].obstacle, "wall")
    same((answers[4].done, answers[5].done, str(answers[6])), (True, True, 'no object "new"'))
    same((answers[7], answers[8], answers[9].added), ([], [True], 8))
    assert 0 < module.ping() < 60


def drives(module, folder):
    """Velocities over time, and a world from a file."""
    thing = box([1, 0, 1], 1, 1, 1)
    same([o["name"] for o in robosim.named([thing, {**thing, "name": "box 2"}, thing])], ["box 0", "box 2", "box 2'"])
    told = module.load(folder + "/pushing.xml")
    same((told.added, told.left_out, told.dimension), (11, [], "PLANAR"))
    same(module.step(0).bodies["drum"].velocity, robosim.Velocity())
    same(sorted(module.step(0).bodies), ["ball", "cart", "crate 1", "crate 2", "drum", "mule"])
    same(module.drive("cart", forward=0.8).center, [-4, -1, 0])
    after = module.step(1)
    near(after.bodies["cart"].velocity.x, 0.8)
    assert -3.4 < after.bodies["cart"].center[0] < -3.1, after  # it gains 2 m/s each second at most
    same((after.contacts, after.stopped, after.refused), ([], [], {}))
    met = module.step(3).contacts
    same([(c.name, c.other, c.phase) for c in met], [("cart", "crate 1", "BEGIN")])
    assert met[0].impulse > 0 and met[0].normal[0] < 0, met
    said = module.step(0, [robosim.body("cart", mass=9, max_turn=2, velocity=(1, 0, 0, 0), drive="velocity"),
                           robosim.body("nobody", inertia=1), robosim.body("pillar", restitution=0.5)],
                       [robosim.command("cart", 0.1, 0.2), robosim.command("pillar", 1)])
    same(sorted(said.refused), [1, 4])
    same(said.refused[1], 'no object "nobody"')
    small = {"objectName": "cart", "drive": {"kind": "omnidirectional", "maxSpeed": 1}}
    same(module.ask({"type": "step", "seconds": 0, "bodies": [small]}, "bodies")[0]["refused"], [])
    same(module.step(0, mixing=robosim.mixing(restitution="larger")).refused, {})
    refused_in(lambda: module.step(0, mixing=robosim.mixing("largest")), "GEOMETRIC_MEAN")
    refused(lambda: module.drive("nobody", 1), 'no object "nobody"')
    refused(lambda: module.drive("drum", right=0.3), "right must be 0 for a drive of kind DIFFERENTIAL; give \"drum\" a body"
            " with a drive of kind OMNIDIRECTIONAL, SWERVE, VELOCITY or FORCE (got: 0.3)")
    for wrong, words in ((lambda: robosim.body("cart", weight=3), "a body has no weight; it may have: mass,"),
                         (lambda: module.step(1, [{"objectName": "cart", "Mass": 3}]), "a body has no Mass"),
                         (lambda: module.step(1, [], [{"objectName": "cart", "speed": 3}]), "a command has no speed"),
                         (lambda: robosim.drive_settings("diff"), "a drive must be one of DIFFERENTIAL,"),
                         (lambda: robosim.drive_settings("force", base=1), "a drive of kind FORCE has no base")):
        try:
            wrong()
        except TypeError as e:
            assert words in str(e), e
        else:
            raise AssertionError(f"expected a TypeError: {words}")
    told = module.load(folder + "/meshes.xml")
    same(told.left_out, [])  # the module reads the face of eight corners
    assert "wall with a hole" in [o.name for o in module.objects()]
    same(module.load("meshes.xml", on_server=True), told)
    for path, words in (("../README.md", "stays in its folder"), ("/etc/passwd", "stays in its folder"),
                        ("none.xml", "must be in the folder of worlds")):
        refused_in(lambda: module.load(path, on_server=True), words)
    for files, words in (({"a.xml": "PHdvcmxkLz4="}, "a.xml:1"), ({"b.xml": ""}, "must be one of the files sent"),
                         ({"a.xml": "", "../b": ""}, "stays in its folder"), ({"a.xml": "*"}, "must be base64")):
        refused_in(lambda: module.ask({"type": "load", "file": "a.xml", "files": files}, "answers"), words)
    same(module.world(), told)  # what cannot be read leaves the world as it is
    same(module.load(folder + "/rooms.xml", accuracy="OBB").accuracy, "OBB")
    robots = [o.name for o in module.objects() if o.moveable]
    assert module.move(robots[0], x=100).obstacle != "", "every object must have a name"
    several(module)


def several(module):
    """Files of several kinds, which name others: an inclusion in one with a mesh, and a ROS map with its image."""
    with tempfile.TemporaryDirectory() as made:
        place = pathlib.Path(made)
        (place / "parts of it").mkdir()
        (place / "main.xml").write_text(
            "<world xmlns='urn:robosim:world:1' width='20' height='4' length='20'>"
            "<include file='parts of it/shelf.xml'/>"
            "<cylinder name='robot' moveable='true' radius='0.25' height='1'><body mass='3'/></cylinder></world>")
        (place / "parts of it" / "shelf.xml").write_text(
            "<world xmlns='urn:robosim:world:1' width='8' height='4' length='4'><mesh file='tent.obj' center='3 0 0'/></world>")
        (place / "parts of it" / "tent.obj").write_text("v 0 0 -1\nv 0 1 0\nv 0 0 1\nf 1 2 3\n")
        told = module.load(str(place / "main.xml"))
        same((told.added, told.left_out), (2, []))
        near(module.sonar("robot"), 3)
        same(list(module.step(0).bodies), ["robot"])
        (place / "map.yaml").write_text("image: the map.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\n"
                                        "occupied_thresh: 0.65\nfree_thresh: 0.2\n")
        (place / "the map.pgm").write_bytes(b"P5 4 4 255\n" + bytes([0] + [254] * 15))
        same(module.load(str(place / "map.yaml")).left_out, [])
        assert "grid" in [o.kind for o in module.objects()]
    try:
        module.load(str(place / "none.xml"))
    except robosim.NotDone as e:
        assert "none.xml cannot be read; check the path" in str(e), e


def refused_in(what, words):
    try:
        what()
    except RequestError as e:
        assert words in str(e) and "robosim-world" not in str(e), e
    else:
        raise AssertionError(f"expected a RequestError: {words}")


def steps(module):
    module.init([box([3, 0, 0], 0.2, 2, 4, name="wall"),
                 cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)])
    wheels = robosim.drive_settings("differential", max_speed=1)
    step = module.step(0.5, [robosim.body("robot", mass=9, drive=wheels), robosim.body("rover")],
                       [robosim.command("robot", 2)])
    same(step.bodies["robot"].center, [0.5, 0, 0])
    same(step.bodies["robot"].velocity.x, 1)
    same((step.refused, step.contacts, step.stopped), ({1: 'no object "rover"'}, [], []))
    met = module.step(5)
    same([(c.name, c.other, c.phase) for c in met.contacts], [("robot", "wall", "BEGIN")])
    same(met.contacts[0].normal, [-1, 0, 0])
    assert 2.649 < met.bodies["robot"].center[0] < 2.65, met
    same([c.phase for c in module.step(0.1, [], [robosim.command("robot", -1)]).contacts], ["END"])


def mistakes(place):
    with robosim.connect(place, timeout=60) as module:
        module.init([cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True), box([3, 0, 0], 0.2, 2, 4)])
        same(module.sonars([("robot", 1, 0), ("robot", -1, 0, 0, 9)]), [2.9, float("inf")])
        same(module.moves([("robot", 1), ("robot", 0, 0, 1)]).refused, {})
        for ask, reason in ((lambda: module.move("robot", x=float("nan")), "numbers must be finite (got: nan at /"),
                            (lambda: module.scan("robot", count=0), "count must be at least 1 (got: 0)")):
            try:
                ask()
            except ValueError as e:
                assert reason in str(e), e
            else:
                raise AssertionError(reason)
        same(module.pose("robot").center, [1, 0, 1])  # nothing was sent
        for _ in range(2):  # the conversation goes on
            try:
                module.sonar("robot", 0, 0)
            except RequestError as e:
                assert "xOffset and zOffset must not both be zero" in str(e), e
            else:
                raise AssertionError("a sonar must have a direction")
        same(module.pose("robot").center, [1, 0, 1])
        asked = {"type": "sonars", "requests": [{"objectName": "robot", "xOffset": 0, "zOffset": 1}]}
        module.send(asked)
        module.send({**asked, "id": "mine"})
        same(module.move("robot", z=-1).made, True)  # in between
        same([module.receive("distances")["id"] for _ in range(2)][1], "mine")
        module.send({"type": "init", "objects": [{"kind": "cone"}]})  # has no answer, unless it is wrong
        try:
            module.ping()
        except RequestError as e:
            assert "must be box, cylinder" in str(e), e
        else:
            raise AssertionError("a cone must be refused")
        same(module.pose("robot").center, [1, 0, 0])
        module._sock.sendall(b"{]\n")
        for reason in ("the module refused it: ", "the module ended the conversation when it refused this: "):
            try:
                module.sonar("robot")
            except robosim.NotDone as e:
                assert str(e).startswith(reason) and "must be JSON" in str(e), e
            else:
                raise AssertionError(reason)


def main():
    with robosim.connect(sys.argv[1], timeout=60) as module:
        assert module.version.startswith("robosim-geometry"), module.version
        assert module.limits["messageBytes"] > 0
        refused(lambda: module.move("robot", x=1), 'no moveable object "robot", there is no world yet')
        refused(module.world, "there is no world yet")
        shapes(module)
        moves(module)
        changes(module)
        sensors(module)
        together(module)
        blocked(module)
        steps(module)
        drives(module, sys.argv[2])
    mistakes(sys.argv[1])
    units()
    try:
        box([0, 0, 0], 1, 1, 1, colour="red")
    except TypeError as e:
        assert "a box has no colour" in str(e), e
    else:
        raise AssertionError("a mistyped field must be refused")
    for place in ("localhost:http", "localhost"):
        try:
            robosim.connect(place)
        except robosim.NotDone as e:
            assert "a place must be" in str(e), e
        else:
            raise AssertionError("a place without a port must be refused")
    print("all done")


main()
