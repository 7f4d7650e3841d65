/* SPDX-License-Identifier: MIT
 * support/reference.c - docs/SPEC.md sections 1 to 9 by the letter: C, L, S are the volumes of the text.
 *
 * Read beside the specification; names are its letters. Slow on purpose. */
#include "reference.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#define MX 32767

typedef struct ref {
    int w, h, cn, mode;
    unsigned mend;
    int minD, D, r, F, P1, P2, U, M12, rawBlock;
    int X0, X1, W;
    int checkOff;
    const uint8_t *I, *J;
    uint8_t *planeL, *planeR; /* one row: 2 * cn planes of w bytes */
    int *e;                   /* pixel costs of every row: h * W * D */
    int16_t *hs;              /* horizontal sums: h * W * D */
    int16_t *C, *S;           /* volumes: h * W * D */
    int16_t *L;               /* path costs of one direction: h * W * D */
    int *m;                   /* their minima: h * W */
    int ytop, yend;           /* rows of the stripe at work */
    reference_extras *x;      /* never NULL */
} ref;

static const char *const mend_names[MEND_COUNT] = {
    "saturation", "border-intensity", "hh4-last-rows", "3way-ties",  "3way-lanes", "3way-uniqueness", "unset-right", "check-off",
    "median",     "3way-block",       "subpixel",      "3way-shift", "cost-order", "path-order",      "cost-gate"};

const char *reference_mend_name(int i)
{
    return i >= 0 && i < MEND_COUNT ? mend_names[i] : NULL;
}

static int clampi(int v, int a, int b)
{
    return v < a ? a : v > b ? b : v;
}

static int mini(int a, int b)
{
    return a < b ? a : b;
}

static int maxi(int a, int b)
{
    return a > b ? a : b;
}

/* Low 16 bits as a signed number. */
static int w16(int v)
{
    int u = (int)((unsigned)v & 0xffffu);
    return u > MX ? u - 65536 : u;
}

static int sat(const ref *R, int v)
{
    return R->mend & MEND_SATURATION ? w16(v) : clampi(v, -32768, MX);
}

/* ---- section 1: parameters ---- */

static int setup(ref *R, const stad_params *p)
{
    int maxD = p->min_disparity + p->num_disparities;
    int defaultBlock = R->mode == STAD_MODE_3WAY && !(R->mend & MEND_3WAY_BLOCK) ? 3 : 5;
    R->minD = p->min_disparity;
    R->D = p->num_disparities;
    R->rawBlock = p->block_size;
    R->r = (p->block_size > 0 ? p->block_size : defaultBlock) / 2;
    R->F = maxi(p->pre_filter_cap, 15) | 1;
    R->P1 = p->p1 > 0 ? p->p1 : 2;
    R->P2 = maxi(p->p2 > 0 ? p->p2 : 5, R->P1 + 1);
    R->U = p->uniqueness_ratio >= 0 ? p->uniqueness_ratio : 10;
    R->M12 = p->disp12_max_diff > 0 ? p->disp12_max_diff : 1;
    R->checkOff = (R->mend & MEND_CHECK_OFF) && p->disp12_max_diff <= 0;
    R->X0 = maxi(maxD, 0);
    R->X1 = R->w + mini(R->minD, 0);
    R->W = R->X1 - R->X0;
    return R->W > 0 ? 0 : -1;
}

static int inv(const ref *R)
{
    return (R->minD - 1) * 16;
}

static size_t cell(const ref *R, int y, int x)
{
    return ((size_t)y * (size_t)R->W + (size_t)x) * (size_t)R->D;
}

/* ---- sections 2 and 3: features and pixel cost ---- */

static void feature_planes(const ref *R, const uint8_t *img, int y, uint8_t *planes)
{
    int w = R->w, cn = R->cn, up = maxi(y - 1, 0), down = mini(y + 1, R->h - 1);
    for (int c = 0; c < cn; c++) {
        uint8_t *G = planes + c * w, *V = planes + (cn + c) * w;
#define PX(yy, xx) ((int)img[((yy) * w + (xx)) * cn + c])
        for (int x = 0; x < w; x++) {
            int edge = x == 0 || x == w - 1, g = 0;
            if (!edge) {
                g = 2 * (PX(y, x + 1) - PX(y, x - 1)) + PX(up, x + 1) - PX(up, x - 1) + PX(down, x + 1) - PX(down, x - 1);
            }
            G[x] = (uint8_t)((clampi(g, -R->F, R->F) + R->F) & 255);
            V[x] = (uint8_t)(edge && !(R->mend & MEND_BORDER_INTENSITY) ? R->F & 255 : PX(y, x));
        }
#undef PX
    }
}

static void half_range(const uint8_t *a, int w, int x, int *lo, int *hi)
{
    int l = x > 0 ? (a[x] + a[x - 1]) / 2 : a[x], q = x < w - 1 ? (a[x] + a[x + 1]) / 2 : a[x];
    *lo = mini(a[x], mini(l, q));
    *hi = maxi(a[x], maxi(l, q));
}

static int plane_cost(const uint8_t *a, const uint8_t *b, int w, int xl, int xr)
{
    int u = a[xl], v = b[xr], u0, u1, v0, v1;
    half_range(a, w, xl, &u0, &u1);
    half_range(b, w, xr, &v0, &v1);
    return mini(maxi(0, maxi(u - v1, v0 - u)), maxi(0, maxi(v - u1, u0 - v)));
}

static void pixel_costs(const ref *R, int y)
{
    feature_planes(R, R->I, y, R->planeL);
    feature_planes(R, R->J, y, R->planeR);
    for (int x = 0; x < R->W; x++) {
        for (int d = 0; d < R->D; d++) {
            int sum = 0;
            for (int k = 0; k < 2 * R->cn; k++) {
                int xl = x + R->X0, xr = xl - (R->minD + d);
                int cost = plane_cost(R->planeL + k * R->w, R->planeR + k * R->w, R->w, xl, xr);
                sum += k < R->cn ? cost : cost >> 2;
            }
            R->e[cell(R, y, x) + (size_t)d] = sum;
        }
    }
}

/* ---- section 4: block cost by the sliding recurrences ---- */

static int pixel(const ref *R, int k, int x, int d)
{
    return R->e[cell(R, k, clampi(x, 0, R->W - 1)) + (size_t)d];
}

static int add_sub(const ref *R, int v, int add, int sub, int add_first)
{
    int side = 2 * R->r + 1, top = R->cn * (mini(2 * R->F, 255) + 63);
    if ((R->mend & MEND_COST_GATE) && R->P2 + side * side * top <= MX) {
        return v + add - sub;
    }
    if (add_first != ((R->mend & MEND_COST_ORDER) != 0)) {
        return sat(R, sat(R, v + add) - sub);
    }
    return sat(R, sat(R, v - sub) + add);
}

static void horizontal_sums(const ref *R, int k, int d)
{
    int r = R->r, add_first = R->mode == STAD_MODE_3WAY || k <= R->ytop + r, v;
    int16_t *hs = R->hs + cell(R, k, 0) + d;
    if (R->mode == STAD_MODE_HH4) {
        v = 0;
        for (int i = -r; i <= r; i++) {
            v = sat(R, v + pixel(R, k, i, d));
        }
    } else {
        v = sat(R, pixel(R, k, 0, d) * (r + 1));
        for (int i = 1; i <= r; i++) {
            v = sat(R, v + pixel(R, k, i, d));
        }
    }
    hs[0] = (int16_t)v;
    for (int x = 1; x < R->W; x++) {
        v = add_sub(R, v, pixel(R, k, x + r, d), pixel(R, k, x - r - 1, d), add_first);
        hs[(size_t)x * (size_t)R->D] = (int16_t)v;
    }
}

static void block_costs(const ref *R, int d)
{
    int r = R->r, last = R->h - 1, drop = R->mode == STAD_MODE_HH4 && !(R->mend & MEND_HH4_LAST_ROWS);
    for (int x = 0; x < R->W; x++) {
#define HS(k) ((int)R->hs[cell(R, (k), x) + (size_t)d])
        int c = w16(R->P2);
        for (int k = R->ytop; k <= R->ytop + r; k++) {
            c = sat(R, c + (k == R->ytop ? sat(R, HS(k) * (r + 1)) : HS(mini(k, last))));
        }
        R->C[cell(R, R->ytop, x) + (size_t)d] = (int16_t)c;
        for (int y = R->ytop + 1; y < R->yend; y++) {
            int a = HS(mini(y + r, last)), b = HS(maxi(y - r - 1, R->ytop));
            int add_first = R->mode == STAD_MODE_3WAY || (x == 0 && y + r < R->h);
            c = drop && y + r >= R->h ? w16(R->P2) : add_sub(R, c, a, b, add_first);
            R->C[cell(R, y, x) + (size_t)d] = (int16_t)c;
        }
#undef HS
    }
}

static void cost_volume(ref *R, int ytop, int yend)
{
    R->ytop = ytop;
    R->yend = yend;
    for (int d = 0; d < R->D; d++) {
        for (int k = ytop; k < R->h; k++) {
            horizontal_sums(R, k, d);
        }
        block_costs(R, d);
    }
}

/* ---- sections 5 and 6: paths ---- */

static void path_step(const ref *R, const int16_t *p, int m, const int16_t *C, int16_t *L, int *minimum)
{
    int way3 = R->mode == STAD_MODE_3WAY, best = MX;
    int delta = way3 ? sat(R, m + R->P2) : w16(m + R->P2), pi = way3 ? sat(R, R->P1) : w16(R->P1);
    for (int d = 0; d < R->D; d++) {
        int left = d > 0 ? p[d - 1] : MX, right = d < R->D - 1 ? p[d + 1] : MX;
        int t = mini(p[d], delta);
        /* beyond the ends stands infinity, which must not wrap where saturation is mended */
        t = d > 0 ? mini(t, sat(R, left + pi)) : t;
        t = d < R->D - 1 ? mini(t, sat(R, right + pi)) : t;
        L[d] = (int16_t)sat(R, sat(R, t - delta) + C[d]);
        best = mini(best, L[d]);
    }
    *minimum = best;
}

/* Walks one direction over the rows of the stripe and adds it to S. */
static void add_path(const ref *R, int dx, int dy)
{
    static const int16_t zeros[4096];
    int rows = R->yend - R->ytop;
    for (int i = 0; i < rows; i++) {
        int y = dy > 0 ? R->yend - 1 - i : R->ytop + i;
        for (int j = 0; j < R->W; j++) {
            int x = dx > 0 ? R->W - 1 - j : j, px = x + dx, py = y + dy;
            int inside = px >= 0 && px < R->W && py >= R->ytop && py < R->yend;
            const int16_t *p = inside ? R->L + cell(R, py, px) : zeros;
            int m = inside ? R->m[py * R->W + px] : 0;
            size_t here = cell(R, y, x);
            path_step(R, p, m, R->C + here, R->L + here, &R->m[y * R->W + x]);
            for (int d = 0; d < R->D; d++) {
                size_t q = here + (size_t)d;
                R->S[q] = (int16_t)sat(R, R->S[q] + R->L[q]);
            }
        }
    }
}

static void aggregate(const ref *R)
{
    static const signed char order[4][9][2] = {
        {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}},
        {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}},
        {{1, 0}, {-1, 0}, {0, -1}},
        {{0, -1}, {0, 1}, {-1, 0}, {1, 0}},
    };
    size_t from = cell(R, R->ytop, 0), to = cell(R, R->yend, 0);
    int n = 0;
    memset(R->S + from, 0, (to - from) * sizeof *R->S);
    while (order[R->mode][n][0] || order[R->mode][n][1]) {
        n++;
    }
    for (int k = 0; k < n; k++) {
        int i = R->mend & MEND_PATH_ORDER ? n - 1 - k : k;
        add_path(R, order[R->mode][i][0], order[R->mode][i][1]);
    }
}

/* ---- section 8: from S to disparity ---- */

static int best_of(const ref *R, const int16_t *S, int *minS)
{
    int b = -1, lanes = R->mend & MEND_3WAY_LANES ? 16 : 8, first = INT_MAX;
    *minS = MX;
    if (R->mode != STAD_MODE_3WAY || (R->mend & MEND_3WAY_TIES)) {
        for (int d = 0; d < R->D; d++) {
            if (S[d] < *minS) {
                *minS = S[d];
                b = d;
            }
        }
        return b;
    }
    for (int d = 0; d < R->D; d++) {
        *minS = mini(*minS, S[d]);
    }
    for (int lane = 0; lane < lanes; lane++) {
        int largest = -1;
        for (int d = lane; d < R->D; d += lanes) {
            largest = S[d] == *minS ? d : largest;
        }
        first = largest >= 0 ? mini(first, largest) : first;
    }
    return first;
}

/* The least cost outside +-1 of the winner. */
static int runner_up(const ref *R, const int16_t *S, int b)
{
    int least = MX;
    for (int d = 0; d < R->D; d++) {
        least = abs(b - d) > 1 ? mini(least, S[d]) : least;
    }
    return least;
}

static int confidence_of(const ref *R, const int16_t *S, int b, int minS)
{
    int rival = runner_up(R, S, b);
    return rival > 0 && minS < rival ? (rival - maxi(minS, 0)) * 255 / rival : 0;
}

static int unique(const ref *R, const int16_t *S, int b, int minS)
{
    int way3 = R->mode == STAD_MODE_3WAY && !(R->mend & MEND_3WAY_UNIQUENESS);
    int limit = way3 ? w16(100 * minS / (100 - R->U) + 1) : 0;
    if (R->mode == STAD_MODE_3WAY && R->U == 0) {
        return 1;
    }
    for (int d = 0; d < R->D; d++) {
        int rival = way3 ? S[d] < limit : S[d] * (100 - R->U) < minS * 100;
        if (abs(b - d) > 1 && rival) {
            return 0;
        }
    }
    return 1;
}

static int subpixel(const ref *R, const int16_t *S, int b)
{
    int n, a;
    if (b <= 0 || b >= R->D - 1) {
        return 16 * b;
    }
    n = maxi(S[b - 1] + S[b + 1] - 2 * S[b], 1);
    a = (S[b - 1] - S[b + 1]) * 16 + n;
    if ((R->mend & MEND_SUBPIXEL) && a < 0) {
        a -= 2 * n - 1;
    }
    return 16 * b + a / (2 * n);
}

static int disagrees(const ref *R, const int *D2, int x, int k)
{
    int xr = x - k;
    if (xr < 0 || xr >= R->w || D2[xr] < R->minD) {
        return 0;
    }
    if ((R->mend & MEND_UNSET_RIGHT) && D2[xr] == w16(inv(R))) {
        return 0;
    }
    return abs(D2[xr] - k) > R->M12;
}

/* y: row of S; i: row of the map. */
static void select_row(const ref *R, int y, int i, int *D2, int *C2, int16_t *out)
{
    uint8_t *confidence = R->x->confidence ? R->x->confidence + (size_t)i * (size_t)R->w : NULL;
    int16_t *right = R->x->right_q4 ? R->x->right_q4 + (size_t)i * (size_t)R->w : NULL;
    for (int x = 0; x < R->w; x++) {
        D2[x] = w16(inv(R));
        C2[x] = MX;
        out[x] = (int16_t)w16(inv(R));
    }
    for (int x = R->W - 1; x >= 0; x--) {
        const int16_t *S = R->S + cell(R, y, x);
        int minS, b = best_of(R, S, &minS), xr = x + R->X0 - (b + R->minD);
        R->x->firm += runner_up(R, S, b) * 75 >= minS * 100;
        if (!unique(R, S, b, minS)) {
            R->x->rejected_uniqueness++;
            continue;
        }
        if (confidence) {
            confidence[x + R->X0] = (uint8_t)confidence_of(R, S, b, minS);
        }
        if (xr >= 0 && xr < R->w && C2[xr] > minS) {
            C2[xr] = minS;
            D2[xr] = b + R->minD;
        }
        out[x + R->X0] = (int16_t)w16(subpixel(R, S, b) + 16 * R->minD);
    }
    for (int x = R->X0; x < R->X1 && !R->checkOff; x++) {
        int v = out[x];
        if (v != w16(inv(R)) && disagrees(R, D2, x, v >> 4) && disagrees(R, D2, x, (v + 15) >> 4)) {
            out[x] = (int16_t)w16(inv(R));
            R->x->rejected_check++;
        }
    }
    for (int x = 0; x < R->w; x++) {
        R->x->valid += out[x] != w16(inv(R));
        if (confidence && out[x] == w16(inv(R))) {
            confidence[x] = 0;
        }
        if (right) {
            right[x] = (int16_t)(C2[x] == MX ? w16(inv(R)) : D2[x] * 16);
        }
    }
}

/* ---- section 7: stripes, section 9: post-filters ---- */

static void match_whole(ref *R, int *D2, int *C2, int16_t *out)
{
    cost_volume(R, 0, R->h);
    aggregate(R);
    for (int y = 0; y < R->h; y++) {
        select_row(R, y, y, D2, C2, out + (size_t)y * (size_t)R->w);
    }
}

static void match_stripes(ref *R, int *D2, int *C2, int16_t *out, int16_t *row)
{
    int h = R->h, sz = (h + 3) / 4, ov = R->rawBlock / 2 + 1 + (sz + 9) / 10;
    for (int s = 0; s < 4; s++) {
        int ys = clampi(s * sz - ov, 0, h), ye = mini((s + 1) * sz, h);
        if (ys >= ye) {
            continue;
        }
        cost_volume(R, ys, ye);
        aggregate(R);
        for (int y = ys; y < ye; y++) {
            int i = R->mend & MEND_3WAY_SHIFT ? y : s * sz + (y - ys) + (s == 0 ? ov : 0) - ov;
            if (i >= s * sz && i < ye) {
                select_row(R, y, i, D2, C2, row);
                memcpy(out + (size_t)i * (size_t)R->w, row, (size_t)R->w * sizeof *row);
            }
        }
    }
}

static void median(const ref *R, const int16_t *in, int16_t *out)
{
    for (int y = 0; y < R->h; y++) {
        for (int x = 0; x < R->w; x++) {
            int16_t v[9];
            for (int k = 0; k < 9; k++) {
                int yy = clampi(y + k / 3 - 1, 0, R->h - 1), xx = clampi(x + k % 3 - 1, 0, R->w - 1), j = k;
                int16_t t = in[yy * R->w + xx];
                for (; j > 0 && v[j - 1] > t; j--) {
                    v[j] = v[j - 1];
                }
                v[j] = t;
            }
            out[y * R->w + x] = v[4];
        }
    }
}

/* Grows the component of `start`; its pixels stay listed in `queue`. Returns how many there are. */
static int component(const ref *R, const int16_t *out, int range_q4, int start, char *seen, int *queue)
{
    static const int step[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int count = 1;
    queue[0] = start;
    seen[start] = 1;
    for (int i = 0; i < count; i++) {
        int x = queue[i] % R->w, y = queue[i] / R->w;
        for (int k = 0; k < 4; k++) {
            int xx = x + step[k][0], yy = y + step[k][1], q = yy * R->w + xx;
            if (xx < 0 || yy < 0 || xx >= R->w || yy >= R->h || seen[q] || out[q] == w16(inv(R)) ||
                abs(out[q] - out[queue[i]]) > range_q4) {
                continue;
            }
            seen[q] = 1;
            queue[count++] = q;
        }
    }
    return count;
}

static void speckle(const ref *R, int size, int range_q4, int16_t *out, char *seen, int *queue)
{
    memset(seen, 0, (size_t)R->w * (size_t)R->h);
    for (int i = 0; i < R->w * R->h; i++) {
        int count = seen[i] || out[i] == w16(inv(R)) ? INT_MAX : component(R, out, range_q4, i, seen, queue);
        for (int j = 0; count <= size && j < count; j++) {
            out[queue[j]] = (int16_t)w16(inv(R));
            R->x->rejected_speckle++;
        }
    }
}

static void *grab(size_t count, size_t size, int *failed)
{
    void *p = calloc(count, size);
    *failed |= p == NULL;
    return p;
}

int reference_match(const stad_params *raw, int mode, unsigned mends, const uint8_t *left, const uint8_t *right, int width,
                    int height, int channels, int16_t *disp_q4)
{
    reference_extras none = {0, 0, 0, 0, 0, 0, NULL, NULL};
    return reference_match_extras(raw, mode, mends, left, right, width, height, channels, disp_q4, &none);
}

int reference_match_extras(const stad_params *raw, int mode, unsigned mends, const uint8_t *left, const uint8_t *right, int width,
                           int height, int channels, int16_t *disp_q4, reference_extras *extras)
{
    ref R = {.w = width, .h = height, .cn = channels, .mode = mode, .mend = mends, .I = left, .J = right, .x = extras};
    size_t n, px = (size_t)width * (size_t)height;
    int *D2, *C2, *queue, failed = 0;
    int16_t *row, *map;
    char *seen;
    if (setup(&R, raw) < 0) {
        return -1;
    }
    n = cell(&R, height, 0);
    R.planeL = grab((size_t)(2 * channels * width), 1, &failed);
    R.planeR = grab((size_t)(2 * channels * width), 1, &failed);
    R.e = grab(n, sizeof *R.e, &failed);
    R.hs = grab(n, 2, &failed);
    R.C = grab(n, 2, &failed);
    R.S = grab(n, 2, &failed);
    R.L = grab(n, 2, &failed);
    R.m = grab(px, sizeof *R.m, &failed);
    D2 = grab((size_t)width, sizeof *D2, &failed);
    C2 = grab((size_t)width, sizeof *C2, &failed);
    row = grab((size_t)width, 2, &failed);
    map = grab(px, 2, &failed);
    queue = grab(px, sizeof *queue, &failed);
    seen = grab(px, 1, &failed);
    if (!failed) {
        for (int y = 0; y < height; y++) {
            pixel_costs(&R, y);
        }
        for (size_t i = 0; i < px; i++) {
            map[i] = (int16_t)w16(inv(&R));
        }
        extras->considered = R.W * height;
        for (size_t i = 0; i < px && extras->right_q4; i++) {
            extras->right_q4[i] = (int16_t)w16(inv(&R)); /* rows that no stripe writes */
        }
        if (mode == STAD_MODE_3WAY) {
            match_stripes(&R, D2, C2, map, row);
        } else {
            match_whole(&R, D2, C2, map);
        }
        if (mends & MEND_MEDIAN) {
            memcpy(disp_q4, map, px * 2);
        } else {
            median(&R, map, disp_q4);
        }
        if (raw->speckle_window_size > 0) {
            speckle(&R, raw->speckle_window_size, 16 * raw->speckle_range, disp_q4, seen, queue);
        }
    }
    free(R.planeL), free(R.planeR), free(R.e), free(R.hs), free(R.C), free(R.S), free(R.L), free(R.m);
    free(D2), free(C2), free(row), free(map), free(queue), free(seen);
    return failed ? -1 : 0;
}
