#!/usr/bin/env bash
# Gradescope runs this once, when it builds the image: the languages of your class.
set -euo pipefail
apt-get update
apt-get install -y --no-install-recommends python3 nodejs gcc g++ libc6-dev
