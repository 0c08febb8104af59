#!/usr/bin/env python3
"""Drives a robot by its camera, and saves what it saw, with nothing but Python's standard library.

It uses the package robosim in ../python, which need not be installed.

A robot in a room with pillars, crates and balls looks for the balls. Each step it asks the geometry module for one frame:
the distances of 64 x 48 rays, which object each of them met, and the label of its material. It turns to the nearest ball
that it has not visited, and away from what is in its way. Frames go to a folder, depth as 16-bit PGM in millimetres and
objects as PPM in colours, and every tenth time what the camera sees in colour, with light and shadows, as PNG.

    python3 examples/camera.py --connect localhost:7575 --save frames

against a module that listens, such as `robosim-geometry serve`. It exits with 0 where every ball was visited, with 1 where one was
not, or an answer did not keep to the protocol, and with 2 where it could not be asked.
"""

import argparse
import math
import pathlib
import random
import socket
import struct
import sys

from environment import place, steps  # which finds the package robosim
from robosim import Error, Module, ProtocolFault

WIDTH, HEIGHT, FIELD = 64, 48, math.radians(90)
REACH = 12.0
NEAR = 0.75  # from the middle of a ball, it is visited
STRIDE, ROOM = 0.1, 0.45
BALL = 2

def scene(seed):
    """A room of 10 x 10 metres: walls, pillars and crates that stand in the way, and balls."""
    whims = random.Random(seed)

    def box(name, center, width, height, length, label):
        return {"kind": "box", "name": name, "center": center, "width": width, "height": height, "length": length,
                "material": {"color": "#b0a890", "label": label}}

    objects = [box("north", [0, 1, -5.1], 10.4, 2, 0.2, 1), box("south", [0, 1, 5.1], 10.4, 2, 0.2, 1),
               box("west", [-5.1, 1, 0], 0.2, 2, 10, 1), box("east", [5.1, 1, 0], 0.2, 2, 10, 1),
               box("floor", [0, -0.1, 0], 10.4, 0.2, 10.4, 1)]
    taken = [(0.0, 0.0)]

    def somewhere():
        while True:
            x, z = whims.uniform(-4, 4), whims.uniform(-4, 4)
            if all(math.hypot(x - a, z - b) > 1.8 for a, b in taken):
                taken.append((x, z))
                return x, z

    for number in range(3):
        x, z = somewhere()
        objects.append({"kind": "sphere", "name": f"ball {number}", "center": [x, 0.26, z], "radius": 0.25,
                        "material": {"color": "#d03020", "label": BALL}})
    for number in range(4):
        x, z = somewhere()
        objects.append(box(f"crate {number}", [x, 0.31, z], 0.6, 0.6, 0.6, 3))
    objects.append({"kind": "cylinder", "name": "robot", "moveable": True, "center": [0, 0.26, 0], "radius": 0.2,
                    "height": 0.5})
    return objects


class Frame:
    """What the camera saw: a distance, an object and a label for each pixel, row by row from the top."""

    def __init__(self, scan):
        self.distances, self.objects, self.labels, self.names = scan.distances, scan.objects, scan.labels, scan.names

    @staticmethod
    def across(column):
        """How far a pixel lies to the right for each metre ahead."""
        return (2 * column + 1 - WIDTH) / WIDTH * math.tan(FIELD / 2)

    @staticmethod
    def along(pixel):
        """The share of a ray's length that goes ahead."""
        row, column = divmod(pixel, WIDTH)
        down = (2 * row + 1 - HEIGHT) / WIDTH * math.tan(FIELD / 2)
        return 1 / math.sqrt(1 + down * down + Frame.across(column) ** 2)

    def nearest_ball(self, visited):
        """Name, distance and bearing (radians to the left) of the nearest ball in sight."""
        best = None
        for pixel, label in enumerate(self.labels):
            if label == BALL and self.names[self.objects[pixel]] not in visited:
                distance = self.distances[pixel]
                if best is None or distance < best[1]:
                    best = self.names[self.objects[pixel]], distance, -math.atan(self.across(pixel % WIDTH))
        return best

    def room(self, left, right):
        """How far ahead is free between two columns, for rays that do not point at the floor."""
        rows = range(HEIGHT // 4, HEIGHT // 2 + 2)
        pixels = [row * WIDTH + column for row in rows for column in range(left, right)]
        return min(min(self.distances[pixel], REACH) * self.along(pixel) for pixel in pixels)

    def save(self, folder, number):
        depths = []
        for pixel, distance in enumerate(self.distances):
            depths.append(0 if math.isinf(distance) else min(65535, round(1000 * distance * self.along(pixel))))
        depth = b"P5\n%d %d\n65535\n" % (WIDTH, HEIGHT) + struct.pack(f">{len(depths)}H", *depths)
        (folder / f"depth-{number:04}.pgm").write_bytes(depth)
        colors = bytearray()
        for label, thing in zip(self.labels, self.objects):
            shade = 0 if thing < 0 else 90 + 53 * thing % 120
            colors += bytes([shade, shade // 3, 20] if label == BALL else [shade, shade, shade * label % 200])
        (folder / f"objects-{number:04}.ppm").write_bytes(b"P6\n%d %d\n255\n" % (WIDTH, HEIGHT) + colors)


def drive(module, most, save):
    """Looks, decides and moves until every ball was visited, or so many steps were made."""
    visited, made = [], 0
    side, aside = 1, 0  # which way to turn, and for how many steps to forget the balls
    for number in range(most):
        frame = Frame(module.frame("robot", WIDTH, HEIGHT, FIELD, at=[0.15, 0.3, 0], max=REACH))
        if save is not None:
            frame.save(save, number)
            if number % 10 == 0:
                picture = module.picture("robot", 320, 240, FIELD, at=[0.15, 0.3, 0], samples=2)
                picture.save(save / f"color-{number:04}.png")
        ball = frame.nearest_ball(visited)
        if ball is not None and ball[1] < NEAR:
            visited.append(ball[0])
            print(f"step {number}: at {ball[0]}")
            if len(visited) == 3:
                break
            continue
        ahead = frame.room(WIDTH // 4, WIDTH * 3 // 4)
        if ahead < ROOM:  # round it, on the side that has more room
            if aside == 0:
                side = 1 if frame.room(0, WIDTH // 3) > frame.room(WIDTH * 2 // 3, WIDTH) else -1
            turn, forward, aside = side * 0.5, 0.0, 15
        elif aside > 0:
            turn, forward, aside = 0.0, STRIDE, aside - 1
        elif ball is not None:
            turn, forward = max(-0.3, min(0.3, ball[2])), STRIDE
        else:
            turn, forward = 0.12 if number % 80 < 40 else 0.0, STRIDE if number % 80 >= 40 else 0.02
        if module.move("robot", forward, ry=turn):
            made += 1
        else:  # something that the camera does not see is in the way
            module.move("robot", ry=side * 0.7)
            aside = 15
    print(f"{number + 1} frames, {made} moves made, {len(visited)} of 3 balls visited: {', '.join(visited) or 'none'}")
    return len(visited) == 3


def main():
    parser = argparse.ArgumentParser(description="Drives a robot by its camera.")
    parser.add_argument("--connect", metavar="HOST:PORT", type=place, required=True, help="a module that listens")
    parser.add_argument("--steps", type=steps, default=1500, help="the most frames")
    parser.add_argument("--seed", type=int, default=1, help="of the room")
    parser.add_argument("--save", metavar="FOLDER", type=pathlib.Path, help="takes the frames as PGM, PPM and PNG images")
    arguments = parser.parse_args()
    try:
        if arguments.save is not None:
            arguments.save.mkdir(parents=True, exist_ok=True)
        with socket.create_connection(arguments.connect, timeout=60) as sock:
            module = Module(sock)
            module.init(scene(arguments.seed), width=30, height=10, length=30, dimension="SPATIAL")
            sys.exit(0 if drive(module, arguments.steps, arguments.save) else 1)
    except ProtocolFault as fault:
        sys.exit(f"The module broke the protocol: {fault}")
    except (Error, OSError) as reason:
        print(f"Not done: {reason}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
