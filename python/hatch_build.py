"""Puts the application jar into what is built, and reads the version from Maven's pom.xml."""

import pathlib
import re
from typing import Any, Dict

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

HERE = pathlib.Path(__file__).resolve().parent
BESIDE = HERE / "robosim" / "robosim-geometry-app.jar"  # in a source distribution


def version() -> str:
    """The version of pom.xml as PEP 440 writes it: 1.0.0-rc.1 is 1.0.0rc1."""
    pom = HERE.parent / "pom.xml"
    if not pom.is_file():  # in a source distribution
        return re.search(r"^Version: (.*)$", (HERE / "PKG-INFO").read_text("utf-8"), re.M)[1]
    told = re.search(r"^  <version>(.*)</version>$", pom.read_text("utf-8"), re.M)[1]
    return re.sub(r"-rc\.(\d+)", r"rc\1", told).replace("-SNAPSHOT", ".dev0")


class JarHook(BuildHookInterface):
    """An editable install needs no copy: `launch` finds the jar in target/."""

    def initialize(self, version: str, build_data: Dict[str, Any]) -> None:
        jars = sorted((HERE.parent / "target").glob("robosim-geometry-*-app.jar"), key=lambda jar: jar.stat().st_mtime)
        if jars and not BESIDE.exists() and version != "editable":
            build_data["force_include"][str(jars[-1])] = "robosim/robosim-geometry-app.jar"
        elif not jars and not BESIDE.exists():
            self.app.display_warning("this package has no application jar, which robosim.launch needs; build it with"
                                     " `mvn -q package -DskipTests` in the folder above, then install again")
