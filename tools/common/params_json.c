/* SPDX-License-Identifier: MIT
 * common/params_json.c - parameters as JSON. */
#include "params_text.h"

#include <cjson/cJSON.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "whole_file.h"

#define JSON_FILE_MAX ((size_t)16 << 20)

static int take_mode(params_some *s, const cJSON *item, const char *path, tool_fail *f)
{
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
    double v = cJSON_IsNumber(item) ? item->valuedouble : (double)NAN;
    if (!(fabs(v) < 4e9) || floor(v) != v)
        return tool_fail_set(f, TOOL_FILE, "%s: \"%s\" must be a whole number", path, item->string);
    if (!params_fits(field, (long)v))
        return tool_fail_set(f, TOOL_USAGE, "%s: \"%s\": %.0f is out of range", path, item->string, v);
    s->value[field] = (long)v;
    s->given |= 1u << field;
    return TOOL_OK;
}

/* The object that holds the fields: best.params, params, or the document itself. */
static const cJSON *fields_of(const cJSON *document)
{
    const cJSON *best = cJSON_GetObjectItemCaseSensitive(document, "best");
    const cJSON *params = cJSON_GetObjectItemCaseSensitive(best ? best : document, "params");
    return params ? params : document;
}

int params_read_json(params_some *s, const char *path, tool_fail *f)
{
    unsigned char *text;
    size_t size;
    params_some_init(s);
    int status = tool_read_whole(path, JSON_FILE_MAX, &text, &size, f);
    if (status)
        return status;
    cJSON *document = cJSON_ParseWithLength((const char *)text, size);
    const cJSON *item, *object = fields_of(document);
    if (!cJSON_IsObject(object))
        status = tool_fail_set(f, TOOL_FILE, "%s: not a JSON object of parameters", path);
    else
        cJSON_ArrayForEach(item, object)
        {
            if (status == TOOL_OK)
                status = take_field(s, item, path, f);
        }
    cJSON_Delete(document);
    free(text);
    return status;
}

cJSON *params_to_json(const stad_params *p)
{
    cJSON *o = cJSON_CreateObject();
    for (int i = 0; i < FIELD_COUNT; i++)
        cJSON_AddNumberToObject(o, params_field_name(i), (double)params_get(p, i));
    return o;
}
