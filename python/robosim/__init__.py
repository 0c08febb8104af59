"""The geometry module from Python: collisions, swept moves, lasers, sonars, cameras and dynamics.

    import robosim
    from robosim import box, cylinder

    with robosim.launch([box([3, 0, 0], 0.2, 2, 4, name="wall"),
                         cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)]) as world:
        print(world.move("robot", x=5).obstacle)    # wall
        print(world.scan("robot", count=360)[0])    # 2.9 ahead
        world.plan().save("plan.png")

`launch` starts a module for this program alone; `connect` and `accept` use one that runs already. `Frame.ros` converts to and
from the axes of ROS. The guide is docs/guide-python.md.
"""

from .client import *  # noqa: F403
from .client import __all__ as _client
from .coordinates import Frame, Pose2D, RosPose, Twist, Wrench, renormalised
from .launching import Launched, Server, find_jar, find_java, launch, serve

__all__ = [*_client, "launch", "Launched", "serve", "Server", "find_java", "find_jar", "Frame", "RosPose", "Pose2D", "Twist", "Wrench", "renormalised"]
