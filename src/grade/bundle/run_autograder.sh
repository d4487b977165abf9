#!/usr/bin/env bash
# For every submission: the platform has it in submission/ and wants results/results.json.
# farop writes that file before the first picture and anew, whole, after every one: whoever stops it keeps what was earned.
set -u
base=${FAROP_AUTOGRADER:-/autograder}
mkdir -p "$base/results"
cd "$base" || exit 1
# The jail of a submission needs a kernel that can close files and calls. Where this one cannot, the container of its own that every submission has here
# must do, and setup.sh, which closes this file to others. The results say which layers were on (extra_data.sandbox).
loose=
"$base/source/farop" sandbox >/dev/null 2>&1 || loose=--unsafe-no-sandbox
"$base/source/farop" grade @LAB@ --submission "$base/submission" $loose --gradescope "$base/results/results.json" @OPTIONS@
code=$?
# 0: all points, 1: found wanting. Both are grades; only without a file something went wrong.
if [ -s "$base/results/results.json" ]; then exit 0; fi
exit "$code"
