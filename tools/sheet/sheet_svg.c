/* SPDX-License-Identifier: MIT
 * pages -> [sheet/sheet_svg.c] -> files - a pen that writes one SVG a page: name-1.svg, name-2.svg ...
 *
 * Print is embedded as PNG with stored (uncompressed) blocks, so that no version of a compressor can change the
 * bytes. */
#include "sheet.h"

#include "../common/whole_file.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct svg {
    char *stem; /* path without its suffix */
    FILE *out;  /* of `file`, NULL between pages */
    tool_out file;
    tool_fail *fail;
    int lost;
} svg;

/* -- base 64, PNG ------------------------------------------------------------------------------------------------ */

typedef struct coder {
    FILE *out;
    uint32_t bits, crc, adler_a, adler_b;
    int count;
} coder;

static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

static void byte(coder *c, unsigned value)
{
    c->crc ^= value;
    for (int i = 0; i < 8; i++)
        c->crc = (c->crc >> 1) ^ (c->crc & 1u ? 0xedb88320u : 0u);
    c->bits = c->bits << 8 | value;
    if (++c->count % 3 == 0)
        for (int i = 18; i >= 0; i -= 6)
            fputc(digits[c->bits >> i & 63], c->out);
}

static void word(coder *c, uint32_t value)
{
    for (int i = 24; i >= 0; i -= 8)
        byte(c, value >> i & 255);
}

static void finish(coder *c)
{
    int left = c->count % 3;
    if (left == 0)
        return;
    c->bits <<= 8 * (3 - left);
    for (int i = 0; i < 4; i++)
        fputc(i <= left ? digits[c->bits >> (18 - 6 * i) & 63] : '=', c->out);
}

static void open_chunk(coder *c, uint32_t bytes, const char *name)
{
    word(c, bytes);
    c->crc = 0xffffffffu;
    for (int i = 0; i < 4; i++)
        byte(c, (unsigned char)name[i]);
}

static void close_chunk(coder *c)
{
    word(c, ~c->crc);
}

static void data(coder *c, unsigned value)
{
    c->adler_a = (c->adler_a + value) % 65521u;
    c->adler_b = (c->adler_b + c->adler_a) % 65521u;
    byte(c, value);
}

/* One stored block a row: a filter byte and the pixels. */
static void rows(coder *c, const sheet_raster *r)
{
    unsigned n = (unsigned)r->width + 1;
    open_chunk(c, 2 + (uint32_t)r->height * (n + 5) + 4, "IDAT");
    byte(c, 0x78);
    byte(c, 0x01);
    for (int y = 0; y < r->height; y++) {
        byte(c, y == r->height - 1);
        byte(c, n & 255);
        byte(c, n >> 8);
        byte(c, ~n & 255);
        byte(c, ~n >> 8 & 255);
        data(c, 0);
        for (int x = 0; x < r->width; x++)
            data(c, r->grey[(size_t)y * (size_t)r->width + (size_t)x]);
    }
    word(c, c->adler_b << 16 | c->adler_a);
    close_chunk(c);
}

static void png(FILE *out, const sheet_raster *r)
{
    coder c = {out, 0, 0, 1, 0, 0};
    static const unsigned char magic[8] = {137, 80, 78, 71, 13, 10, 26, 10};
    for (int i = 0; i < 8; i++)
        byte(&c, magic[i]);
    open_chunk(&c, 13, "IHDR");
    word(&c, (uint32_t)r->width);
    word(&c, (uint32_t)r->height);
    byte(&c, 8);
    for (int i = 0; i < 4; i++)
        byte(&c, 0); /* grey, deflate, no filter type, not interlaced */
    close_chunk(&c);
    rows(&c, r);
    open_chunk(&c, 0, "IEND");
    close_chunk(&c);
    finish(&c);
}

/* -- pen --------------------------------------------------------------------------------------------------------- */

static void close_page(svg *s)
{
    if (!s->out)
        return;
    fputs("</svg>\n", s->out);
    s->lost |= tool_out_close(&s->file, 1, s->fail) != TOOL_OK;
    s->out = NULL;
}

static int svg_begin(void *to, double width_mm, double height_mm, int page, int pages)
{
    svg *s = to;
    size_t room = strlen(s->stem) + 20;
    char *path = malloc(room);
    (void)pages;
    close_page(s);
    if (!path || s->lost) {
        free(path);
        return 0;
    }
    snprintf(path, room, "%s-%d.svg", s->stem, page);
    s->lost |= tool_out_open(&s->file, path, s->fail) != TOOL_OK;
    free(path);
    if (s->lost)
        return 0;
    s->out = s->file.stream;
    fprintf(s->out,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" "
            "width=\"%.3fmm\" height=\"%.3fmm\" viewBox=\"0 0 %.3f %.3f\">\n",
            width_mm, height_mm, width_mm, height_mm);
    return 1;
}

static void svg_line(void *to, sheet_point a, sheet_point b, int kind)
{
    static const char *const style[] = {"stroke=\"#000\" stroke-width=\".15\"",
                                        "stroke=\"#000\" stroke-width=\".15\" stroke-dasharray=\"2 1\"",
                                        "stroke=\"#595959\" stroke-width=\".08\""};
    fprintf(((svg *)to)->out, "<line x1=\"%.3f\" y1=\"%.3f\" x2=\"%.3f\" y2=\"%.3f\" %s/>\n", a.x, a.y, b.x, b.y, style[kind]);
}

static void svg_fill(void *to, const sheet_point *p, int count, int grey)
{
    FILE *out = ((svg *)to)->out;
    fprintf(out, "<polygon fill=\"#%02x%02x%02x\" points=\"", grey, grey, grey);
    for (int i = 0; i < count; i++)
        fprintf(out, "%s%.3f,%.3f", i ? " " : "", p[i].x, p[i].y);
    fputs("\"/>\n", out);
}

static void svg_raster(void *to, const sheet_raster *r)
{
    FILE *out = ((svg *)to)->out;
    fprintf(out,
            "<image width=\"%d\" height=\"%d\" transform=\"matrix(%.6f %.6f %.6f %.6f %.3f %.3f)\" "
            "xlink:href=\"data:image/png;base64,",
            r->width, r->height, r->u.x, r->u.y, r->v.x, r->v.y, r->origin.x, r->origin.y);
    png(out, r);
    fputs("\"/>\n", out);
}

static void svg_text(void *to, sheet_point at, double size_mm, const char *words)
{
    FILE *out = ((svg *)to)->out;
    fprintf(out,
            "<text x=\"%.3f\" y=\"%.3f\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"%.3f\" "
            "xml:space=\"preserve\">",
            at.x, at.y, size_mm);
    for (const char *c = words; *c; c++)
        if (*c == '<' || *c == '&')
            fputs(*c == '<' ? "&lt;" : "&amp;", out);
        else
            fputc(*c, out);
    fputs("</text>\n", out);
}

static int svg_end(void *to)
{
    svg *s = to;
    close_page(s);
    int ok = !s->lost;
    free(s->stem);
    free(s);
    return ok;
}

sheet_pen sheet_svg_pen(const char *path, void **state, tool_fail *f)
{
    svg *s = calloc(1, sizeof *s);
    sheet_pen pen = {s, svg_begin, svg_line, svg_fill, svg_raster, svg_text, svg_end};
    size_t n = strlen(path) - 4;
    *state = NULL;
    if (!s)
        return pen;
    s->stem = calloc(n + 1, 1);
    if (!s->stem) {
        free(s);
        return pen;
    }
    memcpy(s->stem, path, n);
    s->fail = f;
    *state = s;
    return pen;
}
