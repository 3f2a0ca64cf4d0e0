/* Generated from normal/strip_lengths.py by tools/transpile_kernel.py; change that one.
 *
 * Half-lengths of the strips from their line loads; eqs. (S6)-(S9).
 */

#include "strip_lengths.h"

/* Line load, square of the corrected half-length, and pressure of every strip.
 *
 * At fixed line load the half-length follows from two conditions that are one for an ellipse: the curvature
 * of the middle line along the track, eqs. (S3) and (S6), and ANALYN's ratio of line load to half-length,
 * eq. (S7).  Their geometric mean is taken, eq. (S8).
 */
static inline int64_t strip_lengths__correct_lengths(array_double_1d work, array_double_1d tables)
{
    int64_t count;
    double scale;
    int64_t i;
    int64_t strip;
    double line_load;
    double square;
    double pressure;
    double half;
    double bend;
    int64_t row;
    int64_t j;
    int64_t other;
    double away;
    double by_curvature;
    double by_load;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    scale = 0.5 * M_PI * M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS));
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        line_load = 0.0;
        square = 0.0;
        pressure = 0.0;
        if ((*cspan_at(&work, strip + layout__STRIP_Y)) > 0.0)
        {
            half = (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH));
            line_load = scale * half * (*cspan_at(&work, strip + layout__STRIP_Y)) / (*cspan_at(&work, strip + layout__STRIP_WIDTH));
            bend = 0.0;
            row = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_INFLUENCES + INT64_C(104) * i;
            for (j = INT64_C(0); j < count; j += INT64_C(1))
            {
                other = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * j;
                away = (*cspan_at(&work, strip + layout__STRIP_STATION)) - (*cspan_at(&work, other + layout__STRIP_STATION));
                bend += (*cspan_at(&work, row + j)) * (*cspan_at(&work, other + layout__STRIP_Y)) / ((*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) * (*cspan_at(&work, other + layout__STRIP_HALF_LENGTH)) + away * away);
            }
            by_curvature = half * half * bend / (2.0 * (*cspan_at(&work, strip + layout__STRIP_A)));
            by_load = line_load / (*cspan_at(&work, strip + layout__STRIP_LOAD_PER_SQUARE));
            square = sqrt(by_curvature * by_load);
            pressure = 2.0 / M_PI * line_load / sqrt(square);
        }
        (*cspan_at(&work, strip + layout__STRIP_LINE_LOAD)) = line_load;
        (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) = square;
        (*cspan_at(&work, strip + layout__STRIP_PRESSURE)) = pressure;
    }
    return INT64_C(0);
}

/* Give loaded strips their corrected half-lengths, for the next sweep. */
static inline int64_t strip_lengths__adopt_lengths(array_double_1d work)
{
    int64_t count;
    double longest;
    int64_t i;
    int64_t strip;
    double half;
    count = (int64_t)((*cspan_at(&work, layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_COUNT)));
    longest = 0.0;
    for (i = INT64_C(0); i < count; i += INT64_C(1))
    {
        strip = layout__WORK_CONTACT + layout__CONTACT_STRIP_PROBLEM + layout__STRIP_PROBLEM_STRIPS + layout__STRIP_SIZE * i;
        if ((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)) > 0.0)
        {
            half = sqrt((*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH_SQUARE)));
            (*cspan_at(&work, strip + layout__STRIP_HALF_LENGTH)) = half;
            if (half > longest)
            {
                longest = half;
            }
        }
    }
    strip_surfaces__limit_lengths(work, count, longest);
    return INT64_C(0);
}
