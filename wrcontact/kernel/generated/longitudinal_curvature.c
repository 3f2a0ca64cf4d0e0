/* Generated from surface/longitudinal_curvature.py by tools/transpile_kernel.py; change that one.
 *
 * Curvature of the wheel along the track.
 */

#include "longitudinal_curvature.h"

/* Curvature 1/R_x of the wheel along the track [1/m] at the locus point with profile height ``z`` [m],
 * ``slope`` [-] and second derivative ``bend`` [1/m].
 *
 * effective: of the surface cut by the plane of the track's x and the contact normal.  With e the track's x
 * in the wheelset frame, [(e1 cos(phi) - e3 sin(phi))^2 / r - r'' e2^2] / sqrt(1 + r'^2); without yaw
 * cos(delta) / r, the source's eq. (6.1). basic: 1/r.
 */
static inline double longitudinal_curvature__longitudinal_curvature(array_double_1d work, array_double_1d tables, int64_t place, double z, double slope, double bend)
{
    double r;
    double sin_phi;
    double cos_phi;
    double e1;
    double e2;
    double e3;
    double around;
    double steep;
    double curvature;
    r = (*cspan_at(&work, place + layout__PLACE_RADIUS)) + z;
    curvature = 1.0 / r;
    if ((int64_t)((*cspan_at(&tables, layout__TABLES_LONGITUDINAL))) == layout__LONGITUDINAL_BASIC)
    {
        return curvature;
    }
    if (!((*cspan_at(&work, place + layout__PLACE_YAWED)) == 1.0))
    {
        curvature = 1.0 / (r * sqrt(1.0 + slope * slope));
    }
    else
    {
        locus__around_wheel(&sin_phi, &cos_phi, work, place, slope);
        e1 = (*cspan_at(&work, place + layout__PLACE_COS_YAW));
        e2 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_COS_ROLL));
        e3 = (*cspan_at(&work, place + layout__PLACE_SIN_YAW)) * (*cspan_at(&work, place + layout__PLACE_SIN_ROLL));
        around = e1 * cos_phi - e3 * sin_phi;
        steep = sqrt(1.0 + slope * slope);
        curvature = (around * around / r - bend * e2 * e2) / steep;
        if (curvature < longitudinal_curvature__CURVATURE_FLOOR / (r * steep))
        {
            curvature = longitudinal_curvature__CURVATURE_FLOOR / (r * steep);
        }
    }
    return curvature;
}
