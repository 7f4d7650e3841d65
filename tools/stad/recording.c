/* SPDX-License-Identifier: MIT
 * stad/recording.c - recorded stereo frames, however they lie on the disk. */
#include "recording.h"

#include <ctype.h>
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "../common/engine.h"
#include "../common/whole_file.h"

static int is_picture(const struct dirent *e)
{
    return e->d_name[0] != '.' &&
           (tool_has_suffix(e->d_name, ".png") || tool_has_suffix(e->d_name, ".pgm") || tool_has_suffix(e->d_name, ".ppm"));
}

static char *join(const char *folder, const char *name)
{
    size_t room = strlen(folder) + strlen(name) + 2;
    char *path = malloc(room);
    if (path)
        snprintf(path, room, "%s/%s", folder, name);
    return path;
}

static int is_file(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 && S_ISREG(s.st_mode);
}

/* `name` with `from` replaced by `to` where it stands last, or NULL. */
static char *replaced(const char *name, const char *from, const char *to)
{
    const char *at = NULL, *next = name;
    while ((next = strstr(next, from)) != NULL)
        at = next++;
    if (!at)
        return NULL;
    size_t head = (size_t)(at - name), room = strlen(name) + strlen(to) + 1;
    char *other = malloc(room);
    if (other)
        snprintf(other, room, "%.*s%s%s", (int)head, name, to, at + strlen(from));
    return other;
}

#define WORDS 5
static const char *const words[WORDS][2] = {{"left", "right"}, {"Left", "Right"}, {"_0.", "_1."}, {"_L.", "_R."}, {"im0", "im1"}};

/* The right view's file beside a left one, or NULL when `name` is no left one. */
static char *partner(const char *folder, const char *name)
{
    for (int i = 0; i < WORDS; i++) {
        char *other = replaced(name, words[i][0], words[i][1]);
        char *path = other ? join(folder, other) : NULL;
        free(other);
        if (path && is_file(path))
            return path;
        free(path);
    }
    return NULL;
}

/* Two views in two files, by names that say so; "_0." and "_1." may also be numbers of frames. */
static int check_halves(const char *folder, const char *name, tool_fail *f)
{
    char *right = strstr(name, "_0.") ? NULL : partner(folder, name);
    if (!right)
        return TOOL_OK;
    tool_fail_set(f, TOOL_USAGE, "--side-by-side: %s/%s and %s are a view each: leave the option out", folder, name, right);
    free(right);
    return TOOL_USAGE;
}

typedef struct listing {
    struct dirent **entry;
    int count;
} listing;

static int list(listing *l, const char *folder, tool_fail *f)
{
    l->count = scandir(folder, &l->entry, is_picture, alphasort);
    if (l->count < 0)
        return tool_fail_set(f, TOOL_FILE, "%s: cannot be read: %s", folder, strerror(errno));
    return TOOL_OK;
}

static void unlist(listing *l)
{
    for (int i = 0; i < l->count; i++)
        free(l->entry[i]);
    free(l->entry);
}

static int reserve(recording *r, int frames, const char *folder, tool_fail *f)
{
    r->left = calloc((size_t)frames + 1, sizeof *r->left);
    r->right = calloc((size_t)frames + 1, sizeof *r->right);
    if (!r->left || !r->right)
        return tool_fail_set(f, TOOL_FILE, "%s: not enough memory for its names", folder);
    return TOOL_OK;
}

/* Alike but for digits. */
static int is_alike(const char *a, const char *b)
{
    for (; *a && *b; a++, b++)
        if (*a != *b && !(isdigit((unsigned char)*a) && isdigit((unsigned char)*b)))
            return 0;
    return *a == *b;
}

/* The name that `name`'s other view would have, side 0 given or 1, when a pair of the listing is called alike. */
static char *expected(const listing *l, const char *folder, const char *name, int side)
{
    for (int w = 0; w < WORDS; w++) {
        char *other = replaced(name, words[w][side], words[w][1 - side]);
        for (int i = 0; other && i < l->count; i++) {
            char *right = is_alike(l->entry[i]->d_name, side ? other : name) ? partner(folder, l->entry[i]->d_name) : NULL;
            free(right);
            if (right)
                return other;
        }
        free(other);
    }
    return NULL;
}

/* A view of a pair whose other file is gone: a frame that cannot be read, told when its turn comes. */
static int add_half(recording *r, const listing *l, const char *folder, const char *name)
{
    for (int side = 0; side < 2; side++) {
        char *other = expected(l, folder, name, side), *path = other ? join(folder, other) : NULL;
        int gone = path && !is_file(path);
        free(other);
        if (!gone) {
            free(path);
            continue;
        }
        r->left[r->count] = side ? path : join(folder, name);
        r->right[r->count] = side ? join(folder, name) : path;
        r->count++;
        return r->left[r->count - 1] && r->right[r->count - 1];
    }
    return 1;
}

/* Pairs in one folder, or single pictures that hold both views. */
static int scan_one(recording *r, const char *folder, int side_by_side, tool_fail *f)
{
    listing l;
    int status = list(&l, folder, f);
    if (status)
        return status;
    status = reserve(r, l.count, folder, f);
    for (int i = 0; i < l.count && status == TOOL_OK; i++) {
        if (side_by_side && check_halves(folder, l.entry[i]->d_name, f)) {
            status = f->status;
            break;
        }
        char *right = side_by_side ? NULL : partner(folder, l.entry[i]->d_name);
        if (!right && !side_by_side) {
            if (!add_half(r, &l, folder, l.entry[i]->d_name))
                status = tool_fail_set(f, TOOL_FILE, "%s: not enough memory for its names", folder);
            continue;
        }
        r->right[r->count] = right;
        r->left[r->count] = join(folder, l.entry[i]->d_name);
        if (!r->left[r->count++])
            status = tool_fail_set(f, TOOL_FILE, "%s: not enough memory for its names", folder);
    }
    unlist(&l);
    if (side_by_side) {
        free(r->right);
        r->right = NULL;
    }
    return status;
}

/* A folder a view, the same names in both. */
static int scan_two(recording *r, const char *left, const char *right, tool_fail *f)
{
    listing l;
    int status = list(&l, left, f);
    if (status)
        return status;
    status = reserve(r, l.count, left, f);
    for (int i = 0; i < l.count && status == TOOL_OK; i++) {
        r->left[r->count] = join(left, l.entry[i]->d_name);
        r->right[r->count] = join(right, l.entry[i]->d_name);
        if (!r->left[r->count] || !r->right[r->count])
            status = tool_fail_set(f, TOOL_FILE, "%s: not enough memory for its names", left);
        r->count++;
    }
    unlist(&l);
    return status;
}

static int is_folder(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 && S_ISDIR(s.st_mode);
}

/* *found: whether this layout is there at all. */
static int try_layout(recording *r, const char *where, const char *const names[2], int *found, tool_fail *f)
{
    char *left = join(where, names[0]), *right = join(where, names[1]);
    int status = TOOL_OK;
    *found = left && right && is_folder(left) && is_folder(right);
    if (*found)
        status = scan_two(r, left, right, f);
    free(left);
    free(right);
    return status;
}

static int scan(recording *r, const char *where, int side_by_side, tool_fail *f)
{
    static const char *const layouts[][2] = {
        {"cam0/data", "cam1/data"},         {"mav0/cam0/data", "mav0/cam1/data"}, {"image_0", "image_1"}, {"image_2", "image_3"},
        {"image_00/data", "image_01/data"}, {"image_02/data", "image_03/data"},   {"left", "right"}};
    int found = 0, status = TOOL_OK;
    for (size_t i = 0; i < sizeof layouts / sizeof layouts[0] && !found && !side_by_side && status == TOOL_OK; i++)
        status = try_layout(r, where, layouts[i], &found, f);
    return found || status ? status : scan_one(r, where, side_by_side, f);
}

static int open_raw(recording *r, const char *where, tool_fail *f)
{
    struct stat s;
    long long frame = 2LL * r->raw_width * r->raw_height;
    if (stat(where, &s))
        return tool_fail_set(f, TOOL_FILE, "%s: %s", where, strerror(errno));
    if (S_ISDIR(s.st_mode))
        return tool_fail_set(f, TOOL_USAGE, "%s is a folder: --size WxH is for frames in one file", where);
    if (s.st_size == 0 || s.st_size % frame || s.st_size / frame > 10000000)
        return tool_fail_set(f, TOOL_FILE, "%s: %lld bytes are no whole number of pairs of %d x %d", where, (long long)s.st_size,
                             r->raw_width, r->raw_height);
    r->count = (int)(s.st_size / frame);
    return TOOL_OK;
}

int recording_open(recording *r, const char *where, int side_by_side, int raw_width, int raw_height, tool_fail *f)
{
    memset(r, 0, sizeof *r);
    r->where = where;
    r->raw_width = raw_width;
    r->raw_height = raw_height;
    if (raw_width == 0 && is_file(where))
        return tool_fail_set(f, TOOL_USAGE, "%s is a file: frames in one file go with --size WxH, pictures lie in a folder",
                             where);
    int status = raw_width > 0 ? open_raw(r, where, f) : scan(r, where, side_by_side, f);
    if (status == TOOL_OK && r->count == 0)
        status = tool_fail_set(f, TOOL_FILE, "%s: no stereo frames found; `stad simulate --help` tells the layouts", where);
    if (status)
        recording_close(r);
    return status;
}

void recording_close(recording *r)
{
    for (int i = 0; i < r->count && r->left; i++) {
        free(r->left[i]);
        if (r->right)
            free(r->right[i]);
    }
    free(r->left);
    free(r->right);
    memset(r, 0, sizeof *r);
}

static int read_raw(const recording *r, int i, picture *left, picture *right, tool_fail *f)
{
    size_t bytes = (size_t)r->raw_width * (size_t)r->raw_height;
    int status = picture_alloc(left, r->raw_width, r->raw_height, 1, f);
    if (status == TOOL_OK)
        status = picture_alloc(right, r->raw_width, r->raw_height, 1, f);
    FILE *in = status ? NULL : fopen(r->where, "rb");
    if (status == TOOL_OK && (!in || fseek(in, (long)(2 * bytes * (size_t)i), SEEK_SET) ||
                              fread(left->pix, 1, bytes, in) != bytes || fread(right->pix, 1, bytes, in) != bytes))
        status = tool_fail_set(f, TOOL_FILE, "%s: frame %d cannot be read", r->where, i);
    if (in)
        fclose(in);
    return status;
}

static int split(picture *both, picture *left, picture *right, const char *path, tool_fail *f)
{
    int half = both->width / 2;
    size_t row = (size_t)half * (size_t)both->channels;
    if (both->width % 2)
        return tool_fail_set(f, TOOL_FILE, "%s: %d pixels wide cannot be halved", path, both->width);
    int status = picture_alloc(left, half, both->height, both->channels, f);
    if (status == TOOL_OK)
        status = picture_alloc(right, half, both->height, both->channels, f);
    for (size_t y = 0; status == TOOL_OK && y < (size_t)both->height; y++) {
        memcpy(left->pix + y * row, both->pix + 2 * y * row, row);
        memcpy(right->pix + y * row, both->pix + (2 * y + 1) * row, row);
    }
    return status;
}

int recording_read(const recording *r, int i, int color, picture *left, picture *right, tool_fail *f)
{
    picture both;
    int status;
    memset(left, 0, sizeof *left);
    memset(right, 0, sizeof *right);
    if (r->raw_width > 0) {
        status = read_raw(r, i, left, right, f);
    } else if (r->right) {
        status = engine_read_pair(left, right, r->left[i], r->right[i], color, f);
    } else {
        status = picture_read(&both, r->left[i], color ? PICTURE_BGR : PICTURE_GREY, f);
        if (status == TOOL_OK)
            status = split(&both, left, right, r->left[i], f);
        picture_free(&both);
    }
    if (status) {
        picture_free(left);
        picture_free(right);
    }
    return status;
}
