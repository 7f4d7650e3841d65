/* SPDX-License-Identifier: MIT
 * stad/config.h - version and the limits that are fixed when the library is built. */
#ifndef STAD_CONFIG_H
#define STAD_CONFIG_H

/* The version of the library. tools/release/manifests carries it to whatever else repeats it. */
#define STAD_VERSION_MAJOR 0
#define STAD_VERSION_MINOR 1 /* raised when the interface grows or changes */
#define STAD_VERSION_PATCH 0 /* raised when it does not */
/* The three as text. */
#define STAD_VERSION "0.1.0"

/* Alignment in bytes of every workspace a caller hands in: one vector of the widest port. A static array gets it from
 * STAD_ALIGNED, which gcc and clang spell as an attribute; with another compiler define it before including stad.h. */
#define STAD_ALIGN 64
#ifndef STAD_ALIGNED
#    if defined(__GNUC__)
#        define STAD_ALIGNED __attribute__((aligned(STAD_ALIGN))) /* behind the array's name */
#    else
#        define STAD_ALIGNED
#    endif
#endif

#endif
