/* SPDX-License-Identifier: MIT
 * quad -> [mark/mark_decode.c] -> refine - reads the cells of a quadrilateral and looks the word up.
 *
 * A homography carries the grid of 10 x 10 cells (white ring, black ring, 6 x 6 code) into the image; each cell is the mean of
 * four samples. What is white and what is black is fitted by one plane each over its ring, so shading does no harm. At most
 * four cells of the rings may be wrong. */
#include "mark/mark_work.h"

#include "base/arith.h"

enum { GRID = 10, STRIDE = 12, MAX_WRONG_RING = 4, MIN_RING_CONTRAST = 12 };

/* (x, y) = ((a u + b v + c) / w, (d u + e v + f) / w), w = g u + h v + i; u, v in 1/40 of the black square's side.
 * Widths: corners in Q4 from the first one, < 2^16; g, h, i < 2^34, a, b, d, e < 2^51, times u < 2^6: below 2^58. */
typedef struct homography {
    stad_corner origin;
    int64_t a, b, d, e, g, h, i;
} homography;

static int homography_from(const mark_quad *quad, homography *m)
{
    int64_t x[4], y[4];
    for (int k = 0; k < 4; k++) {
        x[k] = (quad->p[k].x_q8 - quad->p[0].x_q8) / 16;
        y[k] = (quad->p[k].y_q8 - quad->p[0].y_q8) / 16;
    }
    const int64_t sx = x[0] - x[1] + x[2] - x[3], sy = y[0] - y[1] + y[2] - y[3];
    const int64_t dx1 = x[1] - x[2], dx2 = x[3] - x[2], dy1 = y[1] - y[2], dy2 = y[3] - y[2];
    m->origin = quad->p[0];
    m->i = dx1 * dy2 - dx2 * dy1;
    m->g = sx * dy2 - dx2 * sy;
    m->h = dx1 * sy - sx * dy1;
    m->a = x[1] * (m->i + m->g);
    m->b = x[3] * (m->i + m->h);
    m->d = y[1] * (m->i + m->g);
    m->e = y[3] * (m->i + m->h);
    return m->i != 0;
}

/* The image at (u, v) of the square in units of 1/40 side; -1 when the point lies behind the camera. */
static int32_t sample_q8(const mark_work *w, const homography *m, int32_t u, int32_t v)
{
    const int64_t below = m->g * u + m->h * v + m->i * 40;
    if ((below > 0) != (m->i > 0) || below == 0)
        return -1;
    const int64_t x_q4 = (m->a * u + m->b * v) / below, y_q4 = (m->d * u + m->e * v) / below;
    if (x_q4 > 65535 || x_q4 < -65535 || y_q4 > 65535 || y_q4 < -65535)
        return -1;
    return stad_mark_sample_q8(w, m->origin.x_q8 + (int32_t)x_q4 * 16, m->origin.y_q8 + (int32_t)y_q4 * 16);
}

/* Fills the cells, row after row: cell (0, 0) is the top left one of the white ring. A cell is 5 units wide. */
static int read_cells(const mark_work *w, const homography *m)
{
    for (int32_t row = 0; row < GRID; row++)
        for (int32_t column = 0; column < GRID; column++) {
            int32_t sum_q8 = 0;
            for (int32_t k = 0; k < 4; k++) {
                const int32_t s = sample_q8(w, m, column * 5 - 4 + 3 * (k % 2), row * 5 - 4 + 3 * (k / 2));
                if (s < 0)
                    return 0;
                sum_q8 += s;
            }
            w->cells[row * STRIDE + column] = (uint8_t)(sum_q8 / 1024);
        }
    return 1;
}

/* Grey over a ring as a plane: (mean + slope_x (2 column - 9) + slope_y (2 row - 9)), all times `scale`. A ring is symmetric,
 * so the three sums are independent. */
typedef struct ring {
    int32_t cells, squares, sum, sum_x, sum_y;
} ring;

static void ring_fit(const uint8_t *cells, int32_t inset, ring *r)
{
    const int32_t last = GRID - 1 - inset;
    r->cells = r->squares = r->sum = r->sum_x = r->sum_y = 0;
    for (int32_t row = inset; row <= last; row++) {
        const int32_t step = row == inset || row == last ? 1 : last - inset;
        for (int32_t column = inset; column <= last; column += step) {
            const int32_t value = cells[row * STRIDE + column], x = 2 * column - 9;
            r->cells++;
            r->squares += x * x;
            r->sum += value;
            r->sum_x += value * x;
            r->sum_y += value * (2 * row - 9);
        }
    }
}

/* The ring's grey at a cell, Q6. */
static int32_t ring_at_q6(const ring *r, int32_t row, int32_t column)
{
    return r->sum * 64 / r->cells + (r->sum_x * (2 * column - 9) + r->sum_y * (2 * row - 9)) * 64 / r->squares;
}

static int on_ring(int32_t row, int32_t column, int32_t inset)
{
    const int32_t near = min_i32(row, column), far = max_i32(row, column);
    return near == inset || far == GRID - 1 - inset;
}

/* The value of an inner cell with its surroundings taken off by a quarter: undoes some of the blur. Q6. */
static int32_t sharpened_q6(const uint8_t *cell)
{
    const int32_t around = cell[-1] + cell[1] + cell[-STRIDE] + cell[STRIDE];
    return cell[0] * 128 - around * 16;
}

/* The 36 bits in reading order. 1, or 0 when the rings do not look like a mark's. */
static int read_word(const uint8_t *cells, uint64_t *word)
{
    ring white, black;
    ring_fit(cells, 0, &white);
    ring_fit(cells, 1, &black);
    if (white.sum / white.cells - black.sum / black.cells < MIN_RING_CONTRAST)
        return 0;
    int32_t wrong = 0;
    *word = 0;
    for (int32_t row = 0; row < GRID; row++)
        for (int32_t column = 0; column < GRID; column++) {
            const uint8_t *cell = cells + row * STRIDE + column;
            const int32_t limit_q6 = (ring_at_q6(&white, row, column) + ring_at_q6(&black, row, column)) / 2;
            if (on_ring(row, column, 0))
                wrong += cell[0] * 64 < limit_q6;
            else if (on_ring(row, column, 1))
                wrong += cell[0] * 64 >= limit_q6;
            else
                *word = *word * 2 + (uint64_t)(sharpened_q6(cell) >= limit_q6);
        }
    return wrong <= MAX_WRONG_RING;
}

/* The word of the mark turned a quarter: its left column becomes the top row read from below. */
static uint64_t quarter_turn(uint64_t word)
{
    uint64_t turned = 0;
    for (int row = 0; row < 6; row++)
        for (int column = 0; column < 6; column++)
            turned = turned * 2 + (word >> (35 - ((5 - column) * 6 + row)) & 1u);
    return turned;
}

static int16_t bits_set(uint64_t v)
{
    int16_t count = 0;
    for (; v; v &= v - 1)
        count++;
    return count;
}

int stad_mark_cell(int id, int row, int column)
{
    if (row < 0 || row > 7 || column < 0 || column > 7)
        return 1;
    if (row == 0 || row == 7 || column == 0 || column == 7 || id < 0 || id >= STAD_MARK_IDS)
        return 0;
    return (int)(stad_mark_codes[id] >> (35 - ((row - 1) * 6 + column - 1)) & 1u);
}

int stad_mark_decode(const mark_work *w, const mark_quad *quad, stad_mark *mark, int *first_corner)
{
    homography m;
    uint64_t word;
    if (!homography_from(quad, &m) || !read_cells(w, &m) || !read_word(w->cells, &word))
        return 0;
    mark->id = 0;
    mark->hamming = (int16_t)(w->config->max_hamming + 1);
    for (int turn = 0; turn < 4; turn++, word = quarter_turn(word))
        for (int16_t id = 0; id < STAD_MARK_IDS; id++) {
            const int16_t wrong = bits_set(word ^ stad_mark_codes[id]);
            if (wrong >= mark->hamming)
                continue;
            mark->hamming = wrong;
            mark->id = id;
            *first_corner = (4 - turn) % 4;
        }
    return mark->hamming <= w->config->max_hamming && (w->config->ids >> mark->id & 1u);
}
