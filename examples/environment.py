#!/usr/bin/env python3
"""Plays RoboSim's environment module in Python 3, with nothing but its standard library.

It loads a world, sends it to the geometry module over TCP as JSON lines, and lets its robots wander by what their
sonars tell: what ReferenceEnvironment.java does in Java serialization. It checks every answer against the protocol and
measures how long answers take. Of meshes in OBJ files it reads those of triangles and quads.

    python3 examples/environment.py --world worlds/rooms.xml --connect localhost:7575

against a module that listens, or with --listen 7575 for a module that dials. docs/protocol.md tells what goes over the
wire, and docs/protocol.schema.json is its schema.
"""

import argparse
import json
import math
import pathlib
import random
import socket
import sys
import time
import xml.etree.ElementTree as ElementTree

SPACE = "{urn:robosim:world:1}"
METRES = {"km": 1000.0, "m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254, "ft": 0.3048}


class ProtocolFault(Exception):
    """The module said what the protocol does not allow."""


class Connection:
    """JSON lines over a socket: a hello first, then one line for each message."""

    def __init__(self, sock, secret=None):
        sock.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.sock = sock
        self.lines = sock.makefile("rb")
        hello = {"type": "hello", "version": 1}
        if secret is not None:
            hello["secret"] = secret
        # At once: who is silent for 300 ms is taken for a Java peer that waits for a stream header.
        self.send(hello)
        self.module = self.receive("hello", first=True)["module"]

    def send(self, message):
        # json writes the shortest digits that mean a double, and reads them back to the same bits.
        self.sock.sendall(json.dumps(message, allow_nan=False, separators=(",", ":")).encode() + b"\n")

    def receive(self, kind, first=False):
        line = self.lines.readline()
        if first and line and not line.startswith(b"{"):
            line = self.lines.readline()  # we were late: the header for Java peers, on a line of its own
        if not line.endswith(b"\n"):
            raise ProtocolFault("the module ended the conversation")
        answer = json.loads(line)
        if answer["type"] == "error":
            raise ProtocolFault(answer["message"])
        if answer["type"] != kind:
            raise ProtocolFault(f"the answer must be {kind} (got: {answer['type']})")
        return answer

    def ask(self, message, kind):
        """The answer, and the seconds that it took."""
        begin = time.perf_counter()
        self.send(message)
        return self.receive(kind), time.perf_counter() - begin


class World:
    """A world file, as objects for an init message and the sonars of its robots."""

    def __init__(self, path):
        self.folder = pathlib.Path(path).parent
        root = ElementTree.parse(path).getroot()
        self.unit = root.get("unit")
        self.size = [self.length(root, side) for side in ("width", "height", "length")]
        self.objects = []
        self.robots = []
        for element in root:
            made = self.read(element)
            self.objects.append(made)
            rings = element.findall(SPACE + "sonar")
            # What lies on its side has no level sensors, and stays.
            if made.get("moveable") and made.get("rotation", [0, 0, 0, 0, 1])[4] == 1:
                self.robots.append((made, [beam for ring in rings for beam in self.ring(ring)]))

    def number(self, text):
        for unit in sorted(METRES, key=len, reverse=True):
            if text.endswith(unit):
                return float(text[: -len(unit)]) * METRES[unit] / METRES[self.unit]
        return float(text)

    def length(self, element, name, default=None):
        text = element.get(name)
        return default if text is None else self.number(text)

    def read(self, element):
        kind = element.tag[len(SPACE):]
        made = {"kind": kind, "center": [self.number(n) for n in element.get("center", "0 0 0").split()]}
        if element.get("name") is not None:
            made["name"] = element.get("name")
        if element.get("moveable") == "true":
            made["moveable"] = True
        rotation = self.rotation(element)
        if rotation:
            made["rotation"] = rotation
        for side in {"box": ["width", "height", "length"], "cylinder": ["radius", "height"], "sphere": ["radius"]}.get(
            kind, []
        ):
            made[side] = self.length(element, side)
        if kind == "mesh":
            self.mesh(element, made)
        elif kind == "group":
            members = [e for e in element if e.tag not in (SPACE + "bounds", SPACE + "sonar")]
            made["members"] = [self.read(member) for member in members]
        bounds = element.find(SPACE + "bounds")
        if bounds is not None:
            made["boundingVolume"] = self.read(bounds[0])
        return made

    @staticmethod
    def rotation(element):
        """Nine numbers, row by row; its columns are the object's own axes."""
        if element.get("rotation") is not None:
            return [float(n) for n in element.get("rotation").split()]
        if element.get("turned") is not None:
            rx, ry = (float(n) for n in element.get("turned").split())
        else:
            rx, ry = 0.0, float(element.get("heading", 0))
        if rx == 0 and ry == 0:
            return None
        c, s = turn(ry)
        cx, sx = turn(rx)
        return [c, s * sx, s * cx, 0.0, cx, -sx, -s, c * sx, c * cx]

    def mesh(self, element, made):
        vertices, faces = [], []
        if element.get("file") is not None:
            self.obj(element, vertices, faces)
        for part in element:
            numbers = (part.text or "").split()
            if part.tag == SPACE + "vertices":
                flat = [self.number(n) for n in numbers]
                vertices += [flat[k:k + 3] for k in range(0, len(flat), 3)]
            elif part.tag in (SPACE + "triangles", SPACE + "quads"):
                corners = 3 if part.tag == SPACE + "triangles" else 4
                flat = [int(n) for n in numbers]
                faces += [flat[k:k + corners] for k in range(0, len(flat), corners)]
        made["vertices"], made["faces"] = vertices, faces
        if element.get("solid") == "true":
            made["solid"] = True

    def obj(self, element, vertices, faces):
        scale = float(element.get("scale", 1))
        for line in (self.folder / element.get("file")).read_text().splitlines():
            words = line.split()
            if words and words[0] == "v":
                vertices.append([float(n) * scale for n in words[1:4]])
            elif words and words[0] == "f":
                corners = [int(word.split("/")[0]) for word in words[1:]]
                corners = [k - 1 if k > 0 else len(vertices) + k for k in corners]
                if len(corners) > 4:
                    name = element.get("file")
                    raise ValueError(f"{name}: a face must have 3 or 4 corners here (got: {len(corners)})")
                faces.append(corners)

    def ring(self, ring):
        """Each sensor of a ring: its bearing in radians, its direction in the robot's own frame, and its beam."""
        count = int(ring.get("count"))
        first = float(ring.get("first", 0))
        step = float(ring.get("step", 360 / count))
        # On the wire every angle is in radians, and no end is null.
        beam = {
            "min": self.length(ring, "min", 0.0),
            "max": self.length(ring, "max"),
            "width": math.radians(float(ring.get("width", 0))),
        }
        for sensor in range(count):
            c, s = turn(first + sensor * step)
            yield math.atan2(s, c), (c, -s), beam


def turn(degrees):
    """Cosine and sine, exact at quarter turns."""
    quarter = round(degrees / 90)
    rest = math.radians(degrees - 90 * quarter)
    c, s = math.cos(rest), math.sin(rest)
    return [(c, s), (-s, c), (-c, -s), (s, -c)][quarter % 4]


class Robot:
    """Goes ahead where there is room, turns to the roomier side where there is not, and is bold at times."""

    def __init__(self, made, sensors, speed, seed):
        self.name = made["name"]
        self.speed = speed
        self.random = random.Random(seed)
        box = math.hypot(made.get("width", 0), made.get("length", 0)) / 2
        self.reach = box if made["kind"] == "box" else made.get("radius", 0)
        sensors = sensors or [(0.0, (1.0, 0.0), None)]
        self.bearings = [bearing for bearing, _, _ in sensors]
        self.requests = []
        for _, (x, z), beam in sensors:
            request = {"objectName": self.name, "xOffset": x, "zOffset": z}
            if beam is not None:
                request["beam"] = beam
            self.requests.append(request)
        self.distances = [math.inf] * len(sensors)
        self.refused_in_a_row = self.bold_steps = self.retreat_steps = 0
        self.retreat = 0.0

    def move(self, x=0.0, z=0.0, ry=0.0):
        return {"objectName": self.name, "x": x, "y": 0.0, "z": z, "rx": 0.0, "ry": ry}

    def wander(self):
        seen = [min(distance, self.reach + 60 * self.speed) for distance in self.distances]
        ahead = min((s for s, bearing in zip(seen, self.bearings) if abs(bearing) < 0.8), default=math.inf)
        left = sum(s for s, bearing in zip(seen, self.bearings) if bearing > 0)
        right = sum(s for s, bearing in zip(seen, self.bearings) if bearing < 0)
        side = 1 if left >= right else -1
        if self.refused_in_a_row > 0:
            return self.unstick(side)
        if self.retreat_steps > 0:
            self.retreat_steps -= 1
            return self.back_off()
        if self.bold_steps == 0 and self.random.randrange(50) == 0:
            self.bold_steps = 40
        if self.bold_steps > 0:
            self.bold_steps -= 1
            return self.move(x=self.speed)
        if ahead < self.reach + 8 * self.speed:
            return self.move(x=self.speed / 4, ry=side * self.random.uniform(0.15, 0.35))
        return self.move(x=self.speed, ry=self.random.uniform(-0.06, 0.06))

    def unstick(self, side):
        """Turns away; where that is refused too, retreats a few steps to where it sees farthest, without a turn."""
        self.bold_steps = 0
        if self.refused_in_a_row == 1:
            return self.move(ry=side * self.random.uniform(0.3, 2.4))
        farthest = max(range(len(self.distances)), key=lambda k: (self.distances[k], self.random.random()))
        # Where that is refused as well, any way may be the one out.
        stuck = self.refused_in_a_row > 2
        self.retreat = self.random.uniform(-math.pi, math.pi) if stuck else self.bearings[farthest]
        self.retreat_steps = 8
        return self.back_off()

    def back_off(self):
        return self.move(x=self.speed * math.cos(self.retreat), z=-self.speed * math.sin(self.retreat))

    def told(self, allowed):
        self.refused_in_a_row = 0 if allowed else self.refused_in_a_row + 1


class Tally:
    """What was asked, what was answered, and how long it took."""

    def __init__(self):
        self.distances = self.echoes = self.asked = self.made = 0
        self.reasons = {}
        self.sonar_seconds = []
        self.move_seconds = []

    @staticmethod
    def micros(seconds, share):
        """The least time that so large a share stays within, in microseconds."""
        ordered = sorted(seconds) or [0.0]
        return ordered[max(0, math.ceil(share * len(ordered)) - 1)] * 1e6

    def text(self, steps, robots):
        times = [self.micros(s, share) for s in (self.sonar_seconds, self.move_seconds) for share in (0.5, 0.99)]
        lines = [
            f"environment   {steps:,} steps of {robots} robots: {self.asked:,} moves asked, {self.made:,} made;"
            f" {self.distances:,} distances, {self.echoes:,} of them echoes",
            "              every answer kept to the protocol",
            "              a round of sonar took {:.1f} us (median), {:.1f} us (99 %); of moves {:.1f} us, {:.1f} us"
            .format(*times),
        ]
        for reason, count in sorted(self.reasons.items(), key=lambda item: (-item[1], item[0]))[:3]:
            lines.append(f"              {count:,} times {reason}")
        return "\n".join(lines)


def sense(connection, robots, tally):
    """One round of all sonars of all robots."""
    requests = [request for robot in robots for request in robot.requests]
    answer, seconds = connection.ask({"type": "sonars", "requests": requests}, "distances")
    tally.sonar_seconds.append(seconds)
    distances = answer["distances"]
    if len(distances) != len(requests):
        raise ProtocolFault(f"{len(requests)} requests, {len(distances)} distances")
    for k, (request, distance) in enumerate(zip(requests, distances)):
        if isinstance(distance, dict):
            raise ProtocolFault(f"{distance['error']} (for {request})")
        distances[k] = math.inf if distance is None else distance
        beam = request.get("beam", {"min": 0.0, "max": None})
        most = math.inf if beam["max"] is None else beam["max"]
        if distance is not None and not beam["min"] <= distance <= most:
            raise ProtocolFault(f"a distance must be {beam['min']} to {most} or null (got: {distance} for {request})")
        tally.echoes += distance is not None
    tally.distances += len(distances)
    at = 0
    for robot in robots:
        robot.distances = distances[at:at + len(robot.requests)]
        at += len(robot.requests)


def step(connection, robots, tally):
    """One bundle with a move of each robot."""
    moves = [robot.wander() for robot in robots]
    answer, seconds = connection.ask({"type": "moves", "moves": moves}, "moves")
    tally.move_seconds.append(seconds)
    refused = {refusal["index"]: refusal["reason"] for refusal in answer["refused"]}
    expected = [move for k, move in enumerate(moves) if k not in refused]
    if repr(answer["moves"]) != repr(expected):  # repr tells -0.0 from 0.0
        raise ProtocolFault(f"the answer must hold the moves that were made, bit for bit (got: {answer['moves']})")
    for k, robot in enumerate(robots):
        robot.told(k not in refused)
    for reason in refused.values():
        obstacle = reason.split(" after ")[0]
        tally.reasons[obstacle] = tally.reasons.get(obstacle, 0) + 1
    tally.asked += len(moves)
    tally.made += len(expected)


def open_socket(options):
    if options.connect:
        host, _, port = options.connect.rpartition(":")
        return socket.create_connection((host, int(port)))
    with socket.create_server(("127.0.0.1", options.listen), backlog=1) as server:
        print(f"Listening on port {server.getsockname()[1]}", flush=True)
        return server.accept()[0]


def first_line(path):
    return pathlib.Path(path).read_text(encoding="utf-8").split("\n", 1)[0]


def run(options):
    world = World(options.world)
    seeds = random.Random(options.seed)
    robots = [Robot(made, sensors, options.speed, seeds.random()) for made, sensors in world.robots]
    if not robots:
        raise ValueError(f"world must hold a moveable object that stands upright (got: {options.world})")
    secret = first_line(options.secret_file) if options.secret_file else None
    tally = Tally()
    with open_socket(options) as sock:
        connection = Connection(sock, secret)
        width, height, length = world.size
        # The world as RoboSim sees it: from above, and exactly.
        settings = {"width": width, "height": height, "length": length, "dimension": "PLANAR", "accuracy": "EXACT"}
        connection.send({"type": "init", "objects": world.objects, "settings": settings})
        connection.ask({"type": "ping", "id": "ready"}, "pong")  # an init has no answer, but this has
        for _ in range(options.steps):
            sense(connection, robots, tally)
            step(connection, robots, tally)
        sense(connection, robots, tally)  # what the robots see where they have come to rest
    print(tally.text(options.steps, len(robots)))
    print(f"              by {connection.module}")


def main():
    parser = argparse.ArgumentParser(description="RoboSim's environment module, in JSON lines.")
    parser.add_argument("--world", required=True, help="a world with moveable objects")
    place = parser.add_mutually_exclusive_group(required=True)
    place.add_argument("--connect", metavar="HOST:PORT", help="dial a module that listens")
    place.add_argument("--listen", metavar="PORT", type=int, help="wait for a module that dials; 0 for any port")
    parser.add_argument("--steps", type=int, default=1000, help="rounds of sonar and moves")
    parser.add_argument("--seed", type=int, default=1, help="of the robots' whims")
    parser.add_argument("--speed", type=float, default=0.05, help="world units a robot advances in a step")
    parser.add_argument("--secret-file", metavar="FILE", help="its first line is the secret for a module that asks for one")
    try:
        run(parser.parse_args())
    except ProtocolFault as fault:
        sys.exit(f"The module broke the protocol, or ended it: {fault}")
    except (OSError, ValueError) as failed:
        print(f"The conversation failed: {failed}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
