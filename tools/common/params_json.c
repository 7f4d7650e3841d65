/* SPDX-License-Identifier: MIT
 * common/params_json.c - JSON files, and parameters as JSON. */
#include "params_text.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whole_file.h"

#define JSON_FILE_MAX ((size_t)16 << 20)

/* The line where the text stops being JSON. */
static int line_at(const unsigned char *text, const char *at)
{
    int line = 1;
    for (const char *c = (const char *)text; c < at; c++)
        line += *c == '\n';
    return line;
}

cJSON *json_read(const char *path, tool_fail *f)
{
    unsigned char *text;
    size_t size, at = 0;
    const char *end = NULL;
    if (tool_read_whole(path, JSON_FILE_MAX, &text, &size, f))
        return NULL;
    cJSON *document = cJSON_ParseWithLengthOpts((const char *)text, size, &end, 0);
    if (document)
        for (at = (size_t)(end - (const char *)text); at < size && strchr(" \t\r\n", text[at]) && text[at];)
            at++;
    if (!document)
        tool_fail_set(f, TOOL_FILE, "%s: no JSON: see line %d", path, line_at(text, end));
    else if (at < size)
        tool_fail_set(f, TOOL_FILE, "%s: no JSON: there is more behind its end, from byte %zu on", path, at);
    free(text);
    if (at == size)
        return document;
    cJSON_Delete(document);
    return NULL;
}

int json_write(const char *path, cJSON *document, tool_fail *f)
{
    tool_out out;
    char *text = cJSON_Print(document);
    int status = text ? tool_out_open(&out, path, f) : tool_fail_set(f, TOOL_FILE, "%s: not enough memory", path);
    if (status == TOOL_OK) {
        fprintf(out.stream, "%s\n", text);
        status = tool_out_close(&out, 1, f);
    }
    cJSON_free(text);
    cJSON_Delete(document);
    return status;
}

static int twice(const cJSON *item, const char *path, tool_fail *f)
{
    return tool_fail_set(f, TOOL_FILE, "%s: \"%s\" is there twice", path, item->string);
}

static int take_mode(params_some *s, const cJSON *item, const char *path, tool_fail *f)
{
    if (s->mode >= 0)
        return twice(item, path, f);
    if (cJSON_IsString(item))
        s->mode = params_mode_of(item->valuestring);
    else if (cJSON_IsNumber(item) && item->valuedouble >= 0 && item->valuedouble <= 3)
        s->mode = (int)item->valuedouble;
    if (s->mode < 0)
        return tool_fail_set(f, TOOL_USAGE, "%s: mode must be sgbm, hh, 3way or hh4", path);
    return TOOL_OK;
}

static int take_field(params_some *s, const cJSON *item, const char *path, tool_fail *f)
{
    if (strcmp(item->string, "mode") == 0)
        return take_mode(s, item, path, f);
    int field = params_field_find(item->string);
    if (field < 0)
        return tool_fail_set(f, TOOL_FILE, "%s: \"%s\" is no parameter", path, item->string);
    if (s->given >> field & 1)
        return twice(item, path, f);
    double v = cJSON_IsNumber(item) ? item->valuedouble : (double)NAN;
    if (!(fabs(v) < 4e9) || floor(v) != v)
        return tool_fail_set(f, TOOL_FILE, "%s: \"%s\" must be a whole number", path, item->string);
    if (!params_fits(field, (long)v))
        return tool_fail_set(f, TOOL_USAGE, "%s: \"%s\": %.0f is out of range", path, item->string, v);
    s->value[field] = (long)v;
    s->path[field] = path;
    s->given |= 1u << field;
    return TOOL_OK;
}

/* The only member of that name; *status tells when there are two. */
static const cJSON *only(const cJSON *object, const char *name, const char *path, int *status, tool_fail *f)
{
    const cJSON *item, *found = NULL;
    cJSON_ArrayForEach(item, object)
    {
        if (!item->string || strcmp(item->string, name) != 0)
            continue;
        if (found)
            *status = twice(item, path, f);
        found = item;
    }
    return found;
}

int params_read_json(params_some *s, const char *path, tool_fail *f)
{
    params_some_init(s);
    cJSON *document = json_read(path, f);
    if (!document)
        return f->status;
    int status = TOOL_OK;
    /* the object that holds the fields: best.params, in_use.params, params, or the document itself */
    const cJSON *best = only(document, "best", path, &status, f), *used = only(document, "in_use", path, &status, f);
    const cJSON *params = only(best ? best : used ? used : document, "params", path, &status, f);
    const cJSON *item, *object = params ? params : document;
    if (!cJSON_IsObject(object))
        status = tool_fail_set(f, TOOL_FILE, "%s: not a JSON object of parameters", path);
    cJSON_ArrayForEach(item, object)
    {
        if (status == TOOL_OK)
            status = take_field(s, item, path, f);
    }
    if (status == TOOL_OK && s->given == 0 && s->mode < 0)
        status = tool_fail_set(f, TOOL_FILE, "%s: there is no parameter in it", path);
    s->corrected = !best && cJSON_IsTrue(cJSON_GetObjectItemCaseSensitive(used, "corrected"));
    cJSON_Delete(document);
    return status;
}

cJSON *params_to_json(const stad_params *p)
{
    cJSON *o = cJSON_CreateObject();
    for (int i = 0; i < FIELD_COUNT; i++)
        cJSON_AddNumberToObject(o, params_field_name(i), (double)params_get(p, i));
    return o;
}
