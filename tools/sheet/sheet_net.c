/* SPDX-License-Identifier: MIT
 * target table -> [sheet/sheet_net.c] -> pages - unfolds a part: facets side by side, walls folded out, flaps to
 * glue.
 *
 * Every piece after the first is attached along an edge that is on the page already: a point of the new piece keeps
 * its distance from the edge and its place along it. */
#include "sheet.h"

#include <math.h>

#define FLAP_MM 8.0

typedef struct solid {
    double x, y, z;
} solid;

static solid corner(const stad_target_facet *f, int i)
{
    solid p = {f->x_mm[i & 3], f->y_mm[i & 3], f->h_mm[i & 3]};
    return p;
}

static solid foot(solid p)
{
    p.z = 0;
    return p;
}

static solid minus(solid a, solid b)
{
    solid d = {a.x - b.x, a.y - b.y, a.z - b.z};
    return d;
}

static double dot(solid a, solid b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static double length(solid a)
{
    return sqrt(dot(a, a));
}

double sheet_edge_mm(const stad_target_facet *f, int edge)
{
    return length(minus(corner(f, edge + 1), corner(f, edge)));
}

/* An edge in space and on the page; new pieces go to the side of `out`, a unit normal on the page. */
typedef struct hinge {
    solid a, along; /* unit */
    sheet_point p, e, out;
} hinge;

static hinge hinge_of(solid a, solid b, sheet_point pa, sheet_point pb, sheet_point inside)
{
    hinge h;
    double mm = length(minus(b, a));
    h.a = a;
    h.along = minus(b, a);
    h.along.x /= mm;
    h.along.y /= mm;
    h.along.z /= mm;
    h.p = pa;
    h.e.x = (pb.x - pa.x) / mm;
    h.e.y = (pb.y - pa.y) / mm;
    h.out.x = h.e.y;
    h.out.y = -h.e.x;
    if ((inside.x - pa.x) * h.out.x + (inside.y - pa.y) * h.out.y > 0) {
        h.out.x = -h.out.x;
        h.out.y = -h.out.y;
    }
    return h;
}

static sheet_point unfolded(const hinge *h, solid q)
{
    solid d = minus(q, h->a);
    double along = dot(d, h->along), square = dot(d, d) - along * along;
    double off = square > 0 ? sqrt(square) : 0;
    sheet_point p = {h->p.x + along * h->e.x + off * h->out.x, h->p.y + along * h->e.y + off * h->out.y};
    return p;
}

static sheet_point centre(const sheet_piece *p)
{
    sheet_point c = {0, 0};
    for (int i = 0; i < p->count; i++) {
        c.x += p->p[i].x / p->count;
        c.y += p->p[i].y / p->count;
    }
    return c;
}

static sheet_piece *new_piece(sheet_net *net, int kind, int facet)
{
    static sheet_piece overflow;
    sheet_piece *piece = net->count < SHEET_PIECES ? &net->piece[net->count++] : &overflow;
    piece->kind = kind;
    piece->count = 0;
    piece->facet = facet;
    piece->folds = 0;
    return piece;
}

/* A flap on edge i of a piece, away from it: a trapezoid. */
static void add_flap(sheet_net *net, sheet_piece *on, int i)
{
    sheet_point a = on->p[i], b = on->p[(i + 1) % on->count], c = centre(on);
    double mm = hypot(b.x - a.x, b.y - a.y), in = mm < 4 * FLAP_MM ? mm / 4 : FLAP_MM;
    double ex = (b.x - a.x) / mm, ey = (b.y - a.y) / mm;
    double side = (c.x - a.x) * ey - (c.y - a.y) * ex > 0 ? -1 : 1;
    sheet_piece *flap = new_piece(net, SHEET_FLAP, on->facet);
    sheet_point p[4] = {a,
                        b,
                        {b.x - in * ex + side * FLAP_MM * ey, b.y - in * ey - side * FLAP_MM * ex},
                        {a.x + in * ex + side * FLAP_MM * ey, a.y + in * ey - side * FLAP_MM * ex}};
    flap->count = 4;
    for (int k = 0; k < 4; k++)
        flap->p[k] = p[k];
    flap->folds = 1;
    on->folds |= 1 << i;
}

/* The wall under edge i of a facet, with a flap on its foot and one on its far side. */
static void add_wall(sheet_net *net, sheet_piece *top, const stad_target_facet *f, int i)
{
    solid a = corner(f, i), b = corner(f, i + 1);
    hinge h = hinge_of(a, b, top->p[i], top->p[(i + 1) & 3], centre(top));
    sheet_piece *wall = new_piece(net, SHEET_WALL, top->facet);
    int foot_edge = 1;
    wall->p[wall->count++] = top->p[i];
    wall->p[wall->count++] = top->p[(i + 1) & 3];
    if (b.z > 0) {
        wall->p[wall->count++] = unfolded(&h, foot(b));
        foot_edge = 2;
    }
    if (a.z > 0)
        wall->p[wall->count++] = unfolded(&h, foot(a));
    wall->folds = 1;
    top->folds |= 1 << i;
    add_flap(net, wall, foot_edge);
    if (b.z > 0)
        add_flap(net, wall, 1);
}

/* The facet of the same part that shares edge i, or -1; its own edge in *other. */
static int neighbour(const stad_target *t, int facet, int i, int *other)
{
    for (int g = 0; g < t->facet_count; g++)
        for (int k = 0; k < 4 && g != facet && t->facets[g].part == t->facets[facet].part; k++) {
            solid d = minus(corner(&t->facets[g], k), corner(&t->facets[facet], i + 1));
            solid e = minus(corner(&t->facets[g], k + 1), corner(&t->facets[facet], i));
            *other = k;
            if (dot(d, d) + dot(e, e) == 0)
                return g;
        }
    return -1;
}

static sheet_piece *place_first(sheet_net *net, const stad_target_facet *f, int facet)
{
    solid u = minus(corner(f, 1), corner(f, 0)), v = minus(corner(f, 3), corner(f, 0));
    double mm = length(u);
    sheet_piece *top = new_piece(net, SHEET_TOP, facet);
    top->count = 4;
    for (int i = 0; i < 4; i++) {
        solid d = minus(corner(f, i), corner(f, 0));
        double along = dot(d, u) / mm, square = dot(d, d) - along * along;
        top->p[i].x = along;
        top->p[i].y = square > 0 ? sqrt(square) * (dot(d, v) < 0 ? -1 : 1) : 0;
    }
    return top;
}

static sheet_piece *place_beside(sheet_net *net, const stad_target *t, sheet_piece *was, int i, int facet, int k)
{
    const stad_target_facet *f = &t->facets[was->facet], *g = &t->facets[facet];
    hinge h = hinge_of(corner(f, i), corner(f, i + 1), was->p[i], was->p[(i + 1) & 3], centre(was));
    sheet_piece *top = new_piece(net, SHEET_TOP, facet);
    top->count = 4;
    for (int j = 0; j < 4; j++)
        top->p[j] = unfolded(&h, corner(g, j));
    was->folds |= 1 << i;
    top->folds |= 1 << k;
    return top;
}

/* Walls and flaps round one facet; a neighbour that is not on the page yet is placed and becomes *next. */
static void dress(sheet_net *net, const stad_target *t, sheet_piece *top, sheet_piece **next)
{
    const stad_target_facet *f = &t->facets[top->facet];
    for (int i = 0; i < 4; i++) {
        int k = 0, g = neighbour(t, top->facet, i, &k);
        if (g > top->facet)
            *next = place_beside(net, t, top, i, g, k);
        else if (g < 0 && f->h_mm[i] == 0 && f->h_mm[(i + 1) & 3] == 0)
            add_flap(net, top, i);
        else if (g < 0)
            add_wall(net, top, f, i);
    }
}

static void bound(sheet_net *net)
{
    net->low = net->high = net->piece[0].p[0];
    for (int i = 0; i < net->count; i++)
        for (int k = 0; k < net->piece[i].count; k++) {
            sheet_point p = net->piece[i].p[k];
            net->low.x = fmin(net->low.x, p.x);
            net->low.y = fmin(net->low.y, p.y);
            net->high.x = fmax(net->high.x, p.x);
            net->high.y = fmax(net->high.y, p.y);
        }
}

void sheet_unfold(const stad_target *target, int part, sheet_net *net)
{
    int facet = 0;
    net->count = 0;
    while (facet < target->facet_count && target->facets[facet].part != part)
        facet++;
    if (facet == target->facet_count)
        return;
    sheet_piece *top = place_first(net, &target->facets[facet], facet);
    while (top) {
        sheet_piece *next = NULL;
        dress(net, target, top, &next);
        top = next;
    }
    bound(net);
}
