/* SPDX-License-Identifier: MIT
 * [sheet/sheet_write.c] - a target to a file, PDF or SVG by its suffix. */
#include "sheet.h"

#include "../common/whole_file.h"

static int write_pdf(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f)
{
    void *state;
    tool_out out;
    int status = tool_out_open(&out, path, f);
    if (status)
        return status;
    sheet_pen pen = sheet_pdf_pen(out.stream, &state);
    int pages = state ? sheet_draw(target, paper, &pen) : 0;
    int lost = ferror(out.stream); /* which closing tells better */
    if (pages == 0 && !lost)
        tool_fail_set(f, TOOL_FILE, "%s: the pages cannot be drawn", path);
    return tool_out_close(&out, pages > 0 || lost, f);
}

static int write_svg(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f)
{
    void *state;
    sheet_pen pen = sheet_svg_pen(path, &state, f);
    if (state && sheet_draw(target, paper, &pen) > 0)
        return TOOL_OK;
    return f->status ? f->status : tool_fail_set(f, TOOL_FILE, "%s: the pages cannot be drawn", path);
}

int sheet_write(const stad_target *target, const sheet_paper *paper, const char *path, tool_fail *f)
{
    int pdf = tool_has_suffix(path, ".pdf");
    if (!pdf && !tool_has_suffix(path, ".svg"))
        return tool_fail_set(f, TOOL_USAGE, "%s: the suffix must be .pdf or .svg", path);
    return pdf ? write_pdf(target, paper, path, f) : write_svg(target, paper, path, f);
}
