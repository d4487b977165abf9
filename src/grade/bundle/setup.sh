#!/usr/bin/env bash
# Once, when the platform builds the autograder: the languages that submissions are written in.
# Add others here. farop itself needs nothing.
set -eu
export DEBIAN_FRONTEND=noninteractive
apt-get update
apt-get install -y --no-install-recommends gcc g++ libc6-dev python3
# Submissions, which run as another user, must not read the seed of hidden probes, nor anybody's results.
base=${FAROP_AUTOGRADER:-/autograder}
for file in "$base/run_autograder" "$base/source/run_autograder" "$base/source/rubric.toml" "$base/results"; do
  [ ! -e "$file" ] || chmod go-rwx "$file"
done
