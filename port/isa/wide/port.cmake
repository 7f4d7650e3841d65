# SPDX-License-Identifier: MIT
file(GLOB STAD_PORT_SOURCES CONFIGURE_DEPENDS ${STAD_PORT_DIR}/*.c)
target_sources(stadimeter PRIVATE ${STAD_PORT_SOURCES})
