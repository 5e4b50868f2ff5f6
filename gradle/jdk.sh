# Sourced by gradlew, glint and tools/registry-only/setup.sh.
# find_jdk MIN MAX: sets `jdk` to the folder of an installed JDK of that range; fails if there is none.
# The first that fits wins: JAVA_HOME, the java on the PATH, then the folders where JDKs are usually installed.

jdk_fits() { # FOLDER MIN MAX
    [ -x "$1/bin/java" ] && [ -x "$1/bin/javac" ] || return 1
    jdk_version=$(sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release" 2>/dev/null)
    [ "${jdk_version:-0}" -ge "$2" ] && [ "${jdk_version:-0}" -le "$3" ]
}

find_jdk() { # MIN MAX
    jdk=${JAVA_HOME:-}
    jdk_fits "$jdk" "$1" "$2" && return
    # the java on the PATH may be a link or a script of a version manager, so it is asked itself
    jdk=$(java -XshowSettings:properties -version 2>&1 | sed -n 's/^ *java\.home = //p')
    jdk_fits "$jdk" "$1" "$2" && return
    for jdk in /usr/lib/jvm/* /Library/Java/JavaVirtualMachines/*/Contents/Home \
        "$HOME"/Library/Java/JavaVirtualMachines/*/Contents/Home "$HOME"/.sdkman/candidates/java/* "$HOME"/.jdks/* \
        "$HOME"/.asdf/installs/java/* "$HOME"/.local/share/mise/installs/java/*; do
        jdk_fits "$jdk" "$1" "$2" && return
    done
    jdk=
    return 1
}
