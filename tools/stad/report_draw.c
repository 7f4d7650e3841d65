/* SPDX-License-Identifier: MIT
 * stad/report_draw.c - what is looked at in a report: pictures, sliders, scales, the plot of a search. */
#include <math.h>
#include <stdlib.h>

#include "../common/colour.h"
#include "report.h"

static void base64(FILE *to, const unsigned char *b, size_t n)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (size_t i = 0; i < n; i += 3) {
        unsigned v = (unsigned)b[i] << 16 | (unsigned)(i + 1 < n ? b[i + 1] : 0) << 8 | (i + 2 < n ? b[i + 2] : 0u);
        fputc(digit[v >> 18], to);
        fputc(digit[v >> 12 & 63], to);
        fputc(i + 1 < n ? digit[v >> 6 & 63] : '=', to);
        fputc(i + 2 < n ? digit[v & 63] : '=', to);
    }
}

static int image(report *r, const picture *p, const char *name, tool_fail *f)
{
    char *png;
    size_t size;
    int status = picture_png_bytes(p, &png, &size, f);
    if (status)
        return status;
    fprintf(r->to, "<img width=\"%d\" height=\"%d\" alt=\"", p->width, p->height);
    report_escaped(r, name);
    fputs("\" src=\"data:image/png;base64,", r->to);
    base64(r->to, (const unsigned char *)png, size);
    fputs("\">", r->to);
    free(png);
    return TOOL_OK;
}

int report_picture(report *r, const picture *p, const char *caption, tool_fail *f)
{
    fputs("<figure>", r->to);
    int status = image(r, p, caption, f);
    fputs("<figcaption>", r->to);
    report_escaped(r, caption);
    fputs("</figcaption></figure>\n", r->to);
    return status;
}

int report_slider(report *r, const picture *before, const picture *after, const char *before_name, const char *after_name,
                  tool_fail *f)
{
    fputs("<figure><div class=\"pair\">", r->to);
    int status = image(r, before, before_name, f);
    if (status == TOOL_OK)
        status = image(r, after, after_name, f);
    fputs("<input type=\"range\" min=\"0\" max=\"100\" value=\"50\" step=\"0.1\" aria-label=\"", r->to);
    report_escaped(r, before_name);
    fputs(" against ", r->to);
    report_escaped(r, after_name);
    fputs("\"><i></i></div><figcaption class=\"names\"><span>left of the line: ", r->to);
    report_escaped(r, before_name);
    fputs("</span><span>right of it: ", r->to);
    report_escaped(r, after_name);
    fputs("</span></figcaption></figure>\n", r->to);
    return status;
}

#define STEPS 64 /* of the colour scale */
#define WIDTH 640
#define TICKS 4

void report_scale(report *r, int min_disparity, int num_disparities)
{
    fprintf(r->to, "<svg class=\"scale\" viewBox=\"-20 0 %d 62\" width=\"%d\">", WIDTH + 60, WIDTH + 60);
    for (int i = 0; i < STEPS; i++) {
        uint8_t c[3];
        colour_of((i + 0.5) / STEPS, c);
        fprintf(r->to, "<rect x=\"%d\" y=\"0\" width=\"%d\" height=\"18\" fill=\"#%02x%02x%02x\"/>", i * WIDTH / STEPS,
                WIDTH / STEPS + 1, c[0], c[1], c[2]);
    }
    for (int i = 0; i <= TICKS; i++) {
        double px = min_disparity + (double)i * num_disparities / TICKS;
        int x = i * WIDTH / TICKS;
        fprintf(r->to, "<text x=\"%d\" y=\"34\" text-anchor=\"middle\">%g px</text>", x, px);
        if (r->focal_baseline > 0 && px > 0)
            fprintf(r->to, "<text x=\"%d\" y=\"52\" text-anchor=\"middle\">%.3g m</text>", x, r->focal_baseline / px);
    }
    fputs("</svg>\n<p class=\"soft\">Disparity, far to near; black: none.</p>\n", r->to);
}

static void swatch(report *r, enum colour_error_kind kind, double error, const char *text)
{
    uint8_t c[3];
    colour_error(kind, error, c);
    fprintf(r->to, "<span><b style=\"background:#%02x%02x%02x\"></b>%s</span>", c[0], c[1], c[2], text);
}

void report_error_legend(report *r, double threshold)
{
    fprintf(r->to, "<p class=\"legend soft\">Against a threshold of %g px: ", threshold);
    swatch(r, ERROR_RIGHT, 0, "right");
    swatch(r, ERROR_RIGHT, 1, "right, just");
    swatch(r, ERROR_WRONG, 1, "wrong, just");
    swatch(r, ERROR_WRONG, 16, "wrong by 16 thresholds or more");
    swatch(r, ERROR_MISSING, 0, "missing");
    swatch(r, ERROR_NO_TRUTH, 0, "no truth");
    fputs("half as bright: hidden from the right camera</p>\n", r->to);
}

typedef struct plot {
    double top, bottom; /* costs at the upper and the lower edge */
    int count;
} plot;

#define PLOT_W 640
#define PLOT_H 240

static double plot_x(const plot *p, int i)
{
    return p->count > 1 ? (double)i * PLOT_W / (p->count - 1) : 0;
}

static double plot_y(const plot *p, double cost)
{
    double v = p->top > p->bottom ? (cost - p->bottom) / (p->top - p->bottom) : 0;
    return PLOT_H * (1 - (v < 0 ? 0 : v > 1 ? 1 : v));
}

/* From a little below the best to a little above the start; worse evaluations stick to the upper edge. */
static plot plot_of(const double *cost, int count)
{
    double least = INFINITY, first = NAN;
    for (int i = 0; i < count; i++) {
        if (isnan(first) && !isnan(cost[i]))
            first = cost[i];
        if (cost[i] < least)
            least = cost[i];
    }
    double margin = (first - least) * 0.15 + 0.01 * first;
    plot p = {first + margin, least - margin < 0 ? 0 : least - margin, count};
    return p;
}

void report_curve(report *r, const double *cost, int count, const char *name)
{
    plot p = plot_of(cost, count);
    double best = INFINITY;
    fprintf(r->to, "<svg class=\"curve\" viewBox=\"-60 -10 %d %d\" width=\"%d\">", PLOT_W + 80, PLOT_H + 50, PLOT_W + 80);
    for (int i = 0; i <= 4; i++) {
        double v = p.bottom + (p.top - p.bottom) * i / 4, y = plot_y(&p, v);
        fprintf(r->to,
                "<line x1=\"0\" x2=\"%d\" y1=\"%.1f\" y2=\"%.1f\" stroke=\"var(--line)\"/><text x=\"-6\" "
                "y=\"%.1f\" "
                "text-anchor=\"end\">%.2f %%</text>",
                PLOT_W, y, y, y + 4, 100 * v);
    }
    for (int i = 0; i < count; i++)
        if (!isnan(cost[i]))
            fprintf(r->to, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"2.5\" fill=\"var(--soft)\" opacity=\".6\"/>", plot_x(&p, i),
                    plot_y(&p, cost[i]));
    fputs("<polyline fill=\"none\" stroke=\"var(--mark)\" stroke-width=\"2\" points=\"", r->to);
    for (int i = 0; i < count; i++) {
        if (cost[i] < best)
            best = cost[i];
        if (!isinf(best))
            fprintf(r->to, "%.1f,%.1f ", plot_x(&p, i), plot_y(&p, best));
    }
    fprintf(r->to,
            "\"/><text x=\"0\" y=\"%d\">1</text><text x=\"%d\" y=\"%d\" text-anchor=\"end\">%d "
            "evaluations</text></svg>\n",
            PLOT_H + 18, PLOT_W, PLOT_H + 18, count);
    fputs("<p class=\"soft\">", r->to);
    report_escaped(r, name);
    fputs(" of each evaluation (dots; those worse than the start lie at the upper edge) and the best so far "
          "(line).</p>\n",
          r->to);
}
