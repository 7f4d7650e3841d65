#!/bin/sh
# SPDX-License-Identifier: MIT
# The golden vectors on armhf.
exec "$(dirname "$0")/cross.sh" arm-linux-gnueabihf-gcc qemu-arm
