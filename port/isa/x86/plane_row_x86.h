/* SPDX-License-Identifier: MIT
 * port/isa/x86/plane_row_x86.h - template: prefilter, half-sample ranges and median; the borders and what does not fill a
 * vector are left to C. */

/* x-Sobel of VEC_LANES pixels: lanes stay within +-1020. */
static inline vec gradient_at(const uint8_t *above, const uint8_t *row, const uint8_t *below)
{
    const vec mid = vec_sub(vec_widen(row + 1), vec_widen(row - 1));
    const vec top = vec_sub(vec_widen(above + 1), vec_widen(above - 1));
    const vec low = vec_sub(vec_widen(below + 1), vec_widen(below - 1));
    return vec_add(vec_add(mid, mid), vec_add(top, low));
}

static inline vec clipped(vec g, vec cap)
{
    const vec bound = vec_min(vec_max(g, vec_sub(vec_set(0), cap)), cap);
    return vec_and(vec_add(bound, cap), vec_set(0xFF));
}

void STAD_TIER(stad_prefilter_row)(const uint8_t *above, const uint8_t *row, const uint8_t *below, int32_t width,
                                   int32_t channels, int32_t cap, uint8_t *planes)
{
    const vec c = vec_set(cap);
    uint8_t *gradient = planes, *intensity = planes + width;
    if (channels != 1 || width < 2 * VEC_LANES + 2) {
        STAD_NARROWER(stad_prefilter_row)(above, row, below, width, channels, cap, planes);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += 2 * VEC_LANES) {
        const int32_t at = x < width - 1 - 2 * VEC_LANES ? x : width - 1 - 2 * VEC_LANES, next = at + VEC_LANES;
        const vec a = clipped(gradient_at(above + at, row + at, below + at), c);
        const vec b = clipped(gradient_at(above + next, row + next, below + next), c);
        vec_store(gradient + at, vec_narrow(a, b));
        vec_store(intensity + at, vec_load(row + at));
    }
    gradient[0] = gradient[width - 1] = intensity[0] = intensity[width - 1] = (uint8_t)(cap & 0xFF);
}

/* (a + b) / 2 rounded down, in bytes. */
static inline vec mean(vec a, vec b)
{
    const vec odd = vec_and(vec_xor(a, b), vec_set_u8(1));
    return vec_sub_floor_u8(vec_mean_up_u8(a, b), odd);
}

/* One column of the borders, by the definition. */
static inline void range_at(const uint8_t *plane, int32_t width, int32_t x, int32_t to, uint8_t *out)
{
    const int here = plane[x], before = (here + plane[x > 0 ? x - 1 : x]) / 2;
    const int after = (here + plane[x < width - 1 ? x + 1 : x]) / 2;
    const int low = before < after ? before : after, high = before < after ? after : before;
    out[to] = (uint8_t)here;
    out[width + to] = (uint8_t)(low < here ? low : here);
    out[2 * (ptrdiff_t)width + to] = (uint8_t)(high > here ? high : here);
}

void STAD_TIER(stad_range_row)(const uint8_t *plane, int32_t width, int reverse, uint8_t *out)
{
    const int32_t block = 2 * VEC_LANES;
    if (width < block + 2) {
        STAD_NARROWER(stad_range_row)(plane, width, reverse, out);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += block) {
        const int32_t at = x < width - 1 - block ? x : width - 1 - block;
        const int32_t to = reverse ? width - at - block : at;
        const vec here = vec_load(plane + at);
        const vec before = mean(here, vec_load(plane + at - 1)), after = mean(here, vec_load(plane + at + 1));
        const vec low = vec_min_u8(here, vec_min_u8(before, after)), high = vec_max_u8(here, vec_max_u8(before, after));
        vec_store(out + to, reverse ? vec_reverse_u8(here) : here);
        vec_store(out + width + to, reverse ? vec_reverse_u8(low) : low);
        vec_store(out + 2 * (ptrdiff_t)width + to, reverse ? vec_reverse_u8(high) : high);
    }
    range_at(plane, width, 0, reverse ? width - 1 : 0, out);
    range_at(plane, width, width - 1, reverse ? 0 : width - 1, out);
}

typedef struct triple {
    vec low, mid, high;
} triple;

static inline triple sorted_at(const int16_t *above, const int16_t *row, const int16_t *below, int32_t x)
{
    const vec a = vec_load(above + x), b = vec_load(row + x), c = vec_load(below + x);
    const vec low = vec_min(a, b), high = vec_max(a, b);
    triple t = {vec_min(low, c), vec_max(low, vec_min(high, c)), vec_max(high, c)};
    return t;
}

static inline vec median_of(vec a, vec b, vec c)
{
    return vec_max(vec_min(a, b), vec_min(vec_max(a, b), c));
}

/* The borders by C on three columns each, so that their neighbours outside are replicated by one piece of code. */
void STAD_TIER(stad_median_row)(const int16_t *above, const int16_t *row, const int16_t *below, int32_t width, int16_t *out)
{
    int16_t edge[3];
    if (width < VEC_LANES + 2) {
        STAD_NARROWER(stad_median_row)(above, row, below, width, out);
        return;
    }
    for (int32_t x = 1; x < width - 1; x += VEC_LANES) {
        const int32_t at = x < width - 1 - VEC_LANES ? x : width - 1 - VEC_LANES;
        const triple l = sorted_at(above, row, below, at - 1), m = sorted_at(above, row, below, at);
        const triple r = sorted_at(above, row, below, at + 1);
        const vec low = vec_max(l.low, vec_max(m.low, r.low)), high = vec_min(l.high, vec_min(m.high, r.high));
        vec_store(out + at, median_of(low, median_of(l.mid, m.mid, r.mid), high));
    }
    stad_median_row_c(above, row, below, 3, edge);
    out[0] = edge[0];
    stad_median_row_c(above + width - 3, row + width - 3, below + width - 3, 3, edge);
    out[width - 1] = edge[2];
}
