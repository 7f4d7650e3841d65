/* SPDX-License-Identifier: MIT
 * stad/interrupt.h - a signal that ends long work early, so that what was done can still be written. */
#ifndef STAD_INTERRUPT_H
#define STAD_INTERRUPT_H

/* From here on the first SIGINT, SIGTERM or SIGHUP is only noted; a second one ends the program. Signals that are ignored
 * stay so. */
void interrupt_watch(void);

/* The signal that came, or 0. A program it ended exits with 128 + the signal. */
int interrupt_seen(void);

/* Signals end the program again. */
void interrupt_leave(void);

#endif
