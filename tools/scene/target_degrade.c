/* SPDX-License-Identifier: MIT
 * frames -> [scene/target_degrade.c] -> frames - noise, light and blur, seeded. */
#include "scene/target_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void target_random_seed(target_random *r, uint64_t seed)
{
    r->state = seed * 6364136223846793005u + 1442695040888963407u;
    (void)target_random_uniform(r);
}

/* splitmix64. */
static uint64_t next(target_random *r)
{
    uint64_t z = r->state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

double target_random_uniform(target_random *r)
{
    return (double)(next(r) >> 11) / 9007199254740992.0;
}

double target_random_normal(target_random *r)
{
    const double u = 1 - target_random_uniform(r), v = target_random_uniform(r);
    return sqrt(-2 * log(u)) * cos(6.283185307179586 * v);
}

/* Knuth below 30, else the normal approximation. */
static double poisson(target_random *r, double mean)
{
    if (mean >= 30)
        return fmax(0, floor(mean + sqrt(mean) * target_random_normal(r) + 0.5));
    const double limit = exp(-mean);
    double product = target_random_uniform(r);
    int count = 0;
    for (; product > limit; count++)
        product *= target_random_uniform(r);
    return count;
}

void target_add_noise(float *grey, int count, double sd, target_random *r)
{
    for (int i = 0; i < count; i++)
        grey[i] += (float)(sd * target_random_normal(r));
}

void target_expose(float *grey, int count, double black, double white)
{
    for (int i = 0; i < count; i++)
        grey[i] = (float)(black + grey[i] * (white - black) / 255);
}

void target_quantise(const float *grey, int count, uint8_t *pix)
{
    for (int i = 0; i < count; i++) {
        const float v = floorf(grey[i] + 0.5f);
        pix[i] = (uint8_t)(v < 0 ? 0 : v > 255 ? 255 : v);
    }
}

/* Blurs `count` values `stride` apart; borders repeat. */
static void blur_line(float *p, int count, int stride, const double *kernel, int reach, float *copy)
{
    for (int i = 0; i < count; i++)
        copy[i] = p[i * stride];
    for (int i = 0; i < count; i++) {
        double sum = 0;
        for (int k = -reach; k <= reach; k++) {
            const int n = i + k < 0 ? 0 : i + k >= count ? count - 1 : i + k;
            sum += kernel[k + reach] * copy[n];
        }
        p[i * stride] = (float)sum;
    }
}

void target_blur(float *grey, int width, int height, double sd)
{
    double kernel[65], sum = 0;
    const int reach = (int)fmin(32, ceil(3.5 * sd));
    for (int i = -reach; i <= reach; i++)
        sum += kernel[i + reach] = exp(-0.5 * i * i / (sd * sd));
    for (int i = 0; i <= 2 * reach; i++)
        kernel[i] /= sum;
    float *copy = malloc(sizeof *copy * (size_t)(width > height ? width : height));
    for (int y = 0; y < height; y++)
        blur_line(grey + y * width, width, 1, kernel, reach, copy);
    for (int x = 0; x < width; x++)
        blur_line(grey + x, height, width, kernel, reach, copy);
    free(copy);
}

static void vignette(float *grey, int width, int height, double cx, double cy, double strength)
{
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            const double rx = (x - cx) / (width / 2.0), ry = (y - cy) / (width / 2.0);
            grey[y * width + x] *= (float)fmax(0, 1 - strength * (rx * rx + ry * ry));
        }
}

static void low_light(float *grey, int count, target_random *r)
{
    for (int i = 0; i < count; i++)
        grey[i] = (float)(0.7 * (poisson(r, fmax(0, grey[i]) * 60 / 255) + 1.5 * target_random_normal(r)));
}

const char *target_kind_name(int kind)
{
    static const char *const names[] = {"clean", "noise-5", "noise-10", "noise-20", "gain", "vignette", "low-light", "blur"};
    return kind >= 0 && kind < TARGET_KINDS ? names[kind] : "?";
}

void target_degrade(float *left, float *right, int width, int height, int kind, target_random *r)
{
    static const double noise[] = {0, 5, 10, 20};
    const int count = width * height;
    if (kind >= TARGET_NOISE_5 && kind <= TARGET_NOISE_20) {
        target_add_noise(left, count, noise[kind], r);
        target_add_noise(right, count, noise[kind], r);
    } else if (kind == TARGET_GAIN) {
        for (int i = 0; i < count; i++)
            right[i] = right[i] * 0.7f + 15;
    } else if (kind == TARGET_VIGNETTE) {
        vignette(left, width, height, width / 2.0, height / 2.0, 0.55);
        vignette(right, width, height, 0.6 * width, 0.45 * height, 0.6);
    } else if (kind == TARGET_LOW_LIGHT) {
        low_light(left, count, r);
        low_light(right, count, r);
    } else if (kind == TARGET_BLUR) {
        target_blur(right, width, height, 1.5);
    }
}
