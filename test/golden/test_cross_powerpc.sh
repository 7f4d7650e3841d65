#!/bin/sh
# SPDX-License-Identifier: MIT
# The golden vectors on powerpc, big-endian.
exec "$(dirname "$0")/cross.sh" powerpc-linux-gnu-gcc qemu-ppc
