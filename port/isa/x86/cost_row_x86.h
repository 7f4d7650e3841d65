/* SPDX-License-Identifier: MIT
 * port/isa/x86/cost_row_x86.h - template: pixel costs, 2 * VEC_LANES disparities at once, in bytes. */

/* A left sample and its range in all lanes, and where the right row's samples begin. */
typedef struct plane_pair {
    vec value, low, high;
    const uint8_t *right;
    ptrdiff_t width;
} plane_pair;

static inline plane_pair pair_at(const stad_cost_job *job, int32_t plane, int32_t x)
{
    const ptrdiff_t width = job->width;
    const uint8_t *left = job->left + plane * 3 * width + x;
    plane_pair pair = {vec_set_u8(left[0]), vec_set_u8(left[width]), vec_set_u8(left[2 * width]),
                       job->right + plane * 3 * width + (width - 1 - x + job->min_disparity), width};
    return pair;
}

static inline vec distance(const plane_pair *p, int32_t d)
{
    const vec value = vec_load(p->right + d), low = vec_load(p->right + p->width + d);
    const vec high = vec_load(p->right + 2 * p->width + d);
    const vec to_right = vec_max_u8(vec_sub_floor_u8(p->value, high), vec_sub_floor_u8(low, p->value));
    const vec to_left = vec_max_u8(vec_sub_floor_u8(value, p->high), vec_sub_floor_u8(p->low, value));
    return vec_min_u8(to_right, to_left);
}

static inline vec channel_cost(const plane_pair *gradient, const plane_pair *intensity, int32_t d)
{
    const vec quarter = vec_and(vec_shift_right(distance(intensity, d), 2), vec_set_u8(0x3F));
    return vec_add_u8(distance(gradient, d), quarter);
}

/* The disparities that do not fill a vector of bytes, in C: a job of their own, pixel by pixel. */
static inline stad_cost_job rest_job(const stad_cost_job *job, int32_t x, int32_t done)
{
    stad_cost_job rest = *job;
    rest.x = x;
    rest.count = 1;
    rest.min_disparity += done;
    rest.disparities -= done;
    return rest;
}

void STAD_TIER(stad_cost_row_u8)(const stad_cost_job *job, uint8_t *cost)
{
    const int32_t n = job->disparities, whole = n - n % (2 * VEC_LANES);
    for (int32_t i = 0; i < job->count; i++, cost += n) {
        for (int32_t c = 0; c < job->channels && whole > 0; c++) {
            const plane_pair gradient = pair_at(job, c, job->x + i);
            const plane_pair intensity = pair_at(job, job->channels + c, job->x + i);
            for (int32_t d = 0; d < whole; d += 2 * VEC_LANES) {
                const vec here = channel_cost(&gradient, &intensity, d);
                vec_store(cost + d, c == 0 ? here : vec_add_u8(here, vec_load(cost + d)));
            }
        }
        if (whole < n) {
            const stad_cost_job rest = rest_job(job, job->x + i, whole);
            STAD_NARROWER(stad_cost_row_u8)(&rest, cost + whole);
        }
    }
}

/* A gradient cost above 255 - 63 plus a quarter of an intensity cost leaves the byte: here the sum is made in 16 bits. */
void STAD_TIER(stad_cost_row_u16)(const stad_cost_job *job, uint16_t *cost)
{
    const int32_t n = job->disparities, whole = n - n % (2 * VEC_LANES);
    for (int32_t i = 0; i < job->count; i++, cost += n) {
        for (int32_t c = 0; c < job->channels && whole > 0; c++) {
            const plane_pair gradient = pair_at(job, c, job->x + i);
            const plane_pair intensity = pair_at(job, job->channels + c, job->x + i);
            for (int32_t d = 0; d < whole; d += 2 * VEC_LANES) {
                const vec g = distance(&gradient, d);
                const vec q = vec_and(vec_shift_right(distance(&intensity, d), 2), vec_set_u8(0x3F));
                vec low = vec_add(vec_low_half(g), vec_low_half(q)), high = vec_add(vec_high_half(g), vec_high_half(q));
                if (c > 0) {
                    low = vec_add(low, vec_load(cost + d));
                    high = vec_add(high, vec_load(cost + d + VEC_LANES));
                }
                vec_store(cost + d, low);
                vec_store(cost + d + VEC_LANES, high);
            }
        }
        if (whole < n) {
            const stad_cost_job rest = rest_job(job, job->x + i, whole);
            STAD_NARROWER(stad_cost_row_u16)(&rest, cost + whole);
        }
    }
}
