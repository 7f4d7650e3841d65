/* SPDX-License-Identifier: MIT
 * examples/mcu/main.c - the firmware: one source for every board of port/board and for the host
 *
 * Runs the chain on made-up frames and ends with 0 only if every hash is the one in expected.h: same bits on every core. */
#include "board.h"
#include "chain.h"
#include "say.h"
#include "stad/stad.h"

enum { WORK_BYTES = STAD_MATCH_BYTES(96, 64, 1, 16, 5, 800, 63, STAD_MODE_HH, STAD_MEMORY_SMALL) };

STAD_ALIGNED uint8_t work[WORK_BYTES];
const size_t work_bytes = sizeof work;

static int32_t agreed;

int chain_agrees(const char *name, uint32_t hash, uint32_t expected)
{
    say(name);
    say(": ");
    say_hex(hash);
    if (hash == expected) {
        say(" ok\n");
        agreed++;
        return 1;
    }
    say(" WRONG, expected ");
    say_hex(expected);
    say("\n");
    return 0;
}

int main(void)
{
    stad_params params;
    stad_rig rig;
    int good;
    say("stadimeter " STAD_VERSION "\n");
    good = chain_match();
    good &= chain_watch();
    good &= chain_marks(&rig);
    good &= chain_tune(&params);
    good &= chain_store(&params, &rig);
    say("sum: ");
    say_dec(agreed);
    say(" hashes agree, ");
    say_dec((int32_t)board_stack_used());
    say(" bytes of stack\n");
    say(good ? "done\n" : "failed\n");
    return good ? 0 : 1;
}
