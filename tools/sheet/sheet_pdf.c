/* SPDX-License-Identifier: MIT
 * pages -> [sheet/sheet_pdf.c] -> file - a pen that writes PDF 1.4: no compression, no dates, nothing that differs
 * between runs.
 *
 * A page's drawing is kept in memory, its images too; at the page's end they become objects. Object 1 is the catalog, 2 the
 * page tree, 3 the font. */
#include "sheet.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#define OBJECTS 400
#define PAGES   32
#define IMAGES  32
#define PT      (72.0 / 25.4)

typedef struct text {
    char *at;
    size_t count, room;
    int lost;
} text;

typedef struct pdf {
    FILE *out;
    long offset[OBJECTS];
    int objects, page_object[PAGES], pages;
    text drawing;
    int image[IMAGES], images;
    double height, width;
    int open, lost;
} pdf;

static void add(text *t, const void *bytes, size_t n)
{
    if (t->count + n > t->room) {
        size_t room = 2 * (t->count + n);
        char *more = realloc(t->at, room);
        if (!more) {
            t->lost = 1;
            return;
        }
        t->at = more;
        t->room = room;
    }
    memcpy(t->at + t->count, bytes, n);
    t->count += n;
}

static void addf(text *t, const char *format, ...)
{
    char line[256];
    va_list list;
    va_start(list, format);
    int n = vsnprintf(line, sizeof line, format, list);
    va_end(list);
    if (n > 0 && n < (int)sizeof line)
        add(t, line, (size_t)n);
    else
        t->lost = 1;
}

static int new_object(pdf *p)
{
    int number = ++p->objects;
    if (number >= OBJECTS) {
        p->lost = 1;
        return OBJECTS - 1;
    }
    return number;
}

static void begin_object(pdf *p, int number)
{
    p->offset[number] = ftell(p->out);
    fprintf(p->out, "%d 0 obj\n", number);
}

static int write_stream(pdf *p, const char *dictionary, const void *bytes, size_t n)
{
    int number = new_object(p);
    begin_object(p, number);
    fprintf(p->out, "<< %s /Length %zu >>\nstream\n", dictionary, n);
    p->lost |= fwrite(bytes, 1, n, p->out) != n;
    fprintf(p->out, "\nendstream\nendobj\n");
    return number;
}

static void close_page(pdf *p)
{
    if (!p->open)
        return;
    p->open = 0;
    p->lost |= p->drawing.lost;
    int content = write_stream(p, "", p->drawing.at, p->drawing.count);
    int page = new_object(p);
    begin_object(p, page);
    fprintf(p->out, "<< /Type /Page /Parent 2 0 R /MediaBox [0 0 %.3f %.3f] /Contents %d 0 R\n", p->width * PT, p->height * PT,
            content);
    fprintf(p->out, "   /Resources << /Font << /F1 3 0 R >> /XObject <<");
    for (int i = 0; i < p->images; i++)
        fprintf(p->out, " /I%d %d 0 R", i, p->image[i]);
    fprintf(p->out, " >> >> >>\nendobj\n");
    if (p->pages < PAGES)
        p->page_object[p->pages++] = page;
    else
        p->lost = 1;
}

static int pdf_begin(void *to, double width_mm, double height_mm, int page, int pages)
{
    pdf *p = to;
    (void)pages;
    if (page == 1) {
        fprintf(p->out, "%%PDF-1.4\n%%\xe2\xe3\xcf\xd3\n");
        p->objects = 3;
    }
    close_page(p);
    p->open = 1;
    p->width = width_mm;
    p->height = height_mm;
    p->images = 0;
    p->drawing.count = 0;
    addf(&p->drawing, "%.6f 0 0 %.6f 0 %.6f cm\n", PT, -PT, height_mm * PT);
    return !p->lost;
}

static void pdf_line(void *to, sheet_point a, sheet_point b, int kind)
{
    static const char *const style[] = {"0.15 w 0 G [] 0 d", "0.15 w 0 G [2 1] 0 d", "0.08 w 0.35 G [] 0 d"};
    addf(&((pdf *)to)->drawing, "%s %.3f %.3f m %.3f %.3f l S\n", style[kind], a.x, a.y, b.x, b.y);
}

static void pdf_fill(void *to, const sheet_point *p, int count, int grey)
{
    text *t = &((pdf *)to)->drawing;
    addf(t, "%.3f g", grey / 255.0);
    for (int i = 0; i < count; i++)
        addf(t, " %.3f %.3f %c", p[i].x, p[i].y, i == 0 ? 'm' : 'l');
    addf(t, " f\n");
}

static void pdf_raster(void *to, const sheet_raster *r)
{
    pdf *p = to;
    char dictionary[160];
    if (p->images == IMAGES) {
        p->lost = 1;
        return;
    }
    snprintf(dictionary, sizeof dictionary,
             "/Type /XObject /Subtype /Image /Width %d /Height %d /ColorSpace /DeviceGray /BitsPerComponent 8", r->width,
             r->height);
    p->image[p->images] = write_stream(p, dictionary, r->grey, (size_t)r->width * (size_t)r->height);
    double ux = r->u.x * r->width, uy = r->u.y * r->width, vx = r->v.x * r->height, vy = r->v.y * r->height;
    /* an image's own y runs up: its origin is the lower left corner */
    addf(&p->drawing, "q %.3f %.3f %.3f %.3f %.3f %.3f cm /I%d Do Q\n", ux, uy, -vx, -vy, r->origin.x + vx, r->origin.y + vy,
         p->images);
    p->images++;
}

static void pdf_text(void *to, sheet_point at, double size_mm, const char *words)
{
    text *t = &((pdf *)to)->drawing;
    addf(t, "0 g BT /F1 %.3f Tf 1 0 0 -1 %.3f %.3f Tm (", size_mm, at.x, at.y);
    for (const char *c = words; *c; c++) {
        if (*c == '(' || *c == ')' || *c == '\\')
            add(t, "\\", 1);
        add(t, c, 1);
    }
    addf(t, ") Tj ET\n");
}

static int pdf_end(void *to)
{
    pdf *p = to;
    close_page(p);
    begin_object(p, 1);
    fprintf(p->out, "<< /Type /Catalog /Pages 2 0 R >>\nendobj\n");
    begin_object(p, 2);
    fprintf(p->out, "<< /Type /Pages /Count %d /Kids [", p->pages);
    for (int i = 0; i < p->pages; i++)
        fprintf(p->out, " %d 0 R", p->page_object[i]);
    fprintf(p->out, " ] >>\nendobj\n");
    begin_object(p, 3);
    fprintf(p->out, "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>\nendobj\n");
    long table = ftell(p->out);
    fprintf(p->out, "xref\n0 %d\n0000000000 65535 f \n", p->objects + 1);
    for (int i = 1; i <= p->objects && i < OBJECTS; i++)
        fprintf(p->out, "%010ld 00000 n \n", p->offset[i]);
    fprintf(p->out, "trailer\n<< /Size %d /Root 1 0 R >>\nstartxref\n%ld\n%%%%EOF\n", p->objects + 1, table);
    int ok = !p->lost && !ferror(p->out);
    free(p->drawing.at);
    free(p);
    return ok;
}

sheet_pen sheet_pdf_pen(FILE *out, void **state)
{
    pdf *p = calloc(1, sizeof *p);
    sheet_pen pen = {p, pdf_begin, pdf_line, pdf_fill, pdf_raster, pdf_text, pdf_end};
    if (p)
        p->out = out;
    *state = p;
    return pen;
}
