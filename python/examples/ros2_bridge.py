#!/usr/bin/env python3
"""A robot of the geometry module as a robot of ROS 2: publishes /scan, /odom, /tf and /clock, obeys /cmd_vel.

    pip install ./python                      # in the project's folder, after mvn -q package -DskipTests
    source /opt/ros/jazzy/setup.bash
    python3 python/examples/ros2_bridge.py worlds/rooms.xml --robot "cart 1"
    ros2 topic pub /cmd_vel geometry_msgs/msg/Twist '{linear: {x: 0.3}, angular: {z: 0.2}}'

It needs rclpy and the messages of ROS 2. The frame `odom` is the world in the axes of ROS: X as in the world, Y along its -Z,
Z up; `base_link` is below the robot's centre at the height of its lowest point, and `laser` is fixed to it. Simulated time
begins at 0 and is published on /clock: set `use_sim_time` in the nodes that listen.
"""

import argparse
import math
import time

import robosim
from robosim import Frame, fan

SILENCE = 0.5  # seconds of simulated time after which a robot that gets no command stops


class Robot:
    """One robot of a world: a differential drive that carries a laser."""

    def __init__(self, world, name, *, beams=360, reach=12.0, laser_height=0.0, frame=None):
        self.world = world
        self.name = name
        self.frame = frame if frame is not None else Frame.ros()
        self.reach = reach
        self.pattern = fan(-math.pi, 2 * math.pi / beams, beams)
        self.laser_height = laser_height  # above the robot's centre
        listed = {each.name: each for each in world.objects()}
        if name not in listed or not listed[name].moveable:
            robots = ", ".join(each.name for each in listed.values() if each.moveable) or "none"
            raise SystemExit(f"--robot must be a moveable object: {robots} (got: {name})")
        self.rise = listed[name].center[1] - listed[name].low[1]
        self.seconds = 0.0
        self.commanded = -math.inf
        answer = world.step(0, [robosim.body(name, drive="differential")])
        if answer.refused:
            raise SystemExit(f"{name} cannot be driven: {answer.refused[0]}")
        self.body = answer.bodies[name]

    def command(self, forward, turn):
        """What /cmd_vel has: m/s ahead, and radians a second to the left."""
        self.commanded = self.seconds
        self.world.drive(self.name, forward, turn)

    def step(self, seconds):
        """Lets time pass and measures: returns the laser's distances."""
        if self.commanded > -math.inf and self.seconds - self.commanded > SILENCE:
            self.world.drive(self.name, 0, 0)
            self.commanded = -math.inf
        self.body = self.world.step(seconds).bodies[self.name]
        self.seconds += seconds
        return self.world.sense(self.name, self.pattern, at=(0, self.laser_height, 0), max=self.reach)

    def pose(self):
        """Where base_link is in `odom`: X, Y, Z and the yaw."""
        x, y, z = self.frame.point(self.body.center)
        return x, y, z - self.rise, self.body.heading

    def twist(self):
        """Velocities in base_link."""
        return self.frame.twist(self.body.velocity)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("world", help="a world, or HOST:PORT of a server that has one already")
    parser.add_argument("--robot", required=True, help="the name of a moveable object")
    parser.add_argument("--rate", type=float, default=20.0, help="steps a second (default: 20)")
    parser.add_argument("--beams", type=int, default=360, help="beams of the laser (default: 360)")
    parser.add_argument("--reach", type=float, default=12.0, help="metres that the laser reaches (default: 12)")
    parser.add_argument("--fast", action="store_true", help="as fast as possible instead of in real time")
    options = parser.parse_args()

    try:
        import rclpy
    except ImportError:
        raise SystemExit("rclpy is missing; install ROS 2 and source its setup.bash: https://docs.ros.org") from None
    rclpy.init()
    is_address = options.world.rpartition(":")[2].isdigit()
    opening = robosim.connect(options.world) if is_address else robosim.launch(options.world)
    with opening as world:
        robot = Robot(world, options.robot, beams=options.beams, reach=options.reach)
        bridge = Bridge(rclpy, robot)
        begun = time.monotonic()
        try:
            while rclpy.ok():
                bridge.tick(1 / options.rate)
                rclpy.spin_once(bridge.node, timeout_sec=0)
                ahead = robot.seconds - (time.monotonic() - begun)
                if ahead > 0 and not options.fast:
                    time.sleep(ahead)
        except KeyboardInterrupt:
            pass


class Bridge:
    """The topics of a robot."""

    def __init__(self, rclpy, robot):
        from geometry_msgs.msg import TransformStamped, Twist
        from nav_msgs.msg import Odometry
        from rosgraph_msgs.msg import Clock
        from sensor_msgs.msg import LaserScan
        from tf2_msgs.msg import TFMessage

        self.messages = {"tf": TFMessage, "transform": TransformStamped, "odom": Odometry, "clock": Clock, "scan": LaserScan}
        self.robot = robot
        self.node = rclpy.create_node("robosim")
        self.topics = {name: self.node.create_publisher(self.messages[name], "/" + name, 10)
                       for name in ("clock", "tf", "odom", "scan")}
        self.node.create_subscription(Twist, "/cmd_vel", lambda twist: robot.command(twist.linear.x, twist.angular.z), 10)

    def tick(self, seconds):
        """A step, and what was measured after it."""
        scan = self.robot.step(seconds)
        clock = self.messages["clock"]()
        self._stamp(clock.clock)
        self.topics["clock"].publish(clock)
        x, y, z, yaw = self.robot.pose()
        laser = self.robot.rise + self.robot.laser_height
        self.topics["tf"].publish(self.messages["tf"](transforms=[
            self._transform("odom", "base_link", (x, y, z), yaw),
            self._transform("base_link", "laser", (0.0, 0.0, laser), 0.0)]))
        self.topics["odom"].publish(self._odometry((x, y, z), yaw))
        self.topics["scan"].publish(self._scan(scan))

    def _stamp(self, stamp):
        nanoseconds = round(self.robot.seconds * 1e9)
        stamp.sec, stamp.nanosec = divmod(nanoseconds, 1_000_000_000)

    def _transform(self, parent, child, place, yaw):
        message = self.messages["transform"]()
        self._stamp(message.header.stamp)
        message.header.frame_id, message.child_frame_id = parent, child
        _set(message.transform.translation, place)
        _turn(message.transform.rotation, yaw)
        return message

    def _odometry(self, place, yaw):
        message = self.messages["odom"]()
        self._stamp(message.header.stamp)
        message.header.frame_id, message.child_frame_id = "odom", "base_link"
        _set(message.pose.pose.position, place)
        _turn(message.pose.pose.orientation, yaw)
        linear, angular = self.robot.twist()
        _set(message.twist.twist.linear, linear)
        _set(message.twist.twist.angular, angular)
        return message

    def _scan(self, scan):
        message = self.messages["scan"]()
        self._stamp(message.header.stamp)
        message.header.frame_id = "laser"
        first, step, count = (scan.pattern[field] for field in ("first", "step", "count"))
        message.angle_min, message.angle_max, message.angle_increment = first, first + (count - 1) * step, step
        message.range_min, message.range_max = 0.0, self.robot.reach
        message.ranges = list(scan)
        return message


def _set(vector, numbers):
    vector.x, vector.y, vector.z = map(float, numbers)


def _turn(quaternion, yaw):
    quaternion.x = quaternion.y = 0.0
    quaternion.z, quaternion.w = math.sin(yaw / 2), math.cos(yaw / 2)


if __name__ == "__main__":
    main()
