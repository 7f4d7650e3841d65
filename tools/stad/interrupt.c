/* SPDX-License-Identifier: MIT
 * stad/interrupt.c - a signal that ends long work early, so that what was done can still be written. */
#include "interrupt.h"

#include <signal.h>
#include <stddef.h>

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};
static volatile sig_atomic_t came;

static void note(int signal_number)
{
    came = signal_number;
}

static void change(void (*from)(int), void (*to)(int))
{
    struct sigaction is, now = {.sa_handler = to, .sa_flags = (int)(SA_RESETHAND | SA_RESTART)};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
        if (sigaction(ends[i], NULL, &is) == 0 && is.sa_handler == from)
            sigaction(ends[i], &now, NULL);
}

void interrupt_watch(void)
{
    change(SIG_DFL, note);
}

int interrupt_seen(void)
{
    return came;
}

void interrupt_leave(void)
{
    change(note, SIG_DFL);
}
