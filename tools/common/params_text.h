/* SPDX-License-Identifier: MIT
 * common/params_text.h - stad_params by name: options, JSON, and messages that a person can act on. */
#ifndef TOOL_PARAMS_TEXT_H
#define TOOL_PARAMS_TEXT_H

#include "fail.h"
#include "stad/params.h"

struct cJSON;

#ifdef __cplusplus
extern "C" {
#endif

/* The fields of stad_params, in its order. */
enum params_field {
    FIELD_MIN_DISPARITY,
    FIELD_NUM_DISPARITIES,
    FIELD_BLOCK_SIZE,
    FIELD_P1,
    FIELD_P2,
    FIELD_DISP12_MAX_DIFF,
    FIELD_PRE_FILTER_CAP,
    FIELD_UNIQUENESS_RATIO,
    FIELD_SPECKLE_WINDOW_SIZE,
    FIELD_SPECKLE_RANGE,
    FIELD_COUNT
};

const char *params_field_name(int field);   /* "block_size" */
const char *params_field_option(int field); /* "block-size" */
int params_field_find(const char *name);    /* by name or option; -1: none such */
long params_get(const stad_params *p, int field);
int params_fits(int field, long value);                 /* does the field's type hold it? */
void params_set(stad_params *p, int field, long value); /* `value` fits */

/* Some of the fields, and which. */
typedef struct params_some {
    long value[FIELD_COUNT];
    unsigned given;                /* bit `field` */
    const char *path[FIELD_COUNT]; /* the file it was read from, borrowed; NULL: an option */
    int mode;                      /* enum stad_mode, -1 = not said */
    int corrected;                 /* 1: found for a corrected right view, and the correction is not among the fields */
} params_some;

void params_some_init(params_some *s);

/* "123" to a long; zero when it is anything else. */
int params_number(const char *text, long *value);

/* A value as text. Refused with the option's name when it is no number or outside the field's type. */
int params_some_set(params_some *s, int field, const char *text, tool_fail *f);

/* Lays `over` on `under`. */
void params_some_merge(params_some *under, const params_some *over);

/* The sample's parameters with what is given laid over: block_size and num_disparities first, because p1 and p2 follow from
 * the block. num_disparities, when not given, is an eighth of the width, rounded up to 16, as in OpenCV's sample. */
void params_from_some(stad_params *p, const params_some *s, int width, int channels);

/* sgbm, hh, 3way, hh4 to enum stad_mode and back; -1 and NULL for anything else. */
int params_mode_of(const char *name);
const char *params_mode_name(int mode);

/* stad_params_check() in words: field, option or file (`from` tells), value, and what OpenCV would silently make of it. */
int params_check_text(const stad_params *p, const params_some *from, int mode, int width, tool_fail *f);

/* A JSON document and nothing behind it; NULL with a message otherwise. The caller deletes it. */
struct cJSON *json_read(const char *path, tool_fail *f);

/* Writes a document to a file, whole or not at all, and deletes the document. */
int json_write(const char *path, struct cJSON *document, tool_fail *f);

/* JSON: an object of field names; also the documents that `stad tune` ("best") and `stad simulate` ("in_use") write, and an object with
 * "params". An unknown name is refused, and a name that is there twice. */
int params_read_json(params_some *s, const char *path, tool_fail *f);
struct cJSON *params_to_json(const stad_params *p);

#ifdef __cplusplus
}
#endif

#endif
