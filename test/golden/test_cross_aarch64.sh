#!/bin/sh
# SPDX-License-Identifier: MIT
# The golden vectors on aarch64.
exec "$(dirname "$0")/cross.sh" aarch64-linux-gnu-gcc qemu-aarch64
