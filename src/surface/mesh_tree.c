/* SPDX-License-Identifier: MIT */
/* Rays and places in the tree of a mesh. */
#include "mesh_tree.h"

#include <math.h>
#include <string.h>
#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "../base/bounded.h"
#include "../base/larger.h"
#include "../base/vector.h"
#include "../base/wide.h"

/* ---- rays ---- */

/* A ray ready for triangles: its start is where it is nearest to the middle of the tree, and its direction has 1 or -1
 * along its main axis, which is the last one of those that corners are sheared to. */
struct sheared {
    double origin[3], direction[3];
    double size, ahead; /* of the direction as it was given; how far the start is from its origin */
    double from, to;
    int axes[3];
    double shear[2], sign;
    bool is_passing; /* it passes the tree */
};

static struct sheared shear_ray(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray)
{
    struct sheared made = {.is_passing = false};
    const double *d = ray->direction;
    int main = 0;
    for (int k = 1; k < 3; k++)
        main = fabs(d[k]) > fabs(d[main]) ? k : main;
    made.size = fabs(d[main]);
    if (!(made.size > 0 && made.size < HUGE_VAL))
        return made;
    for (int k = 0; k < 3; k++)
        made.direction[k] = d[k] / made.size;
    made.ahead = -lx_dot(ray->origin, made.direction) / lx_dot(made.direction, made.direction);
    for (int k = 0; k < 3; k++)
        made.origin[k] = ray->origin[k] + made.ahead * made.direction[k];
    const double reach = tree->farthest + (double)LX_TREE_ROOM;
    made.is_passing = lx_dot(made.origin, made.origin) <= reach * reach;
    made.from = ray->from * made.size - made.ahead;
    made.to = ray->to * made.size - made.ahead;
    made.sign = made.direction[main];
    made.axes[2] = main;
    made.axes[0] = (main + (made.sign > 0 ? 1 : 2)) % 3;
    made.axes[1] = (main + (made.sign > 0 ? 2 : 1)) % 3;
    made.shear[0] = made.direction[made.axes[0]] / made.sign;
    made.shear[1] = made.direction[made.axes[1]] / made.sign;
    return made;
}

static void begin(struct lx_tree_walk *walk, const struct lx_mesh_tree *tree, const struct sheared *ray)
{
    static const double NEARLY_ALONG = 1e-18; /* so that no product below is infinite */
    walk->tree = tree;
    walk->depth = ray->is_passing ? 1 : 0;
    walk->stack[0] = 0;
    walk->entries[0] = -HUGE_VALF;
    walk->next = walk->last = 0;
    for (int k = 0; k < 3; k++) {
        const double d = ray->direction[k];
        walk->origin[k] = (float)ray->origin[k];
        walk->inverse[k] = (float)(1 / (fabs(d) > NEARLY_ALONG ? d : copysign(NEARLY_ALONG, d)));
    }
    walk->from = (float)ray->from - 2 * LX_TREE_ROOM * (1 + fabsf((float)ray->from));
    walk->to = (float)ray->to + 2 * LX_TREE_ROOM * (1 + fabsf((float)ray->to));
}

static inline float smaller(float a, float b)
{
    return a < b ? a : b;
}

/* Four numbers at once: of two boxes the low and the high ends along an axis. */
#ifdef __SSE2__
typedef __m128 four;
#define FOUR_OF(number) _mm_set1_ps(number)
#define FOUR_AT(numbers) _mm_loadu_ps(numbers)
#define FOUR_SUB(a, b) _mm_sub_ps(a, b)
#define FOUR_MUL(a, b) _mm_mul_ps(a, b)
#define FOUR_LESS(a, b) _mm_min_ps(a, b)
#define FOUR_MORE(a, b) _mm_max_ps(a, b)
#define FOUR_SWAP(a) _mm_shuffle_ps(a, a, _MM_SHUFFLE(1, 0, 3, 2)) /* of both halves */
#define FOUR_PUT(numbers, a) _mm_storeu_ps(numbers, a)
#else
typedef struct {
    float at[4];
} four;

static inline four four_at(const float numbers[4])
{
    return (four){{numbers[0], numbers[1], numbers[2], numbers[3]}};
}

#define FOUR_EACH(name_, term_)                                                                                        \
    static inline four name_(four a, four b)                                                                           \
    {                                                                                                                  \
        four made;                                                                                                     \
        for (int i = 0; i < 4; i++)                                                                                    \
            made.at[i] = (term_);                                                                                      \
        return made;                                                                                                   \
    }
FOUR_EACH(four_sub, a.at[i] - b.at[i])
FOUR_EACH(four_mul, a.at[i] * b.at[i])
FOUR_EACH(four_less, a.at[i] < b.at[i] ? a.at[i] : b.at[i])
FOUR_EACH(four_more, a.at[i] > b.at[i] ? a.at[i] : b.at[i])
#define FOUR_OF(number) ((four){{number, number, number, number}})
#define FOUR_AT(numbers) four_at(numbers)
#define FOUR_SUB(a, b) four_sub(a, b)
#define FOUR_MUL(a, b) four_mul(a, b)
#define FOUR_LESS(a, b) four_less(a, b)
#define FOUR_MORE(a, b) four_more(a, b)
#define FOUR_SWAP(a) ((four){{(a).at[2], (a).at[3], (a).at[0], (a).at[1]}})
#define FOUR_PUT(numbers, a) memcpy(numbers, (a).at, sizeof(a).at)
#endif

/* Where a ray enters both boxes of a node, and in ends[2] and [3] where it leaves them, between its own ends. */
static inline void enter(const struct lx_tree_node *node, const struct lx_tree_walk *walk, float ends[4])
{
    four near = FOUR_OF(walk->from), far = FOUR_OF(walk->to);
    for (int k = 0; k < 3; k++) {
        const four at = FOUR_MUL(FOUR_SUB(FOUR_AT(node->ends[k]), FOUR_OF(walk->origin[k])), FOUR_OF(walk->inverse[k]));
        const four swapped = FOUR_SWAP(at);
        near = FOUR_MORE(near, FOUR_LESS(at, swapped));
        far = FOUR_LESS(far, FOUR_MORE(at, swapped));
    }
    float entries[4], exits[4];
    FOUR_PUT(entries, near);
    FOUR_PUT(exits, far);
    ends[0] = entries[0], ends[1] = entries[1], ends[2] = exits[0], ends[3] = exits[1];
}

/* Goes on to the next leaf that the ray passes, nearer ones mostly first; false: there is none. */
static inline bool next_leaf(struct lx_tree_walk *walk)
{
    while (walk->depth > 0) {
        const uint32_t at = walk->stack[--walk->depth];
        if (walk->entries[walk->depth] > walk->to)
            continue;
        const struct lx_tree_node *node = &walk->tree->nodes[at >> 2];
        if (at & 2) { /* a leaf that was left for later */
            walk->next = node->child[at & 1];
            walk->last = walk->next + node->count[at & 1];
            return true;
        }
        float entry[4];
        enter(node, walk, entry);
        const int later = entry[1] > entry[0]; /* goes onto the stack first */
        for (int i = 0; i < 2; i++) {
            const int side = i == 0 ? later : !later;
            if (!(entry[side] <= entry[side + 2]))
                continue;
            const bool is_leaf = node->count[side] != LX_TREE_BRANCH;
            walk->entries[walk->depth] = entry[side];
            walk->stack[walk->depth++] = is_leaf ? (at & ~UINT32_C(3)) | 2 | (uint32_t)side : node->child[side] << 2;
        }
    }
    return false;
}

void lx_tree_begin(struct lx_tree_walk *walk, const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray)
{
    const struct sheared sheared = shear_ray(tree, ray);
    begin(walk, tree, &sheared);
}

const struct lx_tree_triangle *lx_tree_next(struct lx_tree_walk *walk)
{
    if (walk->next == walk->last && !next_leaf(walk))
        return NULL;
    return walk->next == walk->last ? lx_tree_next(walk) : &walk->tree->triangles[walk->next++];
}

/* ---- triangles ---- */

/* Sheared coordinates are below 6, so that a determinant of two products is off by less. */
static const double DOUBT = 0x1p-45;

/* a b - c d without rounding, as far as its sign goes; 0 or the sign. */
static int sign_of_difference(double a, double b, double c, double d)
{
    return lx_wide_compare(lx_exact_product(a, b), lx_exact_product(c, d));
}

/* Whether the signs of three determinants, found without rounding where they are in doubt, are no different ones. */
static bool signs_agree(const double at[3][2], const double values[3])
{
    bool any_above = false, any_below = false;
    for (int i = 0; i < 3; i++) {
        const double *b = at[(i + 1) % 3], *c = at[(i + 2) % 3];
        int sign = values[i] > 0 ? 1 : -1;
        if (!(fabs(values[i]) > DOUBT))
            sign = sign_of_difference(c[0], b[1], c[1], b[0]);
        any_above = any_above || sign > 0;
        any_below = any_below || sign < 0;
    }
    return !(any_above && any_below);
}

/* Whether the line of a ray meets a triangle, its edges included; where, and whether from its front. */
static inline bool meet(const struct sheared *ray, const struct lx_tree_triangle *triangle, double *t, bool *is_front)
{
    const int x = ray->axes[0], y = ray->axes[1], z = ray->axes[2];
    double at[3][2], depth[3], values[3];
    for (int c = 0; c < 3; c++) {
        const double *corner = triangle->corners[c];
        depth[c] = corner[z] - ray->origin[z];
        at[c][0] = corner[x] - ray->origin[x] - ray->shear[0] * depth[c];
        at[c][1] = corner[y] - ray->origin[y] - ray->shear[1] * depth[c];
    }
    values[0] = at[2][0] * at[1][1] - at[2][1] * at[1][0];
    values[1] = at[0][0] * at[2][1] - at[0][1] * at[2][0];
    values[2] = at[1][0] * at[0][1] - at[1][1] * at[0][0];
    const double least = lx_smaller(lx_smaller(values[0], values[1]), values[2]);
    const double most = lx_larger(lx_larger(values[0], values[1]), values[2]);
    if (least < 0 && most > 0 && ((least < -DOUBT && most > DOUBT) || !signs_agree((const double(*)[2])at, values)))
        return false;
    const double sum = values[0] + values[1] + values[2];
    if (sum == 0)
        return false; /* it is seen from its edge: its neighbours are met there */
    double along = 0, all = 0;
    for (int c = 0; c < 3; c++) {
        const double share = sum > 0 ? lx_larger(values[c], 0) : lx_smaller(values[c], 0);
        along += share * depth[c];
        all += share;
    }
    *t = along / all * ray->sign;
    *is_front = sum > 0;
    return all != 0;
}

struct lx_tree_hit lx_tree_first(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, bool fronts_only)
{
    const struct sheared sheared = shear_ray(tree, ray);
    struct lx_tree_hit best = {.t = sheared.to};
    struct lx_tree_walk walk;
    begin(&walk, tree, &sheared);
    while (next_leaf(&walk))
        for (; walk.next < walk.last; walk.next++) {
            const struct lx_tree_triangle *triangle = &tree->triangles[walk.next];
            double t;
            bool is_front;
            if (!meet(&sheared, triangle, &t, &is_front) || t < sheared.from || t > best.t ||
                (fronts_only && !is_front) ||
                (t == best.t && best.triangle && triangle->number > best.triangle->number))
                continue;
            best = (struct lx_tree_hit){.triangle = triangle, .t = t, .is_front = is_front};
            walk.to = smaller(walk.to, (float)t + 2 * LX_TREE_ROOM * (1 + fabsf((float)t)));
        }
    for (int k = 0; k < 3; k++)
        best.place[k] = sheared.origin[k] + best.t * sheared.direction[k];
    best.t = (best.t + sheared.ahead) / sheared.size;
    return best;
}

bool lx_tree_is_met(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, double touch)
{
    const struct sheared sheared = shear_ray(tree, ray);
    struct lx_tree_walk walk;
    begin(&walk, tree, &sheared);
    while (next_leaf(&walk))
        for (; walk.next < walk.last; walk.next++) {
            const struct lx_tree_triangle *triangle = &tree->triangles[walk.next];
            double t;
            bool is_front;
            if (meet(&sheared, triangle, &t, &is_front) && t > sheared.from && t < sheared.to - touch &&
                lx_triangle_square(triangle, ray->origin) > touch * touch)
                return true;
        }
    return false;
}

unsigned lx_tree_count(const struct lx_mesh_tree *tree, const struct lx_tree_ray *ray, double touch)
{
    const struct sheared sheared = shear_ray(tree, ray);
    struct lx_tree_walk walk;
    unsigned count = 0;
    begin(&walk, tree, &sheared);
    while (next_leaf(&walk))
        for (; walk.next < walk.last; walk.next++) {
            const struct lx_tree_triangle *triangle = &tree->triangles[walk.next];
            double t;
            bool is_front;
            count += meet(&sheared, triangle, &t, &is_front) && t > sheared.from && t < sheared.to &&
                     lx_triangle_square(triangle, ray->origin) > touch * touch;
        }
    return count;
}

bool lx_tree_is_inside(const struct lx_mesh_tree *tree, const double place[3])
{
    /* Ways that no mesh is likely to be aligned with; the last one decides between the others. */
    static const double ways[3][3] = {{0.8147, 0.4218, 0.3987}, {-0.2785, 0.9157, -0.2898}, {0.1419, -0.6557, 0.7416}};
    int inside = 0;
    for (int i = 0; i < 3; i++) {
        struct lx_tree_ray ray = {.from = 0, .to = HUGE_VAL};
        memcpy(ray.origin, place, sizeof ray.origin);
        memcpy(ray.direction, ways[i], sizeof ray.direction);
        const struct lx_tree_hit hit = lx_tree_first(tree, &ray, false);
        inside += hit.triangle && !hit.is_front;
    }
    return inside > 1;
}

/* ---- places ---- */

/* The square of the distance from a place to the edge between two corners. */
static double edge_square(const double a[3], const double b[3], const double place[3])
{
    double way[3], from[3], gap[3];
    for (int k = 0; k < 3; k++)
        way[k] = b[k] - a[k], from[k] = place[k] - a[k];
    const double square = lx_dot(way, way);
    const double share = square > 0 ? lx_smaller(lx_larger(lx_dot(from, way) / square, 0), 1) : 0;
    for (int k = 0; k < 3; k++)
        gap[k] = from[k] - share * way[k];
    return lx_dot(gap, gap);
}

double lx_triangle_square(const struct lx_tree_triangle *triangle, const double place[3])
{
    const double *a = triangle->corners[0], *b = triangle->corners[1], *c = triangle->corners[2];
    double first[3], second[3], from[3], best = HUGE_VAL;
    for (int k = 0; k < 3; k++)
        first[k] = b[k] - a[k], second[k] = c[k] - a[k], from[k] = place[k] - a[k];
    const double normal[3] = {first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
                              first[0] * second[1] - first[1] * second[0]};
    const double square = lx_dot(normal, normal);
    /* shares of the corners b and c, times the square */
    const double u =
        lx_dot((double[]){from[1] * second[2] - from[2] * second[1], from[2] * second[0] - from[0] * second[2],
                          from[0] * second[1] - from[1] * second[0]},
               normal);
    const double v = lx_dot((double[]){first[1] * from[2] - first[2] * from[1], first[2] * from[0] - first[0] * from[2],
                                       first[0] * from[1] - first[1] * from[0]},
                            normal);
    if (square > 0 && u >= 0 && v >= 0 && u + v <= square) {
        const double height = lx_dot(from, normal);
        return height * height / square;
    }
    for (int i = 0; i < 3; i++)
        best = lx_smaller(best, edge_square(triangle->corners[i], triangle->corners[(i + 1) % 3], place));
    return best;
}

/* The square of the distance from a place to one of the boxes of a node. */
static double box_square(const struct lx_tree_node *node, int side, const double place[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const double below = (double)node->ends[k][side] - place[k], above = place[k] - (double)node->ends[k][side + 2];
        const double gap = lx_larger(lx_larger(below, above), 0);
        square += gap * gap;
    }
    return square;
}

const struct lx_tree_triangle *lx_tree_nearest(const struct lx_mesh_tree *tree, const double place[3], double most,
                                               double *distance)
{
    const struct lx_tree_triangle *best = NULL;
    double least = most * most;
    uint32_t stack[LX_TREE_DEPTH];
    double gaps[LX_TREE_DEPTH];
    unsigned depth = 1;
    stack[0] = 0;
    gaps[0] = 0;
    while (depth > 0) {
        const struct lx_tree_node *node = &tree->nodes[stack[--depth]];
        if (gaps[depth] > least)
            continue;
        const double squares[2] = {box_square(node, 0, place), box_square(node, 1, place)};
        const int farther = squares[1] > squares[0];
        for (int i = 0; i < 2; i++) { /* branches: the nearer one is on top */
            const int side = i == 0 ? farther : !farther;
            if (node->count[side] == LX_TREE_BRANCH && squares[side] <= least) {
                gaps[depth] = squares[side];
                stack[depth++] = node->child[side];
            }
        }
        for (int side = 0; side < 2; side++)
            for (uint32_t i = 0; node->count[side] != LX_TREE_BRANCH && squares[side] <= least && i < node->count[side];
                 i++) {
                const struct lx_tree_triangle *triangle = &tree->triangles[node->child[side] + i];
                const double square = lx_triangle_square(triangle, place);
                if (square < least || (square == least && (!best || triangle->number < best->number))) {
                    least = square;
                    best = triangle;
                }
            }
    }
    *distance = sqrt(least);
    return best;
}
