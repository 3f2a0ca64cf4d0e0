/* The search over rails whose section changes along the track. */
#ifndef WRCONTACT_SECTIONS_H
#define WRCONTACT_SECTIONS_H

#include "wrcontact_kernel.h"

/* The smallest gap of the wheel of side `index` over a rail whose section changes, at a pose of four numbers
 * (sections/section_pose.py), in the workspace; 1 if it is certain, else 0. */
WRCONTACT_EXPORT int wrcontact_search_sections(array_double_1d tables, array_double_1d workspace, int64_t index,
                                               array_double_1d pose);

#endif
