"""What release/check.sh asks of two builds of a release: release/check.py ONE ANOTHER, each a folder with a pom and a target.

Tells each thing that is wrong, and ends with 1 then.
"""

import hashlib
import io
import json
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

KINDS = [".pom", ".jar", "-sources.jar", "-javadoc.jar", "-app.jar", "-cyclonedx.json", "-cyclonedx.xml"]
SUMS = {".md5": hashlib.md5, ".sha1": hashlib.sha1, ".sha256": hashlib.sha256, ".sha512": hashlib.sha512}
INSIDE = {"info.picocli:picocli", "com.fasterxml.jackson.core:jackson-core", "org.snakeyaml:snakeyaml-engine"}
POM = "{http://maven.apache.org/POM/4.0.0}"

wrong = []


def expect(holds, what):
    if not holds:
        wrong.append(what)


def deployed(folder):
    """The version's files in the folder that it was deployed to, by path; not the repository's own lists of versions."""
    root = folder / "target/repository"
    return {file.relative_to(root).as_posix(): file.read_bytes() for file in root.rglob("*")
            if file.is_file() and not file.name.startswith("maven-metadata")}


def check_pom(text):
    """What Maven Central requires of a pom: central.sonatype.org/publish/requirements."""
    root = ElementTree.fromstring(text)
    properties = {p.tag.replace(POM, ""): p.text for p in root.find(POM + "properties")}

    def value(path):
        found = root.find("/".join(POM + step for step in path.split("/")))
        raw = (found.text or "").strip() if found is not None else ""
        return re.sub(r"\$\{([\w.]+)}", lambda m: properties.get(m[1], m[0]), raw.replace("${project.version}", version))

    version = root.findtext(POM + "version")
    group, artifact = value("groupId"), value("artifactId")
    for path in ["name", "description", "url", "licenses/license/name", "licenses/license/url", "developers/developer/name",
                 "scm/connection", "scm/developerConnection", "scm/url"]:
        expect(value(path) and "${" not in value(path), f"pom: {path} is missing or has an unknown property: {value(path)!r}")
    expect(re.fullmatch(r"[a-z0-9.-]+", group), f"groupId: {group}")
    expect(group == "io.github." + properties["github.owner"], f"groupId {group} is not of {properties['github.owner']}")
    expect(re.fullmatch(r"\d+\.\d+\.\d+(-[a-z]+\.\d+)?", version), f"version: {version}")
    expect(value("scm/tag") == "v" + version, f"tag: {value('scm/tag')}")
    for dependency in root.find(POM + "dependencies"):
        name = dependency.findtext(POM + "artifactId")
        hidden = dependency.findtext(POM + "scope") == "test" or dependency.findtext(POM + "optional") == "true"
        expect(hidden, f"pom: who embeds the jar would get {name} with it")
    return group, artifact, version


def check_files(files, base):
    expected = {base + kind for kind in KINDS}
    plain = {name for name in files if not name.endswith((".asc", *SUMS))}
    expect(plain == expected, f"files: {sorted(plain ^ expected)} are missing or too many")
    for name in sorted(plain):
        expect(name + ".asc" in files, f"no signature of {name}")
        for end in [".md5", ".sha1"]:
            expect(name + end in files, f"no {end} of {name}")
    for name, content in files.items():
        for end, digest in SUMS.items():
            if name.endswith(end):
                told = content.decode().split()[0]
                expect(told == digest(files[name[: -len(end)]]).hexdigest(), f"wrong checksum: {name}")


def check_signatures(files):
    count = 0
    with tempfile.TemporaryDirectory() as folder:
        for name in [n for n in files if n.endswith(".asc")]:
            at = Path(folder, "file")
            at.write_bytes(files[name[:-4]])
            at.with_suffix(".asc").write_bytes(files[name])
            verdict = subprocess.run(["gpg", "--batch", "--verify", at.with_suffix(".asc"), at], capture_output=True)
            expect(verdict.returncode == 0, f"wrong signature: {name}: {verdict.stderr.decode()}")
            count += 1
    return count


def check_jars(folder, name):
    def entries(kind):
        with zipfile.ZipFile(folder / "target" / (name + kind)) as file:
            return set(file.namelist())

    jar, sources, pages, app = entries(".jar"), entries("-sources.jar"), entries("-javadoc.jar"), entries("-app.jar")
    expect({"module-info.class", "META-INF/LICENSE"} <= jar, "the jar has no module or no licence")
    expect(not any("/bench/" in e or e.endswith("/GeometryTest.class") for e in jar), "the jar has tests or benchmarks")
    classes = {e for e in jar if e.startswith("robosim/") and e.endswith(".class") and "$" not in e}
    missing = [e for e in classes if e[: -len("class")] + "java" not in sources
               and not any(e.startswith(s[: -len(".java")]) for s in sources if s.endswith(".java"))]
    expect(not missing, f"no sources of {missing[:5]}")
    expect("index.html" in pages and any(e.endswith("robosim/geometry/Geometry.html") for e in pages), "javadoc is missing")
    expect("picocli/CommandLine.class" in app and "META-INF/THIRD-PARTY.txt" in app, "the application lacks a part")
    expect(not any(e.endswith("module-info.class") for e in app), "the application has a module")


def check_bom(text):
    bom = json.loads(text)
    expect(bom["bomFormat"] == "CycloneDX", "not a CycloneDX file")
    parts = {f"{c['group']}:{c['name']}": c for c in bom["components"]}
    expect(INSIDE <= set(parts), f"the bill of materials lacks {INSIDE - set(parts)}")
    for name in INSIDE & set(parts):
        expect(parts[name].get("licenses") and parts[name].get("hashes") and parts[name].get("purl"),
               f"the bill of materials tells too little of {name}")
    return len(parts)


def check_same(one, another):
    for name in sorted(set(one) | set(another)):
        if not name.endswith((".asc", ".asc.md5", ".asc.sha1", ".asc.sha256", ".asc.sha512")):
            expect(one.get(name) == another.get(name), f"two builds differ: {name}{entries(one, another, name)}")


def entries(one, another, name):
    """The first entries of a jar that differ, or nothing."""
    if not name.endswith(".jar") or name not in one or name not in another:
        return ""
    jars = [zipfile.ZipFile(io.BytesIO(files[name])) for files in (one, another)]
    listed = [{i.filename: (i.CRC, i.date_time, i.external_attr >> 16) for i in jar.infolist()} for jar in jars]
    return f": {sorted(e for e in listed[0] if listed[0][e] != listed[1].get(e))[:3]}"


def main():
    here, there = Path(sys.argv[1]), Path(sys.argv[2])
    files, again = deployed(here), deployed(there)
    pom = next(name for name in files if name.endswith(".pom"))
    group, artifact, version = check_pom(files[pom])
    name = f"{artifact}-{version}"
    base = f"{group.replace('.', '/')}/{artifact}/{version}/{name}"
    check_files(files, base)
    signatures = check_signatures(files)
    expect(signatures >= len(KINDS), f"signatures: {signatures}")
    check_jars(here, name)
    parts = check_bom(files.get(base + "-cyclonedx.json", b"{}"))
    check_same(files, again)
    citation = (here / "CITATION.cff").read_text()
    expect(f"\nversion: {version}\n" in citation, "CITATION.cff has another version")
    for fault in wrong:
        print(fault, file=sys.stderr)
    if wrong:
        sys.exit(1)
    print(f"{group}:{artifact}:{version}: {len(files)} files, {signatures} signatures, {parts} components; two builds are the same")


main()
