/* Generated from normal/analyn_contact.py by tools/transpile_kernel.py; change that one.
 *
 * ANALYN's contact of one side: estimate, regions, nodes, local penetrations, patches.
 *
 * 1. Estimate the penetration from the force and the width of the interpenetration,
 * 2. find the regions that it reaches, and the half-width of each one's interpenetration, which sets
 * 3. spacing and window of the nodes, on which
 * 4. the force is satisfied.
 *
 * The estimate depends on pose and force alone and is smooth in them, and so is the result.
 */

#ifndef WRCONTACT_KERNEL_ANALYN_CONTACT_H
#define WRCONTACT_KERNEL_ANALYN_CONTACT_H

#include "../native/spans.h"
#include "analyn.h"
#include "deep_points.h"
#include "estimate.h"
#include "layout.h"
#include "node_layout.h"
#include "node_patches.h"
#include "planes.h"
#include "pressed_regions.h"

static const double analyn_contact__ESTIMATE_FACTOR = 1.5;
static const int64_t analyn_contact__ESTIMATE_REPEATS = INT64_C(4);
static const int64_t analyn_contact__COVER_REPEATS = INT64_C(6);
static const double analyn_contact__ENLARGED = 1.4;

static inline int64_t analyn_contact__gather_regions(array_double_1d work, array_double_1d tables, array_double_1d state, double penetration);
static inline int64_t analyn_contact__solve_fine(double* result_0_0001, int64_t* result_1, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count, double force, double penetration, int64_t by_penetration);
static inline int64_t analyn_contact__solve_estimated(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, double estimate, double force, int64_t by_penetration);
static inline int64_t analyn_contact__solve_analyn(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed);
static inline int64_t analyn_contact__analyn_contact(double* penetration, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d tables, array_double_1d state, int64_t side, double force, double prescribed);

#endif
