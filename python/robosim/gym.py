"""Environments for Gymnasium: robots that learn to reach a goal, to follow a wall or to push a crate.

    import gymnasium
    import robosim.gym

    env = gymnasium.make("robosim/Reach-v0")
    many = robosim.gym.RobosimVectorEnv("reach", 64)

`pip install "./python[gym]"` installs what this needs: gymnasium and numpy. All worlds of a vector are in one process of the
geometry module, each with a connection of its own; a tick sends all actions before it waits for the first answer. An episode depends on its
seed and its actions alone, to the bit: not on the number of environments, on the machine or on earlier episodes.
"""

import base64
import json
import math
import os
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

import gymnasium
import numpy
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space

from .client import (Json, Module, NotDone, ProtocolFault, RequestError, _with_its_files, body, box, cylinder, drive_settings,
                     fan, pinhole, sense)
from .launching import Server, serve

TASKS = ("reach", "follow_wall", "push")
OBSERVATIONS = ("laser", "camera", "pose", "velocity", "goal")

_CANDIDATES = 64  # places that are tried at once for a robot or a goal
_NEAR = 0.4  # metres from a goal, it is reached
_TOUCH = -0.2  # reward of a step in contact


class Options(NamedTuple):
    """What an environment is made of; all lengths in world units, all angles in radians.

    `world` is a world file, or objects as `robosim.box` and the like make them; None for a walled arena of 8 x 8 with pillars.
    `robot` is the name of its robot, and `crate` that of what is pushed. `observe` names what an observation contains:
    "laser" (distances of `beams` beams over `field`), "camera" (a depth frame of `camera` pixels), "pose" (X, Z and the cosine
    and sine of the heading), "velocity" (forward, right, turn) and "goal" (distance and direction as cosine and sine in the
    robot's own frame). An action has numbers from -1 to 1: shares of `max_speed` and `max_turn`; a drive that is
    "omnidirectional" takes forward, right and turn, "ackermann" forward and steering, others forward and turn. `seconds` is the
    time of a step, and an episode is cut off after `horizon` steps.
    """

    world: Union[str, "os.PathLike[str]", Sequence[Json], None] = None
    robot: str = "robot"
    crate: str = "crate"
    observe: Tuple[str, ...] = ("laser", "velocity", "goal")
    beams: int = 271
    field: float = math.radians(270)
    reach: float = 8.0
    camera: Tuple[int, int] = (32, 24)
    camera_field: float = math.radians(80)
    drive: str = "differential"
    max_speed: float = 1.0
    max_turn: float = 2.0
    seconds: float = 0.1
    horizon: int = 300
    distance: float = 0.8  # from a wall that is followed


class Checkpoint(NamedTuple):
    """An episode so far: where it began, and all actions. `restore` repeats them, and has the same bits."""

    start: Json
    actions: List[List[float]]
    seed_state: Json


def arena(crate: bool = False) -> List[Json]:
    """The default world: 8 x 8 with walls, four pillars and a robot; a crate on request."""
    objects = [box([0, 0.25, z], 8.4, 0.5, 0.2, name=name) for name, z in (("north", -4.1), ("south", 4.1))]
    objects += [box([x, 0.25, 0], 0.2, 0.5, 8, name=name) for name, x in (("west", -4.1), ("east", 4.1))]
    objects += [cylinder([x, 0.25, z], 0.3, 0.5, name=f"pillar {number}")
                for number, (x, z) in enumerate(((-1.6, -1.4), (1.8, -1.7), (-1.9, 1.8), (1.5, 1.6)))]
    objects.append(cylinder([0, 0.25, 0], 0.2, 0.5, name="robot", moveable=True))
    if crate:
        objects.append(box([0, 0.25, 0.8], 0.4, 0.5, 0.4, name="crate", moveable=True))
    return objects


class _Line:
    """A connection's socket, used for prepared lines: what a tick sends and receives, without the checks of single calls."""

    def __init__(self, module: Module) -> None:
        self._sock = module._sock
        self._rest = b""

    def send(self, lines: bytes) -> None:
        self._sock.sendall(lines)

    def receive(self, kind: str) -> Json:
        """The next answer."""
        end = self._rest.find(b"\n")
        while end < 0:
            got = self._sock.recv(1 << 17)
            if not got:
                raise NotDone("the module ended the conversation; see its log")
            begun = len(self._rest)
            self._rest += got
            end = self._rest.find(b"\n", begun)
        line, self._rest = self._rest[:end], self._rest[end + 1:]
        answer = json.loads(line)
        if answer.get("type") == "error":
            raise RequestError(answer["message"])
        if answer.get("type") != kind:
            raise ProtocolFault(f"the answer must be {kind} (got: {answer.get('type')})")
        return answer


def _bytes(message: Json) -> bytes:
    return json.dumps(message, allow_nan=False, separators=(",", ":")).encode() + b"\n"


class _Episodes:
    """One world and its robot: begins episodes, and carries out their steps in two halves, so that many can be under way."""

    def __init__(self, task: str, options: Options, server: Server) -> None:
        self.task = task
        self.options = options
        self.generator = numpy.random.default_rng()
        self._module = server.connect()
        self._line = _Line(self._module)
        self._opening = self._made(options, task)
        self._sensors = self._sensed(options)
        self._head = f'{{"type":"step","seconds":{options.seconds!r},"bodies":[],"commands":[{{"objectName":{json.dumps(options.robot)}'
        self._has_right = options.drive in ("omnidirectional", "velocity", "force")
        self._width = 3 if self._has_right else 2
        self.actions: List[List[float]] = []
        self.start: Json = {}
        self.steps = 0
        self._left = 0.0

    @staticmethod
    def _made(options: Options, task: str) -> Json:
        world = options.world
        if world is None:
            world = arena(task == "push")
        if isinstance(world, (str, os.PathLike)):
            file, files = _with_its_files(os.fspath(world))
            return {"type": "load", "file": file, "files": files, "named": True}
        return {"type": "init", "objects": list(world), "answer": True}

    def _sensed(self, options: Options) -> bytes:
        """The request that measures after each step."""
        requests = []
        if "laser" in options.observe or self.task == "follow_wall":
            step = options.field / max(options.beams - 1, 1)
            requests.append(sense(options.robot, fan(-options.field / 2, step, options.beams), max=options.reach))
        if "camera" in options.observe:
            requests.append(sense(options.robot, pinhole(*options.camera, options.camera_field), max=options.reach))
        return _bytes({"type": "batch", "requests": requests}) if requests else b""

    def seed(self, seed: Optional[int]) -> None:
        if seed is not None:
            self.generator = numpy.random.default_rng(seed)

    def begin(self, start: Optional[Json] = None) -> Dict[str, Any]:
        """Begins an episode at a drawn place, or at one given; returns the first observation."""
        options = self.options
        self._module.ask(self._opening, "answers")
        self._objects = {each.name: each for each in self._module.objects()}
        for name in (options.robot, *((options.crate,) if self.task == "push" else ())):
            if name not in self._objects or not self._objects[name].moveable:
                known = ", ".join(name for name, each in self._objects.items() if each.moveable) or "none"
                raise ValueError(f"the world must have a moveable object \"{name}\" (got: {known})")
        self.start = self._drawn() if start is None else start
        bodies = [body(options.robot, drive=self._drive(), velocity=(0, 0, 0, 0))]
        if self.task == "push":
            bodies.append(body(options.crate, mass=5, floor_friction=0.4, velocity=(0, 0, 0, 0)))
        self._line.send(_bytes({"type": "step", "seconds": 0, "bodies": bodies, "commands": []}) + self._sensors)
        self.actions = []
        self.steps = 0
        return self._finish()[0]

    def _drive(self) -> Json:
        options = self.options
        limits = {} if options.drive in ("velocity", "force") else {"max_speed": options.max_speed, "max_acceleration": 4.0}
        return drive_settings(options.drive, **limits)

    def _drawn(self) -> Json:
        """Places the crate, then the robot, and draws a goal."""
        start: Json = {}
        robot = self.options.robot
        if self.task == "push":
            start[self.options.crate] = self._put(self.options.crate, margin=0.9)
        start[robot] = self._put(robot)
        goal = None
        if self.task != "follow_wall":
            about = start[self.options.crate if self.task == "push" else robot]["center"]
            free = self._free(robot, margin=0.5)
            far = [place for place in free if math.hypot(place[0] - about[0], place[2] - about[2]) > 1.5]
            goal = (far or free)[0][:3]
        start["goal"] = goal
        return start

    def _free(self, name: str, margin: float = 0.0) -> List[List[float]]:
        """Free places of an object, drawn at random within the world's walls."""
        low = numpy.min([each.low for each in self._objects.values()], axis=0)
        high = numpy.max([each.high for each in self._objects.values()], axis=0)
        y = self._objects[name].center[1]
        for _ in range(100):
            numbers = self.generator.uniform((low[0] + margin, y, low[2] + margin, -math.pi),
                                             (high[0] - margin, y, high[2] - margin, math.pi), (_CANDIDATES, 4))
            numbers[:, 1] = y
            free = numpy.array(self._module.free_poses(name, numbers.ravel()))
            if free.any():
                return numbers[free].tolist()
        raise NotDone(f"no free place was found for \"{name}\" in 100 draws of {_CANDIDATES}; is the world full?")

    def _put(self, name: str, margin: float = 0.0) -> Json:
        for place in self._free(name, margin):
            put = {"center": place[:3], "heading": place[3]}
            self._place(name, put)
            return put
        raise NotDone(f"no place for \"{name}\"")

    def _place(self, name: str, put: Json) -> None:
        if not self._module.place(name, put["center"], put["heading"]):
            raise NotDone(f"\"{name}\" could not be placed at {put['center']}")

    def restore(self, checkpoint: Checkpoint) -> Dict[str, Any]:
        """Begins the episode of a checkpoint again and repeats its steps."""
        observation = self.begin({})
        for name in (self.options.crate, self.options.robot):
            if name in checkpoint.start:
                self._place(name, checkpoint.start[name])
        self.start = checkpoint.start
        self._line.send(_bytes({"type": "step", "seconds": 0, "bodies": [], "commands": []}) + self._sensors)
        observation = self._finish()[0]
        for action in checkpoint.actions:
            self.act(action)
            observation = self.finish()[0]
        self.generator.bit_generator.state = checkpoint.seed_state
        return observation

    def checked(self, action: Sequence[float]) -> List[float]:
        """An action as shares from -1 to 1, or why it is none."""
        numbers = [float(share) for share in action]
        if len(numbers) != self._width or not all(map(math.isfinite, numbers)):
            raise ValueError(f"an action must have {self._width} finite numbers from -1 to 1 (got: {numbers})")
        return [min(1.0, max(-1.0, number)) for number in numbers]

    def act(self, shares: List[float]) -> None:
        """Sends a step; `finish` waits for it."""
        self.actions.append(shares)
        options = self.options
        right = shares[1] * options.max_speed if self._has_right else 0.0
        forward, turn = shares[0] * options.max_speed, shares[-1] * options.max_turn
        # By hand, as every step of every world sends one: the repr of a number is its JSON.
        told = f'{self._head},"forward":{forward!r},"right":{right!r},"turnRadians":{turn!r}}}]}}\n'
        self._line.send(told.encode() + self._sensors)

    def finish(self) -> Tuple[Dict[str, Any], float, bool, bool, Json]:
        """The observation, the reward, whether the episode is over or cut off, and what else is known."""
        self.steps += 1
        observation, reward, is_over, info = self._finish()
        return observation, reward, is_over, self.steps >= self.options.horizon, info

    def _finish(self) -> Tuple[Dict[str, Any], float, bool, Json]:
        options = self.options
        answer = self._line.receive("bodies")
        sensed = self._line.receive("answers")["answers"] if self._sensors else []
        bodies = {each["objectName"]: each for each in answer["bodies"]}
        robot = bodies[options.robot]
        contacts = [each.get("other") if each["objectName"] == options.robot else each["objectName"]
                    for each in answer["contacts"]
                    if options.robot in (each["objectName"], each.get("other")) and each["phase"] != "END"]
        x, _, z = robot["center"]
        heading = robot["heading"]
        scans = [_distances(each, options.reach) for each in sensed]
        observation: Dict[str, Any] = {}
        if "laser" in options.observe:
            observation["laser"] = scans[0]
        if "camera" in options.observe:
            observation["camera"] = scans[-1].reshape(options.camera[1], options.camera[0])
        if "pose" in options.observe:
            observation["pose"] = numpy.array((x, z, math.cos(heading), math.sin(heading)), "float32")
        if "velocity" in options.observe:
            velocity = robot["velocity"]
            observation["velocity"] = numpy.array((velocity["x"], velocity["z"], velocity["ry"]), "float32")
        info: Json = {"center": robot["center"], "heading": heading, "contacts": contacts}
        goal = self.start.get("goal")
        away = 0.0
        if goal is not None:
            away = math.hypot(goal[0] - x, goal[2] - z)
            toward = math.atan2(z - goal[2], goal[0] - x) - heading
            info["goal"] = goal
        if "goal" in options.observe:
            observation["goal"] = numpy.array((away, math.cos(toward), math.sin(toward)) if goal is not None else (0, 1, 0),
                                              "float32")
        reward, is_over = self._judged(bodies, away, scans, contacts)
        return observation, reward, is_over, info

    def _judged(self, bodies: Json, away: float, scans: List[Any], contacts: List[Any]) -> Tuple[float, bool]:
        """The reward of a step and whether the episode is over."""
        options = self.options
        if self.task == "follow_wall":
            scan = scans[0]
            right = float(scan[: len(scan) // 2].min())  # beams count from the right to the left
            forward = bodies[options.robot]["velocity"]["x"] * options.seconds
            reward = forward * math.exp(-abs(right - options.distance) / 0.3)
            return (reward - 1.0, True) if contacts else (reward, False)
        touches = [other for other in contacts if other != options.crate or self.task != "push"]
        if self.task == "push":
            crate = bodies[options.crate]["center"]
            goal = self.start.get("goal") or crate
            left = math.hypot(goal[0] - crate[0], goal[2] - crate[2])
        else:
            left = away
        before = self._left if self.steps > 0 else left
        self._left = left
        is_there = left < _NEAR and self.start.get("goal") is not None
        reward = (before - left) - 0.01 + (_TOUCH if touches else 0.0) + (10.0 if is_there else 0.0)
        return reward, is_there

    def checkpoint(self) -> Checkpoint:
        return Checkpoint(self.start, [list(action) for action in self.actions],
                          dict(self.generator.bit_generator.state))

    def observations(self) -> spaces.Dict:
        options = self.options
        far, fast = 1e4, 1e2  # beyond what any episode reaches
        kinds = {
            "laser": spaces.Box(0.0, options.reach, (options.beams,), numpy.float32),
            "camera": spaces.Box(0.0, options.reach, (options.camera[1], options.camera[0]), numpy.float32),
            "pose": spaces.Box(numpy.array((-far, -far, -1, -1), "float32"), numpy.array((far, far, 1, 1), "float32")),
            "velocity": spaces.Box(-fast, fast, (3,), numpy.float32),
            "goal": spaces.Box(numpy.array((0, -1, -1), "float32"), numpy.array((far, 1, 1), "float32")),
        }
        return spaces.Dict({name: kinds[name] for name in options.observe})

    def action_space(self) -> spaces.Box:
        return spaces.Box(-1.0, 1.0, (self._width,), numpy.float32)

    def plan(self) -> Any:
        """The world from above, as an image."""
        return self._module.plan(320).array()

    def close(self) -> None:
        self._module.close()


def _distances(answer: Json, reach: float) -> Any:
    if "distances" not in answer:
        raise RequestError(str(answer.get("error", answer)))
    distances = numpy.frombuffer(base64.b64decode(answer["distances"]), "<f8").astype("float32")
    return numpy.minimum(distances, numpy.float32(reach), out=distances)  # where nothing echoes


def _checked(task: str, given: Json) -> Options:
    if task not in TASKS:
        raise ValueError(f"task must be one of {', '.join(TASKS)} (got: {task})")
    options = Options(**given)
    wrong = [name for name in options.observe if name not in OBSERVATIONS]
    if wrong or not options.observe:
        raise ValueError(f"observe must name some of {', '.join(OBSERVATIONS)} (got: {', '.join(options.observe) or 'none'})")
    return options


class RobosimEnv(gymnasium.Env):
    """One environment; its `checkpoint` and `restore` repeat an episode from its start, to the bit.

    `options` are the fields of `Options`. The geometry module runs as a process of its own, unless a `server` is given,
    as `robosim.serve` starts one."""

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(self, task: str = "reach", *, server: Optional[Server] = None, render_mode: Optional[str] = None,
                 **options: Any) -> None:
        checked = _checked(task, options)
        self._own = None if server is not None else serve(connections=1)
        self.render_mode = render_mode
        self._episodes = _Episodes(task, checked, server or self._own)  # type: ignore[arg-type]
        self.observation_space = self._episodes.observations()
        self.action_space = self._episodes.action_space()

    def reset(self, *, seed: Optional[int] = None, options: Optional[Json] = None) -> Tuple[Any, Json]:
        super().reset(seed=seed)
        self._episodes.seed(seed)
        return self._episodes.begin(), {}

    def step(self, action: Any) -> Tuple[Any, float, bool, bool, Json]:
        self._episodes.act(self._episodes.checked(action))
        return self._episodes.finish()

    def checkpoint(self) -> Checkpoint:
        """The episode so far."""
        return self._episodes.checkpoint()

    def restore(self, checkpoint: Checkpoint) -> Any:
        """Goes back to a checkpoint of this or of an equal environment; returns its observation."""
        return self._episodes.restore(checkpoint)

    def render(self) -> Any:
        return self._episodes.plan() if self.render_mode == "rgb_array" else None

    def close(self) -> None:
        self._episodes.close()
        if self._own is not None:
            self._own.close()


class RobosimVectorEnv(VectorEnv):
    """Many environments in one process of the geometry module. An environment whose episode is over begins another in the
    next step, as Gymnasium's vectors do by default."""

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, task: str = "reach", num_envs: int = 8, *, server: Optional[Server] = None, **options: Any) -> None:
        checked = _checked(task, options)
        if num_envs < 1:
            raise ValueError(f"num_envs must be at least 1 (got: {num_envs})")
        self.num_envs = num_envs
        self._own = None if server is not None else serve(connections=num_envs)
        used = server or self._own
        self._all = [_Episodes(task, checked, used) for _ in range(num_envs)]  # type: ignore[arg-type]
        self.single_observation_space = self._all[0].observations()
        self.single_action_space = self._all[0].action_space()
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._over = numpy.zeros(num_envs, bool)

    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None, options: Optional[Json] = None) -> Tuple[Any, Json]:
        seeds = [None if seed is None else seed + k for k in range(self.num_envs)] if not isinstance(seed, Sequence) else seed
        for each, own in zip(self._all, seeds):
            each.seed(own)
        self._over[:] = False
        return self._together([each.begin() for each in self._all]), {}

    def step(self, actions: Any) -> Tuple[Any, Any, Any, Any, Json]:
        if len(actions) != self.num_envs:
            raise ValueError(f"there must be one action for each of {self.num_envs} environments (got: {len(actions)})")
        checked = [each.checked(action) for each, action in zip(self._all, actions)]  # before any is sent
        for each, over, shares in zip(self._all, self._over, checked):
            if not over:
                each.act(shares)
        rewards = numpy.zeros(self.num_envs)
        terminated = numpy.zeros(self.num_envs, bool)
        truncated = numpy.zeros(self.num_envs, bool)
        observations = []
        for k, (each, over) in enumerate(zip(self._all, self._over)):
            if over:
                observations.append(each.begin())
            else:
                observation, rewards[k], terminated[k], truncated[k], _ = each.finish()
                observations.append(observation)
        self._over = terminated | truncated
        return self._together(observations), rewards, terminated, truncated, {}

    def begin(self, index: int) -> Json:
        """Begins another episode in one environment at once; returns its observation."""
        self._over[index] = False
        return self._all[index].begin()

    def _together(self, observations: List[Json]) -> Json:
        return {name: numpy.stack([each[name] for each in observations]) for name in observations[0]}

    def close_extras(self, **_: Any) -> None:
        for each in self._all:
            each.close()
        if self._own is not None:
            self._own.close()


for _task, _name in zip(TASKS, ("Reach", "FollowWall", "Push")):
    _id = f"robosim/{_name}-v0"
    if _id not in gymnasium.registry:
        gymnasium.register(id=_id, entry_point="robosim.gym:RobosimEnv", kwargs={"task": _task})
