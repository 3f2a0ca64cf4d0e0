/* Generated from tangential/correction.py by tools/transpile_kernel.py; change that one.
 *
 * What the strips' force of an ellipse lacks to that of the complete theory.
 *
 * For the ellipse with the patch's area and length over width, r = a/b, the saturation
 *
 *     s1 = -xi ab G C11/(mu N),   s2 = -eta ab G C22/(mu N),
 *     s3 = -phi (ab)^1.5 G C23/(mu N) sqrt(1 + 0.66 r^-2.7)                                        (D1)
 *
 * is mirrored until s1 and s3 are not negative, and taken in polar coordinates: its length R as R / (1 + R), its
 * elevation arctan(s1 / sqrt(s2^2 + s3^2)) and its azimuth arctan2(s3, s2).  Over these and ln r the table holds
 * the force over mu N and the moment over mu N sqrt(ab) that are missing; between its nodes they follow straight
 * lines along each coordinate.  The force is then cut to mu N.
 *
 * s3 is zero on both sides of the azimuth's ends, where the table's values change over into their mirror images;
 * so the correction is continuous all over.
 */

#include "correction.h"

/* Add to a patch's force and moment what is missing. */
static inline int64_t correction__correct_force(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    int64_t table;
    double bound;
    double mean_axis;
    int64_t ratio;
    double on_ratio;
    double along;
    double across;
    double turning;
    double sign_x;
    double sign_y;
    int64_t at;
    double on_elevation;
    double on_azimuth;
    double on_radius;
    double force_x;
    double force_y;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING)));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    mean_axis = sqrt((*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)));
    table_cell__table_cell(&ratio, &on_ratio, (log((*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) - log(correction__FIRST_RATIO)) * correction__PER_DOUBLING, (double)(layout__CORRECTION_RATIOS - INT64_C(1)));
    correction__saturation(&along, &across, &turning, work, tables, rolling, ratio, on_ratio);
    sign_x = 1.0;
    if (along < 0.0)
    {
        sign_x = -1.0;
        along = -along;
    }
    sign_y = 1.0;
    if (turning < 0.0)
    {
        sign_y = -1.0;
        across = -across;
        turning = -turning;
    }
    correction__node_at(&at, &on_elevation, &on_azimuth, &on_radius, tables, table, along, across, turning);
    at += ratio * correction__RATIO_STRIDE;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) += sign_x * bound * correction__missing(tables, table, at, on_ratio, on_elevation, on_azimuth, on_radius);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) += sign_y * bound * correction__missing(tables, table, at + INT64_C(1), on_ratio, on_elevation, on_azimuth, on_radius);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) += sign_y * bound * mean_axis * correction__missing(tables, table, at + INT64_C(2), on_ratio, on_elevation, on_azimuth, on_radius);
    tractions__cut_to(&force_x, &force_y, (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)), (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)), bound);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = force_x;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = force_y;
    return INT64_C(0);
}

/* s1, s2, s3 of eq. (D1), with the coefficients that the table was made with; ``cell`` and ``share`` are
 * the patch's place among the table's ratios a/b.
 */
static inline int64_t correction__saturation(double* result_0, double* result_1, double* result_2, array_double_1d work, array_double_1d tables, int64_t rolling, int64_t cell, double share)
{
    double ratio;
    double area;
    double first;
    double second;
    double third;
    double scale;
    double wide;
    int64_t at;
    ratio = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    area = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    shapes__kalker_coefficients(&first, &second, &third, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio);
    scale = (-area) * (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)) / ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)));
    wide = sqrt(1.0 + 0.66 * exp((-2.7) * log(ratio)));
    at = INT64_C(3) * cell;
    (*result_0) = scale * first * correction__scale_at(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at, share) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*result_1) = scale * second * correction__scale_at(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at + INT64_C(1), share) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    (*result_2) = scale * sqrt(area) * third * correction__scale_at(tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at + INT64_C(2), share) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * wide;
    return 0;
}

/* A scale of the table between two ratios. */
static inline double correction__scale_at(array_double_1d tables, int64_t table, int64_t at, double share)
{
    double result;
    result = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + at)) + share * ((*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + (at + INT64_C(3)))) - (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + at)));
    return result;
}

/* Where the cell of a saturation begins in the corrections of a ratio, and where in it that lies;
 * ``along`` and ``turning`` are not negative.
 */
static inline int64_t correction__node_at(int64_t* at, double* on_elevation, double* on_azimuth, double* on_radius, array_double_1d tables, int64_t table, double along, double across, double turning)
{
    double flat;
    double radius;
    int64_t elevation;
    int64_t azimuth;
    int64_t cell;
    flat = sqrt(across * across + turning * turning);
    radius = sqrt(flat * flat + along * along);
    table_cell__table_cell(&elevation, on_elevation, atan2(along, flat) * (2.0 / M_PI) * (double)(layout__CORRECTION_ELEVATIONS - INT64_C(1)), (double)(layout__CORRECTION_ELEVATIONS - INT64_C(1)));
    table_cell__table_cell(&azimuth, on_azimuth, atan2(fabs(turning), across) / M_PI * (double)(layout__CORRECTION_AZIMUTHS - INT64_C(1)), (double)(layout__CORRECTION_AZIMUTHS - INT64_C(1)));
    correction__radius_cell(&cell, on_radius, tables, table, radius / (1.0 + radius));
    (*at) = elevation * correction__ELEVATION_STRIDE + azimuth * layout__CORRECTION_LINE + cell * layout__CORRECTION_COLUMNS;
    return 0;
}

/* The cell that holds R / (1 + R) = ``place``, and where in it. */
static inline int64_t correction__radius_cell(int64_t* cell, double* result_1, array_double_1d tables, int64_t table, double place)
{
    (*cell) = INT64_C(0);
    while(((*cell) < layout__CORRECTION_RADII - INT64_C(2)) && (place >= (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + ((*cell) + INT64_C(1))))))
    {
        (*cell) += INT64_C(1);
    }
    (*result_1) = (place - (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + (*cell)))) / ((*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + ((*cell) + INT64_C(1)))) - (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + (*cell))));
    return 0;
}

/* A number of the table, linear along all four coordinates of the cell that begins ``at``. */
static inline double correction__missing(array_double_1d tables, int64_t table, int64_t at, double on_ratio, double on_elevation, double on_azimuth, double on_radius)
{
    double low;
    double result;
    low = correction__on_plane(tables, table, at, on_elevation, on_azimuth, on_radius);
    result = low + on_ratio * (correction__on_plane(tables, table, at + correction__RATIO_STRIDE, on_elevation, on_azimuth, on_radius) - low);
    return result;
}

/* The same for one ratio. */
static inline double correction__on_plane(array_double_1d tables, int64_t table, int64_t at, double on_elevation, double on_azimuth, double on_radius)
{
    double low;
    double result;
    low = correction__on_cone(tables, table, at, on_azimuth, on_radius);
    result = low + on_elevation * (correction__on_cone(tables, table, at + correction__ELEVATION_STRIDE, on_azimuth, on_radius) - low);
    return result;
}

/* The same for one elevation. */
static inline double correction__on_cone(array_double_1d tables, int64_t table, int64_t at, double on_azimuth, double on_radius)
{
    double low;
    double result;
    low = correction__on_line(tables, table, at, on_radius);
    result = low + on_azimuth * (correction__on_line(tables, table, at + layout__CORRECTION_LINE, on_radius) - low);
    return result;
}

/* The same for one azimuth. */
static inline double correction__on_line(array_double_1d tables, int64_t table, int64_t at, double on_radius)
{
    double low;
    double result;
    low = (*cspan_at(&tables, table + layout__ROLLING_TABLE_CORRECTIONS + at));
    result = low + on_radius * ((*cspan_at(&tables, table + layout__ROLLING_TABLE_CORRECTIONS + (at + layout__CORRECTION_COLUMNS))) - low);
    return result;
}
