/* Generated from wheelset/compliant.py by tools/transpile_kernel.py; change that one.
 *
 * Compliant contact: height and roll of the wheelset are given, and each wheel's load follows from
 * how deep it is in its rail.
 */

#ifndef WRCONTACT_KERNEL_COMPLIANT_H
#define WRCONTACT_KERNEL_COMPLIANT_H

#include "../native/spans.h"
#include "damping.h"
#include "layout.h"
#include "leaning.h"
#include "moving.h"
#include "roll.h"
#include "side.h"
#include "starts.h"
#include "totals.h"
#include "trial.h"

static const double compliant__GRAZING = 1e-13;

static OUT_OF_LINE int64_t compliant__follow_starts(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);
static OUT_OF_LINE int64_t compliant__load_at_height(array_double_1d tables, array_double_1d work, array_double_1d state, int64_t index, double height);
static OUT_OF_LINE int64_t compliant__solve_compliant(array_double_1d left_tables, array_double_1d right_tables, array_double_1d work, array_double_1d state);

#endif
