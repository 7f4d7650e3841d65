# SPDX-License-Identifier: MIT
target_sources(stadimeter PRIVATE ${STAD_PORT_DIR}/kernels_mve.c)
