"""The bridge to ROS 2, with messages that have ROS's fields and nothing of ROS."""

import importlib.util
import math
import pathlib
import sys
import types
import unittest

import robosim
from robosim import box, cylinder

_FILE = pathlib.Path(__file__).resolve().parents[1] / "examples" / "ros2_bridge.py"
_SPEC = importlib.util.spec_from_file_location("ros2_bridge", _FILE)
ros2_bridge = importlib.util.module_from_spec(_SPEC)
_SPEC.loader.exec_module(ros2_bridge)


class Fields:
    """A message: fields that are messages come into being when they are read."""

    def __init__(self, **given):
        self.__dict__.update(given)

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        made = Fields()
        setattr(self, name, made)
        return made


class Node:
    def __init__(self):
        self.sent = {}
        self.heard = None

    def create_publisher(self, _, topic, __):
        sent = self.sent.setdefault(topic, [])
        return types.SimpleNamespace(publish=sent.append)

    def create_subscription(self, _, topic, hear, __):
        assert topic == "/cmd_vel"
        self.heard = hear


class Bridge(unittest.TestCase):
    def setUp(self):
        for package, names in (("geometry_msgs", ("TransformStamped", "Twist")), ("nav_msgs", ("Odometry",)),
                               ("rosgraph_msgs", ("Clock",)), ("sensor_msgs", ("LaserScan",)), ("tf2_msgs", ("TFMessage",))):
            module = types.ModuleType(package + ".msg")
            for name in names:
                setattr(module, name, Fields)
            sys.modules[package] = types.ModuleType(package)
            sys.modules[package + ".msg"] = module
            self.addCleanup(sys.modules.pop, package)
            self.addCleanup(sys.modules.pop, package + ".msg")
        self.node = Node()
        self.world = robosim.launch([box([3, 0.5, 0], 0.2, 1, 4, name="wall"),
                                     cylinder([0, 0.25, -1], 0.25, 0.5, name="r", moveable=True)], width=20, height=4, length=20)
        self.addCleanup(self.world.close)
        self.robot = ros2_bridge.Robot(self.world, "r", beams=4)
        self.bridge = ros2_bridge.Bridge(types.SimpleNamespace(create_node=lambda _: self.node), self.robot)

    def command(self, forward, turn):
        self.node.heard(Fields(linear=Fields(x=forward), angular=Fields(z=turn)))

    def test_a_robot_that_drives(self):
        self.command(0.5, 0.0)
        for _ in range(4):
            self.bridge.tick(0.05)
        self.assertEqual([(c.clock.sec, c.clock.nanosec) for c in self.node.sent["/clock"]],
                         [(0, 50_000_000), (0, 100_000_000), (0, 150_000_000), (0, 200_000_000)])
        odom = self.node.sent["/odom"][-1]
        self.assertEqual((odom.header.frame_id, odom.child_frame_id), ("odom", "base_link"))
        self.assertAlmostEqual(odom.pose.pose.position.x, 0.1, 9)
        self.assertAlmostEqual(odom.pose.pose.position.y, 1, 9)  # -Z
        self.assertAlmostEqual(odom.pose.pose.position.z, 0, 9)  # on the floor
        self.assertAlmostEqual(odom.twist.twist.linear.x, 0.5, 9)
        scan = self.node.sent["/scan"][-1]
        self.assertEqual((scan.header.frame_id, scan.angle_increment, len(scan.ranges)), ("laser", math.pi / 2, 4))
        self.assertAlmostEqual(scan.ranges[2], 2.8, 9)  # ahead; behind, left and right nothing
        self.assertEqual([scan.ranges[k] for k in (0, 1, 3)], [math.inf] * 3)
        transforms = self.node.sent["/tf"][-1].transforms
        self.assertEqual([(t.header.frame_id, t.child_frame_id) for t in transforms],
                         [("odom", "base_link"), ("base_link", "laser")])
        self.assertAlmostEqual(transforms[1].transform.translation.z, 0.25, 9)

    def test_turns_to_the_left_are_positive(self):
        self.command(0.0, math.pi / 2)
        for _ in range(8):
            self.bridge.tick(0.05)
        rotation = self.node.sent["/odom"][-1].pose.pose.orientation
        self.assertAlmostEqual(2 * math.atan2(rotation.z, rotation.w), 0.2 * math.pi, 9)
        self.assertAlmostEqual(self.node.sent["/odom"][-1].twist.twist.angular.z, math.pi / 2, 9)

    def test_a_robot_without_commands_stops(self):
        self.command(0.5, 0.0)
        for _ in range(30):
            self.bridge.tick(0.05)
        self.assertAlmostEqual(self.node.sent["/odom"][-1].twist.twist.linear.x, 0, 9)
        self.assertLess(self.node.sent["/odom"][-1].pose.pose.position.x, 0.5 * 0.6)

    def test_a_robot_that_is_not_there(self):
        with self.assertRaisesRegex(SystemExit, r"--robot must be a moveable object: r \(got: wall\)"):
            ros2_bridge.Robot(self.world, "wall")


if __name__ == "__main__":
    unittest.main()
