/* Generated from tangent_longitudinal_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of longitudinal_curvature.py.
 */

#include "tangent_longitudinal_curvature.h"

/* Tangent of ``longitudinal_curvature``. */
static inline int64_t tangent_longitudinal_curvature__longitudinal_curvature_t(double* curvature, double* curvature_t, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t place, double z, double z_t, double slope, double slope_t, double bend, double bend_t)
{
    double r_t;
    double r;
    double v1;
    double v2;
    double v3;
    double v4;
    double v5;
    double sin_phi;
    double sin_phi_t;
    double cos_phi;
    double cos_phi_t;
    double e1_t;
    double e1;
    double e2_t;
    double e2;
    double e3_t;
    double e3;
    double around_t;
    double around;
    double v6;
    double v7;
    double steep_t;
    double steep;
    double v8;
    double v9;
    double v10;
    double v11;
    double v12;
    double v13;
    double v14;
    r_t = (*cspan_at(&work_t, place + layout__PLACE_RADIUS)) + z_t;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    v1 = 1.0 / r;
    (*curvature_t) = (-v1) * r_t / r;
    (*curvature) = v1;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL))) == layout__LONGITUDINAL_BASIC)
    {
        return 0;
    }
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        v2 = 1.0 + slope * slope;
        v3 = sqrt(v2);
        v4 = r * v3;
        v5 = 1.0 / v4;
        (*curvature_t) = (-v5) * (r_t * v3 + r * tangent_rates__root_rate(v3, slope_t * slope + slope * slope_t)) / v4;
        (*curvature) = v5;
    }
    else
    {
        tangent_locus__around_wheel_t(&sin_phi, &sin_phi_t, &cos_phi, &cos_phi_t, work, work_t, place, slope, slope_t);
        e1_t = (*cspan_at(&work_t, place + layout__PLACE_COS_YAW));
        e1 = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        e2_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL)) + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work_t, place + layout__PLACE_COS_ROLL));
        e2 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
        e3_t = (*cspan_at(&work_t, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL)) + (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work_t, place + layout__PLACE_SIN_ROLL));
        e3 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
        around_t = e1_t * cos_phi + e1 * cos_phi_t - (e3_t * sin_phi + e3 * sin_phi_t);
        around = e1 * cos_phi - e3 * sin_phi;
        v6 = 1.0 + slope * slope;
        v7 = sqrt(v6);
        steep_t = tangent_rates__root_rate(v7, slope_t * slope + slope * slope_t);
        steep = v7;
        v8 = around * around;
        v9 = v8 / r;
        v10 = bend * e2;
        v11 = v9 - v10 * e2;
        v12 = v11 / steep;
        (*curvature_t) = ((around_t * around + around * around_t - v9 * r_t) / r - ((bend_t * e2 + bend * e2_t) * e2 + v10 * e2_t) - v12 * steep_t) / steep;
        (*curvature) = v12;
        if ((*curvature) < longitudinal_curvature__CURVATURE_FLOOR / (r * steep))
        {
            v13 = r * steep;
            v14 = longitudinal_curvature__CURVATURE_FLOOR / v13;
            (*curvature_t) = (-v14) * (r_t * steep + r * steep_t) / v13;
            (*curvature) = v14;
        }
    }
    return 0;
}
