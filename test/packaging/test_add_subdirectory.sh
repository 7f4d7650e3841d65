#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# add_subdirectory() gives the target stadimeter::stadimeter and nothing else.
. "$(dirname "$0")/common.sh"
consume "add_subdirectory(\"$source_dir\" stadimeter)"
