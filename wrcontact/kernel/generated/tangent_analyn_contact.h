/* Generated from tangent_analyn_contact.py by tools/transpile_kernel.py; change that one.
 *
 * Tangents of analyn_contact.py.
 */

#ifndef WRCONTACT_KERNEL_TANGENT_ANALYN_CONTACT_H
#define WRCONTACT_KERNEL_TANGENT_ANALYN_CONTACT_H

#include "../native/spans.h"
#include "analyn_contact.h"
#include "layout.h"
#include "node_layout.h"
#include "tangent_analyn.h"
#include "tangent_deep_points.h"
#include "tangent_estimate.h"
#include "tangent_node_layout.h"
#include "tangent_node_patches.h"
#include "tangent_planes.h"
#include "tangent_pressed_regions.h"

static inline int64_t tangent_analyn_contact__gather_regions_t(array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double penetration, double penetration_t);
static inline int64_t tangent_analyn_contact__solve_fine_t(double* result_0_0001, double* result_1_0001, int64_t* result_2, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t count, double force, double force_t, double penetration, double penetration_t, int64_t by_penetration);
static inline int64_t tangent_analyn_contact__solve_estimated_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, double estimate, double estimate_t, double force, double force_t, int64_t by_penetration);
static inline int64_t tangent_analyn_contact__solve_analyn_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t);
static inline int64_t tangent_analyn_contact__analyn_contact_t(double* penetration, double* penetration_t, int64_t* count, int64_t* satisfied, array_double_1d work, array_double_1d work_t, array_double_1d tables, array_double_1d state, int64_t side, double force, double force_t, double prescribed, double prescribed_t);

#endif
