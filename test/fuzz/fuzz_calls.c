/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_calls.c - any order of init, begin, options, push, pull and counts on one matcher: a status, never a fault; and
 * a frame that got through gives the same rows as a matcher that was driven in order.
 *
 * The input is a program: four bytes of geometry, then an operation a byte. */
#include <string.h>

#include "fuzz/fuzz.h"
#include "stad/match.h"
#include "support/subject.h"

enum { MOST_WIDTH = 80, MOST_HEIGHT = 20, OPERATIONS = 400 };

typedef struct machine {
    stad_geometry g;
    stad_params p;
    stad_match m;
    void *work;
    size_t bytes;
    uint8_t *left, *right;
    int16_t map[MOST_WIDTH * MOST_HEIGHT], in_order[MOST_WIDTH * MOST_HEIGHT];
    int begun, pushed, pulled;
    unsigned options;
} machine;

/* The frame in order, on a matcher of its own. */
static void drive_in_order(machine *k)
{
    stad_match m;
    stad_image left = stad_image_packed(k->left, k->g.width, k->g.height, k->g.channels);
    stad_image right = stad_image_packed(k->right, k->g.width, k->g.height, k->g.channels);
    void *work = subject_alloc(k->bytes, 0, 9);
    expect(stad_match_init(&m, &k->g, work, k->bytes) == STAD_OK);
    expect(stad_match_options(&m, k->options) == STAD_OK);
    expect(stad_match_frame(&m, &k->p, &left, &right, k->in_order, k->g.width, NULL, 0) == STAD_OK);
    expect(subject_guards_stand(work));
    subject_free(work);
}

static void begin(machine *k, bytes *b)
{
    stad_params p = k->p;
    if (next(b) % 8 == 0) {
        p.p2 = number(b, 500);
        p.num_disparities = number(b, 64);
    } else {
        p.uniqueness_ratio = (int16_t)(next(b) % 40);
        p.speckle_window_size = 0;
    }
    int status = stad_match_begin(&k->m, &p);
    expect(status == STAD_OK || ((status == STAD_E_PARAM || status == STAD_E_LIMIT) && stad_match_culprit(&k->m)));
    k->begun = status == STAD_OK ? 1 : 0; /* a refused begin drops the frame before as well */
    k->pushed = k->pulled = 0;
    if (k->begun) {
        k->p = p;
    }
}

static void push(machine *k)
{
    size_t line = (size_t)k->g.width * (size_t)k->g.channels, y = (size_t)(k->pushed < k->g.height ? k->pushed : 0);
    int status = stad_match_push(&k->m, k->left + y * line, k->right + y * line);
    expect(status == STAD_OK || status == STAD_AGAIN || status == STAD_E_STATE);
    expect(k->begun || status == STAD_E_STATE);
    k->pushed += status == STAD_OK;
}

static void pull(machine *k, int all)
{
    int16_t *row = subject_alloc((size_t)k->g.width * 2, 0, 5), *other = subject_alloc((size_t)k->g.width * 2, 0, 6);
    uint8_t *confidence = subject_alloc((size_t)k->g.width, 0, 7);
    int status =
        all ? stad_match_pull_all(&k->m, row, all & 2 ? confidence : NULL, all & 4 ? other : NULL) : stad_match_pull(&k->m, row);
    expect(status < k->g.height && (status >= 0 || status == STAD_AGAIN || status == STAD_E_STATE));
    expect(k->begun || status == STAD_E_STATE);
    expect(subject_guards_stand(row) && subject_guards_stand(other) && subject_guards_stand(confidence));
    if (status >= 0) {
        memcpy(k->map + status * k->g.width, row, (size_t)k->g.width * 2);
        k->pulled++;
    }
    subject_free(row), subject_free(other), subject_free(confidence);
    if (k->begun && k->pulled == k->g.height) {
        size_t n = (size_t)k->g.width * (size_t)k->g.height;
        const stad_match_counts *c = stad_match_counts_of(&k->m);
        expect(c->considered >= c->valid && c->considered >= c->firm && c->valid >= 0);
        drive_in_order(k);
        expect(memcmp(k->map, k->in_order, n * 2) == 0);
        k->begun = 0;
        k->pulled = k->pushed = 0;
    }
}

static void operate(machine *k, bytes *b)
{
    int op = next(b);
    if (op < 8) {
        expect(stad_match_init(&k->m, &k->g, k->work, k->bytes - 1) == STAD_E_SIZE || k->bytes == 0);
        expect(stad_match_init(&k->m, &k->g, k->work, k->bytes) == STAD_OK);
        k->begun = 0;
        k->options = 0;
    } else if (op < 16) {
        begin(k, b);
    } else if (op < 20 && !k->begun) {
        unsigned wish = (unsigned)next(b) % 8;
        int status = stad_match_options(&k->m, wish);
        expect(status == (wish < 4 ? STAD_OK : STAD_E_PARAM));
        k->options = status == STAD_OK ? wish : k->options;
    } else if (op < 140) {
        push(k);
    } else {
        pull(k, op % 8);
    }
}

static int set_up(machine *k, bytes *b)
{
    const char *culprit = NULL;
    memset(k, 0, sizeof *k);
    k->g.width = (int16_t)(1 + next(b) % MOST_WIDTH);
    k->g.height = (int16_t)(1 + next(b) % MOST_HEIGHT);
    int kind = next(b), block = 1 + 2 * (next(b) % 4);
    k->g.channels = kind & 1 ? 1 : 3;
    k->g.mode = (uint8_t)(kind >> 1 & 3);
    k->g.memory = (uint8_t)(kind >> 3 & 1);
    stad_params_sample(&k->p, 16 + (kind >> 4 & 1) * 16, block, k->g.channels);
    k->p.min_disparity = (int16_t)(kind >> 5);
    k->g.max_disparities = 32;
    k->g.max_block_size = 7;
    k->g.max_p2 = k->p.p2;
    k->g.max_pre_filter_cap = 63;
    return stad_geometry_check(&k->g, &culprit) == STAD_OK && stad_params_check(&k->p, k->g.mode, k->g.width, NULL) == STAD_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static machine k;
    bytes b = {data, size};
    if (!set_up(&k, &b)) {
        return 0;
    }
    size_t pixels = (size_t)k.g.width * (size_t)k.g.height * (size_t)k.g.channels;
    k.bytes = stad_match_bytes(&k.g);
    k.work = subject_alloc(k.bytes, 0, 4);
    k.left = subject_alloc(pixels, 0, 1);
    k.right = subject_alloc(pixels, 0, 2);
    fill(k.left, pixels, &b, 0);
    fill(k.right, pixels, &b, 3);
    expect(stad_match_init(&k.m, &k.g, k.work, k.bytes) == STAD_OK);
    for (int i = 0; i < OPERATIONS && b.left; i++) {
        operate(&k, &b);
    }
    expect(subject_guards_stand(k.work) && subject_guards_stand(k.left) && subject_guards_stand(k.right));
    subject_free(k.work), subject_free(k.left), subject_free(k.right);
    return 0;
}
