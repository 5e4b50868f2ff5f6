# Sourced by gradlew, before it looks for java: finds a JDK on which this Gradle runs and, where the Gradle of the wrapper
# is neither installed nor to be downloaded, has tools/registry-only make it. With a JDK 17 and ordinary internet this
# does nothing.

. "$APP_HOME/gradle/jdk.sh"
find_jdk 17 21 ||
    die 'ERROR: Glint is built by Gradle 8.7 on a JDK 17 (18 to 21 do, too; newer ones do not). None was found in JAVA_HOME, on the
PATH, or where JDKs are usually installed. Install one (for example the package openjdk-17-jdk-headless) or set JAVA_HOME.'
[ -z "${JAVA_HOME:-}" ] || [ "$jdk" = "$JAVA_HOME" ] ||
    warn "gradlew: uses $jdk, as Gradle 8.7 does not run on JAVA_HOME=$JAVA_HOME"
export JAVA_HOME="$jdk"
# Java takes the home folder from the user's account, and the scripts from HOME: say the same to both
export GRADLE_USER_HOME="${GRADLE_USER_HOME:-$HOME/.gradle}"

bootstrap_gradle() {
    url=$(sed -n 's/\\//g; s/^distributionUrl=//p' "$APP_HOME/gradle/wrapper/gradle-wrapper.properties")
    dists=$GRADLE_USER_HOME/wrapper/dists/$(basename "$url" .zip)
    setup=$APP_HOME/tools/registry-only/setup.sh
    if ls "$dists"/*/*.zip.ok >/dev/null 2>&1; then
        # That tool made it, in another clone perhaps: then it also tells this clone where the Android SDK is.
        if ls "$dists"/*/*/registry-only >/dev/null 2>&1 && [ ! -f "$APP_HOME/local.properties" ] &&
            [ -z "${ANDROID_HOME:-${ANDROID_SDK_ROOT:-}}" ]; then
            "$setup" || warn "gradlew: $setup failed; the Android app is left out"
        fi
        return
    fi
    # shellcheck disable=SC2086
    "$JAVA_HOME/bin/java" ${JAVA_OPTS:-} ${GRADLE_OPTS:-} "$APP_HOME/tools/registry-only/java/Kit.java" reachable "$url" && return
    if command -v mvn >/dev/null 2>&1; then
        "$setup" || die "ERROR: $setup failed."
    else
        warn "gradlew: $url does not answer. Where Maven Central does, install mvn (Apache Maven) and run this again:
it then makes Gradle from artifacts of Maven Central (tools/registry-only). The wrapper tries the download now all the same."
    fi
}
bootstrap_gradle
