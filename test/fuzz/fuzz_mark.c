/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_mark.c - the whole way of a frame with marks, on any image: finder, pairs, rig, truth, score rows. A status or marks
 * inside the image; nothing outside the buffers.
 *
 * The input chooses sizes, strides and config, draws marks with any corners and smears bytes over them. */
#include <string.h>

#include "fuzz/fuzz.h"
#include "stad/stad.h"
#include "support/subject.h"

enum { MOST = 160, MARKS = 12 };

/* A mark in any parallelogram: cell by cell, or rather pixel by pixel, by the inverse of the affine map in Q16. */
static void draw_mark(uint8_t *pix, int width, int height, bytes *b)
{
    int id = next(b) % (STAD_MARK_IDS + 1), x0 = next(b) % MOST, y0 = next(b) % MOST, cell = 3 + next(b) % 4;
    int shear = next(b) % 5 - 2, dark = next(b) % 128, turn = next(b) % 4;
    int light = 255 - next(b) % 100;
    for (int row = -8; row < 8 * 8 + 64; row++) {
        for (int column = -1; column < 9; column++) {
            for (int k = 0; k < cell; k++) {
                int r = row / cell, c = column, x = x0 + column * cell + k + shear * row / 16, y = y0 + row;
                r = row < 0 ? -1 : r;
                if (r > 8 || x < 0 || y < 0 || x >= width || y >= height) {
                    continue;
                }
                int u = turn & 1 ? c : r, v = turn & 1 ? 7 - r : c;
                u = turn & 2 ? 7 - u : u;
                v = turn & 2 ? 7 - v : v;
                int white = u < 0 || v < 0 || u > 7 || v > 7 || stad_mark_cell(id, u, v);
                pix[y * width + x] = (uint8_t)(white ? light : dark);
            }
        }
    }
}

/* A plane of grey: noise, flat or gradient, marks, smears. */
static void draw(uint8_t *pix, int width, int height, bytes *b)
{
    int kind = next(b);
    size_t n = (size_t)width * (size_t)height;
    for (size_t i = 0; i < n; i++) {
        int x = (int)(i % (size_t)width), y = (int)(i / (size_t)width);
        pix[i] = (uint8_t)(kind & 1 ? 200 : kind & 2 ? x * 2 + y : (kind & 4 ? (x / 3 + y / 5) % 2 * 255 : 128));
    }
    if (kind & 8) {
        fill(pix, n, b, (size_t)kind);
    }
    for (int i = kind >> 4 & 7; i > 0; i--) {
        draw_mark(pix, width, height, b);
    }
    for (int i = next(b) % 32; i > 0; i--) {
        size_t at = ((size_t)next(b) * 256 + (size_t)next(b)) % n;
        size_t run = (size_t)next(b) % (n - at);
        memset(pix + at, next(b), run);
    }
}

static int find(const uint8_t *grey, int width, int height, bytes *b, stad_mark *marks)
{
    int channels = next(b) % 4 ? 1 : 3, step = channels + next(b) % 3, most = next(b) % (MARKS + 1);
    int up = next(b) % 4 == 0;
    size_t row = (size_t)width * (size_t)step + (size_t)(next(b) % 5), need = stad_mark_bytes(width, height);
    uint8_t *pix = subject_alloc(row * (size_t)height, 0, 1), *work = subject_alloc(need, 0, 2);
    stad_image image = {pix, width, height, channels, step, (ptrdiff_t)row};
    stad_mark_config config;
    stad_mark_config_default(&config);
    if (next(b) % 4 == 0) {
        config.ids = (uint32_t)next_i32(b);
        config.max_hamming = (uint8_t)(next(b) % 4);
        config.min_contrast = (uint8_t)next(b);
    }
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            pix[(size_t)(up ? height - 1 - y : y) * row + (size_t)x * (size_t)step + (channels == 3)] = grey[y * width + x];
        }
    }
    if (up) {
        image.pix = pix + (size_t)(height - 1) * row;
        image.row_stride = -image.row_stride;
    }
    expect(need == 0 || stad_mark_find(&image, &config, marks, most, work, need - 1) < 0);
    int found = stad_mark_find(&image, &config, marks, most, work, need);
    expect(found <= most && subject_guards_stand(work) && subject_guards_stand(pix));
    for (int i = 0; i < found; i++) {
        expect(marks[i].id >= 0 && marks[i].id < STAD_MARK_IDS && (config.ids >> marks[i].id & 1));
        expect(marks[i].hamming >= 0 && marks[i].hamming <= config.max_hamming);
        for (int k = 0; k < 4; k++) {
            stad_corner c = marks[i].corner[k];
            expect(c.x_q8 > -2048 && c.y_q8 > -2048 && c.x_q8 < (width + 8) * 256 && c.y_q8 < (height + 8) * 256);
        }
    }
    subject_free(pix), subject_free(work);
    return found > 0 ? found : 0;
}

/* What follows in the loop, with pairs as found or, at times, moved anywhere. */
static void use_pairs(stad_pair *pairs, int n, int width, int height, bytes *b)
{
    static stad_truth truth;
    stad_rig rig;
    stad_rig_report report;
    stad_camera camera = {(150 + next(b)) * 256, width * 128, height * 128};
    int32_t *row = subject_alloc((size_t)width * 4, 0, 3);
    uint8_t *label = subject_alloc((size_t)width, 0, 4);
    int verdict = stad_rig_fit(&rig, &report, pairs, n, width, height);
    expect(verdict >= STAD_E_PARAM && verdict <= STAD_RIG_FAIL);
    if (verdict >= 0) {
        stad_rig_straighten(&rig, pairs, n);
    }
    if (stad_truth_init(&truth, width, height, next(b) % 32 - 8, 16 + next(b) % 80, next(b) % 4) == STAD_OK &&
        stad_truth_from_target(&truth, next(b) % 4 ? stad_target_relief() : stad_target_card(), pairs, n, &camera) >= 0) {
        for (int y = 0; y < height; y++) {
            expect(stad_truth_row(&truth, y, width, row, label) == STAD_OK);
        }
        stad_box box = stad_truth_box(&truth);
        expect(box.width == 0 || (box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height));
        expect(box.width == 0 || stad_truth_crop(&truth, &box) == STAD_OK);
        expect(stad_truth_pixels(&truth) >= 0);
    }
    expect(subject_guards_stand(row) && subject_guards_stand(label));
    subject_free(row), subject_free(label);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    stad_mark left[MARKS], right[MARKS];
    stad_pair pairs[MARKS];
    bytes b = {data, size};
    int width = 12 + next(&b) % (MOST - 12), height = 12 + next(&b) % (MOST - 12);
    uint8_t *grey = subject_alloc((size_t)width * (size_t)height, 0, 8);
    draw(grey, width, height, &b);
    int n_left = find(grey, width, height, &b, left);
    if (next(&b) % 2) {
        draw(grey, width, height, &b);
    }
    int n_right = find(grey, width, height, &b, right);
    int n = stad_mark_pair(left, n_left, right, n_right, pairs, MARKS);
    expect(n <= n_left && n <= n_right);
    if (next(&b) % 4 == 0) {
        for (n = 0; n < 6; n++) {
            pairs[n].id = (int16_t)n;
            for (int k = 0; k < 8; k++) {
                stad_corner *c = k < 4 ? &pairs[n].left[k] : &pairs[n].right[k - 4];
                c->x_q8 = next(&b) * 256 + next(&b);
                c->y_q8 = next(&b) * 256 + next(&b);
            }
        }
    }
    use_pairs(pairs, n, width, height, &b);
    subject_free(grey);
    return 0;
}
