#!/usr/bin/env bash
# Compares the CPU seconds of the commit checked out with those of another: the same command, one thread, run in turns.
#
#   bench/paired.sh BASE [PAIRS [FILE [SAMPLES]]]
#
# Both are built in clones under bench/build; what is not committed is not measured. Runs go A B, B A, A B, … so that what
# drifts on the machine meets both alike. A run's figure is the CPU time of its whole process; PAIRS is 30, FILE
# scenes/sphereflake.yaml and SAMPLES 16 unless told. Printed is the geometric mean of the seconds over those of BASE, and
# its 95 % interval (Student's t).
set -euo pipefail
[ $# -ge 1 ] || { sed -n '4s/# *//p' "$0" >&2; exit 2; }
root=$(cd "$(dirname "$0")/.." && pwd)
base=$(git -C "$root" rev-parse --short "$1^{commit}")
head=$(git -C "$root" rev-parse --short HEAD)
pairs=${2:-30} file=$(realpath "${3:-$root/scenes/sphereflake.yaml}") samples=${4:-16}

work=$root/bench/build/paired

# checkout COMMIT: makes a clone of that commit, once
checkout() {
    [ -d "$work/$1" ] && return
    mkdir -p "$work"
    git clone -q --shared --no-checkout "$root" "$work/$1.new"
    git -C "$work/$1.new" checkout -q --detach "$1"
    mv "$work/$1.new" "$work/$1"
}

# render COMMIT: prints the CPU seconds of one run
render() {
    local TIMEFORMAT='%3U %3S'
    { time "$work/$1/glint" render "$file" --samples "$samples" --threads 1 --format pfm --quiet --out "$work/$1/out" \
        --stats "$work/$1/stats.json" 2>&3; } 2>&1 | awk '{print $1 + $2}'
}

# rays COMMIT: prints how many rays of all kinds its last run traced
rays() {
    awk '/"(camera|reflection|refraction|shadow)"/ { gsub(/[^0-9]/, ""); sum += $0 } END { printf "%d", sum }' "$work/$1/stats.json"
}

exec 3>&2
for commit in "$head" "$base"; do
    checkout "$commit"
    rm -rf "$work/$commit/out" # of another file
    render "$commit" >/dev/null # builds; not counted
done
same=identical
diff -rq "$work/$head/out" "$work/$base/out" >/dev/null || same=different

echo "$(basename "$file"), $samples samples, $pairs pairs: $head against $base," \
    "$("${JAVA_HOME:+$JAVA_HOME/bin/}java" -version 2>&1 | sed -n '1s/"//gp'), $(uname -m)," \
    "$(sed -n 's/^model name.*: *//p' /proc/cpuinfo | head -n 1) x $(nproc)"
echo "rays: $(rays "$head") against $(rays "$base"); images $same"
for i in $(seq "$pairs"); do
    if [ $((i % 2)) = 1 ]; then
        a=$(render "$head") b=$(render "$base")
    else
        b=$(render "$base") a=$(render "$head")
    fi
    echo "$a $b"
done | awk '
    # the quantile 0.975 of Student'\''s t, by its expansion in 1/f (Abramowitz and Stegun, 26.7.5)
    function t(f,  z) {
        z = 1.959964
        return z + (z^3 + z) / (4 * f) + (5 * z^5 + 16 * z^3 + 3 * z) / (96 * f^2) + \
            (3 * z^7 + 19 * z^5 + 17 * z^3 - 15 * z) / (384 * f^3)
    }
    { x = log($1 / $2); n++; sum += x; squares += x * x; a += $1; b += $2 }
    END {
        mean = sum / n
        half = n > 1 ? t(n - 1) * sqrt((squares - n * mean * mean) / (n - 1) / n) : 0
        printf "CPU seconds a run: %.2f against %.2f\n", a / n, b / n
        printf "ratio %.4f, 95 %% interval %.4f to %.4f\n", exp(mean), exp(mean - half), exp(mean + half)
    }'
