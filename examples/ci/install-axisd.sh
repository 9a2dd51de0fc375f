#!/bin/sh
# install-axisd.sh PREFIX: builds axisd from its sources on Debian 12 and installs it to PREFIX; for pipelines, as root.
# AXISD_REPOSITORY and AXISD_REF say where the sources are and which branch or tag of them.
set -eu

prefix=${1:?a prefix is missing}
sources=$(mktemp -d)
git clone --quiet --depth 1 ${AXISD_REF:+--branch "$AXISD_REF"} "${AXISD_REPOSITORY:-https://github.com/OWNER/axisd}" "$sources"
cd "$sources"
scripts/setup.sh --build
cmake --preset release -DAXISD_TESTS=OFF -DAXISD_BENCH=OFF
cmake --build --preset release --target installed
cmake --install build/release --prefix "$prefix"
rm -rf "$sources"
