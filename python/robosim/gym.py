"""Environments for Gymnasium: robots that learn to reach a goal, to follow a wall or to push a crate.

    import gymnasium
    import robosim.gym

    env = gymnasium.make("robosim/Reach-v0")
    many = robosim.gym.RobosimVectorEnv("reach", 64)

`pip install "./python[gym]"` installs what this needs: gymnasium and numpy. All worlds of a vector are copies in one process of
the geometry module, which a message for each of its processors steps and measures together. An episode depends on its seed and
its actions alone, to the bit: not on the number of environments, on the machine or on earlier episodes.
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


class _Seen(NamedTuple):
    """What was measured in several worlds: an array each, with a row for each world."""

    robot: Any  # X, Y, Z, heading, velocity forward, up and right, speed of turning
    crate: Any  # the same; None without a crate
    touches: Any  # contacts of the robot, but with the crate
    scans: List[Any]  # distances of each sensor


class _Judge:
    """Observations, rewards and ends of episodes, for several worlds at a time."""

    def __init__(self, task: str, options: Options, count: int) -> None:
        self.task = task
        self.options = options
        self.goals = numpy.zeros((count, 3))
        self.left = numpy.zeros(count)  # what was still to go before a step

    def begin(self, index: int, goal: Optional[Sequence[float]]) -> None:
        if goal is not None:
            self.goals[index] = goal

    def observed(self, seen: _Seen) -> Dict[str, Any]:
        options, robot, found = self.options, seen.robot, {}
        x, z, heading = robot[:, 0], robot[:, 2], robot[:, 3]
        if "laser" in options.observe:
            found["laser"] = seen.scans[0]
        if "camera" in options.observe:
            found["camera"] = seen.scans[-1].reshape(-1, options.camera[1], options.camera[0])
        if "pose" in options.observe:
            found["pose"] = numpy.stack((x, z, numpy.cos(heading), numpy.sin(heading)), 1).astype("float32")
        if "velocity" in options.observe:
            found["velocity"] = robot[:, (4, 6, 7)].astype("float32")
        if "goal" in options.observe:
            away, toward = numpy.zeros(len(x)), numpy.zeros(len(x))
            if self.task != "follow_wall":
                away = numpy.hypot(self.goals[:, 0] - x, self.goals[:, 2] - z)
                toward = numpy.arctan2(z - self.goals[:, 2], self.goals[:, 0] - x) - heading
            found["goal"] = numpy.stack((away, numpy.cos(toward), numpy.sin(toward)), 1).astype("float32")
        return {name: found[name] for name in options.observe}

    def judged(self, seen: _Seen, begun: Any) -> Tuple[Any, Any]:
        """Rewards, and which episodes are over; of those that have just begun neither."""
        options, robot = self.options, seen.robot
        touches = seen.touches > 0
        if self.task == "follow_wall":
            scan = seen.scans[0]
            right = scan[:, : max(1, scan.shape[1] // 2)].min(1).astype("float64")  # beams count from the right to the left
            rewards = robot[:, 4] * options.seconds * numpy.exp(-abs(right - options.distance) / 0.3) - 1.0 * touches
            over = touches
        else:
            body = seen.crate if self.task == "push" else robot
            left = numpy.hypot(self.goals[:, 0] - body[:, 0], self.goals[:, 2] - body[:, 2])
            over = left < _NEAR
            rewards = (self.left - left) - 0.01 + _TOUCH * touches + 10.0 * over
            self.left = left
        return numpy.where(begun, 0.0, rewards), over & ~begun


class _Episodes:
    """One world and its robot, on a connection of its own: begins episodes and carries out their steps."""

    def __init__(self, task: str, options: Options, server: Server) -> None:
        self.task = task
        self.options = options
        self.generator = numpy.random.default_rng()
        self.judge = _Judge(task, options, 1)
        self._module = server.connect()
        self._line = _Line(self._module)
        self._opening = self._made(options, task)
        self.senses = self._sensed(options)
        self._sensors = _bytes({"type": "batch", "requests": self.senses}) if self.senses else b""
        self._head = f'{{"type":"step","seconds":{options.seconds!r},"bodies":[],"commands":[{{"objectName":{json.dumps(options.robot)}'
        self.has_right = options.drive in ("omnidirectional", "velocity", "force")
        self.width = 3 if self.has_right else 2
        self.actions: List[List[float]] = []
        self.start: Json = {}
        self.steps = 0

    @staticmethod
    def _made(options: Options, task: str) -> Json:
        world = options.world
        if world is None:
            world = arena(task == "push")
        if isinstance(world, (str, os.PathLike)):
            file, files = _with_its_files(os.fspath(world))
            return {"type": "load", "file": file, "files": files, "named": True}
        return {"type": "init", "objects": list(world), "answer": True}

    def _sensed(self, options: Options) -> List[Json]:
        """The requests that measure after each step."""
        requests = []
        if "laser" in options.observe or self.task == "follow_wall":
            step = options.field / max(options.beams - 1, 1)
            requests.append(sense(options.robot, fan(-options.field / 2, step, options.beams), max=options.reach))
        if "camera" in options.observe:
            requests.append(sense(options.robot, pinhole(*options.camera, options.camera_field), max=options.reach))
        return requests

    def seed(self, seed: Optional[int]) -> None:
        if seed is not None:
            self.generator = numpy.random.default_rng(seed)

    def prepare(self, start: Optional[Json] = None) -> bytes:
        """Makes the world of an episode at a drawn place, or at one given; returns the step that gives it its bodies."""
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
        return _bytes({"type": "step", "seconds": 0, "bodies": bodies, "commands": []})

    def begin(self, start: Optional[Json] = None) -> Dict[str, Any]:
        """Begins an episode at a drawn place, or at one given; returns the first observation."""
        self._line.send(self.prepare(start) + self._sensors)
        self.actions = []
        self.steps = 0
        return self._finish(True)[0]

    def copy(self, index: int) -> Json:
        """Begins an episode in a copy of the world; returns how it begins."""
        self._line.send(self.prepare() + _bytes({"type": "batch", "requests": [{"kind": "copy", "index": index}]}))
        self._line.receive("bodies")
        _answer(self._line)
        return self.start

    def lane(self) -> _Line:
        return self._line

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
        observation = self._finish(True)[0]
        for action in checkpoint.actions:
            self.act(action)
            observation = self.finish()[0]
        self.generator.bit_generator.state = checkpoint.seed_state
        return observation

    def checked(self, action: Sequence[float]) -> List[float]:
        """An action as shares from -1 to 1, or why it is none."""
        numbers = [float(share) for share in action]
        if len(numbers) != self.width or not all(map(math.isfinite, numbers)):
            raise ValueError(f"an action must have {self.width} finite numbers from -1 to 1 (got: {numbers})")
        return [min(1.0, max(-1.0, number)) for number in numbers]

    def act(self, shares: List[float]) -> None:
        """Sends a step; `finish` waits for it."""
        self.actions.append(shares)
        options = self.options
        right = shares[1] * options.max_speed if self.has_right else 0.0
        forward, turn = shares[0] * options.max_speed, shares[-1] * options.max_turn
        # By hand, as every step of every world sends one: the repr of a number is its JSON.
        told = f'{self._head},"forward":{forward!r},"right":{right!r},"turnRadians":{turn!r}}}]}}\n'
        self._line.send(told.encode() + self._sensors)

    def finish(self) -> Tuple[Dict[str, Any], float, bool, bool, Json]:
        """The observation, the reward, whether the episode is over or cut off, and what else is known."""
        self.steps += 1
        observation, reward, is_over, info = self._finish(False)
        return observation, reward, is_over, self.steps >= self.options.horizon, info

    def _finish(self, begun: bool) -> Tuple[Dict[str, Any], float, bool, Json]:
        options = self.options
        answer = self._line.receive("bodies")
        sensed = self._line.receive("answers")["answers"] if self._sensors else []
        bodies = {each["objectName"]: each for each in answer["bodies"]}
        contacts = [each.get("other") if each["objectName"] == options.robot else each["objectName"]
                    for each in answer["contacts"]
                    if options.robot in (each["objectName"], each.get("other")) and each["phase"] != "END"]
        touches = [other for other in contacts if other != options.crate or self.task != "push"]
        seen = _Seen(_state(bodies[options.robot]), _state(bodies[options.crate]) if self.task == "push" else None,
                     numpy.array([len(touches)]), [_distances(each, options.reach)[None] for each in sensed])
        goal = self.start.get("goal")
        self.judge.begin(0, goal)
        rewards, over = self.judge.judged(seen, numpy.array([begun]))
        robot = bodies[options.robot]
        info: Json = {"center": robot["center"], "heading": robot["heading"], "contacts": contacts}
        if goal is not None:
            info["goal"] = goal
        return {name: each[0] for name, each in self.judge.observed(seen).items()}, float(rewards[0]), bool(over[0]), info

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
        return spaces.Box(-1.0, 1.0, (self.width,), numpy.float32)

    def plan(self) -> Any:
        """The world from above, as an image."""
        return self._module.plan(320).array()

    def close(self) -> None:
        self._module.close()


def _state(body: Json) -> Any:
    velocity = body["velocity"]
    return numpy.array([[*body["center"], body["heading"], velocity["x"], velocity["y"], velocity["z"], velocity["ry"]]])


def _distances(answer: Json, reach: float) -> Any:
    if "distances" not in answer:
        raise RequestError(str(answer.get("error", answer)))
    distances = numpy.frombuffer(base64.b64decode(answer["distances"]), "<f8").astype("float32")
    return numpy.minimum(distances, numpy.float32(reach), out=distances)  # where nothing echoes


def _answer(line: _Line) -> Json:
    """The answer to a batch of one request."""
    answer: Json = line.receive("answers")["answers"][0]
    if "error" in answer:
        raise RequestError(answer["error"])
    return answer


class _Lane:
    """A connection with copies of a world, one for each of some environments."""

    def __init__(self, task: str, options: Options, server: Server, indexes: Any) -> None:
        self.indexes = indexes  # of the environments, from the first to the last
        self.episodes = _Episodes(task, options, server)
        self._options = options
        self._bodies = [options.robot] + ([options.crate] if task == "push" else [])
        senses = self.episodes.senses
        tick = {"kind": "tick", "objectName": options.robot, "bodies": self._bodies, "senses": senses, "single": True,
                "commands": "@"}
        self._head, self._tail = _bytes({"type": "batch", "requests": [tick]}).split(b"@")
        patterns = [each["pattern"] for each in senses]
        self._sizes = [each.get("count") or each["width"] * each["height"] for each in patterns]

    def send(self, commands: Any) -> None:
        own = numpy.ascontiguousarray(commands[self.indexes], "<f8")
        self.episodes.lane().send(self._head + base64.b64encode(own.tobytes()) + self._tail)

    def receive(self) -> _Seen:
        answer = _answer(self.episodes.lane())
        count = len(self.indexes)
        states = numpy.frombuffer(base64.b64decode(answer["states"]), "<f8").reshape(count, len(self._bodies), 8)
        touches = numpy.frombuffer(base64.b64decode(answer["touches"]), "<i4").reshape(count, len(self._bodies))
        scans = numpy.frombuffer(base64.b64decode(answer.get("singles", "")), "<f4").reshape(count, -1)
        scans = numpy.minimum(scans, numpy.float32(self._options.reach))  # where nothing echoes
        return _Seen(states[:, 0], states[:, -1], touches[:, 0], numpy.split(scans, numpy.cumsum(self._sizes)[:-1], 1))


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
        self._task = task
        self._options = checked
        count = min(num_envs, os.cpu_count() or 1)
        self._own = None if server is not None else serve(connections=count)
        used = server or self._own
        self._lanes = [_Lane(task, checked, used, indexes)  # type: ignore[arg-type]
                       for indexes in numpy.array_split(numpy.arange(num_envs), count)]
        one = self._lanes[0].episodes
        self._width, self._has_right = one.width, one.has_right
        self.single_observation_space = one.observations()
        self.single_action_space = one.action_space()
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._judge = _Judge(task, checked, num_envs)
        self._generators = [numpy.random.default_rng() for _ in range(num_envs)]
        self._steps = numpy.zeros(num_envs, int)
        self._over = numpy.zeros(num_envs, bool)

    def reset(self, *, seed: Union[int, Sequence[Optional[int]], None] = None, options: Optional[Json] = None) -> Tuple[Any, Json]:
        seeds = [None if seed is None else seed + k for k in range(self.num_envs)] if not isinstance(seed, Sequence) else seed
        for k, own in enumerate(seeds):
            if own is not None:
                self._generators[k] = numpy.random.default_rng(own)
        self._over[:] = True
        return self._stepped(numpy.zeros((self.num_envs, self._width)))[0], {}

    def step(self, actions: Any) -> Tuple[Any, Any, Any, Any, Json]:
        if len(actions) != self.num_envs:
            raise ValueError(f"there must be one action for each of {self.num_envs} environments (got: {len(actions)})")
        shares = numpy.asarray(actions, "float64")
        if shares.shape != (self.num_envs, self._width) or not numpy.isfinite(shares).all():
            raise ValueError(f"an action must have {self._width} finite numbers from -1 to 1 (got: {shares.tolist()})")
        return (*self._stepped(numpy.clip(shares, -1.0, 1.0)), {})

    def _stepped(self, shares: Any) -> Tuple[Any, Any, Any, Any]:
        """Begins the episodes that are due, and lets the others go on."""
        options, begun = self._options, self._over.copy()
        for lane in self._lanes:
            for index in lane.indexes[begun[lane.indexes]]:
                self._begin(lane, index)
        commands = numpy.zeros((self.num_envs, 4))
        commands[:, 0] = numpy.where(begun, 0.0, options.seconds)
        commands[:, 1] = shares[:, 0] * options.max_speed
        commands[:, 2] = shares[:, 1] * options.max_speed if self._has_right else 0.0
        commands[:, 3] = shares[:, -1] * options.max_turn
        seen = self._seen(commands)
        rewards, over = self._judge.judged(seen, begun)
        self._steps = numpy.where(begun, 0, self._steps + 1)
        late = self._steps >= options.horizon
        self._over = over | late
        return self._judge.observed(seen), rewards, over, late

    def _begin(self, lane: _Lane, index: int) -> None:
        lane.episodes.generator = self._generators[index]
        self._judge.begin(index, lane.episodes.copy(int(index - lane.indexes[0])).get("goal"))

    def _seen(self, commands: Any) -> _Seen:
        for lane in self._lanes:
            lane.send(commands)
        parts = [lane.receive() for lane in self._lanes]
        if len(parts) == 1:
            return parts[0]
        robot, crate, touches = (numpy.concatenate([part[field] for part in parts]) for field in range(3))
        return _Seen(robot, crate, touches, [numpy.concatenate(each) for each in zip(*(part.scans for part in parts))])

    def begin(self, index: int) -> Json:
        """Begins another episode in one environment at once; returns its observation."""
        lane = next(lane for lane in self._lanes if index in lane.indexes)
        self._begin(lane, index)
        seen = self._seen(numpy.zeros((self.num_envs, 4)))
        self._judge.judged(seen, numpy.ones(self.num_envs, bool))
        self._steps[index] = 0
        self._over[index] = False
        return {name: each[index] for name, each in self._judge.observed(seen).items()}

    def close_extras(self, **_: Any) -> None:
        for lane in self._lanes:
            lane.episodes.close()
        if self._own is not None:
            self._own.close()


for _task, _name in zip(TASKS, ("Reach", "FollowWall", "Push")):
    _id = f"robosim/{_name}-v0"
    if _id not in gymnasium.registry:
        gymnasium.register(id=_id, entry_point="robosim.gym:RobosimEnv", kwargs={"task": _task})
