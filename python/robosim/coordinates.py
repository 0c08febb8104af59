"""Points, poses, velocities, forces and sizes in the axes of ROS, without ROS and without any other package.

ROS has X forward, Y left and Z up (REP 103), the module X forward, Y up and Z to the right: (x, y, z) of ROS is (x, z, -y)
of the module, as where it imports SDFormat and maps of ROS. Both are right-handed, so angles keep their sign: a yaw is a
heading. Lengths are world units in both, which ROS takes for metres; angles are in radians; quaternions are x, y, z, w.
"""

import math
from typing import List, NamedTuple, Sequence, Tuple

from .client import Json, Pose, Velocity, command

Vector3 = Tuple[float, float, float]
Quaternion = Tuple[float, float, float, float]

_LOOSE = 1e-9  # what a rotation may lack to a unit quaternion or to three unit vectors at right angles, as in the module
_ROUNDED = 1e-6  # what rounding to eight digits, or to floats of 32 bits, leaves


class RosPose(NamedTuple):
    """geometry_msgs/Pose: metres, and a unit quaternion x, y, z, w."""

    position: Vector3
    orientation: Quaternion


class Pose2D(NamedTuple):
    """A place on the floor: metres, and radians counter-clockwise from X."""

    x: float
    y: float
    theta: float


class Twist(NamedTuple):
    """geometry_msgs/Twist: metres a second, and radians a second."""

    linear: Vector3
    angular: Vector3


class Wrench(NamedTuple):
    """geometry_msgs/Wrench: newtons, and newton metres."""

    force: Vector3
    torque: Vector3


def _numbers(what: str, given: Sequence[float], count: int) -> List[float]:
    numbers = [float(number) for number in given]
    if len(numbers) != count or not all(map(math.isfinite, numbers)):
        raise ValueError(f"{what} must be {count} finite numbers (got: {list(given)})")
    return numbers


def _flaw(numbers: Sequence[float]) -> float:
    """How far four numbers are from a unit quaternion, or nine from three unit vectors at right angles, right-handed."""
    if len(numbers) == 4:
        return abs(math.hypot(*numbers) - 1)
    x, y, z = (numbers[0::3], numbers[1::3], numbers[2::3])
    cross = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
    return max(abs(math.hypot(*x) - 1), abs(math.hypot(*y) - 1), abs(sum(a * b for a, b in zip(x, y))),
               *(abs(a - b) for a, b in zip(cross, z)))


def _rotation_of(q: Sequence[float]) -> List[float]:
    """Nine numbers, row by row, of a quaternion of any length but zero."""
    x, y, z, w = q
    n = x * x + y * y + z * z + w * w
    return [(w * w + x * x - y * y - z * z) / n, 2 * (x * y - w * z) / n, 2 * (x * z + w * y) / n,
            2 * (x * y + w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z - w * x) / n,
            2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n]


def _quaternion_of(r: Sequence[float]) -> Quaternion:
    """The unit quaternion of a rotation, with w at least 0; its largest part is found first, so that nothing cancels."""
    squares = [1 + r[0] - r[4] - r[8], 1 - r[0] + r[4] - r[8], 1 - r[0] - r[4] + r[8], 1 + r[0] + r[4] + r[8]]
    largest = squares.index(max(squares))
    sums = {(0, 1): r[1] + r[3], (0, 2): r[2] + r[6], (1, 2): r[5] + r[7],
            (0, 3): r[7] - r[5], (1, 3): r[2] - r[6], (2, 3): r[3] - r[1]}
    parts = [squares[k] if k == largest else sums[min(k, largest), max(k, largest)] for k in range(4)]
    size = math.copysign(math.hypot(*parts), parts[3] if parts[3] != 0 else 1.0)
    x, y, z, w = (part / size + 0.0 for part in parts)  # + 0.0: no zero is negative
    return x, y, z, w


def renormalised(rotation: Sequence[float]) -> List[float]:
    """A rotation that was rounded, to eight digits or to floats of 32 bits, made a rotation again: a quaternion x, y, z, w,
    or nine numbers as the module has them, row by row. One that is further than 1e-6 from a rotation is none, and a
    ValueError says so."""
    if len(rotation) not in (4, 9):
        raise ValueError(f"a rotation must be a quaternion or nine numbers (got: {list(rotation)})")
    numbers = _numbers("a rotation", rotation, len(rotation))
    if _flaw(numbers) > _ROUNDED:
        raise ValueError(f"a rotation must be within {_ROUNDED} of a unit quaternion, or of unit axes at right angles"
                         f" (got: {numbers})")
    if len(numbers) == 9:
        return _rotation_of(_quaternion_of(numbers))
    size = math.hypot(*numbers)
    return [number / size for number in numbers]


def _rotation(what: str, given: Sequence[float], count: int) -> List[float]:
    numbers = _numbers(what, given, count)
    if _flaw(numbers) > _LOOSE:
        raise ValueError(f"{what} must be a rotation to within {_LOOSE}; pass one of fewer digits through robosim.renormalised"
                         f" (got: {numbers})")
    return numbers


class Frame:
    """Another system of coordinates over the world; `Frame.ros` makes one.

    Methods named after a quantity give it in this frame; those that begin with `world_` are their inverses. A rotation of the
    module is nine numbers, row by row, whose columns are the object's own axes; one or the other need not be known to use
    `pose` and `world_pose`."""

    def __init__(self, origin_x: float, origin_y: float) -> None:
        self._origin = _numbers("the origin", (origin_x, origin_y), 2)

    @staticmethod
    def ros(origin_x: float = 0.0, origin_y: float = 0.0) -> "Frame":
        """The frame of ROS in which the world's origin, its centre, lies at (origin_x, origin_y, 0). A room of 10 x 8 metres
        whose corner is ROS's origin is `Frame.ros(5, 4)`; worlds imported from SDFormat or a map of ROS have the origin of
        their file, and are `Frame.ros()`."""
        return Frame(origin_x, origin_y)

    def vector(self, direction: Sequence[float]) -> Vector3:
        """A direction, or a velocity, force, angular velocity or torque: axes are exchanged, the origin does not matter."""
        x, y, z = _numbers("a vector", direction, 3)
        return x, 0.0 - z, y

    def world_vector(self, direction: Sequence[float]) -> Vector3:
        """The inverse of `vector`."""
        x, y, z = _numbers("a vector", direction, 3)
        return x, z, 0.0 - y

    def point(self, point: Sequence[float]) -> Vector3:
        """A place."""
        x, y, z = self.vector(point)
        return x + self._origin[0], y + self._origin[1], z

    def world_point(self, point: Sequence[float]) -> Vector3:
        """The inverse of `point`."""
        x, y, z = _numbers("a point", point, 3)
        return self.world_vector((x - self._origin[0], y - self._origin[1], z))

    def quaternion(self, rotation: Sequence[float]) -> Quaternion:
        """x, y, z and w, of which w is at least 0, of a rotation of the module, such as `Pose.rotation`."""
        x, y, z, w = _quaternion_of(_rotation("a rotation", rotation, 9))
        return x, 0.0 - z, y, w

    def world_rotation(self, quaternion: Sequence[float]) -> List[float]:
        """The inverse of `quaternion`: what objects take as `rotation=`."""
        x, y, z, w = _rotation("a quaternion", quaternion, 4)
        return _rotation_of((x, z, 0.0 - y, w))

    def pose(self, pose: Pose) -> RosPose:
        """The pose of an object."""
        return RosPose(self.point(pose.center), self.quaternion(pose.rotation))

    def world_pose(self, position: Sequence[float], orientation: Sequence[float]) -> Pose:
        """The inverse of `pose`; the heading is where forward points, seen from above."""
        rotation = self.world_rotation(orientation)
        return Pose(list(self.world_point(position)), rotation, math.atan2(0.0 - rotation[6], rotation[0]))

    def pose_2d(self, pose: Pose) -> Pose2D:
        """Where on the floor an object is; its height and its tilt are left out."""
        x, y, _ = self.point(pose.center)
        return Pose2D(x, y, pose.heading)

    def world_pose_2d(self, x: float, y: float, theta: float, height: float = 0.0) -> Tuple[Vector3, float]:
        """The inverse of `pose_2d`: the centre at a height and the heading, as `Module.place` takes them."""
        return self.world_point((x, y, height)), _numbers("theta", (theta,), 1)[0]

    def twist(self, velocity: Velocity) -> Twist:
        """The velocity of a body along its own axes, as odometry has it in its child frame."""
        return Twist(self.vector(velocity[:3]), (0.0, 0.0, velocity.ry))

    def world_twist(self, linear: Sequence[float], angular: Sequence[float]) -> Velocity:
        """The inverse of `twist`. A body turns about its own Y alone; a twist about another axis is refused."""
        about = _numbers("angular", angular, 3)
        if about[0] != 0 or about[1] != 0:
            raise ValueError(f"angular must have Z alone, since robots turn about the vertical (got: {about})")
        return Velocity(*self.world_vector(linear), about[2])

    def command(self, name: str, linear: Sequence[float], angular: Sequence[float]) -> Json:
        """What /cmd_vel says, as a command for `Module.step`; a robot does not fly, and one with a `force` drive takes a wrench
        in the same way: newtons, and newton metres."""
        ahead, up, right, turn = self.world_twist(linear, angular)
        if up != 0:
            raise ValueError(f"linear must not have a Z, since drives do not fly (got: {list(linear)})")
        return command(name, ahead, turn, right)

    def wrench(self, force: Sequence[float], torque: Sequence[float]) -> Wrench:
        """A force and a torque."""
        return Wrench(self.vector(force), self.vector(torque))

    def world_wrench(self, force: Sequence[float], torque: Sequence[float]) -> Wrench:
        """The inverse of `wrench`."""
        return Wrench(self.world_vector(force), self.world_vector(torque))

    def box(self, width: float, height: float, length: float) -> Vector3:
        """A box's length along X, width along Y and height along Z, of its width, height and length as `box` takes them: the
        module's width lies along X, which is the length of a vehicle."""
        x, y, z = _numbers("a box", (width, height, length), 3)
        return x, z, y

    def world_box(self, length: float, width: float, height: float) -> Vector3:
        """The inverse of `box`: width, height and length for `box`."""
        x, y, z = _numbers("a box", (length, width, height), 3)
        return x, z, y
