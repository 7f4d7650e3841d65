/* SPDX-License-Identifier: MIT
 * common/whole_file.c - files are read whole, and written whole or not at all. */
#include "whole_file.h"

#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <unistd.h>

int tool_has_suffix(const char *path, const char *suffix)
{
    size_t n = strlen(path), s = strlen(suffix);
    return n > s && strcasecmp(path + n - s, suffix) == 0;
}

static int grow(unsigned char **bytes, size_t *room, size_t max)
{
    size_t more = *room < 65536 ? 65536 : *room * 2;
    if (more > max + 2)
        more = max + 2; /* one byte to notice a file that is too large, one for the zero */
    unsigned char *b = realloc(*bytes, more);
    if (!b)
        return 0;
    *bytes = b;
    *room = more;
    return 1;
}

static int read_stream(FILE *in, const char *path, size_t max, unsigned char **bytes, size_t *size, tool_fail *f)
{
    size_t room = 0, n = 0;
    for (;;) {
        if (n + 1 >= room && !grow(bytes, &room, max))
            return tool_fail_set(f, TOOL_FILE, "%s: not enough memory to read it", path);
        size_t got = fread(*bytes + n, 1, room - 1 - n, in);
        n += got;
        if (n > max)
            return tool_fail_set(f, TOOL_FILE, "%s: larger than the %zu bytes such a file may have", path, max);
        if (got == 0)
            break;
    }
    if (ferror(in))
        return tool_fail_set(f, TOOL_FILE, "%s: %s", path, strerror(errno));
    (*bytes)[n] = 0;
    *size = n;
    return TOOL_OK;
}

int tool_read_whole(const char *path, size_t max, unsigned char **bytes, size_t *size, tool_fail *f)
{
    *bytes = NULL;
    *size = 0;
    FILE *in = fopen(path, "rb");
    if (!in)
        return tool_fail_set(f, TOOL_FILE, "%s: %s", path, strerror(errno));
    int status = read_stream(in, path, max, bytes, size, f);
    fclose(in);
    if (status) {
        free(*bytes);
        *bytes = NULL;
    }
    return status;
}

/* A file that exists and is no regular one: renaming onto it would replace the device. */
static int is_device(const char *path)
{
    struct stat s;
    return stat(path, &s) == 0 && !S_ISREG(s.st_mode);
}

static char *name_beside(const char *path)
{
    size_t n = strlen(path);
    char *b = malloc(n + 9);
    if (b) {
        memcpy(b, path, n);
        memcpy(b + n, ".XXXXXX", 8);
    }
    return b;
}

/* "folder/name" of two parts; malloc. */
static char *joined(const char *folder, const char *name)
{
    size_t n = strlen(folder);
    char *b = malloc(n + strlen(name) + 2);
    if (!b)
        return NULL;
    memcpy(b, folder, n);
    b[n] = '/';
    strcpy(b + n + (n == 0 || folder[n - 1] != '/'), name);
    return b;
}

/* The file that does not exist yet: its folder's real path, and its name. */
static char *resolved_new(const char *path)
{
    const char *slash = strrchr(path, '/');
    char folder[PATH_MAX];
    size_t n = slash ? (size_t)(slash - path) + 1 : 1;
    if (n >= sizeof folder)
        return strdup(path);
    memcpy(folder, slash ? path : ".", n);
    folder[n] = 0;
    char *real = realpath(folder, NULL);
    char *r = real ? joined(real, slash ? slash + 1 : path) : strdup(path);
    free(real);
    return r;
}

#define LINKS_MAX 40

/* Where a path through symbolic links ends, be there a file or not, so that the link stays and its target is replaced. malloc. */
static char *resolved(const char *path)
{
    char target[PATH_MAX];
    char *r = realpath(path, NULL);
    if (r)
        return r;
    r = resolved_new(path);
    for (int i = 0; r && i < LINKS_MAX; i++) {
        ssize_t n = readlink(r, target, sizeof target - 1);
        char *slash = strrchr(r, '/');
        if (n <= 0 || !slash)
            return r;
        target[n] = 0;
        *slash = 0;
        char *next = target[0] == '/' ? strdup(target) : joined(r, target);
        free(r);
        r = next ? resolved_new(next) : NULL;
        free(next);
    }
    free(r);
    errno = ELOOP;
    return NULL;
}

/* Two names of one file: by device and inode where both exist, by path where one does not yet. */
static int is_same_file(const char *a, const char *b)
{
    struct stat s, t;
    int has_a = stat(a, &s) == 0, has_b = stat(b, &t) == 0;
    if (has_a && has_b)
        return S_ISREG(s.st_mode) && s.st_dev == t.st_dev && s.st_ino == t.st_ino;
    if (has_a || has_b)
        return 0;
    char *real_a = resolved(a), *real_b = resolved(b);
    int same = real_a && real_b && strcmp(real_a, real_b) == 0;
    free(real_a);
    free(real_b);
    return same;
}

int tool_out_apart(const char *const *out, int outs, const char *const *in, int ins, tool_fail *f)
{
    for (int i = 0; i < outs; i++) {
        for (int k = 0; k < ins && out[i]; k++)
            if (in[k] && is_same_file(out[i], in[k]))
                return tool_fail_set(f, TOOL_USAGE, "%s: is the input %s; an output must be another file", out[i], in[k]);
        for (int k = 0; k < i && out[i]; k++)
            if (out[k] && is_same_file(out[i], out[k]))
                return tool_fail_set(f, TOOL_USAGE, "%s and %s: two outputs in one file", out[k], out[i]);
    }
    return TOOL_OK;
}

static int folder_writable(const char *path)
{
    const char *slash = strrchr(path, '/');
    if (!slash)
        return access(".", W_OK | X_OK) == 0;
    if (slash == path)
        return access("/", W_OK | X_OK) == 0;
    size_t n = (size_t)(slash - path);
    char *folder = malloc(n + 1);
    if (!folder)
        return 0;
    memcpy(folder, path, n);
    folder[n] = 0;
    struct stat s;
    int ok = stat(folder, &s) == 0;
    if (ok && !S_ISDIR(s.st_mode)) {
        ok = 0;
        errno = ENOTDIR;
    }
    ok = ok && access(folder, W_OK | X_OK) == 0;
    int why = errno;
    free(folder);
    errno = why;
    return ok;
}

int tool_out_check(const char *path, tool_fail *f)
{
    struct stat s;
    if (strcmp(path, "-") == 0)
        return tool_fail_set(f, TOOL_USAGE, "-: an output is a file's name; ./- is a file of that name");
    if (stat(path, &s) == 0 && S_ISDIR(s.st_mode))
        return tool_fail_set(f, TOOL_FILE, "%s: cannot be written: it is a folder", path);
    if (is_device(path))
        return TOOL_OK;
    char *final = resolved(path);
    int ok = final && folder_writable(final);
    int why = errno;
    free(final);
    if (!ok)
        return tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", path, strerror(why));
    return TOOL_OK;
}

/* The one file under way, for a signal to remove. */
static const char *volatile under_way;

/* With SA_RESETHAND: the signal raised again ends the program once this returns. */
static void drop_and_end(int signal_number)
{
    const char *path = under_way;
    if (path)
        unlink(path);
    raise(signal_number);
}

/* A limit on the size of files shows as a failed write then, like a full disk. Signals that are ignored stay so. */
static void watch_signals(void)
{
    static const int ends[] = {SIGINT, SIGTERM, SIGHUP};
    struct sigaction is, drop = {.sa_handler = drop_and_end, .sa_flags = (int)SA_RESETHAND};
    signal(SIGXFSZ, SIG_IGN);
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++)
        if (sigaction(ends[i], NULL, &is) == 0 && is.sa_handler == SIG_DFL)
            sigaction(ends[i], &drop, NULL);
}

static FILE *open_beside(tool_out *o)
{
    watch_signals();
    under_way = o->beside; /* before the file: between the two the name is that of no file */
    int fd = mkstemp(o->beside);
    if (fd < 0)
        return NULL;
    struct stat s;
    mode_t mask = umask(0);
    umask(mask);
    mode_t mode = stat(o->final, &s) == 0 ? s.st_mode & 0777 : 0666 & ~mask;
    FILE *stream = fchmod(fd, mode) == 0 ? fdopen(fd, "wb") : NULL;
    if (!stream) {
        close(fd);
        unlink(o->beside);
    }
    return stream;
}

static void forget(tool_out *o)
{
    under_way = NULL;
    free(o->final);
    free(o->beside);
    memset(o, 0, sizeof *o);
}

int tool_out_open(tool_out *o, const char *path, tool_fail *f)
{
    memset(o, 0, sizeof *o);
    int status = tool_out_check(path, f);
    if (status)
        return status;
    o->final = resolved(path);
    if (o->final && is_device(path)) {
        o->stream = fopen(path, "wb");
    } else if (o->final && (o->beside = name_beside(o->final)) != NULL) {
        o->stream = open_beside(o);
    }
    if (o->stream)
        return TOOL_OK;
    status = tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", path, strerror(errno));
    forget(o);
    return status;
}

int tool_out_close(tool_out *o, int ok, tool_fail *f)
{
    int status = ok ? TOOL_OK : f->status;
    int bad = ferror(o->stream);
    bad |= fclose(o->stream) != 0;
    if (ok && bad)
        status = tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", o->final, strerror(errno ? errno : EIO));
    if (o->beside && status == TOOL_OK && rename(o->beside, o->final))
        status = tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", o->final, strerror(errno));
    if (o->beside && status)
        unlink(o->beside);
    forget(o);
    return status;
}
