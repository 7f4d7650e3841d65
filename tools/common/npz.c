/* SPDX-License-Identifier: MIT
 * common/npz.c - the first array of an .npz, which is a zip archive of .npy files.
 *
 * The sizes in its local header may be missing (they can follow the data, or stand in an extension), and are not needed: a
 * deflated member says itself where it ends, and a stored one is an .npy, which says so too. */
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "grid_bytes.h"

#define ZIP_HEADER   30 /* bytes of a local header before the name */
#define ZIP_STORED   0
#define ZIP_DEFLATED 8

static int inflate_into(z_stream *z, uint8_t **bytes, size_t *n)
{
    size_t room = 0;
    int code = Z_OK;
    while (code == Z_OK) {
        if (*n == room) {
            room = room ? room * 2 : 1 << 20;
            uint8_t *b = room <= GRID_FILE_MAX ? realloc(*bytes, room) : NULL;
            if (!b)
                return Z_MEM_ERROR;
            *bytes = b;
        }
        z->next_out = *bytes + *n;
        z->avail_out = (uInt)(room - *n);
        code = inflate(z, Z_NO_FLUSH);
        *n = room - z->avail_out;
    }
    return code;
}

static int unpack(const uint8_t *data, size_t size, uint8_t **bytes, size_t *n)
{
    z_stream z;
    memset(&z, 0, sizeof z);
    z.next_in = (z_const Bytef *)data;
    z.avail_in = (uInt)size;
    if (inflateInit2(&z, -MAX_WBITS) != Z_OK)
        return 0;
    int code = inflate_into(&z, bytes, n);
    inflateEnd(&z);
    return code == Z_STREAM_END;
}

static int copy(const uint8_t *data, size_t size, uint8_t **bytes, size_t *n)
{
    *bytes = malloc(size + 1);
    if (!*bytes)
        return 0;
    memcpy(*bytes, data, size);
    *n = size;
    return 1;
}

int npz_first(const uint8_t *file, size_t size, uint8_t **npy, size_t *n, const char *path, tool_fail *f)
{
    *npy = NULL;
    *n = 0;
    if (size < ZIP_HEADER)
        return tool_fail_set(f, TOOL_FILE, "%s: bad .npz: the file ends inside its header", path);
    size_t start = ZIP_HEADER + (size_t)grid_word(file + 26, 2, 0) + (size_t)grid_word(file + 28, 2, 0);
    uint64_t method = grid_word(file + 8, 2, 0);
    int encrypted = file[6] & 1;
    if (encrypted || start > size || (method != ZIP_STORED && method != ZIP_DEFLATED))
        return tool_fail_set(f, TOOL_FILE, "%s: bad .npz: not an archive that NumPy writes", path);
    int ok = method == ZIP_STORED ? copy(file + start, size - start, npy, n) : unpack(file + start, size - start, npy, n);
    if (ok)
        return TOOL_OK;
    free(*npy);
    *npy = NULL;
    return tool_fail_set(f, TOOL_FILE, "%s: bad .npz: its first member is damaged or too large", path);
}
