/* SPDX-License-Identifier: MIT
 * common/whole_file.c - files are read whole, and written whole or not at all. */
#include "whole_file.h"

#include <errno.h>
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

static int read_stream(FILE *in, const char *path, size_t max, unsigned char **bytes, size_t *size,
                       tool_fail *f)
{
    size_t room = 0, n = 0;
    for (;;) {
        if (n + 1 >= room && !grow(bytes, &room, max))
            return tool_fail_set(f, TOOL_FILE, "%s: not enough memory to read it", path);
        size_t got = fread(*bytes + n, 1, room - 1 - n, in);
        n += got;
        if (n > max)
            return tool_fail_set(f, TOOL_FILE, "%s: larger than the %zu bytes such a file may have", path,
                                 max);
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

/* Where a path through symbolic links ends, so that the link stays and its target is replaced. */
static char *resolved(const char *path)
{
    char *r = realpath(path, NULL);
    if (!r) {
        r = malloc(strlen(path) + 1);
        if (r)
            strcpy(r, path);
    }
    return r;
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
    int ok = access(folder, W_OK | X_OK) == 0;
    if (ok && (stat(folder, &s) || !S_ISDIR(s.st_mode))) {
        ok = 0;
        errno = ENOTDIR;
    }
    int why = errno;
    free(folder);
    errno = why;
    return ok;
}

int tool_out_check(const char *path, tool_fail *f)
{
    struct stat s;
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

static FILE *open_beside(tool_out *o)
{
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
        status =
            tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", o->final, strerror(errno ? errno : EIO));
    if (o->beside && status == TOOL_OK && rename(o->beside, o->final))
        status = tool_fail_set(f, TOOL_FILE, "%s: cannot be written: %s", o->final, strerror(errno));
    if (o->beside && status)
        unlink(o->beside);
    forget(o);
    return status;
}
