"""Frame.ros: cases computed by hand, round trips, and the places where the module's importers put the same numbers."""

import math
import pathlib
import random
import tempfile
import unittest

import robosim
from robosim import Frame, Pose, Velocity, box, cylinder, renormalised

HALF = math.sqrt(0.5)
UPRIGHT = [1.0, 0, 0, 0, 1, 0, 0, 0, 1]


def product(a, b):
    return [sum(a[3 * row + k] * b[3 * k + column] for k in range(3)) for row in range(3) for column in range(3)]


def about(axis, angle):
    """A turn about X, Y or Z of a right-handed frame, as nine numbers."""
    c, s = math.cos(angle), math.sin(angle)
    return {"x": [1, 0, 0, 0, c, -s, 0, s, c], "y": [c, 0, s, 0, 1, 0, -s, 0, c], "z": [c, -s, 0, s, c, 0, 0, 0, 1]}[axis]


class Ros(unittest.TestCase):
    def near(self, got, expected, places=12):
        got, expected = list(got), list(expected)
        self.assertEqual(len(got), len(expected))
        for a, b in zip(got, expected):
            self.assertAlmostEqual(a, b, places, f"{got} must be {expected}")

    def test_forward_left_and_up(self):
        ros = Frame.ros()
        for world, there in (((1, 0, 0), (1, 0, 0)), ((0, 1, 0), (0, 0, 1)), ((0, 0, 1), (0, -1, 0))):
            self.assertEqual(ros.vector(world), there)
            self.assertEqual(ros.point(world), there)
            self.assertEqual(ros.world_vector(there), world)
            self.assertEqual(ros.world_point(there), world)

    def test_the_origin_is_where_the_world_s_centre_lies(self):
        ros = Frame.ros(5, 4)
        self.assertEqual(ros.point((0, 0, 0)), (5, 4, 0))
        self.assertEqual(ros.point((-5, 1.5, 4)), (0, 0, 1.5))
        self.assertEqual(ros.world_point((0, 0, 1.5)), (-5, 1.5, 4))
        self.assertEqual(ros.vector((1, 2, 3)), (1, -3, 2))

    def test_turns_about_each_axis(self):
        ros = Frame.ros()
        # ROS: a roll of a quarter turn about X takes left to up, a pitch about Y forward to down, a yaw about Z forward to left.
        self.near(ros.world_rotation((HALF, 0, 0, HALF)), about("x", math.pi / 2))
        self.near(ros.world_rotation((0, HALF, 0, HALF)), about("z", -math.pi / 2))
        self.near(ros.world_rotation((0, 0, HALF, HALF)), about("y", math.pi / 2))
        self.near(ros.quaternion(about("y", math.pi / 2)), (0, 0, HALF, HALF))
        self.near(ros.quaternion(about("z", -0.2)), (0, math.sin(0.1), 0, math.cos(0.1)))
        self.near(ros.quaternion(about("x", 0.2)), (math.sin(0.1), 0, 0, math.cos(0.1)))
        self.assertEqual(ros.quaternion(UPRIGHT), (0, 0, 0, 1))

    def test_half_turns_have_a_quaternion_too(self):
        ros = Frame.ros()
        self.near(ros.quaternion(about("x", math.pi)), (1, 0, 0, 0))
        self.near(map(abs, ros.quaternion(about("y", math.pi))), (0, 0, 1, 0))
        self.near(map(abs, ros.quaternion(about("z", math.pi))), (0, 1, 0, 0))

    def test_poses(self):
        ros = Frame.ros(1, 2)
        there = ros.pose(Pose([3, 0.5, -1], about("y", 0.3), 0.3))
        self.near(there.position, (4, 3, 0.5))
        self.near(there.orientation, (0, 0, math.sin(0.15), math.cos(0.15)))
        back = ros.world_pose(*there)
        self.near(back.center, (3, 0.5, -1))
        self.near(back.rotation, about("y", 0.3))
        self.assertAlmostEqual(back.heading, 0.3, 15)
        self.assertEqual(ros.pose_2d(Pose([3, 0.5, -1], UPRIGHT, 0.3)), (4, 3, 0.3))
        self.assertEqual(ros.world_pose_2d(4, 3, 0.3, height=0.5), ((3, 0.5, -1), 0.3))

    def test_velocities_and_commands(self):
        ros = Frame.ros(9, 9)
        twist = ros.twist(Velocity(1, 0.1, 0.5, 0.3))
        self.assertEqual(twist, ((1, -0.5, 0.1), (0, 0, 0.3)))
        self.assertEqual(ros.world_twist(*twist), Velocity(1, 0.1, 0.5, 0.3))
        self.assertEqual(ros.command("r", (1, 0.5, 0), (0, 0, 0.3)), robosim.command("r", forward=1, right=-0.5, turn=0.3))
        with self.assertRaisesRegex(ValueError, r"angular must have Z alone.*\(got: \[0.1, 0.0, 0.3\]\)"):
            ros.command("r", (1, 0, 0), (0.1, 0, 0.3))
        with self.assertRaisesRegex(ValueError, r"drives do not fly \(got: \[0, 0, 1\]\)"):
            ros.command("r", [0, 0, 1], (0, 0, 0))

    def test_forces_and_boxes(self):
        ros = Frame.ros(9, 9)
        self.assertEqual(ros.wrench((1, 2, 3), (4, 5, 6)), ((1, -3, 2), (4, -6, 5)))
        self.assertEqual(ros.world_wrench((1, -3, 2), (4, -6, 5)), ((1, 2, 3), (4, 5, 6)))
        self.assertEqual(ros.box(4.5, 1.4, 1.8), (4.5, 1.8, 1.4))  # of a car: length, width, height
        self.assertEqual(ros.world_box(4.5, 1.8, 1.4), (4.5, 1.4, 1.8))

    def test_round_trips(self):
        rng = random.Random(42)
        for _ in range(2000):
            ros = Frame.ros(rng.uniform(-9, 9), rng.uniform(-9, 9))
            turn = product(about("y", rng.uniform(-4, 4)), product(about("x", rng.uniform(-4, 4)), about("z", rng.uniform(-4, 4))))
            pose = Pose([rng.uniform(-9, 9) for _ in range(3)], turn, math.atan2(-turn[6], turn[0]))
            there = ros.pose(pose)
            self.assertGreaterEqual(there.orientation[3], 0)
            back = ros.world_pose(*there)
            self.near(back.center, pose.center)
            self.near(back.rotation, turn)
            self.assertAlmostEqual(math.sin(back.heading - pose.heading), 0, 9)
            # A point of the object is in ROS where ROS's own rotation puts it.
            own = [rng.uniform(-1, 1) for _ in range(3)]
            placed = [pose.center[row] + sum(turn[3 * row + k] * own[k] for k in range(3)) for row in range(3)]
            self.near(ros.point(placed), rotated(there.orientation, ros.vector(own), there.position))

    def test_rotations_of_eight_digits(self):
        ros = Frame.ros()
        rng = random.Random(8)
        loose = 0
        for _ in range(500):
            exact = ros.world_rotation(unit([rng.gauss(0, 1) for _ in range(4)]))
            quaternion = [round(number, 8) for number in ros.quaternion(exact)]
            nine = [round(number, 8) for number in exact]
            self.near(ros.world_rotation(renormalised(quaternion)), exact, 7)
            self.near(ros.quaternion(renormalised(nine)), ros.quaternion(exact), 7)
            kept = renormalised(nine)
            self.near(product(kept, [kept[k] for k in (0, 3, 6, 1, 4, 7, 2, 5, 8)]), UPRIGHT)
            try:
                ros.quaternion(nine)
            except ValueError as e:
                self.assertIn("robosim.renormalised", str(e))
                loose += 1
        self.assertGreater(loose, 400)
        self.assertEqual(renormalised((0, 0, 0, 1)), [0, 0, 0, 1])

    def test_what_is_no_rotation_is_refused(self):
        ros = Frame.ros()
        mirror = [1.0, 0, 0, 0, 1, 0, 0, 0, -1]
        for call in (lambda: renormalised((0, 0, 0, 0)), lambda: renormalised((0, 0, 0.5, 0.5)), lambda: renormalised(mirror),
                     lambda: ros.quaternion(mirror), lambda: ros.world_rotation((1, 1, 1, 1)), lambda: renormalised([0] * 5),
                     lambda: ros.quaternion([0] * 9), lambda: ros.world_rotation((0, 0, math.nan, 1)), lambda: ros.point((1, 2)),
                     lambda: Frame.ros(math.inf)):
            with self.assertRaisesRegex(ValueError, r"\(got: .+\)"):
                call()


def unit(numbers):
    size = math.hypot(*numbers)
    return [number / size for number in numbers]


def rotated(quaternion, vector, offset):
    """offset + q v q*, by Hamilton's product."""
    def times(a, b):
        ax, ay, az, aw = a
        bx, by, bz, bw = b
        return (aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx,
                aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz)

    x, y, z, w = quaternion
    turned = times(times((x, y, z, w), (*vector, 0.0)), (-x, -y, -z, w))
    return [a + b for a, b in zip(turned, offset)]


class Importers(unittest.TestCase):
    """The module itself puts SDFormat and maps of ROS where `Frame.ros()` does."""

    @classmethod
    def setUpClass(cls):
        cls.world = robosim.launch()
        cls.folder = tempfile.TemporaryDirectory()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()
        cls.world.close()

    def load(self, **files):
        for name, content in files.items():
            pathlib.Path(self.folder.name, name.replace("_", ".")).write_text(content)
        return self.world.load(str(pathlib.Path(self.folder.name, next(iter(files)).replace("_", "."))))

    def test_sdformat(self):
        ros = Frame.ros()
        roll, pitch, yaw = 0.3, -0.4, 1.1
        pose = f"1.5 -2.5 3 {roll} {pitch} {yaw}"
        model = ('<model name="m"><pose>{}</pose><link name="l"><collision name="c"><geometry><box><size>0.5 0.25 0.125</size></box>'
                 "</geometry></collision></link></model>").format(pose)
        self.load(a_sdf=f'<sdf version="1.9"><world name="w">{model}</world></sdf>')
        read = self.world.pose("m")
        # REP 103: fixed axes, about X, then Y, then Z.
        turn = product(about("z", yaw), product(about("y", pitch), about("x", roll)))
        quaternion = robosim.coordinates._quaternion_of(turn)
        told = ros.world_pose((1.5, -2.5, 3), quaternion)
        for got, expected in ((told.center, read.center), (told.rotation, read.rotation), ([told.heading], [read.heading]),
                              (ros.pose(read).orientation, quaternion)):
            for a, b in zip(got, expected):
                self.assertAlmostEqual(a, b, 12)
        # Upright, the box along the axes has the sizes that it was given.
        self.world.init([box([0, 0, 0], *ros.world_box(0.5, 0.25, 0.125), name="b", moveable=True)])
        listed = self.world.objects()[0]
        self.assertEqual((listed.low, listed.high), ([-0.25, -0.0625, -0.125], [0.25, 0.0625, 0.125]))

    def test_maps_of_ros(self):
        # One wall of 3 x 2 cells, at the image's lower right corner but one column; the corner of the image is at (2, -1).
        rows = ["254 254 254 254", "254 254 0 254", "254 254 254 254"]
        self.load(m_yaml="image: m.pgm\nresolution: 0.5\norigin: [2.0, -1.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\n"
                         "free_thresh: 0.196\n", m_pgm="P2\n4 3\n255\n" + "\n".join(rows) + "\n")
        self.assertTrue(self.world.add(cylinder(Frame.ros().world_point((2.25, -0.25, 0.2)), 0.1, 0.1, name="r", moveable=True)))
        self.assertAlmostEqual(self.world.sonar("r"), 0.75, 12)  # the wall is from x = 3 to 3.5, y = -0.5 to 0

    def test_commands_drive_where_ros_means(self):
        ros = Frame.ros(5, 4)
        self.world.init([cylinder([0, 0, 0], 0.25, 1, name="r", moveable=True)], width=20, length=20)
        omni = robosim.body("r", mass=5, drive="omnidirectional")
        after = self.world.step(1, [omni], [ros.command("r", (0.5, 0.25, 0), (0, 0, 0))]).bodies["r"]
        for got, expected in ((ros.point(after.center), (5.5, 4.25, 0)), (ros.twist(after.velocity).linear, (0.5, 0.25, 0))):
            for a, b in zip(got, expected):
                self.assertAlmostEqual(a, b, 9)
        after = self.world.step(1, [], [ros.command("r", (0, 0, 0), (0, 0, 0.5))]).bodies["r"]
        self.assertAlmostEqual(after.heading, 0.5, 9)


if __name__ == "__main__":
    unittest.main()
