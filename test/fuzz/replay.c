/* SPDX-License-Identifier: MIT
 * fuzz/replay.c - a fuzz target without a fuzzer: replay_NAME COUNT FILE... gives it every file, then COUNT inputs, each a
 * file with bytes changed or random bytes alone. The same on every machine and compiler. */
#include <string.h>

#include "fuzz/fuzz.h"

enum { MOST = 1024, FILES = 64 };

static uint8_t seed[FILES][MOST];
static size_t seed_bytes[FILES];
static int seeds;
static uint32_t state = 2463534242u;

static uint32_t dice(void)
{
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    return state >> 4;
}

static void load(const char *path)
{
    FILE *f = fopen(path, "rb");
    if (!f) {
        fprintf(stderr, "%s: cannot be read\n", path);
        exit(2);
    }
    seed_bytes[seeds] = fread(seed[seeds], 1, MOST, f);
    fclose(f);
    LLVMFuzzerTestOneInput(seed[seeds], seed_bytes[seeds]);
    seeds++;
}

static size_t make(uint8_t *out)
{
    int from = seeds > 0 && dice() % 4 ? (int)(dice() % (uint32_t)seeds) : -1;
    size_t n = from >= 0 ? seed_bytes[from] : 1 + dice() % (MOST / 2);
    for (size_t i = 0; i < n; i++) {
        out[i] = from >= 0 ? seed[from][i] : (uint8_t)dice();
    }
    for (uint32_t i = 1 + dice() % 12; from >= 0 && i > 0 && n > 0; i--) {
        out[dice() % n] = (uint8_t)dice();
    }
    return n;
}

int main(int argc, char **argv)
{
    static uint8_t input[MOST];
    long count = argc > 1 ? atol(argv[1]) : 0;
    for (int i = 2; i < argc && seeds < FILES; i++) {
        load(argv[i]);
    }
    for (long i = 0; i < count; i++) {
        size_t n = make(input);
        LLVMFuzzerTestOneInput(input, n);
    }
    printf("%d files and %ld inputs made of them\n", seeds, count);
    return 0;
}
