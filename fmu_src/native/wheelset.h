/* The life cycle of one simulated wheelset, free of FMI: what wrcontact/interface/session.py is in Python.
 *
 * Functions that can be refused return 0 when they did what they were asked, and otherwise 1 with the reason in `sentence`;
 * then nothing has changed.  Memory is allocated by wheelset_new and by the preparation at initialisation, and nowhere else.
 */
#ifndef WHEELSET_H
#define WHEELSET_H

#include <stdbool.h>
#include <stddef.h>

#include "kernel/native/wrcontact_prepare.h"
#include "kernel/native/wrcontact_tangent.h"
#include "model.h"

typedef enum { PHASE_INSTANTIATED, PHASE_INITIALISING, PHASE_RUNNING, PHASE_TERMINATED } wheelset_phase;

/* What a simulation goes on from: all that a saved state holds. */
typedef struct {
    double values[MODEL_VARIABLES];         /* by value reference */
    double memory[MODEL_MEMORY];            /* the kernel's state */
    double known[MODEL_KNOWN];              /* the inputs and outputs that the kernel has evaluated last */
    double time;
    char text[MODEL_STRINGS][MODEL_TEXT];   /* the Strings */
    int32_t phase;
    int32_t built;                          /* the tables belong to the parameters as last initialised */
    int32_t locked;                         /* the parameters are fixed */
    int32_t stale;                          /* an input has changed since the last evaluation */
    int32_t told;                           /* this step's status has been told */
    int32_t unused;
} wheelset_core;

/* A saved state as bytes. */
typedef struct {
    char format[16];
    char token[48];
    uint64_t size;
    uint64_t checksum;
    wheelset_core core;
} wheelset_saved;

typedef void wheelset_tell(void *owner, const char *sentence);

typedef struct {
    wheelset_core core;
    wheelset_tell *tell;                    /* is told one sentence for every step whose status is not 0 */
    void *owner;
    double *tables;
    int64_t table_size;
    double *workspace;
    double *tangent_room;                   /* memory of a directional derivative */
    double built_values[MODEL_VARIABLES];   /* the parameters that the tables were made with */
    char built_text[MODEL_STRINGS][MODEL_TEXT];
    char sentence[MODEL_SENTENCE];
} wheelset;

wheelset *wheelset_new(wheelset_tell *tell, void *owner);       /* NULL: there is no memory */
void wheelset_free(wheelset *self);
void wheelset_reset(wheelset *self);

int wheelset_refuse(wheelset *self, const char *format, ...);   /* 1, with this sentence */
int wheelset_check(wheelset *self, uint32_t reference, model_type type);

int wheelset_set_real(wheelset *self, uint32_t reference, double value);
int wheelset_set_string(wheelset *self, uint32_t reference, const char *value);
int wheelset_set_integer(wheelset *self, uint32_t reference);   /* none can be set */
int wheelset_refresh(wheelset *self);                           /* bring the outputs up to date, before they are read */

int wheelset_enter(wheelset *self);                             /* initialisation mode */
int wheelset_exit(wheelset *self);                              /* and out of it */
int wheelset_step(wheelset *self, double time, double size);
int wheelset_terminate(wheelset *self);

/* Directional derivatives of the outputs at the present inputs; they change nothing of the instance. */
int wheelset_check_known(wheelset *self, uint32_t reference);
int wheelset_check_unknown(wheelset *self, uint32_t reference);
int wheelset_differentiate(wheelset *self, const double seed[MODEL_INPUTS], double rates[MODEL_OUTPUTS]);

void wheelset_save(const wheelset *self, wheelset_saved *saved);
int wheelset_restore(wheelset *self, const wheelset_saved *saved, size_t size);

#endif
