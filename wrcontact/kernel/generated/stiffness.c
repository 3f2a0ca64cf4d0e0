/* Generated from tangential/stiffness.py by tools/transpile_kernel.py; change that one.
 *
 * Linear theory of strips that roll side by side on one half-space: how stiff each of them is.
 *
 * A strip j carries the traction X_j sqrt((a - x)/(a + x)), zero at the leading edge a, or in spin X_j
 * sqrt(1 - (x/a)^2).  That its neighbours move the surface below strip i, weighted along i, gives
 *
 *     (2 (1 - nu) / G) sum_j Phi_ij X_j = -w_i                                                    (K1)
 *     Phi_ij = S((e_{j+1} - y_i) / a_ij) - S((e_j - y_i) / a_ij),   a_ij^2 = (a_i^2 + a_j^2) / 2  (K2)
 *
 * for longitudinal creepage; e_j are the strips' edges, y_i their middles.  For lateral creepage and for spin
 * 2/G stands for 2 (1 - nu)/G, and each of the three has its own odd function S, with S(infinity) = 1/2
 * (binding/reach_table.py), so that one infinitely wide strip is Carter's.  With unit creepages
 *
 *     K1 = f1 G / (2 (1 - nu)) Phi_x^-1 1,   K2 = f2 (G/2) Phi_y^-1 1,   K3 = f3 (G/2) (Phi_s^-1 a) / a   (K3)
 *
 * in which the factors f, of the patch's length over width, make the force of an ellipse exactly Kalker's.
 * Long patches have the mean of K3, weighted with a^2 and width, in all strips: from a/b = 1.5 to 3 it takes
 * over.  The equations are solved for pairs of strips; between the middles of pairs stiffnesses follow straight
 * lines.  None is taken below a small share of their mean: in spin the outermost strips of patches with a/b < 3
 * would be dragged the other way round by their neighbours, which errs more.
 */

#include "stiffness.h"

/* K1, K2, K3 of the blocks of a patch, eqs. (K1) to (K3). */
static inline int64_t stiffness__find_stiffnesses(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    int64_t blocks;
    double ratio;
    double place;
    double half;
    double along;
    double across;
    double turning;
    int64_t i;
    int64_t block;
    blocks = rolling + layout__ROLLING_PATCH_BLOCKS;
    stiffness__join_strips(work, rolling);
    stiffness__fill_equations(tables, work, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), rolling);
    stiffness__solve_blocks(work, rolling + layout__ROLLING_PATCH_EQUATIONS_X);
    stiffness__solve_blocks(work, rolling + layout__ROLLING_PATCH_EQUATIONS_Y);
    stiffness__solve_blocks(work, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN);
    ratio = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    place = shapes__shape_place(ratio);
    half = 0.5 * (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    along = shapes__shape_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(3), place) * half / (1.0 - (*cspan_at(&tables, layout__TABLES_PARAMETERS + layout__PARAMETERS_POISSON_RATIO)));
    across = shapes__shape_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(4), place) * half;
    turning = shapes__shape_value(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), INT64_C(5), place) * half;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) = along * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i + layout__BLOCK_COUNT));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) = across * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i + layout__BLOCK_COUNT));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) = turning * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i + layout__BLOCK_COUNT)) / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
    }
    stiffness__spread_turning(work, blocks, stiffness__mean_share(ratio));
    return INT64_C(0);
}

/* The blocks from pairs of strips: edges, and the mean of a^2. */
static inline int64_t stiffness__join_strips(array_double_1d work, int64_t rolling)
{
    int64_t i;
    int64_t block;
    int64_t low;
    int64_t high;
    double square;
    double least;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * i;
        low = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * (INT64_C(2) * i);
        high = rolling + layout__ROLLING_PATCH_STRIPS + layout__ROLLING_STRIP_SIZE * (INT64_C(2) * i + INT64_C(1));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_START)) = (*cspan_at(&work, low + layout__ROLLING_STRIP_START));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) = (*cspan_at(&work, high + layout__ROLLING_STRIP_STOP));
        square = ((*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, low + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, low + layout__ROLLING_STRIP_WIDTH)) + (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, high + layout__ROLLING_STRIP_HALF_LENGTH)) * (*cspan_at(&work, high + layout__ROLLING_STRIP_WIDTH))) / ((*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START)));
        least = stiffness__SHORT * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) = sqrt(square + least * least);
    }
    return INT64_C(0);
}

/* Phi of eq. (K2), and the right-hand sides of unit creepages. */
static inline int64_t stiffness__fill_equations(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling)
{
    int64_t i;
    int64_t block;
    int64_t along;
    int64_t across;
    int64_t turning;
    double x;
    double y;
    double spin;
    int64_t j;
    int64_t other;
    double scale;
    double middle;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * i;
        along = rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i;
        across = rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i;
        turning = rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i;
        stiffness__reaches(&x, &y, &spin, tables, table, 0.5 * ((*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START))) / (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)));
        (*cspan_at(&work, along + i)) = 2.0 * x;
        (*cspan_at(&work, across + i)) = 2.0 * y;
        (*cspan_at(&work, turning + i)) = 2.0 * spin;
        (*cspan_at(&work, along + layout__BLOCK_COUNT)) = 1.0;
        (*cspan_at(&work, across + layout__BLOCK_COUNT)) = 1.0;
        (*cspan_at(&work, turning + layout__BLOCK_COUNT)) = (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH));
        for (j = i + INT64_C(1); j < layout__BLOCK_COUNT; j += INT64_C(1))
        {
            other = rolling + layout__ROLLING_PATCH_BLOCKS + layout__ROLLING_BLOCK_SIZE * j;
            scale = 1.0 / sqrt(0.5 * ((*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, other + layout__ROLLING_BLOCK_HALF_LENGTH))));
            middle = 0.5 * ((*cspan_at(&work, block + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)));
            stiffness__reach_beside(tables, work, table, rolling, i, j, ((*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) - middle) * scale, ((*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP)) - middle) * scale);
            middle = 0.5 * ((*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP)));
            stiffness__reach_beside(tables, work, table, rolling, j, i, (middle - (*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP))) * scale, (middle - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START))) * scale);
        }
    }
    return INT64_C(0);
}

/* Phi of block ``i`` and another one ``j``, whose edges are ``near`` and ``far`` from its middle. */
static inline int64_t stiffness__reach_beside(array_double_1d tables, array_double_1d work, int64_t table, int64_t rolling, int64_t i, int64_t j, double near, double far)
{
    double near_x;
    double near_y;
    double near_spin;
    double far_x;
    double far_y;
    double far_spin;
    int64_t along;
    int64_t across;
    int64_t turning;
    stiffness__reaches(&near_x, &near_y, &near_spin, tables, table, near);
    stiffness__reaches(&far_x, &far_y, &far_spin, tables, table, far);
    along = rolling + layout__ROLLING_PATCH_EQUATIONS_X + INT64_C(9) * i;
    across = rolling + layout__ROLLING_PATCH_EQUATIONS_Y + INT64_C(9) * i;
    turning = rolling + layout__ROLLING_PATCH_EQUATIONS_SPIN + INT64_C(9) * i;
    (*cspan_at(&work, along + j)) = far_x - near_x;
    (*cspan_at(&work, across + j)) = far_y - near_y;
    (*cspan_at(&work, turning + j)) = far_spin - near_spin;
    return INT64_C(0);
}

/* S of longitudinal and lateral creepage and of spin at a ``distance`` over the half-length, which is not
 * negative.
 */
static inline int64_t stiffness__reaches(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double distance)
{
    double place;
    int64_t cell;
    double u;
    int64_t at;
    place = layout__REACH_PER_UNIT * sqrt(sqrt(fabs(distance) + stiffness__NEAREST));
    if (!(place < (double)(layout__REACH_CELLS)))
    {
        place = (double)(layout__REACH_CELLS);
    }
    cell = (int64_t)(place);
    u = place - (double)(cell);
    at = layout__REACH_ROW * cell;
    (*result_0) = stiffness__reach_cubic(tables, table, at, u);
    (*result_1) = stiffness__reach_cubic(tables, table, at + INT64_C(4), u);
    (*result_2) = stiffness__reach_cubic(tables, table, at + INT64_C(8), u);
    return 0;
}

/* The cubic of four numbers from ``at`` on, at ``u``. */
static inline double stiffness__reach_cubic(array_double_1d tables, int64_t table, int64_t at, double u)
{
    double high;
    double result;
    high = (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(2)))) + u * (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(3))));
    result = (*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + at)) + u * ((*cspan_at(&tables, table + layout__ROLLING_TABLE_REACHES + (at + INT64_C(1)))) + u * high);
    return result;
}

/* Solve in place by Gauss, without exchange of rows: the kernel is positive, largest on the diagonal. */
static inline int64_t stiffness__solve_blocks(array_double_1d work, int64_t equations)
{
    int64_t k;
    int64_t pivot;
    double inverse;
    int64_t i;
    int64_t row;
    double factor;
    int64_t j;
    int64_t back;
    double value;
    int64_t known;
    for (k = INT64_C(0); k < layout__BLOCK_COUNT; k += INT64_C(1))
    {
        pivot = equations + INT64_C(9) * k;
        inverse = 1.0 / (*cspan_at(&work, pivot + k));
        for (i = k + INT64_C(1); i < layout__BLOCK_COUNT; i += INT64_C(1))
        {
            row = equations + INT64_C(9) * i;
            factor = (*cspan_at(&work, row + k)) * inverse;
            for (j = k + INT64_C(1); j < layout__BLOCK_COUNT + INT64_C(1); j += INT64_C(1))
            {
                (*cspan_at(&work, row + j)) -= factor * (*cspan_at(&work, pivot + j));
            }
        }
    }
    for (back = INT64_C(0); back < layout__BLOCK_COUNT; back += INT64_C(1))
    {
        k = layout__BLOCK_COUNT - INT64_C(1) - back;
        pivot = equations + INT64_C(9) * k;
        value = (*cspan_at(&work, pivot + layout__BLOCK_COUNT));
        for (j = k + INT64_C(1); j < layout__BLOCK_COUNT; j += INT64_C(1))
        {
            known = equations + INT64_C(9) * j;
            value -= (*cspan_at(&work, pivot + j)) * (*cspan_at(&work, known + layout__BLOCK_COUNT));
        }
        (*cspan_at(&work, pivot + layout__BLOCK_COUNT)) = value / (*cspan_at(&work, pivot + k));
    }
    return INT64_C(0);
}

/* How much the mean counts in spin's stiffness, by a/b. */
static inline double stiffness__mean_share(double ratio)
{
    double share;
    share = (log(ratio) - stiffness__OWN_UNTIL) / (stiffness__MEAN_FROM - stiffness__OWN_UNTIL);
    if (share < 0.0)
    {
        share = 0.0;
    }
    if (share > 1.0)
    {
        share = 1.0;
    }
    return share;
}

/* Let spin's stiffness be its mean to this share, and keep all stiffnesses above zero. */
static inline int64_t stiffness__spread_turning(array_double_1d work, int64_t blocks, double share)
{
    double total;
    double mean;
    double along;
    double across;
    int64_t i;
    int64_t block;
    double weight;
    total = 0.0;
    mean = 0.0;
    along = 0.0;
    across = 0.0;
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        weight = (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * (*cspan_at(&work, block + layout__ROLLING_BLOCK_HALF_LENGTH)) * ((*cspan_at(&work, block + layout__ROLLING_BLOCK_STOP)) - (*cspan_at(&work, block + layout__ROLLING_BLOCK_START)));
        total += weight;
        mean += (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) * weight;
        along += (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) * weight;
        across += (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) * weight;
    }
    for (i = INT64_C(0); i < layout__BLOCK_COUNT; i += INT64_C(1))
    {
        block = blocks + layout__ROLLING_BLOCK_SIZE * i;
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) += share * (mean / total - (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)));
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)) = stiffness__not_below((*cspan_at(&work, block + layout__ROLLING_BLOCK_TURNING)), stiffness__SOFT * mean / total);
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)) = stiffness__not_below((*cspan_at(&work, block + layout__ROLLING_BLOCK_ALONG)), stiffness__SOFT * along / total);
        (*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)) = stiffness__not_below((*cspan_at(&work, block + layout__ROLLING_BLOCK_ACROSS)), stiffness__SOFT * across / total);
    }
    return INT64_C(0);
}

/* The larger of both. */
static inline double stiffness__not_below(double value, double least)
{
    if (value < least)
    {
        value = least;
    }
    return value;
}

/* K1, K2, K3 of strip ``index`` with its middle at ``station`` [m], between the middles of two blocks. */
static inline int64_t stiffness__stiffnesses_at(double* along, double* across, double* turning, array_double_1d work, int64_t blocks, int64_t index, double station)
{
    int64_t own;
    int64_t towards;
    int64_t other;
    double middle;
    double share;
    own = blocks + layout__ROLLING_BLOCK_SIZE * (py_floor_div_int64_t(index, INT64_C(2)));
    towards = py_floor_div_int64_t(index, INT64_C(2)) - INT64_C(1);
    if (pyc_modulo(index, INT64_C(2)) == INT64_C(1))
    {
        towards = py_floor_div_int64_t(index, INT64_C(2)) + INT64_C(1);
    }
    (*along) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_ALONG));
    (*across) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_ACROSS));
    (*turning) = (*cspan_at(&work, own + layout__ROLLING_BLOCK_TURNING));
    if ((towards >= INT64_C(0)) && (towards < layout__BLOCK_COUNT))
    {
        other = blocks + layout__ROLLING_BLOCK_SIZE * towards;
        middle = 0.5 * ((*cspan_at(&work, own + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, own + layout__ROLLING_BLOCK_STOP)));
        share = (station - middle) / (0.5 * ((*cspan_at(&work, other + layout__ROLLING_BLOCK_START)) + (*cspan_at(&work, other + layout__ROLLING_BLOCK_STOP))) - middle);
        (*along) += share * ((*cspan_at(&work, other + layout__ROLLING_BLOCK_ALONG)) - (*along));
        (*across) += share * ((*cspan_at(&work, other + layout__ROLLING_BLOCK_ACROSS)) - (*across));
        (*turning) += share * ((*cspan_at(&work, other + layout__ROLLING_BLOCK_TURNING)) - (*turning));
    }
    return 0;
}
