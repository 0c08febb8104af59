#!/usr/bin/env python3
"""Plays RoboSim's environment module in Python 3, with nothing but its standard library, the package
robosim in ../python, which need not be installed, and worldfile.py beside it.

It loads a world, sends it to the geometry module over TCP as JSON lines, and lets its robots wander by what their
sonars tell: what ReferenceEnvironment.java does in Java serialization. It checks every answer against the protocol and
measures how long answers take. All sonars of a step are one batch, with a request for each ring.

    python3 examples/environment.py --world worlds/rooms.xml --connect localhost:7575

against a module that listens, or with --listen 7575 for a module that dials. docs/protocol.md tells what goes over the
wire, and docs/protocol.schema.json is its schema. It exits with 0 where all answers kept to the protocol, with 1 where
one did not, and with 2 where it could not be asked: bad usage, a world with a fault, a connection that failed.
"""

import argparse
import base64
import math
import os
import pathlib
import random
import re
import socket
import struct
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "python"))

from robosim import Module, NotDone, ProtocolFault, RequestError
from worldfile import World

# One ray ahead, without an end, for a robot without sensors.
AHEAD = {
    "kind": "sense",
    "pattern": {"kind": "fan", "first": 0.0, "step": 0.0, "count": 1},
    "min": 0.0,
    "max": None,
    "width": 0.0,
}


class Robot:
    """Goes ahead where there is room, turns to the roomier side where there is not, and is bold at times."""

    def __init__(self, made, sensors, speed, seed):
        self.name = made["name"]
        self.speed = speed
        self.random = random.Random(seed)
        box = math.hypot(made.get("width", 0), made.get("length", 0)) / 2
        self.reach = box if made["kind"] == "box" else made.get("radius", 0)
        sensors = sensors or [([0.0], AHEAD)]
        self.bearings = [bearing for bearings, _ in sensors for bearing in bearings]
        self.requests = [{**request, "objectName": self.name} for _, request in sensors]
        self.distances = [math.inf] * len(self.bearings)
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


def count(number, one):
    return f"{number:,} {one}{'' if number == 1 else 's'}"


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
        micros = [self.micros(s, share) for s in (self.sonar_seconds, self.move_seconds) for share in (0.5, 0.99)]
        lines = [
            f"environment   {count(steps, 'step')} of {count(robots, 'robot')}: {count(self.asked, 'move')} asked,"
            f" {self.made:,} made; {count(self.distances, 'distance')}, {self.echoes:,} of them echoes",
            "              every answer kept to the protocol",
            "              a round of sonar took {:.1f} us (median), {:.1f} us (99 %); of moves {:.1f} us, {:.1f} us"
            .format(*micros),
        ]
        for reason, times in sorted(self.reasons.items(), key=lambda item: (-item[1], item[0]))[:3]:
            lines.append(f"              {count(times, 'time')} {reason}")
        return "\n".join(lines)


def unpacked(text, count):
    """So many packed numbers: the base64 of doubles, the lowest byte first."""
    try:
        return list(struct.unpack(f"<{count}d", base64.b64decode(text, validate=True)))
    except (TypeError, ValueError, struct.error):
        raise ProtocolFault(f"there must be {count} packed numbers (got: {str(text)[:100]})") from None


def sense(connection, robots, tally):
    """One round of all sonars of all robots: one request for each ring, in one batch."""
    requests = [request for robot in robots for request in robot.requests]
    answer, seconds = connection.ask({"type": "batch", "requests": requests}, "answers")
    tally.sonar_seconds.append(seconds)
    answers = answer["answers"]
    if len(answers) != len(requests):
        raise ProtocolFault(f"{len(requests)} requests, {len(answers)} answers")
    distances = []
    for request, given in zip(requests, answers):
        if "error" in given:
            raise ProtocolFault(f"{given['error']} (for {request})")
        ring = unpacked(given["distances"], request["pattern"]["count"])
        most = math.inf if request["max"] is None else request["max"]
        for distance in ring:
            if not request["min"] <= distance <= most and distance != math.inf:
                raise ProtocolFault(f"a distance must be {request['min']} to {most}, or infinite where nothing echoes"
                                    f" (got: {distance} for {request})")
            tally.echoes += distance < math.inf
        distances += ring
    tally.distances += len(distances)
    at = 0
    for robot in robots:
        robot.distances = distances[at:at + len(robot.bearings)]
        at += len(robot.bearings)


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
        host, port = options.connect
        try:
            sock = socket.create_connection((host, port), timeout=10)
        except ConnectionRefusedError:
            raise NotDone(f"nobody listens at {host}:{port}; start the module first, in another terminal:"
                          f' mvn -q compile exec:java -Dexec.args="serve {port}"'
                          f" (or java -jar robosim-geometry-...-app.jar serve {port})") from None
        except socket.gaierror:
            raise NotDone(f"there is no host {host}; check --connect, like localhost:7575") from None
        except socket.timeout:
            raise NotDone(f"{host}:{port} did not answer within 10 s; check --connect, and whether a firewall lets"
                          " you through") from None
        except OSError as e:
            raise NotDone(f"{host}:{port} cannot be reached ({e.strerror}); check --connect") from None
        sock.settimeout(None)
        return sock
    try:
        server = socket.create_server(("127.0.0.1", options.listen), backlog=1)
    except OSError as e:
        raise NotDone(f"port {options.listen} cannot be listened on ({os.strerror(e.errno or 0)}); end the program that"
                      " has it, or take another port, 0 for any free one") from None
    with server:
        print(f"Listening on port {server.getsockname()[1]}", flush=True)
        return server.accept()[0]


def first_line(path):
    try:
        return pathlib.Path(path).read_text(encoding="utf-8").split("\n", 1)[0]
    except (OSError, UnicodeDecodeError) as e:
        raise NotDone(f"{path}: the secret cannot be read; check --secret-file ({e})") from None


def load(connection, world):
    width, height, length = world.size
    # The world as RoboSim sees it: from above, and exactly.
    settings = {"width": width, "height": height, "length": length, "dimension": "PLANAR", "accuracy": "EXACT"}
    connection.send({"type": "init", "objects": world.objects, "settings": settings})
    try:
        connection.ask({"type": "ping"}, "pong")  # an init has no answer unless it is wrong, but this has
    except RequestError as refused:
        number = re.search(r"/objects/(\d+)", str(refused))
        place = f"{world.places[int(number.group(1))]}: " if number else ""
        raise NotDone(f"{place}the module refused it: {refused}") from None
    for request, answer in zip(world.attached, connection.batch(world.attached) if world.attached else []):
        if isinstance(answer, RequestError) or not answer:
            raise NotDone(f"the module did not attach {request['objectName']} to {request['carrier']}: {answer}")


def is_for_the_module(path):
    """Whether only the module can read a file: one of another format, or one that includes others."""
    try:
        return not path.endswith(".xml") or b"<include" in pathlib.Path(path).read_bytes()
    except OSError:
        return False  # whoever reads it says why


def loaded(connection, path):
    """The robots of a file that the module reads, with no sensors of their own: a ring of eight sonars each."""
    try:
        told = connection.load(path, dimension="PLANAR", accuracy="EXACT")
    except RequestError as refused:
        raise NotDone(f"the module refused it: {refused}") from None
    for each in told.left_out:
        print(f"left out: {each.name}: {each.reason}", file=sys.stderr)
    ring = {**AHEAD, "pattern": {"kind": "fan", "first": 0.0, "step": math.pi / 4, "count": 8}}
    bearings = [math.remainder(k * math.pi / 4, math.tau) for k in range(8)]
    return [({"name": each.name, "kind": "box", "width": each.high[0] - each.low[0], "length": each.high[2] - each.low[2]},
             [(bearings, ring)]) for each in connection.objects() if each.moveable]


def wanderers(found, options):
    seeds = random.Random(options.seed)
    robots = [Robot(made, sensors, options.speed, seeds.random()) for made, sensors in found]
    if not robots:
        raise NotDone(f"{options.world}: a world must hold a moveable object that stands upright, else nothing can"
                      ' wander; give one moveable="true"')
    return robots


def run(options):
    by_module = is_for_the_module(options.world)
    robots = []
    if not by_module:
        world = World(options.world)
        for _, reason in world.notes:
            print(f"left out: {reason}", file=sys.stderr)
        robots = wanderers(world.robots, options)
    secret = first_line(options.secret_file) if options.secret_file else None
    tally = Tally()
    with open_socket(options) as sock:
        connection = Module(sock, secret)
        if by_module:
            robots = wanderers(loaded(connection, options.world), options)
        else:
            load(connection, world)
        for _ in range(options.steps):
            sense(connection, robots, tally)
            step(connection, robots, tally)
        sense(connection, robots, tally)  # what the robots see where they have come to rest
    print(tally.text(options.steps, len(robots)))
    print(f"              by {connection.version}")


def place(text):
    host, colon, number = text.rpartition(":")
    if not colon or not host:
        raise argparse.ArgumentTypeError(f"must be HOST:PORT, like localhost:7575 (got: {text})")
    return host.strip("[]"), port(number, least=1)


def port(text, least=0):
    if not (text.isascii() and text.isdigit() and least <= int(text) <= 65535):
        raise argparse.ArgumentTypeError(f"a port must be {least} to 65535 (got: {text})")
    return int(text)


def steps(text):
    if not (text.isascii() and text.isdigit()):
        raise argparse.ArgumentTypeError(f"must be a whole number of at least 0 (got: {text})")
    return int(text)


def speed(text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not 0 < value < 1e9:
        raise argparse.ArgumentTypeError(f"must be a number above 0 (got: {text})")
    return value


def main():
    parser = argparse.ArgumentParser(
        description="RoboSim's environment module, in JSON lines.",
        epilog="Exit codes: 0 all answers kept to the protocol; 1 one did not; 2 not done: bad usage, a world with a"
        " fault, a connection that failed.",
    )
    parser.add_argument("--world", required=True, help="a world with moveable objects")
    ways = parser.add_mutually_exclusive_group(required=True)
    ways.add_argument("--connect", metavar="HOST:PORT", type=place, help="dial a module that listens")
    ways.add_argument("--listen", metavar="PORT", type=port, help="wait for a module that dials; 0 for any port")
    parser.add_argument("--steps", type=steps, default=1000, help="rounds of sonar and moves")
    parser.add_argument("--seed", type=int, default=1, help="of the robots' whims")
    parser.add_argument("--speed", type=speed, default=0.05, help="world units a robot advances in a step")
    parser.add_argument("--secret-file", metavar="FILE", help="its first line is the secret for a module that asks for one")
    try:
        run(parser.parse_args())
    except ProtocolFault as fault:
        sys.exit(f"The module broke the protocol: {fault}")
    except (NotDone, RequestError) as reason:
        print(f"Not done: {reason}", file=sys.stderr)
        sys.exit(2)
    except OSError as failed:
        print(f"Not done: the connection failed ({failed.strerror or failed}); the module's log may tell why",
              file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        sys.exit(130)


if __name__ == "__main__":
    main()
