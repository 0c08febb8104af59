#!/usr/bin/env bash
# release/set.sh version 1.0.0     changes the version
# release/set.sh owner NAME        changes the owner of the group io.github.NAME and of the addresses at github.com
# wherever the project's files name them, except where they tell what was.
set -euo pipefail
cd "$(dirname "$0")/.."

what="${1:-}"
new="${2:-}"
[[ $new =~ ^[A-Za-z0-9][A-Za-z0-9.-]*$ ]] || { sed -n 2,4p "$0" >&2; exit 2; }
files() { git grep -lF -e "$1" -- . ':!CHANGELOG.md' ':!worlds/scenarios' ':!*.scenario.jsonl' ':!docs/report'; }
quoted() { sed 's/[.]/\\./g' <<< "$1"; }

case "$what" in
  version)
    old=$(sed -n 's:^  <version>\(.*\)</version>$:\1:p' pom.xml)
    # Not within another number: 1.0.0 is no part of 11.0.0 or of 1.0.0-rc.1.
    files "$old" | grep -E '(^pom.xml|\.md|\.cff|\.java|examples/.*/pom.xml|Containerfile|jbang-catalog.json)$' | xargs -r \
      perl -pi -e "s/(robosim-geometry[- :]|<(?:robosim\\.)?version>|^version: |NUMBER = \")\\Q$old\\E(?![0-9])/\${1}$new/g"
    ;;
  owner)
    old=$(sed -n 's:.*<github.owner>\(.*\)</github.owner>.*:\1:p' pom.xml)
    q=$(quoted "$old")
    files "$old" | xargs -r sed -i -E \
      -e "s#io\\.github\\.$q#io.github.$new#g" \
      -e "s#github\\.com/$q/#github.com/$new/#g" \
      -e "s#$q\\.github\\.io#$new.github.io#g" \
      -e "s#<github.owner>$q<#<github.owner>$new<#"
    ;;
  *) sed -n 2,4p "$0" >&2; exit 2 ;;
esac
echo "$what: $old -> $new"
git --no-pager diff --stat
