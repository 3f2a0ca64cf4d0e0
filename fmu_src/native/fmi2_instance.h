/* An instance in FMI 2.0: a wheelset, and how errors are logged. */
#ifndef FMI2_INSTANCE_H
#define FMI2_INSTANCE_H

#include "fmi2Functions.h"
#include "wheelset.h"

typedef struct {
    wheelset *wheelset;
    fmi2CallbackFunctions callbacks;
    char *name;
    bool warnings, errors;          /* log categories that are on */
} instance;

fmi2Status fmi2_answer(const instance *self, int refused);      /* what an action's outcome is to the host */
fmi2Status fmi2_refuse(const instance *self, const char *function, const char *reason);

#endif
