/* Generated from normal_contact.py by tools/transpile_kernel.py; change that one.
 *
 * The normal contact of one side: regions, widths, nodes, levels, patches.
 *
 * 1. guess the penetration from the force (it hardly depends on the lateral curvature),
 * 2. find the regions whose gap is below it, and the half-width of each one's interpenetration,
 * 3. solve on COARSE nodes: that fixes the half-widths, hence spacing and window of
 * 4. the FINE nodes, on which the force is met.
 */

#ifndef WRCONTACT_KERNEL_NORMAL_CONTACT_H
#define WRCONTACT_KERNEL_NORMAL_CONTACT_H

#include "../native/spans.h"
#include "analyn.h"
#include "hertz.h"
#include "layout.h"
#include "nodes.h"
#include "patches.h"
#include "regions.h"

static const int64_t normal_contact__COARSE_NODES = INT64_C(5);
static const int64_t normal_contact__COARSE_WINDOW = INT64_C(1);
static const int64_t normal_contact__FINE_NODES = INT64_C(15);
static const int64_t normal_contact__FINE_WINDOW = INT64_C(3);
static const double normal_contact__TYPICAL_RATIO = 2.0;
static const double normal_contact__GUESS_FACTOR = 1.5;
static const double normal_contact__COARSE_MERGE = 0.6;
static const double normal_contact__COARSE_SHARP = 1e-06;
static const int64_t normal_contact__COARSE_REPEATS = INT64_C(8);
static const int64_t normal_contact__COVER_REPEATS = INT64_C(6);
static const double normal_contact__NARROWEST = 0.01;
static const double normal_contact__WIDEST = 110.0;

static double normal_contact__guess_penetration(double force, double A, double contact_modulus);
static int64_t normal_contact__measure_widths(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t region, double level);
static int64_t normal_contact__prepare_regions(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, int64_t nodes, int64_t window, double enlarge);
static int64_t normal_contact__start_levels(array_double_1d work, int64_t count, double penetration);
static int64_t normal_contact__keep_levels(array_double_1d work, int64_t count, double penetration);
static int64_t normal_contact__covered(array_double_1d work, int64_t count);
static int64_t normal_contact__solve_coarse(double* penetration, int64_t* count, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double guess);
static int64_t normal_contact__solve_fine(double* result_0_0001, int64_t* result_1, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t count, double force, double penetration, int64_t by_penetration);
static int64_t normal_contact__solve_analyn(double* penetration, int64_t* count, int64_t* met, array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, double force, double prescribed);
static double normal_contact__solve_hertz(array_double_1d tables, array_double_1d work, int64_t side, double force, double prescribed);
static int64_t normal_contact__solve_normal(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t side, int64_t outputs, double force, double prescribed);

#endif
