/* Generated from tangent_correction.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of correction.py.
 */

#include "tangent_correction.h"

/* Tangent of ``correct_force``. */
static inline int64_t tangent_correction__correct_force_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling)
{
    int64_t table;
    double bound_t;
    double bound;
    double v1;
    double v2;
    double mean_axis_t;
    double mean_axis;
    double v3;
    double v4;
    int64_t ratio;
    double on_ratio;
    double on_ratio_t;
    double along;
    double along_t;
    double across;
    double across_t;
    double turning;
    double turning_t;
    double sign_x;
    double sign_y;
    int64_t at;
    double on_elevation;
    double on_elevation_t;
    double on_azimuth;
    double on_azimuth_t;
    double on_radius;
    double on_radius_t;
    double v5;
    double v6;
    double v6_t;
    double v7;
    double v8;
    double v8_t;
    double v9;
    double v10;
    double v11;
    double v11_t;
    double force_x;
    double force_x_t;
    double force_y;
    double force_y_t;
    table = (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING)));
    bound_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    v2 = sqrt(v1);
    mean_axis_t = tangent_rates__root_rate(v2, (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH)));
    mean_axis = v2;
    v3 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    v4 = log(v3) - log(correction__FIRST_RATIO);
    tangent_table_cell__table_cell_t(&ratio, &on_ratio, &on_ratio_t, v4 * correction__PER_DOUBLING, ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) - v3 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) / v3 * correction__PER_DOUBLING, (double)(layout__CORRECTION_RATIOS - INT64_C(1)), 0.0);
    tangent_correction__saturation_t(&along, &along_t, &across, &across_t, &turning, &turning_t, work, work_t, tables, rolling, ratio, on_ratio, on_ratio_t);
    sign_x = 1.0;
    if (along < 0.0)
    {
        sign_x = -1.0;
        along_t = -along_t;
        along = -along;
    }
    sign_y = 1.0;
    if (turning < 0.0)
    {
        sign_y = -1.0;
        across_t = -across_t;
        across = -across;
        turning_t = -turning_t;
        turning = -turning;
    }
    tangent_correction__node_at_t(&at, &on_elevation, &on_elevation_t, &on_azimuth, &on_azimuth_t, &on_radius, &on_radius_t, tables, table, along, along_t, across, across_t, turning, turning_t);
    at = at + ratio * correction__RATIO_STRIDE;
    v5 = sign_x * bound;
    tangent_correction__missing_t(&v6, &v6_t, tables, table, at, on_ratio, on_ratio_t, on_elevation, on_elevation_t, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) + (sign_x * bound_t * v6 + v5 * v6_t);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + v5 * v6;
    v7 = sign_y * bound;
    tangent_correction__missing_t(&v8, &v8_t, tables, table, at + INT64_C(1), on_ratio, on_ratio_t, on_elevation, on_elevation_t, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) + (sign_y * bound_t * v8 + v7 * v8_t);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) + v7 * v8;
    v9 = sign_y * bound;
    v10 = v9 * mean_axis;
    tangent_correction__missing_t(&v11, &v11_t, tables, table, at + INT64_C(2), on_ratio, on_ratio_t, on_elevation, on_elevation_t, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_MOMENT)) + ((sign_y * bound_t * mean_axis + v9 * mean_axis_t) * v11 + v10 * v11_t);
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MOMENT)) + v10 * v11;
    tangent_tractions__cut_to_t(&force_x, &force_x_t, &force_y, &force_y_t, (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)), (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)), (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)), (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)), bound, bound_t);
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_X)) = force_x_t;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = force_x;
    (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FORCE_Y)) = force_y_t;
    (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = force_y;
    return INT64_C(0);
}

/* Tangent of ``saturation``. */
static inline int64_t tangent_correction__saturation_t(double* result_0, double* result_1, double* result_2, double* result_3, double* result_4, double* result_5, array_double_1d work, array_double_1d work_t, array_double_1d tables, int64_t rolling, int64_t cell, double share, double share_t)
{
    double v1;
    double ratio_t;
    double ratio;
    double area_t;
    double area;
    double first;
    double first_t;
    double second;
    double second_t;
    double third;
    double third_t;
    double v2;
    double v3;
    double v4;
    double v5;
    double scale_t;
    double scale;
    double v6;
    double v7;
    double v8;
    double v9;
    double v10;
    double v11;
    double wide_t;
    double wide;
    int64_t at;
    double v12;
    double v13;
    double v13_t;
    double v14;
    double v15;
    double v16;
    double v16_t;
    double v17;
    double v18;
    double v19;
    double v20;
    double v21;
    double v21_t;
    double v22;
    double v23;
    v1 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio_t = ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) - v1 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH))) / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    ratio = v1;
    area_t = (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    area = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    tangent_shapes__kalker_coefficients_t(&first, &first_t, &second, &second_t, &third, &third_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), ratio, ratio_t);
    v2 = -area;
    v3 = v2 * (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS));
    v4 = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    v5 = v3 / v4;
    scale_t = ((-area_t) * (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)) - v5 * ((*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_LOAD)))) / v4;
    scale = v5;
    v6 = -2.7;
    v7 = log(ratio);
    v8 = v6 * v7;
    v9 = exp(v8);
    v10 = 1.0 + 0.66 * v9;
    v11 = sqrt(v10);
    wide_t = tangent_rates__root_rate(v11, 0.66 * (v9 * (v6 * (ratio_t / ratio))));
    wide = v11;
    at = INT64_C(3) * cell;
    v12 = scale * first;
    tangent_correction__scale_at_t(&v13, &v13_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at, share, share_t);
    v14 = v12 * v13;
    v15 = scale * second;
    tangent_correction__scale_at_t(&v16, &v16_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at + INT64_C(1), share, share_t);
    v17 = v15 * v16;
    v18 = sqrt(area);
    v19 = scale * v18;
    v20 = v19 * third;
    tangent_correction__scale_at_t(&v21, &v21_t, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), at + INT64_C(2), share, share_t);
    v22 = v20 * v21;
    v23 = v22 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN));
    (*result_0) = v14 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*result_1) = ((scale_t * first + scale * first_t) * v13 + v12 * v13_t) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + v14 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
    (*result_2) = v17 * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    (*result_3) = ((scale_t * second + scale * second_t) * v16 + v15 * v16_t) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + v17 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    (*result_4) = v23 * wide;
    (*result_5) = ((((scale_t * v18 + scale * tangent_rates__root_rate(v18, area_t)) * third + v19 * third_t) * v21 + v20 * v21_t) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) + v22 * (*cspan_at(&work_t, rolling + layout__ROLLING_PATCH_SPIN))) * wide + v23 * wide_t;
    return 0;
}

/* Tangent of ``scale_at``. */
static inline int64_t tangent_correction__scale_at_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double share, double share_t)
{
    double v1;
    v1 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + (at + INT64_C(3)))) - (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + at));
    (*result_0) = (*cspan_at(&tables, table + layout__ROLLING_TABLE_SCALES + at)) + share * v1;
    (*result_1) = share_t * v1;
    return 0;
}

/* Tangent of ``node_at``. */
static inline int64_t tangent_correction__node_at_t(int64_t* at, double* on_elevation, double* on_elevation_t, double* on_azimuth, double* on_azimuth_t, double* on_radius, double* on_radius_t, array_double_1d tables, int64_t table, double along, double along_t, double across, double across_t, double turning, double turning_t)
{
    double v1;
    double v2;
    double flat_t;
    double flat;
    double v3;
    double v4;
    double radius_t;
    double radius;
    double v5;
    double v6;
    double v7;
    double v8;
    int64_t elevation;
    double v9;
    double v10;
    double v11;
    double v12;
    int64_t azimuth;
    double v13;
    double v14;
    int64_t cell;
    v1 = across * across + turning * turning;
    v2 = sqrt(v1);
    flat_t = tangent_rates__root_rate(v2, across_t * across + across * across_t + (turning_t * turning + turning * turning_t));
    flat = v2;
    v3 = flat * flat + along * along;
    v4 = sqrt(v3);
    radius_t = tangent_rates__root_rate(v4, flat_t * flat + flat * flat_t + (along_t * along + along * along_t));
    radius = v4;
    v5 = atan2(along, flat);
    v6 = 2.0 / M_PI;
    v7 = v5 * v6;
    v8 = (double)(layout__CORRECTION_ELEVATIONS - INT64_C(1));
    tangent_table_cell__table_cell_t(&elevation, on_elevation, on_elevation_t, v7 * v8, (flat * along_t - along * flat_t) / (flat * flat + along * along) * v6 * v8, (double)(layout__CORRECTION_ELEVATIONS - INT64_C(1)), 0.0);
    v9 = fabs(turning);
    v10 = atan2(v9, across);
    v11 = v10 / M_PI;
    v12 = (double)(layout__CORRECTION_AZIMUTHS - INT64_C(1));
    tangent_table_cell__table_cell_t(&azimuth, on_azimuth, on_azimuth_t, v11 * v12, (across * tangent_rates__size_rate(turning, turning_t) - v9 * across_t) / (across * across + v9 * v9) / M_PI * v12, (double)(layout__CORRECTION_AZIMUTHS - INT64_C(1)), 0.0);
    v13 = 1.0 + radius;
    v14 = radius / v13;
    tangent_correction__radius_cell_t(&cell, on_radius, on_radius_t, tables, table, v14, (radius_t - v14 * radius_t) / v13);
    (*at) = elevation * correction__ELEVATION_STRIDE + azimuth * layout__CORRECTION_LINE + cell * layout__CORRECTION_COLUMNS;
    return 0;
}

/* Tangent of ``radius_cell``. */
static inline int64_t tangent_correction__radius_cell_t(int64_t* cell, double* result_1, double* result_2, array_double_1d tables, int64_t table, double place, double place_t)
{
    double v1;
    double v2;
    (*cell) = INT64_C(0);
    while(((*cell) < layout__CORRECTION_RADII - INT64_C(2)) && (place >= (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + ((*cell) + INT64_C(1))))))
    {
        (*cell) = (*cell) + INT64_C(1);
    }
    v1 = place - (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + (*cell)));
    v2 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + ((*cell) + INT64_C(1)))) - (*cspan_at(&tables, table + layout__ROLLING_TABLE_RADII + (*cell)));
    (*result_1) = v1 / v2;
    (*result_2) = place_t / v2;
    return 0;
}

/* Tangent of ``missing``. */
static inline int64_t tangent_correction__missing_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_ratio, double on_ratio_t, double on_elevation, double on_elevation_t, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t)
{
    double v1;
    double v1_t;
    double low_t;
    double low;
    double v2;
    double v2_t;
    double v3;
    tangent_correction__on_plane_t(&v1, &v1_t, tables, table, at, on_elevation, on_elevation_t, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    low_t = v1_t;
    low = v1;
    tangent_correction__on_plane_t(&v2, &v2_t, tables, table, at + correction__RATIO_STRIDE, on_elevation, on_elevation_t, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    v3 = v2 - low;
    (*result_0) = low + on_ratio * v3;
    (*result_1) = low_t + (on_ratio_t * v3 + on_ratio * (v2_t - low_t));
    return 0;
}

/* Tangent of ``on_plane``. */
static inline int64_t tangent_correction__on_plane_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_elevation, double on_elevation_t, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t)
{
    double v1;
    double v1_t;
    double low_t;
    double low;
    double v2;
    double v2_t;
    double v3;
    tangent_correction__on_cone_t(&v1, &v1_t, tables, table, at, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    low_t = v1_t;
    low = v1;
    tangent_correction__on_cone_t(&v2, &v2_t, tables, table, at + correction__ELEVATION_STRIDE, on_azimuth, on_azimuth_t, on_radius, on_radius_t);
    v3 = v2 - low;
    (*result_0) = low + on_elevation * v3;
    (*result_1) = low_t + (on_elevation_t * v3 + on_elevation * (v2_t - low_t));
    return 0;
}

/* Tangent of ``on_cone``. */
static inline int64_t tangent_correction__on_cone_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_azimuth, double on_azimuth_t, double on_radius, double on_radius_t)
{
    double v1;
    double v1_t;
    double low_t;
    double low;
    double v2;
    double v2_t;
    double v3;
    tangent_correction__on_line_t(&v1, &v1_t, tables, table, at, on_radius, on_radius_t);
    low_t = v1_t;
    low = v1;
    tangent_correction__on_line_t(&v2, &v2_t, tables, table, at + layout__CORRECTION_LINE, on_radius, on_radius_t);
    v3 = v2 - low;
    (*result_0) = low + on_azimuth * v3;
    (*result_1) = low_t + (on_azimuth_t * v3 + on_azimuth * (v2_t - low_t));
    return 0;
}

/* Tangent of ``on_line``. */
static inline int64_t tangent_correction__on_line_t(double* result_0, double* result_1, array_double_1d tables, int64_t table, int64_t at, double on_radius, double on_radius_t)
{
    double low;
    double v1;
    low = (*cspan_at(&tables, table + layout__ROLLING_TABLE_CORRECTIONS + at));
    v1 = (*cspan_at(&tables, table + layout__ROLLING_TABLE_CORRECTIONS + (at + layout__CORRECTION_COLUMNS))) - low;
    (*result_0) = low + on_radius * v1;
    (*result_1) = on_radius_t * v1;
    return 0;
}
