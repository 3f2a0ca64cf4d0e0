/* The contact kernel as C sees it.
 *
 * The caller owns all memory; nothing is allocated or kept between calls, so handles on different memory may be stepped by
 * different threads.  generated/constants.h says what the arrays hold, wrcontact/status.py what a status means.
 */
#ifndef WRCONTACT_KERNEL_H
#define WRCONTACT_KERNEL_H

#include "spans.h"

#ifndef WRCONTACT_EXPORT
#  ifdef _WIN32
#    define WRCONTACT_EXPORT __declspec(dllexport)
#  else
#    define WRCONTACT_EXPORT __attribute__((visibility("default")))
#  endif
#endif

/* The arrays of one wheelset.  Only tables and inputs are left as they are. */
typedef struct {
    array_double_1d tables;
    array_double_1d state;
    array_double_1d workspace;
    array_double_1d inputs;
    array_double_1d outputs;
} wrcontact_handle;

/* One step from handle->inputs to handle->outputs; the status. */
WRCONTACT_EXPORT int wrcontact_step(const wrcontact_handle *handle);

/* `count` steps one after the other: rows of inputs in, rows of outputs and one status each out, instead of the handle's
 * own inputs and outputs.  Returns what the kernel's step_many returns. */
WRCONTACT_EXPORT int wrcontact_step_many(const wrcontact_handle *handle, int64_t count, double *inputs, double *outputs,
                                         double *statuses);

/* Cut the patch by itself in the workspace into strips along the rolling direction. */
WRCONTACT_EXPORT void wrcontact_divide_into_strips(array_double_1d workspace);

/* The creep force of the patch by itself in the workspace. */
WRCONTACT_EXPORT void wrcontact_solve_creep_force(array_double_1d tables, array_double_1d workspace);

/* The fingerprint of the sources this was compiled from; see wrcontact/kernel/binding/files.py. */
WRCONTACT_EXPORT int64_t wrcontact_abi(void);

#endif
