/* The life cycle of one simulated wheelset, free of FMI: what wrcontact/simulation/session.py is in Python.
 *
 * Functions that can be refused return 0 when they did what they were asked, and otherwise 1 with the reason in `sentence`;
 * then nothing has changed.  Memory is allocated by wheelset_new, by the preparation at initialisation and
 * for saved states, and nowhere else.
 */
#ifndef WHEELSET_H
#define WHEELSET_H

#include <stdbool.h>
#include <stddef.h>

#include "kernel/native/wrcontact_prepare.h"
#include "kernel/native/wrcontact_derivative.h"
#include "model.h"

/* After its initialisation a wheelset is running in co-simulation; in model exchange it is in event mode or in
 * continuous-time mode. */
typedef enum { PHASE_INSTANTIATED, PHASE_CONFIGURING, PHASE_INITIALISING, PHASE_RUNNING, PHASE_TERMINATED, PHASE_EVENT,
               PHASE_CONTINUOUS } wheelset_phase;

/* What the kernel gives: the outputs, and behind them, from the place MODEL_BEHIND on, the outlines, if they are of another
 * number of stations than MODEL_STATIONS, and the outputs of wear, if they are asked for. */
enum { ROW = MODEL_OUTPUTS + MODEL_OUTLINES };

/* Rates of a row, and behind them those of the equilibrium. */
enum { RATES = ROW + MODEL_FIRST_OUTPUT - MODEL_EQUILIBRIUM };

/* What a simulation goes on from: all that a saved state holds. */
typedef struct {
    double values[MODEL_FIRST_OUTPUT + ROW];        /* by place in model_variables, and the rest of the row */
    double status;                          /* whose place is MODEL_STATUS */
    uint64_t stations;                      /* of an outline */
    double memory[MODEL_MEMORY];            /* the kernel's state */
    double known[MODEL_KNOWN];              /* the inputs evaluated last, and whether the outputs are theirs */
    double accepted[MODEL_INPUTS];          /* in model exchange: those of the last accepted point with valid outputs */
    double time;
    double stop;                            /* no step goes beyond it */
    char text[MODEL_STRINGS][MODEL_TEXT];   /* the Strings */
    int32_t phase;
    int32_t built;                          /* the tables belong to the parameters as last initialised */
    int32_t locked;                         /* the parameters are fixed */
    int32_t stale;                          /* an input has changed since the last evaluation */
    int32_t logged;                         /* this step's status has been logged */
    int32_t balanced;                       /* the equilibrium is that of the inputs */
    int32_t exchange;                       /* model exchange, not co-simulation */
    int32_t accepts;                        /* there has been an accepted point with valid outputs */
} wheelset_core;

/* A saved state as bytes. */
typedef struct {
    char format[16];
    char token[48];
    uint64_t size;
    uint64_t checksum;
    wheelset_core core;
} wheelset_saved;

/* A saved state of an instance: what the host holds a pointer to.  A pointer that is not in the list is never followed. */
typedef struct wheelset_state {
    struct wheelset_state *next;
    wheelset_saved saved;
} wheelset_state;

typedef void wheelset_log(void *owner, const char *sentence);

typedef struct {
    wheelset_core core;
    wheelset_log *log;                    /* logs one sentence for every step whose status is not 0 */
    void *owner;
    array_double_1d tables;
    double *workspace;
    double *derivative_room;                   /* memory of a directional derivative */
    double built_values[MODEL_VARIABLES];   /* the parameters that the tables were made with */
    char built_text[MODEL_STRINGS][MODEL_TEXT];
    wheelset_state *states;                 /* those that the host has not freed */
    bool remarked;                          /* an unusual load has been logged */
    char sentence[MODEL_SENTENCE];
} wheelset;

wheelset *wheelset_new(wheelset_log *log, void *owner, bool exchange);        /* NULL: there is no memory */
void wheelset_free(wheelset *self);
void wheelset_reset(wheelset *self);

int wheelset_refuse(wheelset *self, const char *format, ...);   /* 1, with this sentence */
int wheelset_check(wheelset *self, uint32_t reference, model_type type);

int wheelset_may_set_real(wheelset *self, uint32_t reference, double value);
int wheelset_may_set_string(wheelset *self, uint32_t reference, const char *value);
int wheelset_may_set_integer(wheelset *self, uint32_t reference);       /* none can be set */
int wheelset_may_set_boolean(wheelset *self, uint32_t reference, bool value);
int wheelset_may_get(wheelset *self, uint32_t reference, model_type type);
void wheelset_set_real(wheelset *self, uint32_t reference, double value);
void wheelset_set_string(wheelset *self, uint32_t reference, const char *value);
int32_t wheelset_integer(const wheelset *self, uint32_t reference);
int wheelset_refresh(wheelset *self);                           /* bring the outputs up to date, before they are read */
bool wheelset_is_equilibrium(uint32_t reference);               /* whether a variable is computed only when it is read: */
void wheelset_find_equilibrium(wheelset *self);                 /* bring these up to date, after the outputs */

int wheelset_experiment(wheelset *self, double start, bool stops, double stop);        /* where the steps begin and end */
int wheelset_configure(wheelset *self);                         /* configuration mode, in which stations can be set */
int wheelset_set_stations(wheelset *self, uint64_t stations);
int wheelset_configured(wheelset *self);                        /* and out of it */
int wheelset_enter(wheelset *self);                             /* initialisation mode */
int wheelset_exit(wheelset *self);                              /* and out of it */
int wheelset_step(wheelset *self, double time, double size);
int wheelset_terminate(wheelset *self);

/* Model exchange: a model without states and event indicators, whose outputs follow the inputs at every point of a solver. */
int wheelset_enter_event_mode(wheelset *self);
int wheelset_update_discrete(wheelset *self);                   /* which ends an event: nothing has to be iterated */
int wheelset_enter_continuous_mode(wheelset *self);
int wheelset_set_time(wheelset *self, double time);
int wheelset_complete_step(wheelset *self);                     /* the present inputs are an accepted point */
int wheelset_check_empty(wheelset *self, const char *what, size_t count);       /* a list of states or event indicators */

/* The host's pointers to states; a new one is made where `*state` is NULL, and for bytes also where it is unknown. */
int wheelset_save_state(wheelset *self, void **state);
int wheelset_restore_state(wheelset *self, const void *state);
int wheelset_free_state(wheelset *self, void **state);
int wheelset_state_size(wheelset *self, const void *state, size_t *size);
int wheelset_write_state(wheelset *self, const void *state, void *bytes, size_t size);
int wheelset_read_state(wheelset *self, const void *bytes, size_t size, void **state);

/* Directional derivatives of the outputs at the present inputs; they change nothing of the instance. */
int wheelset_check_known(wheelset *self, uint32_t reference);
int wheelset_check_unknown(wheelset *self, uint32_t reference);
int wheelset_differentiate(wheelset *self, const double seed[MODEL_INPUTS], bool equilibrium, double rates[RATES]);
size_t wheelset_rate_of(uint32_t reference);                    /* the place of an output's rate */

#endif
