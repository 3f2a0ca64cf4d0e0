/* Generated from contact/arc_length.py by tools/transpile_kernel.py; change that one.
 *
 * Arc lengths of the curves across the track, in two ways for two purposes.
 *
 * Gauss     exact to rounding, piece by piece of the profile: the arcs of the equidistant separation, which are
 *           compared on wheel and rail to 1e-13 m and must not depend on where a piece ends.
 * a table   prepared with the profiles: the stations of a pressed wheel along its rail; any coordinate is
 *           suitable for them that is smooth, the same at every use, and cheap.
 */

#ifndef WRCONTACT_KERNEL_ARC_LENGTH_H
#define WRCONTACT_KERNEL_ARC_LENGTH_H

#include "../native/spans.h"
#include "cubic_table.h"
#include "curves.h"
#include "layout.h"
#include "profile_table.h"

static const double arc_length__GAUSS_1 = 0.2386191860831969;
static const double arc_length__GAUSS_2 = 0.6612093864662645;
static const double arc_length__GAUSS_3 = 0.932469514203152;
static const double arc_length__WEIGHT_1 = 0.467913934572691;
static const double arc_length__WEIGHT_2 = 0.3607615730481386;
static const double arc_length__WEIGHT_3 = 0.1713244923791704;

static OUT_OF_LINE double arc_length__panel_length(array_double_1d work, array_double_1d tables, int64_t curve, double low, double high);
static OUT_OF_LINE double arc_length__arc_length(array_double_1d work, array_double_1d tables, int64_t curve, double start, double stop);
static OUT_OF_LINE double arc_length__rail_length(array_double_1d tables, double start, double stop);
static OUT_OF_LINE double arc_length__rail_abscissa(array_double_1d tables, double start, double length);

#endif
