/* Generated from normal/normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The normal contact of one side: estimate, regions, nodes, levels, patches.
 *
 * 1. estimate the penetration from the force and the width of the interpenetration,
 * 2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
 * 3. spacing and window of the nodes, on which
 * 4. the force is met.
 *
 * The estimate depends on pose and force alone and moves smoothly with them, and so does the result.
 */

#ifndef WRCONTACT_KERNEL_NORMAL_CONTACT_H
#define WRCONTACT_KERNEL_NORMAL_CONTACT_H

#include "../native/spans.h"
#include "analyn.h"
#include "contact_plane.h"
#include "hertz.h"
#include "hertz_contact.h"
#include "layout.h"
#include "node_patches.h"
#include "nodes.h"
#include "overlaps.h"
#include "planes.h"
#include "profile_table.h"
#include "regions.h"
#include "strip_patches.h"
#include "strips.h"

static const double normal_contact__WINDOW = 0.26666666666666666;
static const double normal_contact__MEASURED = 0.9;
static const double normal_contact__NARROWER = 4.0;
static const double normal_contact__COVER = 1.1;
static const double normal_contact__SPREAD = 1.25;
static const double normal_contact__STRIP_SPREAD = 3.0;
static const double normal_contact__TYPICAL_RATIO = 2.0;
static const double normal_contact__CEILING = 1000.0;
static const double normal_contact__ESTIMATE_FACTOR = 1.5;
static const int64_t normal_contact__ESTIMATE_REPEATS = INT64_C(4);
static const int64_t normal_contact__COVER_REPEATS = INT64_C(6);
static const double normal_contact__LEAST_BEND = 1.0;
static const double normal_contact__MOST_BEND = 100.0;
static const double normal_contact__NARROWEST = 0.01;
static const double normal_contact__WIDEST = 110.0;

static inline double normal_contact__guess_penetration(double force, double A, double contact_modulus);
static inline double normal_contact__side_curvature(double reached, double own, double mean);
static inline int64_t normal_contact__measure_widths(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double level);
static inline double normal_contact__zone_share(array_double_1d tables, double A, double side);
static inline int64_t normal_contact__node_stride(array_double_1d tables);
static inline double normal_contact__rail_per_station(array_double_1d tables, array_double_1d work, double abscissa);
static inline int64_t normal_contact__mean_normal(array_double_1d tables, array_double_1d work, int64_t region, double level);
static inline int64_t normal_contact__prepare_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double enlarge);
static inline int64_t normal_contact__start_levels(array_double_1d work, int64_t count, double penetration);
static inline int64_t normal_contact__covered(array_double_1d work, int64_t count);
static inline double normal_contact__estimate_penetration(array_double_1d tables, array_double_1d work, array_double_1d state, double force);
static inline int64_t normal_contact__gather_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double penetration);
static inline double normal_contact__first_penetration(array_double_1d tables, array_double_1d work, array_double_1d state, double force);
static inline int64_t normal_contact__solve_fine(double* result_0_0001, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double force, double penetration, int64_t by_penetration);
static inline int64_t normal_contact__solve_estimated(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double estimate, int64_t by_penetration);
static inline int64_t normal_contact__solve_analyn(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double prescribed);
static inline int64_t normal_contact__solve_normal(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, int64_t outputs, double force, double prescribed);

#endif
