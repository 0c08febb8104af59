"""The environments for Gymnasium, where gymnasium and numpy are installed."""

import math
import pathlib
import subprocess
import sys
import time
import unittest

import robosim

try:
    import gymnasium
    import numpy
    from gymnasium.utils.env_checker import check_env

    import robosim.gym as gym
except ImportError as e:
    raise unittest.SkipTest(f"{e.name} is not installed")

ROOMS = pathlib.Path(__file__).resolve().parents[2] / "worlds" / "rooms.xml"


def actions(count, seed=0, width=2):
    return numpy.random.default_rng(seed).uniform(-1, 1, (count, width))


class Environments(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = robosim.serve()

    @classmethod
    def tearDownClass(cls):
        cls.server.close()

    def env(self, task="reach", **options):
        env = gym.RobosimEnv(task, server=self.server, **options)
        self.addCleanup(env.close)
        return env

    def vector(self, task, count, **options):
        many = gym.RobosimVectorEnv(task, count, server=self.server, **options)
        self.addCleanup(many.close)
        return many

    def assert_same(self, a, b):
        self.assertEqual(set(a), set(b))
        for name in a:
            self.assertEqual(a[name].tobytes(), b[name].tobytes(), name)

    def test_gymnasium_s_own_checks(self):
        for task in gym.TASKS:
            with self.subTest(task):
                check_env(self.env(task, observe=gym.OBSERVATIONS), skip_render_check=True)
        check_env(self.env(drive="omnidirectional"), skip_render_check=True)

    def test_an_episode_depends_on_its_seed_and_actions_alone(self):
        for task in gym.TASKS:
            one = self.env(task)
            many = self.vector(task, 3)
            first, _ = one.reset(seed=8)
            all_first, _ = many.reset(seed=7)  # of which the second has the seed 8
            self.assert_same(first, {name: each[1] for name, each in all_first.items()})
            moved = 0
            for action in actions(40):
                seen, reward, over, _, _ = one.step(action)
                all_seen, rewards, overs, _, _ = many.step(numpy.array([-action, action, action]))
                if over:
                    break
                moved += 1
                self.assert_same(seen, {name: each[1] for name, each in all_seen.items()})
                self.assertEqual(reward, rewards[1])
            self.assertGreater(moved, 3, task)

    def test_a_second_episode_is_as_if_it_were_the_first(self):
        used, fresh = self.env("push"), self.env("push")
        used.reset(seed=1)
        for action in actions(60):
            used.step(action)
        self.assert_same(used.reset(seed=5)[0], fresh.reset(seed=5)[0])
        for action in actions(30, seed=2):
            (a, _, _, _, known), (b, _, _, _, other) = used.step(action), fresh.step(action)
            self.assert_same(a, b)
            self.assertEqual(known["center"], other["center"])

    def test_a_checkpoint_goes_on_as_if_nothing_had_happened(self):
        env = self.env("push")
        env.reset(seed=3)
        for action in actions(15):
            seen = env.step(action)[0]
        kept = env.checkpoint()
        after = [env.step(action) for action in actions(20, seed=4)]
        following = env.reset()[0]
        self.assert_same(env.restore(kept), seen)
        for action, (observation, reward, *_) in zip(actions(20, seed=4), after):
            again = env.step(action)
            self.assert_same(again[0], observation)
            self.assertEqual(again[1], reward)
        self.assert_same(env.reset()[0], following)  # what is drawn next is kept too

    def test_reaching_a_goal_ends_an_episode_with_a_reward(self):
        env = self.env(observe=("goal",), horizon=400)
        reached = 0
        for seed in range(6):
            seen = env.reset(seed=seed)[0]["goal"]
            is_over = is_late = False
            while not (is_over or is_late):
                turn = math.atan2(seen[2], seen[1])
                seen, reward, is_over, is_late, _ = env.step([1.0 if abs(turn) < 0.5 else 0.0, max(-1, min(1, turn))])
                seen = seen["goal"]
            if is_over:
                reached += 1
                self.assertGreater(reward, 9)
                self.assertLess(seen[0], 0.4)
        self.assertGreater(reached, 1)  # pillars are in the way of some

    def test_what_an_observation_contains(self):
        env = self.env(observe=gym.OBSERVATIONS, beams=5, field=math.pi)
        seen, _ = env.reset(seed=2)
        _, _, _, _, known = env.step([0, 0])
        seen, _, _, _, known = env.step([0, 0])
        x, z, cosine, sine = seen["pose"]
        self.assertAlmostEqual(x, known["center"][0], 5)
        self.assertAlmostEqual(z, known["center"][2], 5)
        self.assertAlmostEqual(math.atan2(sine, cosine), known["heading"], 5)
        away, ahead, left = seen["goal"]
        goal = known["goal"]
        self.assertAlmostEqual(away, math.hypot(goal[0] - x, goal[2] - z), 4)
        heading = known["heading"]
        self.assertAlmostEqual(x + away * (ahead * math.cos(heading) - left * math.sin(heading)), goal[0], 3)
        self.assertAlmostEqual(z - away * (ahead * math.sin(heading) + left * math.cos(heading)), goal[2], 3)
        self.assertEqual(seen["laser"].shape, (5,))
        self.assertTrue((seen["laser"] <= 8).all() and (seen["laser"] > 0).all())
        self.assertEqual(seen["camera"].shape, (24, 32))

    def test_vectors_begin_again_by_themselves(self):
        many = self.vector("follow_wall", 2, horizon=5)
        many.reset(seed=1)
        for step in range(1, 14):
            _, rewards, over, late, _ = many.step(numpy.zeros((2, 2)))
            self.assertEqual(late.tolist(), [step % 6 == 5] * 2, step)  # the sixth step is the reset
            if step % 6 == 0:
                self.assertEqual(rewards.tolist(), [0, 0])

    def test_a_world_of_a_file(self):
        env = self.env(world=ROOMS, robot="cart 1", beams=31)
        check_env(env, skip_render_check=True)

    def test_what_is_wrong_is_said(self):
        with self.assertRaisesRegex(ValueError, r"task must be one of reach, follow_wall, push \(got: fly\)"):
            gym.RobosimEnv("fly", server=self.server)
        with self.assertRaisesRegex(ValueError, r"observe must name some of .* \(got: smell\)"):
            gym.RobosimEnv(observe=("smell",), server=self.server)
        with self.assertRaisesRegex(ValueError, r'a moveable object "nobody" \(got: robot\)'):
            self.env(robot="nobody").reset(seed=1)

    def test_a_wrong_action_is_refused_and_changes_nothing(self):
        env = self.env()
        env.reset(seed=1)
        for wrong in ([0.5], [0.5, 0.1, 0.2], [math.nan, 0], [0, math.inf]):
            with self.assertRaisesRegex(ValueError, "an action must have 2 finite numbers"):
                env.step(wrong)
        same = self.env()
        same.reset(seed=1)
        self.assert_same(env.step([0.5, 0.1])[0], same.step([0.5, 0.1])[0])
        many = self.vector("reach", 2)
        many.reset(seed=1)
        with self.assertRaisesRegex(ValueError, r"one action for each of 2 environments \(got: 3\)"):
            many.step(numpy.zeros((3, 2)))
        with self.assertRaisesRegex(ValueError, "an action must have 2 finite numbers"):
            many.step(numpy.array([[0.5, 0.1], [math.nan, 0]]))
        again = self.vector("reach", 2)
        again.reset(seed=1)
        self.assert_same(many.step(numpy.full((2, 2), 0.5))[0], again.step(numpy.full((2, 2), 0.5))[0])

    def test_registered_by_name(self):
        env = gymnasium.make("robosim/Reach-v0", horizon=3)
        env.reset(seed=1)
        self.assertEqual([env.step([0, 0])[3] for _ in range(3)], [False, False, True])
        pid = env.unwrapped._own.pid
        env.close()
        self.assertFalse(pathlib.Path(f"/proc/{pid}").exists() and pathlib.Path("/proc").exists())


class Servers(unittest.TestCase):
    def test_a_server_ends_with_its_program(self):
        program = "import robosim, os; s = robosim.serve(); print(s.pid, s.address, flush=True); os._exit(9)"
        done = subprocess.run([sys.executable, "-c", program], stdout=subprocess.PIPE, cwd=pathlib.Path(__file__).parents[1])
        self.assertEqual(done.returncode, 9)
        address = done.stdout.decode().split()[1]
        for _ in range(100):
            try:
                robosim.connect(address).close()
            except (OSError, robosim.Error):
                return
            time.sleep(0.1)
        self.fail("the server goes on")


if __name__ == "__main__":
    unittest.main()
