/* Generated from contact/planes.py by tools/transpile_kernel.py; change that one.
 *
 * Planes of their own for regions of a rigid contact whose normal differs from the contact point's: a flange
 * beside a tread.
 *
 * One contact plane serves all regions whose normals differ little.  A region whose normal differs by more than
 * SPLIT has its own frame, in the pair of points where it would touch (:mod:`touching`): its gap is measured
 * along its own normal, its stations run in its own plane, and of the wheel's approach it gets the share that
 * comes along its normal,
 *
 *     level_i = cos(angle_i - angle_0) penetration - gap_i
 *
 * In the outputs its stations follow those of the contact point, by the length of the rail between the two.
 */

#ifndef WRCONTACT_KERNEL_PLANES_H
#define WRCONTACT_KERNEL_PLANES_H

#include "../native/spans.h"
#include "arc_length.h"
#include "contact_plane.h"
#include "layout.h"
#include "locus.h"
#include "profile_table.h"
#include "regions.h"
#include "touching.h"
#include "traces.h"

static const double planes__SPLIT = 0.2588190451025207;

static OUT_OF_LINE int64_t planes__keep_frame(array_double_1d work, int64_t slot);
static OUT_OF_LINE int64_t planes__use_frame(array_double_1d work, int64_t slot);
static OUT_OF_LINE double planes__bound_abscissa(array_double_1d work, array_double_1d tables, int64_t region, array_double_1d state, double bound);
static OUT_OF_LINE double planes__bound_station(array_double_1d work, array_double_1d tables, double abscissa);
static OUT_OF_LINE int64_t planes__needs_own_plane(array_double_1d work, int64_t region);
static OUT_OF_LINE int64_t planes__own_plane(array_double_1d work, array_double_1d tables, int64_t region, int64_t slot, array_double_1d state);
static OUT_OF_LINE int64_t planes__locate_along_track(array_double_1d work, array_double_1d tables, int64_t count);
static OUT_OF_LINE int64_t planes__give_planes(array_double_1d work, array_double_1d tables, array_double_1d state, int64_t count);
static OUT_OF_LINE int64_t planes__enter_plane(array_double_1d work, int64_t region, int64_t slot);
static OUT_OF_LINE int64_t planes__leave_plane(array_double_1d work, int64_t region);

#endif
