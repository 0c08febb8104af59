#!/usr/bin/env bash
# A dry run of a release: builds what is committed twice in folders of its own, signs it with a key that is thrown away,
# deploys it to a local folder, and checks what is there. Nothing is sent. Needs git, gpg and python3 besides what the build needs.
set -euo pipefail
cd "$(dirname "$0")/.."

work=$(mktemp -d)
trap 'gpgconf --kill all 2>/dev/null || true; rm -rf "$work"' EXIT
export GNUPGHOME="$work/gpg"
mkdir -m 700 "$GNUPGHOME"
gpg --batch --quiet --passphrase '' --quick-generate-key 'dry run <nobody@example.invalid>' rsa3072 sign 1d

# At two places with names of different lengths, and in two time zones. Rights of files come into the jars, so both have one mask.
build() {
  umask 022
  mkdir -p "$1"
  git archive HEAD | tar -x -C "$1"
  (
    cd "$1"
    export TZ="$2"
    mvn -B -ntp -q deploy -Prelease -DskipTests -Dmaven.install.skip=true \
      -DaltDeploymentRepository="dry-run::file:$1/target/repository"
  )
}
build "$work/one" UTC
build "$work/another/place" Asia/Kathmandu

python3 release/check.py "$work/one" "$work/another/place"
