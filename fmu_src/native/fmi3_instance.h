/* An instance in FMI 3.0: a wheelset, and how errors are logged. */
#ifndef FMI3_INSTANCE_H
#define FMI3_INSTANCE_H

#include "fmi3Functions.h"
#include "wheelset.h"

typedef struct {
    wheelset *wheelset;
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    bool warnings, errors;          /* log categories that are on */
} instance;

typedef const fmi3ValueReference *reference_list;

fmi3Status fmi3_answer(const instance *self, int refused);      /* what an action's outcome is to the host */
fmi3Status fmi3_refuse(const instance *self, const char *function, const char *reason);

#endif
