#!/bin/sh
# Makes ./gradlew work in a closed network that offers package registries but neither Gradle's download site nor an
# Android SDK. Needs a JDK 17 and mvn alone. README.md beside this file says what is made from what, and why.
set -eu

here=$(cd "$(dirname "$0")" && pwd -P)
root=$(cd "$here/../.." && pwd -P)
say() { echo "registry-only: $*" >&2; }
fail() { say "$*"; exit 1; }

. "$root/gradle/jdk.sh"
find_jdk 17 21 || fail 'no JDK 17 to 21 found; install one or set JAVA_HOME'
export JAVA_HOME="$jdk"

url=$(sed -n 's/\\//g; s/^distributionUrl=//p' "$root/gradle/wrapper/gradle-wrapper.properties")
name=$(basename "$url" .zip)                     # gradle-8.7-bin
gradle=${name%-bin}                              # gradle-8.7
home=${GRADLE_USER_HOME:-$HOME/.gradle}
dists=$home/wrapper/dists/$name
kit=${XDG_CACHE_HOME:-$HOME/.cache}/glint-registry-only
sdk=$kit/android-sdk
api=34
tools=34.0.0
aapt2=$sdk/build-tools/$tools/aapt2
# Both folders carry the sum of the files that made them: another sum, and they are made anew.
stamp=$(cat "$here"/setup.sh "$here"/pom.xml "$here"/checksums.sha256 "$here"/java/* "$here"/javac-plugin/* | cksum)

up_to_date() {
    [ "$(cat "$dists"/*/"$gradle/registry-only" 2>/dev/null)" = "$stamp" ] &&
        [ -f "$(echo "$dists"/*/"$name.zip.ok")" ] &&
        [ "$(cat "$sdk/registry-only" 2>/dev/null)" = "$stamp" ]
}

# Folders are made under a name of their own and then moved into place, so that an interrupted run leaves nothing half
# made, and two runs at once do not meet.
make_kit() {
    say "for a network without Gradle's download site and without an Android SDK: makes $gradle and an SDK folder"
    say 'from artifacts of Maven Central that mvn downloads (320 MB, once), each checked against checksums.sha256'
    command -v mvn >/dev/null || fail 'mvn (Apache Maven) is not installed; it is needed for the downloads'
    mkdir -p "$kit" "$dists"
    find "$kit" "$dists" -prune -o -name 'work.*' -mmin +120 -exec rm -rf {} + # of runs that were killed
    work=$(mktemp -d "$kit/work.XXXXXX")
    staged=$(mktemp -d "$dists/work.XXXXXX")
    trap 'rm -rf "$work" "$staged"' EXIT
    trap 'exit 130' INT
    trap 'exit 143' TERM HUP

    say 'downloading ...'
    mvn --batch-mode --quiet --strict-checksums -f "$here/pom.xml" \
        dependency:copy "-DoutputDirectory=$work/jars" >"$work/mvn.log" 2>&1 ||
        { cat "$work/mvn.log" >&2; fail 'mvn could not download the files of pom.xml'; }
    asm=$(echo "$work"/jars/asm-*.jar | tr ' ' :)
    mkdir "$work/classes"
    "$JAVA_HOME/bin/javac" -cp "$asm" -d "$work/classes" "$here"/java/*.java
    run Kit verify "$here/checksums.sha256" "$work/jars" || fail 'so nothing was made'

    make_gradle "$staged/$gradle"
    make_sdk "$work/sdk"

    target=$dists/$(run Kit folder "$url")
    run Kit install "$staged/$gradle" "$target/$gradle"
    touch "$target/$name.zip.ok" # by this the wrapper knows that it need not download
    run Kit install "$work/sdk" "$sdk"
}

run() { "$JAVA_HOME/bin/java" -cp "$work/classes:$asm" "$@"; }

make_gradle() { # FOLDER
    say "laying out $gradle ..."
    mkdir -p "$1/lib" "$1/init.d" "$work/plugin"
    cp "$work"/jars/groovy-* "$work"/jars/kotlin-* "$work"/jars/annotations-* "$work"/jars/ant-* "$1/lib"
    run GradleDistribution "$work/jars/gradle-api-${gradle#*-}.jar" "$1/lib" "${gradle#*-}"
    # What gradle-api lacks: no agent for instrumentation, and a javac plugin that compiles in full each time.
    "$JAVA_HOME/bin/javac" -d "$work/plugin" "$here"/javac-plugin/*.java
    printf 'projects=\nruntime=\n' >"$work/plugin/gradle-java-compiler-plugin-classpath.properties"
    "$JAVA_HOME/bin/jar" cf "$1/lib/gradle-java-compiler-plugin-${gradle#*-}.jar" -C "$work/plugin" .
    echo 'org.gradle.internal.instrumentation.agent=false' >"$1/gradle.properties"
    echo 'allprojects { tasks.withType(JavaCompile).configureEach { options.incremental = false } }' \
        >"$1/init.d/full-javac.gradle"
    echo "$stamp" >"$1/registry-only"
}

make_sdk() { # FOLDER
    say 'making the Android SDK folder ...'
    platform=$1/platforms/android-$api
    build_tools=$1/build-tools/$tools
    mkdir -p "$platform/data" "$build_tools/lib" "$1/platform-tools" "$work/empty"
    run AndroidPlatform "$work"/jars/android-all-*.jar "$platform"
    touch "$platform/framework.aidl" "$platform/build.prop"
    cat >"$platform/source.properties" <<P
Pkg.Desc=Android SDK Platform $api
Pkg.UserSrc=false
Platform.Version=14
Pkg.Revision=3
AndroidVersion.ApiLevel=$api
Layoutlib.Api=15
Layoutlib.Revision=1
Platform.MinToolsRev=22
P
    printf 'Pkg.UserSrc=false\nPkg.Revision=%s\n' $tools >"$build_tools/source.properties"
    # the Android plugin looks whether these exist, and uses jars of its own instead
    for tool in aapt aidl dexdump d8 apksigner zipalign split-select lld bcc_compat llvm-rs-cc; do
        printf '#!/bin/sh\necho "%s is not in this SDK" >&2\nexit 1\n' $tool >"$build_tools/$tool"
        chmod +x "$build_tools/$tool"
    done
    "$JAVA_HOME/bin/jar" cf "$build_tools/core-lambda-stubs.jar" -C "$work/empty" .
    touch "$build_tools/lib/d8.jar" "$build_tools/lib/apksigner.jar"
    case $(uname) in Darwin) system=macosx ;; *) system=linux ;; esac
    (cd "$work" && "$JAVA_HOME/bin/jar" xf jars/apktool-lib-*.jar "prebuilt/$system/aapt2")
    mv "$work/prebuilt/$system/aapt2" "$build_tools/aapt2"
    chmod +x "$build_tools/aapt2"
    echo "$stamp" >"$1/registry-only"
}

# Writes standard input to FILE, in one step and only if it says something else.
write() { # FILE
    new=$1.$$
    cat >"$new"
    if cmp -s "$new" "$1"; then rm "$new"; else mv "$new" "$1" && say "wrote $1"; fi
}

begin=$(date +%s)
if up_to_date; then
    say 'up to date'
else
    make_kit
    say "done in $(($(date +%s) - begin)) s: $dists and $sdk"
fi

# An SDK that the user has is left alone; aapt2 is needed either way, as it is on Google's Maven alone.
if [ ! -d "${ANDROID_HOME:-${ANDROID_SDK_ROOT:-}}" ] &&
    [ ! -d "$(sed -n 's/^sdk\.dir=//p' "$root/local.properties" 2>/dev/null)" ]; then
    if "$aapt2" version >/dev/null 2>&1; then
        echo "sdk.dir=$sdk"
    else
        say "its aapt2 does not run on $(uname -m): the Android app is left out"
        echo '# no SDK: the aapt2 of tools/registry-only does not run on this machine'
    fi | write "$root/local.properties"
fi
touch "$home/gradle.properties"
{
    sed '/^# registry-only$/,/^# end registry-only$/d' "$home/gradle.properties"
    cat <<P
# registry-only
android.aapt2FromMavenOverride=$aapt2
android.builder.sdkDownload=false
# end registry-only
P
} | write "$home/gradle.properties"
