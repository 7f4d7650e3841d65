/* SPDX-License-Identifier: MIT
 * common/raster_png.c - PNG both ways, by libpng.
 *
 * libpng reports by longjmp: nothing here keeps a local variable alive across one except through the `png_job`. */
#include "raster.h"

#include <png.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

#include "picture.h"
#include "whole_file.h"

typedef struct png_job {
    const uint8_t *file; /* reading: what is left of the file */
    size_t left;
    const char *path;
    tool_fail *f;
    png_bytepp rows;
} png_job;

static void on_error(png_structp png, png_const_charp why)
{
    png_job *job = png_get_error_ptr(png);
    tool_fail_set(job->f, TOOL_FILE, "%s: bad PNG: %s", job->path, why);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp why)
{
    (void)png;
    (void)why;
}

static void on_read(png_structp png, png_bytep to, size_t n)
{
    png_job *job = png_get_io_ptr(png);
    if (n > job->left)
        png_error(png, "the file ends too early");
    memcpy(to, job->file, n);
    job->file += n;
    job->left -= n;
}

static int take_rows(png_job *job, raster *r)
{
    size_t stride = (size_t)r->width * (size_t)r->channels * (size_t)(r->bits / 8);
    job->rows = malloc((size_t)r->height * sizeof *job->rows);
    if (!job->rows)
        return 0;
    for (int y = 0; y < r->height; y++)
        job->rows[y] = r->bytes + (size_t)y * stride;
    return 1;
}

static int read_body(png_structp png, png_infop info, png_job *job, raster *r)
{
    png_read_info(png, info);
    png_set_expand(png); /* palette to RGB, few bits to eight */
    png_set_strip_alpha(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    r->width = (int)png_get_image_width(png, info);
    r->height = (int)png_get_image_height(png, info);
    r->channels = png_get_channels(png, info);
    r->bits = png_get_bit_depth(png, info);
    int status = raster_alloc(r, job->path, job->f);
    if (status)
        return status;
    if (!take_rows(job, r))
        return tool_fail_set(job->f, TOOL_FILE, "%s: not enough memory", job->path);
    png_read_image(png, job->rows);
    png_read_end(png, NULL); /* a file cut off after its last pixel is still cut off */
    return TOOL_OK;
}

int raster_read_png(raster *r, const uint8_t *file, size_t size, const char *path, tool_fail *f)
{
    png_job job = {file, size, path, f, NULL};
    png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info) {
        png_destroy_read_struct(&png, NULL, NULL);
        return tool_fail_set(f, TOOL_FILE, "%s: libpng cannot be used", path);
    }
    int status;
    if (setjmp(png_jmpbuf(png))) {
        status = f->status;
    } else {
        png_set_user_limits(png, PICTURE_SIDE_MAX, PICTURE_SIDE_MAX);
        png_set_read_fn(png, &job, on_read);
        status = read_body(png, info, &job, r);
    }
    free(job.rows);
    png_destroy_read_struct(&png, &info, NULL);
    return status;
}

static void write_body(png_structp png, png_infop info, const raster *r, png_bytepp rows)
{
    int colour = r->channels == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY;
    png_set_IHDR(png, info, (png_uint_32)r->width, (png_uint_32)r->height, r->bits, colour, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_write_image(png, rows);
    png_write_end(png, NULL);
}

static int write_stream(FILE *stream, const raster *r, png_job *job)
{
    raster view = *r;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, job, on_error, on_warning);
    png_infop info = png ? png_create_info_struct(png) : NULL;
    if (!info || !take_rows(job, &view)) {
        png_destroy_write_struct(&png, &info);
        return tool_fail_set(job->f, TOOL_FILE, "%s: not enough memory", job->path);
    }
    int status = TOOL_OK;
    if (setjmp(png_jmpbuf(png))) {
        status = job->f->status;
    } else {
        png_init_io(png, stream);
        write_body(png, info, &view, job->rows);
    }
    png_destroy_write_struct(&png, &info);
    return status;
}

int raster_write_png(const raster *r, const char *path, tool_fail *f)
{
    tool_out out;
    png_job job = {NULL, 0, path, f, NULL};
    int status = tool_out_open(&out, path, f);
    if (status)
        return status;
    status = write_stream(out.stream, r, &job);
    free(job.rows);
    return tool_out_close(&out, status == TOOL_OK, f);
}

int raster_png_bytes(const raster *r, char **bytes, size_t *size, tool_fail *f)
{
    png_job job = {NULL, 0, "a picture in memory", f, NULL};
    *bytes = NULL;
    FILE *stream = open_memstream(bytes, size);
    if (!stream)
        return tool_fail_set(f, TOOL_FILE, "not enough memory for a picture");
    int status = write_stream(stream, r, &job);
    free(job.rows);
    if (fclose(stream) && status == TOOL_OK)
        status = tool_fail_set(f, TOOL_FILE, "not enough memory for a picture");
    if (status) {
        free(*bytes);
        *bytes = NULL;
    }
    return status;
}
