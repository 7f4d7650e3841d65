# SPDX-License-Identifier: MIT
target_sources(stadimeter PRIVATE ${STAD_PORT_DIR}/kernels_neon.c ${STAD_PORT_DIR}/select_row_neon.c)
