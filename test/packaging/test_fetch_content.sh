#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# FetchContent from a git repository: what is committed builds on its own.
. "$(dirname "$0")/common.sh"
git -C "$source_dir" rev-parse HEAD >/dev/null 2>&1 || skip "the source is no git repository"
consume "include(FetchContent)
FetchContent_Declare(stadimeter GIT_REPOSITORY \"file://$source_dir\" GIT_TAG $(git -C "$source_dir" rev-parse HEAD))
FetchContent_MakeAvailable(stadimeter)"
