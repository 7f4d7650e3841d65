/* SPDX-License-Identifier: MIT
 * port/isa/c/stad_port.h - plain C: no kernel of its own, every binding falls to `_c`. */
#ifndef STAD_PORT_H
#define STAD_PORT_H

#include "kernel/bind_c.h"

#endif
