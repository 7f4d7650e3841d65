/* SPDX-License-Identifier: MIT
 * fuzz/fuzz_files.c - every reader of the tools on any bytes: a refusal with a message, or what it promises.
 *
 * The first byte chooses the reader, the rest is the file. Readers open names, so the bytes go through a file. */
#include <math.h>
#include <string.h>
#include <unistd.h>

#include <cjson/cJSON.h>

#include "disparity_file.h"
#include "fuzz/fuzz.h"
#include "grid.h"
#include "params_text.h"
#include "picture.h"
#include "recording.h"
#include "scene_set.h"
#include "truth_file.h"

/* A name for the file that ends in `suffix`: readers go by it. */
static const char *file_of(const bytes *b, const char *suffix)
{
    static char path[400];
    const char *folder = getenv("TMPDIR"); /* the runner's, which clears it */
    snprintf(path, sizeof path, "%s/fuzz-%ld%s", folder ? folder : "/tmp", (long)getpid(), suffix);
    FILE *f = fopen(path, "wb");
    expect(f && fwrite(b->at, 1, b->left, f) == b->left && fclose(f) == 0);
    return path;
}

static void check(int status, const tool_fail *f)
{
    expect(status == TOOL_OK || ((status == TOOL_USAGE || status == TOOL_FILE) && f->status == status && f->text[0]));
}

static void read_pictures(bytes *b, const char *suffix)
{
    for (int want = PICTURE_AS_IS; want <= PICTURE_BGR; want++) {
        picture p;
        tool_fail f = {0};
        int status = picture_read(&p, file_of(b, suffix), (enum picture_want)want, &f);
        check(status, &f);
        if (status == TOOL_OK) {
            uint32_t sum = 0;
            expect(p.width > 0 && p.height > 0 && (want != PICTURE_GREY || p.channels == 1) &&
                   (want != PICTURE_BGR || p.channels == 3));
            for (size_t i = 0; i < (size_t)p.width * (size_t)p.height * (size_t)p.channels; i++) {
                sum += p.pix[i];
            }
            expect(sum <= 255u * (uint32_t)(p.width * p.height * p.channels));
            picture_free(&p);
        }
    }
}

static void read_plane(bytes *b, const char *suffix)
{
    uint16_t *pix;
    int width, height, bits;
    tool_fail f = {0};
    int status = plane16_read(&pix, &width, &height, &bits, file_of(b, suffix), &f);
    check(status, &f);
    if (status == TOOL_OK) {
        expect(width > 0 && height > 0 && (bits == 8 || bits == 16));
        free(pix);
    }
}

static void read_grid(bytes *b, const char *suffix)
{
    grid g;
    tool_fail f = {0};
    const char *path = file_of(b, suffix);
    int status = strcmp(suffix, ".pfm") == 0 ? grid_read_pfm(&g, path, &f) : grid_read_npy(&g, path, &f);
    check(status, &f);
    if (status == TOOL_OK) {
        expect(g.width > 0 && g.height > 0);
        grid_free(&g);
    }
}

static void read_truth(bytes *b, const char *suffix)
{
    truth_map t;
    tool_fail f = {0};
    static const double scales[] = {0, 1, 16, 1e-300, -1, 1e300};
    double scale = scales[next(b) % 6];
    int min = next(b) % 40 - 20;
    const char *path = file_of(b, suffix);
    int status = truth_read(&t, path, scale, min, &f);
    check(status, &f);
    if (status == TOOL_OK) {
        status = truth_mask(&t, path, &f);
        check(status, &f);
        truth_free(&t);
    }
}

static void read_disparity(bytes *b, const char *suffix)
{
    disparity d;
    tool_fail f = {0};
    int status = disparity_read(&d, file_of(b, suffix), next(b) % 40 - 20, &f);
    check(status, &f);
    if (status == TOOL_OK) {
        disparity_free(&d);
    }
}

static void read_params(bytes *b)
{
    params_some s;
    stad_params p;
    tool_fail f = {0};
    int status = params_read_json(&s, file_of(b, ".json"), &f);
    check(status, &f);
    if (status == TOOL_OK) {
        params_from_some(&p, &s, 640, 1);
        tool_fail g = {0};
        check(params_check_text(&p, &s, s.mode < 0 ? 0 : s.mode, 640, &g), &g);
        cJSON *again = params_to_json(&p);
        expect(again);
        cJSON_Delete(again);
    }
}

static void read_list(bytes *b)
{
    scene_set s;
    tool_fail f = {0};
    check(scene_set_list(&s, file_of(b, ".json"), &f), &f);
    scene_set_free(&s);
}

static void read_raw(bytes *b)
{
    recording r;
    picture left, right;
    tool_fail f = {0};
    int width = next(b), height = next(b);
    if (width < 1 || height < 1) {
        return;
    }
    int status = recording_open(&r, file_of(b, ".raw"), 0, width, height, &f);
    check(status, &f);
    for (int i = 0; status == TOOL_OK && i < r.count && i < 4; i++) {
        status = recording_read(&r, i, 0, &left, &right, &f);
        check(status, &f);
        picture_free(&left), picture_free(&right);
    }
    recording_close(&r);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char *const suffixes[] = {".png", ".pgm", ".pfm", ".npy", ".npz"};
    bytes b = {data, size};
    int reader = next(&b);
    const char *suffix = suffixes[reader / 16 % 5];
    switch (reader % 16) {
    case 0:
    case 1:
        read_pictures(&b, suffix);
        break;
    case 2:
        read_plane(&b, suffix);
        break;
    case 3:
    case 4:
        read_grid(&b, suffix);
        break;
    case 5:
    case 6:
        read_truth(&b, suffix);
        break;
    case 7:
        read_disparity(&b, suffix);
        break;
    case 8:
        read_params(&b);
        break;
    case 9:
        read_list(&b);
        break;
    default:
        read_raw(&b);
    }
    return 0;
}
