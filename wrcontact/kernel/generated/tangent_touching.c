/* Generated from tangent_touching.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of touching.py.
 */

#include "tangent_touching.h"

/* Tangent of ``pair_rule``. */
static inline int64_t tangent_touching__pair_rule_t(double* result_0, double* result_1, double* result_2, double* result_3, double* depth, double* depth_t, double* aside, double* aside_t, double* back_shift, double* back_shift_t, int64_t* found, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double y, double y_t, double abscissa, double abscissa_t, double shift, double shift_t)
{
    int64_t i;
    double z;
    double z_t;
    double slope;
    double slope_t;
    double bend;
    double bend_t;
    double y_track;
    double y_track_t;
    double z_track;
    double z_track_t;
    double outline_slope;
    double outline_slope_t;
    double stretch;
    double stretch_t;
    double rate;
    double rate_t;
    double height;
    double height_t;
    double m;
    double m_t;
    double rail_bend;
    double rail_bend_t;
    double across_t;
    double across;
    double down_t;
    double down;
    double mismatch_t;
    double mismatch;
    double apart_t;
    double apart;
    double v1;
    double along_t;
    double along;
    double back_t;
    double back;
    double determinant;
    double v2;
    double v3;
    double v4;
    double v5;
    double v6;
    double v7;
    touching__touching_pair(&y, &abscissa, depth, aside, back_shift, found, work, tables, place, y, abscissa, shift);
    y_t = 0.0;
    abscissa_t = 0.0;
    (*depth_t) = 0.0;
    (*aside_t) = 0.0;
    (*back_shift_t) = 0.0;
    if ((*found) == INT64_C(1))
    {
        for (i = INT64_C(0); i < INT64_C(2); i += INT64_C(1))
        {
            tangent_profile_table__height_slope_bend_t(&z, &z_t, &slope, &slope_t, &bend, &bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_WHEEL))), y, y_t);
            tangent_locus__outline_jet_t(&y_track, &y_track_t, &z_track, &z_track_t, &outline_slope, &outline_slope_t, &stretch, &stretch_t, &rate, &rate_t, work, work_t, place, y, y_t, z, z_t, slope, slope_t, bend, bend_t);
            tangent_profile_table__height_slope_bend_t(&height, &height_t, &m, &m_t, &rail_bend, &rail_bend_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_RAIL))), abscissa, abscissa_t);
            across_t = y_track_t - abscissa_t;
            across = y_track - (*cspan_at(&tables, layout__TABLES_RAIL_Y)) - abscissa;
            down_t = z_track_t + shift_t - height_t;
            down = z_track + shift - height;
            if (i == INT64_C(0))
            {
                mismatch_t = outline_slope_t - m_t;
                mismatch = outline_slope - m;
                apart_t = across_t + (down_t * m + down * m_t);
                apart = across + down * m;
                v1 = 1.0 + outline_slope * m;
                along_t = stretch_t * v1 + stretch * (outline_slope_t * m + outline_slope * m_t);
                along = stretch * v1;
                back_t = down_t * rail_bend + down * rail_bend_t - (m_t * m + m * m_t);
                back = down * rail_bend - 1.0 - m * m;
                determinant = rate * back + rail_bend * along;
                v2 = -(mismatch * back + rail_bend * apart);
                y_t = (-(mismatch_t * back + rail_bend * apart_t)) / determinant;
                v3 = -(rate * apart - along * mismatch);
                abscissa_t = (-(rate * apart_t - along * mismatch_t)) / determinant;
            }
            else
            {
                v4 = down - m * across;
                v5 = 1.0 + m * m;
                v6 = sqrt(v5);
                v7 = v4 / v6;
                (*depth_t) = (down_t - (m_t * across + m * across_t) - v7 * tangent_rates__root_rate(v6, m_t * m + m * m_t)) / v6;
                (*aside_t) = -across_t;
                (*back_shift_t) = shift_t - down_t;
            }
        }
    }
    (*result_0) = y;
    (*result_1) = y_t;
    (*result_2) = abscissa;
    (*result_3) = abscissa_t;
    return 0;
}
