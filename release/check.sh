#!/usr/bin/env bash
# A dry run of a release: builds it twice in folders of its own, signs it with a key that is thrown away, and checks what
# would be sent to Maven Central. Nothing is sent. Needs git, gpg, python3, and what the build needs.
set -euo pipefail
cd "$(dirname "$0")/.."

work=$(mktemp -d)
trap 'GNUPGHOME="$work/gpg" gpgconf --kill all 2>/dev/null || true; rm -rf "$work"' EXIT
export GNUPGHOME="$work/gpg"
mkdir -m 700 "$GNUPGHOME"
gpg --batch --quiet --passphrase '' --quick-generate-key 'dry run <nobody@example.invalid>' rsa3072 sign 1d

# What is committed, at two places with names of different lengths, in two time zones and with two masks of rights.
build() {
  mkdir -p "$1"
  git archive HEAD | tar -x -C "$1"
  (cd "$1" && TZ="$2" && export TZ && umask "$3" && mvn -B -ntp -q deploy -Prelease -DskipTests -Dcentral.skip=true)
}
build "$work/one" UTC 022
build "$work/another/place" Asia/Kathmandu 077

python3 release/check.py "$work/one" "$work/another/place"

# A key's signature of each file.
bundle=$(find "$work/one/target/central-staging" "$work/one/target/central-publishing" -name '*.asc' 2>/dev/null | sort)
[ -n "$bundle" ] || { echo "no signature was made" >&2; exit 1; }
for signature in $bundle; do
  gpg --batch --quiet --verify "$signature" "${signature%.asc}" 2>/dev/null || { echo "wrong: $signature" >&2; exit 1; }
done
echo "signatures: $(wc -w <<< "$bundle"), all good"
