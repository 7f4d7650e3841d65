/* SPDX-License-Identifier: MIT
 * [sheet/sheet_write.c] - a target to a file, PDF or SVG by its suffix. */
#include "sheet.h"

#include <string.h>

static int ends_with(const char *path, const char *suffix)
{
    size_t n = strlen(path), k = strlen(suffix);
    return n > k && strcmp(path + n - k, suffix) == 0;
}

static int failed(const char *path, tool_fail *f)
{
    return tool_fail_set(f, TOOL_FILE, "%s cannot be written", path);
}

static int write_pdf(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f)
{
    void *state;
    FILE *out = fopen(path, "wb");
    if (!out)
        return failed(path, f);
    sheet_pen pen = sheet_pdf_pen(out, &state);
    int pages = state ? sheet_draw(target, paper, &pen) : 0;
    return fclose(out) == 0 && pages > 0 ? TOOL_OK : failed(path, f);
}

int sheet_write(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f)
{
    void *state;
    if (ends_with(path, ".pdf"))
        return write_pdf(target, paper, path, f);
    if (!ends_with(path, ".svg"))
        return tool_fail_set(f, TOOL_USAGE, "%s: the suffix must be .pdf or .svg", path);
    sheet_pen pen = sheet_svg_pen(path, &state);
    return state && sheet_draw(target, paper, &pen) > 0 ? TOOL_OK : failed(path, f);
}
