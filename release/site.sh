#!/usr/bin/env bash
# The documents and the javadoc as one static site in target/site, which any web server can serve. Every link is followed.
set -euo pipefail
cd "$(dirname "$0")/.."

mvn="mvn -B -ntp -q ${MVN_OPTIONS:-}"
owner=$(sed -n 's:.*<github.owner>\(.*\)</github.owner>.*:\1:p' pom.xml)
rm -rf target/site
$mvn -DskipTests compile javadoc:javadoc
$mvn -f release/site test exec:java \
  -Dexec.args="$PWD $PWD/target/site $PWD/target/reports/apidocs https://github.com/$owner/robosim-geometry/tree/main/"
