/* What a simulation needs at its start: the kernel's tables from definitions of the profiles and the parameters.
 *
 * kernel/prepare/tables.py (setup, report, outcome) and kernel/prepare/zones.py (definitions) describe the arrays.
 * The caller owns all memory; nothing is allocated.
 */
#ifndef WRCONTACT_PREPARE_H
#define WRCONTACT_PREPARE_H

#include "wrcontact_kernel.h"

typedef struct {
    array_double_1d setup;
    array_double_1d wheel;
    array_double_1d rail;
    array_double_1d fixed;
    array_double_1d tables;         /* are written, as far as report tells */
    array_double_1d work;           /* at least wrcontact_prepare_room(preparation) numbers */
    array_double_1d report;
} wrcontact_preparation;

/* How long the work array has to be for these definitions and this length of the tables. */
WRCONTACT_EXPORT int64_t wrcontact_prepare_room(const wrcontact_preparation *preparation);

/* Fill the tables of one side; the outcome.  Where they are too short it says so, and a longer array is the remedy. */
WRCONTACT_EXPORT int wrcontact_prepare(const wrcontact_preparation *preparation);

/* Complete the tables of both sides, which are one array where the sides are equal: starts and methods.  `work` is the work
 * array of either preparation. */
WRCONTACT_EXPORT void wrcontact_complete(array_double_1d setup, array_double_1d left, array_double_1d right, double *work);

#endif
