/* Generated from tangent_normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of normal_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_NORMAL_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_NORMAL_CONTACT_H

#include "../native/spans.h"
#include "analyn.h"
#include "contact_plane.h"
#include "layout.h"
#include "nodes.h"
#include "normal_contact.h"
#include "tangent_analyn.h"
#include "tangent_contact_plane.h"
#include "tangent_hertz.h"
#include "tangent_hertz_contact.h"
#include "tangent_node_patches.h"
#include "tangent_nodes.h"
#include "tangent_overlaps.h"
#include "tangent_planes.h"
#include "tangent_profile_table.h"
#include "tangent_rates.h"
#include "tangent_regions.h"
#include "tangent_strip_patches.h"
#include "tangent_strips.h"

static inline int64_t tangent_normal_contact__guess_penetration_t(double* v8, double* result_1, double force, double force_t, double A, double A_t, double contact_modulus, double contact_modulus_t);
static inline int64_t tangent_normal_contact__side_curvature_t(double* curvature, double* curvature_t, double reached, double reached_t, double own, double own_t, double mean, double mean_t);
static inline int64_t tangent_normal_contact__measure_widths_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t region, double level, double level_t);
static inline int64_t tangent_normal_contact__zone_share_t(double* share, double* share_t, array_double_1d tables, double A, double A_t, double side, double side_t);
static inline int64_t tangent_normal_contact__rail_per_station_t(double* v3, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, double abscissa, double abscissa_t);
static inline int64_t tangent_normal_contact__mean_normal_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, int64_t region, double level, double level_t);
static inline int64_t tangent_normal_contact__prepare_regions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double enlarge, double enlarge_t);
static inline int64_t tangent_normal_contact__start_levels_t(array_double_1d work, array_double_1d work_t, int64_t count, double penetration, double penetration_t);
static inline int64_t tangent_normal_contact__estimate_penetration_t(double* v8, double* result_1, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double force, double force_t);
static inline int64_t tangent_normal_contact__gather_regions_t(array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double penetration, double penetration_t);
static inline int64_t tangent_normal_contact__first_penetration_t(double* v1, double* v1_t, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, double force, double force_t);
static inline int64_t tangent_normal_contact__solve_fine_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t by_penetration);
static inline int64_t tangent_normal_contact__solve_estimated_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double force, double force_t, double estimate, double estimate_t, int64_t by_penetration);
static inline int64_t tangent_normal_contact__solve_analyn_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t);
static inline int64_t tangent_normal_contact__solve_normal_t(double* penetration, double* penetration_t, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d work_t, array_double_1d state, int64_t side, int64_t outputs, double force, double force_t, double prescribed, double prescribed_t);

#endif
