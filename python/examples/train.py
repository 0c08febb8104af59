#!/usr/bin/env python3
"""Trains a robot to reach goals among pillars by PPO, and writes what it has learnt.

    pip install "./python[gym]" stable-baselines3     # in the project's folder, after mvn -q package -DskipTests
    python3 python/examples/train.py --steps 300000

All worlds are in one process of the geometry module. Before and after training the share of goals that are reached is printed;
`reach.zip` is the policy.
"""

import argparse
import time

import numpy
import robosim.gym


def vectorised(task, count, **options):
    """A vector of environments with the interface of Stable-Baselines3."""
    from stable_baselines3.common.vec_env import VecEnv

    class Vector(VecEnv):
        def __init__(self):
            self.many = robosim.gym.RobosimVectorEnv(task, count, **options)
            super().__init__(count, self.many.single_observation_space, self.many.single_action_space)
            self.returns = numpy.zeros(count)
            self.lengths = numpy.zeros(count, int)
            self.seen = self.many.reset(seed=0)[0]
            self.actions = None

        def reset(self):
            return self.seen

        def step_async(self, actions):
            self.actions = actions

        def step_wait(self):
            seen, rewards, terminated, truncated, _ = self.many.step(self.actions)
            self.returns += rewards
            self.lengths += 1
            infos = [{} for _ in range(count)]
            over = terminated | truncated
            if over.any():  # the next step of such a world is its reset, which Stable-Baselines3 expects at once
                for k in numpy.flatnonzero(over):
                    infos[k] = {"terminal_observation": {name: each[k].copy() for name, each in seen.items()},
                                "TimeLimit.truncated": bool(truncated[k] and not terminated[k]),
                                "episode": {"r": self.returns[k], "l": int(self.lengths[k]), "t": time.time()}}
                    begun = self.many.begin(k)
                    for name in seen:
                        seen[name][k] = begun[name]
                self.returns[over] = 0
                self.lengths[over] = 0
            self.seen = seen
            return seen, rewards, over, infos

        def close(self):
            self.many.close()

        def get_attr(self, name, indices=None):
            return [getattr(self.many, name, None)] * count

        def set_attr(self, name, value, indices=None):
            raise NotImplementedError(name)

        def env_method(self, name, *arguments, indices=None, **named):
            raise NotImplementedError(name)

        def env_is_wrapped(self, wrapper, indices=None):
            return [False] * count

    return Vector()


def share_reached(policy, episodes, **options):
    """Of so many goals, the share that a policy reaches, by seeds that training does not use."""
    env = robosim.gym.RobosimEnv("reach", **options)
    reached = 0
    for seed in range(episodes):
        seen, _ = env.reset(seed=1_000_000 + seed)
        is_over = is_late = False
        while not (is_over or is_late):
            seen, _, is_over, is_late, _ = env.step(policy(seen))
        reached += is_over
    env.close()
    return reached / episodes


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=300_000, help="steps of all worlds together (default: 300000)")
    parser.add_argument("--worlds", type=int, default=32, help="worlds at a time (default: 32)")
    parser.add_argument("--episodes", type=int, default=50, help="episodes of each trial (default: 50)")
    parser.add_argument("--output", default="reach.zip", help="the policy (default: reach.zip)")
    options = parser.parse_args()
    try:
        from stable_baselines3 import PPO
    except ImportError:
        raise SystemExit("stable-baselines3 is missing: pip install stable-baselines3") from None
    world = {"beams": 31, "horizon": 150}
    many = vectorised("reach", options.worlds, **world)
    model = PPO("MultiInputPolicy", many, n_steps=128, batch_size=512, learning_rate=1e-3, gamma=0.98, ent_coef=0.002, seed=0)
    choose = lambda seen: model.predict(seen, deterministic=True)[0]  # noqa: E731
    print(f"before: {share_reached(choose, options.episodes, **world):.0%} of goals reached", flush=True)
    begun = time.time()
    model.learn(options.steps, progress_bar=False)
    took = time.time() - begun
    print(f"trained in {took:.0f} s, {options.steps / took:.0f} steps a second", flush=True)
    print(f"after: {share_reached(choose, options.episodes, **world):.0%} of goals reached")
    model.save(options.output)
    many.close()


if __name__ == "__main__":
    main()
