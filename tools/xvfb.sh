#!/bin/sh
# Makes sure that there is an Xvfb, a display that needs no screen: installs Debian's where one may. Fails where it cannot.
set -u
command -v Xvfb >/dev/null && exit
if [ "$(id -u)" != 0 ] || ! command -v apt-get >/dev/null; then
    echo 'tools/xvfb.sh: there is no Xvfb, and it takes root and apt-get to install it; windows are not tested'
    exit 1
fi
export DEBIAN_FRONTEND=noninteractive
{ apt-get -q update && apt-get -qy install --no-install-recommends xvfb; } >/dev/null 2>&1 || {
    echo 'tools/xvfb.sh: apt-get could not install xvfb; windows are not tested'
    exit 1
}
