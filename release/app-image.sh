#!/usr/bin/env bash
# The application with a Java runtime of its own, for machines without Java: target/app/robosim-geometry/bin/robosim-geometry.
# jlink makes a runtime of the modules that are used, jpackage puts a launcher beside it. Takes the JDK of JAVA_HOME, 17 or
# newer; other arguments go to jpackage, as `--type deb` for a package instead of a folder.
set -euo pipefail
cd "$(dirname "$0")/.."

jdk="${JAVA_HOME:-$(dirname "$(dirname "$(readlink -f "$(command -v javac)")")")}"
jar=$(ls -t target/robosim-geometry-*-app.jar 2>/dev/null | head -n 1 || true)
[ -n "$jar" ] || { echo "There is no application yet: mvn -q package -DskipTests" >&2; exit 2; }
version=$(basename "$jar" -app.jar)
version=${version#robosim-geometry-}

# What the classes name, and what is looked up by name: algorithms of TLS, zip as a file system, charsets, the demo's compiler.
modules="$("$jdk/bin/jdeps" --multi-release 17 --ignore-missing-deps --print-module-deps "$jar"),jdk.crypto.ec,jdk.zipfs,jdk.charsets,jdk.compiler"
rm -rf target/app target/app-input target/app-runtime
"$jdk/bin/jlink" --add-modules "$modules" --strip-java-debug-attributes --no-header-files --no-man-pages --output target/app-runtime
mkdir -p target/app-input
cp "$jar" target/app-input/
"$jdk/bin/jpackage" --type app-image --name robosim-geometry --app-version "${version%%-*}" --input target/app-input \
  --main-jar "$(basename "$jar")" --runtime-image target/app-runtime --dest target/app "$@"

# A launcher that chooses Java's options for each command, and can prepare an archive of classes.
if [ -d target/app/robosim-geometry/lib/runtime ] && [ -x target/app/robosim-geometry/lib/runtime/bin/java ]; then
  cp src/app/robosim-geometry target/app/robosim-geometry/bin/robosim-geometry
fi

# It runs, and without any Java around it.
env -i HOME="$HOME" PATH=/usr/bin:/bin target/app/robosim-geometry/bin/robosim-geometry --version
