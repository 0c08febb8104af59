"""Scans, frames and pictures as arrays, images and pages."""

import base64
import math
import re
import struct
import unittest
import zlib

import robosim
from robosim import box, cylinder

try:
    import numpy
except ImportError:
    numpy = None

ROOM = [box([3, 0, 0], 0.2, 2, 4, name="wall", material={"color": "#0000ff"}),
        cylinder([0, 0, 0], 0.25, 1, name="robot <1>", moveable=True, material={"color": "#ff0000"})]


def pixels(png):
    """The width, height and channels of a PNG image as this package writes it, and its bytes."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at, parts = 8, {}
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        data = png[at + 8:at + 8 + length]
        assert struct.unpack(">I", png[at + 8 + length:at + 12 + length])[0] == zlib.crc32(kind + data)
        parts[kind] = data
        at += 12 + length
    width, height, depth, color = struct.unpack(">IIBB", parts[b"IHDR"][:10])
    channels = {0: 1, 2: 3}[color]
    rows = zlib.decompress(parts[b"IDAT"])
    assert depth == 8 and len(rows) == height * (1 + channels * width) and not any(rows[::1 + channels * width])
    data = b"".join(rows[k + 1:k + 1 + channels * width] for k in range(0, len(rows), 1 + channels * width))
    return width, height, channels, data


class Measurements(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.world = robosim.launch(ROOM)

    @classmethod
    def tearDownClass(cls):
        cls.world.close()

    def test_a_scan_has_its_angles(self):
        scan = self.world.scan("robot <1>", first=-0.5, step=0.25, count=5)
        self.assertEqual(list(scan.angles), [-0.5, -0.25, 0.0, 0.25, 0.5])
        for distance, angle in zip(scan.distances, scan.angles):
            self.assertAlmostEqual(distance * math.cos(angle), 2.9, 12)
        layers = self.world.sense("robot <1>", robosim.layers([-0.1, 0.2, 0.3], 0.0, 0.1, 4))
        self.assertEqual((layers.shape, len(layers), list(layers.angles)), ((3, 4), 12, [0.0, 0.1, 0.2, 0.1 * 3]))
        self.assertAlmostEqual(layers[4] * math.cos(0.2), 2.9, 12)
        with self.assertRaisesRegex(ValueError, r"only a fan and layers have angles \(got: pinhole\)"):
            self.world.frame("robot <1>", 4, 3, 1.0).angles

    def test_layers_are_left_out_and_motions_turn_while_they_translate(self):
        with robosim.launch([box([2, 0, 0], 0.2, 2, 4, name="pane", layers=["glass"]), *ROOM]) as world:
            scan = {"first": 0.0, "step": 0.1, "count": 1}
            self.assertAlmostEqual(world.scan("robot <1>", **scan)[0], 1.9, 12)
            self.assertAlmostEqual(world.scan("robot <1>", **scan, ignored=["glass"])[0], 2.9, 12)
            self.assertAlmostEqual(world.clearances("robot <1>", [0, 0, 0, 0], ignored=["glass"])[0], 2.65, 12)
            with self.assertRaisesRegex(robosim.RequestError, "ignored must name an object or a layer"):
                world.scan("robot <1>", **scan, ignored=["fog"])
            arc = world.drive_for("robot <1>", 2, x=0.5, ry=math.pi / 4)
            self.assertEqual((arc.made, arc.fraction), (True, 1.0))
            pose = world.pose("robot <1>")
            radius = 0.5 / (math.pi / 4)
            self.assertAlmostEqual(pose.heading, math.pi / 2, 12)
            self.assertAlmostEqual(pose.center[0], radius, 12)
            self.assertAlmostEqual(pose.center[2], -radius, 12)
            world.place("robot <1>", [0, 0, 0], heading=0)
            signed = world.signed_distance("robot <1>", "wall")
            self.assertEqual(len(signed), 11)
            self.assertAlmostEqual(signed[0], signed[2] - signed[5] if signed[8] > 0 else signed[5] - signed[2], 9)
            straight = world.drive_for("robot <1>", 3, x=1, clearance=0.05)
            self.assertEqual((straight.made, straight.obstacle), (False, "pane"))
            self.assertAlmostEqual(straight.fraction * 3, 1.6, 9)

    @unittest.skipUnless(numpy, "NumPy is not installed")
    def test_numpy_takes_them_in_their_shapes(self):
        frame = self.world.frame("robot <1>", 8, 6, 1.0, normals=True)
        depths = numpy.asarray(frame)
        self.assertEqual((depths.shape, depths.dtype, frame.shape), ((6, 8), numpy.float64, (6, 8)))
        self.assertEqual(depths.ravel().tolist(), list(frame))
        self.assertEqual(frame.array("normals").shape, (6, 8, 3))
        self.assertEqual(frame.array("normals")[3, 4].tolist(), [-1, 0, 0])
        self.assertEqual((frame.array("objects").shape, frame.names[frame.array("objects")[3, 4]]), ((6, 8), "wall"))
        self.assertEqual(numpy.asarray(frame, dtype="float32").dtype, numpy.float32)
        scan = self.world.scan("robot <1>", count=36)
        self.assertEqual(numpy.min(scan), 2.9)
        with self.assertRaisesRegex(ValueError, "was not asked for labels; give objects=True"):
            scan.array("labels")
        picture = self.world.picture("robot <1>", 8, 6, 1.0)
        self.assertEqual((picture.array().shape, bytes(picture.array()[0, 0])), ((6, 8, 3), picture.rgb[:3]))

    def test_a_frame_is_an_image_the_nearer_the_lighter(self):
        frame = self.world.frame("", 40, 30, 2.0, at=[-2, 0, 0])
        width, height, channels, grey = pixels(frame._repr_png_())
        self.assertEqual((width, height, channels), (40, 30, 1))
        for distance, shade in zip(frame, grey):
            self.assertEqual(shade == 0, math.isinf(distance))
        nearest, ahead = min(range(1200), key=frame.distances.__getitem__), 15 * 40 + 23
        self.assertEqual((frame.name(nearest), grey[nearest], frame.name(ahead)), ("robot <1>", 255, "wall"))
        self.assertLess(grey[ahead], 150)
        self.assertIsNone(self.world.scan("robot <1>", count=8)._repr_png_())

    def test_a_scan_is_drawn(self):
        svg = self.world.scan("robot <1>", first=0.0, step=math.pi / 8, count=2)._repr_svg_()
        ends = [(float(x), float(z)) for x, z in re.findall(r'<line x2="([^"]*)" y2="([^"]*)"/>', svg)]
        self.assertEqual(ends, [(2.9, 0), (2.9, float(f"{-2.9 * math.tan(math.pi / 8):.6g}"))])
        self.assertIsNone(self.world.frame("", 4, 3, 1.0)._repr_svg_())

    def test_the_plan_shows_each_object_at_its_place(self):
        picture = self.world.plan(200)
        width, height, channels, rgb = pixels(picture._repr_png_())
        self.assertEqual((width, height, channels, rgb), (169, 200, 3, picture.rgb))
        red, blue = [], []
        for k in range(width * height):
            r, g, b = rgb[3 * k:3 * k + 3]
            (red if r > 2 * b else blue if b > 2 * r else []).append((k % width, k // width))
        # X from -0.25 to 3.1 and Z from -2 to 2, and 2 % of 4 around it.
        scale, left, top = 200 / 4.16, -0.33, -2.08
        for found, x, z, area in ((red, 0, 0, math.pi / 16), (blue, 3, 0, 0.8)):
            self.assertAlmostEqual(sum(p[0] for p in found) / len(found), (x - left) * scale, delta=1)
            self.assertAlmostEqual(sum(p[1] for p in found) / len(found), (z - top) * scale, delta=1)
            self.assertAlmostEqual(len(found), area * scale * scale, delta=0.1 * area * scale * scale)

    def test_a_notebook_shows_the_plan_with_names(self):
        page = self.world._repr_html_()
        image = re.search(r"data:image/png;base64,([^\"]*)", page)[1]
        self.assertEqual(pixels(base64.b64decode(image))[1], 640)
        self.assertIn(">robot &lt;1&gt;</text>", page)
        self.assertNotIn("wall", page)

    def test_an_empty_world_is_told(self):
        self.world.init([])
        self.addCleanup(self.world.init, ROOM)
        self.assertIn("without objects", self.world._repr_html_())
        with self.assertRaisesRegex(ValueError, "an empty world has no plan"):
            self.world.plan()


if __name__ == "__main__":
    unittest.main()
