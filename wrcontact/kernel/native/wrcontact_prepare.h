/* What a simulation needs at its start: the kernel's tables from definitions of the profiles and the parameters.
 *
 * generated/constants.h describes the arrays (layout/arrays.py: setup; prepare/tables.py: reasons; prepare/zones.py: definitions).
 * The caller owns all memory; nothing is allocated.
 */
#ifndef WRCONTACT_PREPARE_H
#define WRCONTACT_PREPARE_H

#include "wrcontact_kernel.h"

typedef struct {
    array_double_1d setup;          /* also says why a profile cannot be used */
    array_double_1d wheel;
    array_double_1d rail;
    array_double_1d left_wheel;     /* the same as on the right where it is the same profile */
    array_double_1d left_rail;
    array_double_1d fixed;
    array_double_1d tables;         /* are written */
    array_double_1d work;           /* at least wrcontact_prepare_room(preparation) numbers */
} wrcontact_preparation;

/* How long the work array has to be for these definitions and this length of the tables. */
WRCONTACT_EXPORT int64_t wrcontact_prepare_room(const wrcontact_preparation *preparation);

/* Fill the tables; how many numbers of them are used, or a negative reason.  Where they are too short it says so, and a longer
 * array is the remedy. */
WRCONTACT_EXPORT int wrcontact_prepare(const wrcontact_preparation *preparation);

#endif
