/* SPDX-License-Identifier: MIT
 * stad/report_page.c - the frame of a report: style, script, text, tables. */
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "stad/config.h"

static const char style[] =
    ":root{color-scheme:light dark;--ink:#1c2430;--soft:#667;--line:#d5d9e0;--ground:#fff;--mark:#2a6fdb}"
    "@media(prefers-color-scheme:dark){:root{--ink:#e6e9ee;--soft:#9aa3b0;--line:#39414d;--ground:#14181e;--"
    "mark:#7fb0ff}}"
    "body{font:15px/1.5 "
    "system-ui,sans-serif;color:var(--ink);background:var(--ground);max-width:64rem;margin:2rem "
    "auto;padding:0 1rem}"
    "h1{font-size:1.5rem}h2{font-size:1.15rem;margin-top:2.2rem;border-top:1px solid "
    "var(--line);padding-top:1rem}"
    "img{display:block;max-width:100%;height:auto;image-rendering:auto}"
    "figure{margin:1rem "
    "0;width:fit-content;max-width:100%}figcaption,.soft{color:var(--soft);font-size:.88rem}"
    "table{border-collapse:collapse;margin:.8rem 0}td,th{padding:.2rem .9rem .2rem "
    "0;text-align:right;border-bottom:1px solid "
    "var(--line);font-variant-numeric:tabular-nums}td:first-child,th:first-child{text-align:left}"
    "pre{background:color-mix(in srgb,var(--line) "
    "40%,transparent);padding:.7rem;overflow-x:auto;white-space:pre-wrap;font-size:.85rem}"
    ".pair{position:relative;width:fit-content;max-width:100%}.pair "
    "img+img{position:absolute;inset:0;clip-path:inset(0 0 0 50%)}"
    ".pair i{position:absolute;top:0;bottom:0;left:50%;border-left:2px solid #fff;box-shadow:0 0 3px "
    "#000;pointer-events:none}"
    ".pair input{position:absolute;inset:0;width:100%;height:100%;margin:0;opacity:0;cursor:ew-resize}"
    ".pair input:focus-visible~i{border-color:var(--mark)}"
    ".names{display:flex;flex-wrap:wrap;justify-content:space-between;gap:0 1.5rem}"
    ".legend span{display:inline-block;margin-right:1.2rem}.legend "
    "b{display:inline-block;width:1em;height:1em;vertical-align:-.15em;"
    "margin-right:.4em}svg{max-width:100%;height:auto}svg text{fill:var(--soft);font-size:12px}";

static const char script[] = "document.querySelectorAll('.pair').forEach(function(p){var "
                             "s=p.querySelector('input'),o=p.querySelectorAll('img')[1],"
                             "l=p.querySelector('i');function set(){o.style.clipPath='inset(0 0 0 "
                             "'+s.value+'%)';l.style.left=s.value+'%'}"
                             "s.addEventListener('input',set);set()})";

/* In single quotes where a shell would do something with a character. */
static size_t quote(char *to, const char *word)
{
    size_t n = 0;
    int plain = *word && !word[strspn(word, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./,:@%")];
    if (!plain)
        to[n++] = '\'';
    for (; *word; word++) {
        if (*word == '\'') {
            memcpy(to + n, "'\\''", 4);
            n += 4;
        } else {
            to[n++] = *word;
        }
    }
    if (!plain)
        to[n++] = '\'';
    return n;
}

char *report_command(int argc, char **argv)
{
    size_t room = 1, n = 0;
    for (int i = 0; i < argc; i++)
        room += 4 * strlen(argv[i]) + 3;
    char *line = malloc(room);
    if (!line)
        return NULL;
    for (int i = 0; i < argc; i++) {
        if (i > 0)
            line[n++] = ' ';
        if (i == 0) { /* "stad NAME", two words */
            memcpy(line, argv[0], strlen(argv[0]));
            n = strlen(argv[0]);
        } else {
            n += quote(line + n, argv[i]);
        }
    }
    line[n] = 0;
    return line;
}

void report_escaped(report *r, const char *text)
{
    for (; *text; text++) {
        if (*text == '<')
            fputs("&lt;", r->to);
        else if (*text == '>')
            fputs("&gt;", r->to);
        else if (*text == '&')
            fputs("&amp;", r->to);
        else if (*text == '"')
            fputs("&quot;", r->to);
        else
            fputc(*text, r->to);
    }
}

int report_open(report *r, const char *path, const char *title, double focal_baseline, tool_fail *f)
{
    int status = tool_out_open(&r->out, path, f);
    if (status)
        return status;
    r->to = r->out.stream;
    r->focal_baseline = focal_baseline;
    fputs("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
          "content=\"width=device-width\">"
          "<link rel=\"icon\" href=\"data:,\"><title>",
          r->to);
    report_escaped(r, title);
    fprintf(r->to, "</title><style>%s</style></head><body>\n<h1>", style);
    report_escaped(r, title);
    fputs("</h1>\n", r->to);
    return TOOL_OK;
}

int report_close(report *r, int ok, tool_fail *f)
{
    fprintf(r->to, "<p class=\"soft\">stad %s</p>\n<script>%s</script>\n</body></html>\n", STAD_VERSION, script);
    return tool_out_close(&r->out, ok, f);
}

void report_heading(report *r, const char *text)
{
    fputs("<h2>", r->to);
    report_escaped(r, text);
    fputs("</h2>\n", r->to);
}

void report_paragraph(report *r, const char *text)
{
    fputs("<p>", r->to);
    report_escaped(r, text);
    fputs("</p>\n", r->to);
}

void report_commands(report *r, const char *const *commands, int count)
{
    fputs("<pre>", r->to);
    for (int i = 0; i < count; i++) {
        report_escaped(r, commands[i] ? commands[i] : "");
        fputc('\n', r->to);
    }
    fputs("</pre>\n", r->to);
}

typedef struct measure_row {
    const char *name;
    size_t offset;
    const char *unit;
    double factor;
} measure_row;

void report_measures(report *r, const measures *m, const char *const *names, int count)
{
    static const measure_row rows[] = {{"bad above 0.5 px", offsetof(measures, bad[0]), "%", 100},
                                       {"bad above 1 px", offsetof(measures, bad[1]), "%", 100},
                                       {"bad above 2 px", offsetof(measures, bad[2]), "%", 100},
                                       {"bad above 3 px", offsetof(measures, bad[3]), "%", 100},
                                       {"wrong by 1 px, of estimated", offsetof(measures, bad_estimated[1]), "%", 100},
                                       {"chow", offsetof(measures, chow), "%", 100},
                                       {"D1", offsetof(measures, d1), "%", 100},
                                       {"RMSE", offsetof(measures, rmse), "px", 1},
                                       {"mean absolute error", offsetof(measures, mae), "px", 1},
                                       {"density", offsetof(measures, density), "%", 100}};
    fputs("<table><tr><th></th>", r->to);
    for (int i = 0; i < count; i++) {
        fputs("<th>", r->to);
        report_escaped(r, names[i]);
        fputs("</th>", r->to);
    }
    fputs("</tr>\n", r->to);
    for (size_t k = 0; k < sizeof rows / sizeof rows[0]; k++) {
        fprintf(r->to, "<tr><td>%s</td>", rows[k].name);
        for (int i = 0; i < count; i++) {
            double v;
            memcpy(&v, (const char *)&m[i] + rows[k].offset, sizeof v);
            fprintf(r->to, "<td>%.3f %s</td>", rows[k].factor * v, rows[k].unit);
        }
        fputs("</tr>\n", r->to);
    }
    fputs("</table>\n", r->to);
}
