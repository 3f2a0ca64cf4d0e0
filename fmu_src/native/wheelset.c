/* The life cycle of a wheelset: values, initialisation, steps. */
#include "wheelset.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sentences.h"
#include "wheelset_parts.h"

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/constants.h"

static const double ROUNDING = 1e-9;     /* of a time that a host has added up over many steps, relative */

/* --- life ------------------------------------------------------------------------------------------- */

/* Build the tables where the parameters have changed, and begin with an empty memory. */
static int initialise(wheelset *self)
{
    if (self->core.built && wheelset_is_built(self))
        return 0;
    if (wheelset_build(self))
        return 1;
    memset(self->core.memory, 0, sizeof self->core.memory);
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    memset(self->core.values + MODEL_FIRST_OUTPUT, 0, ROW * sizeof(double));
    self->core.built = self->core.stale = 1;
    return 0;
}

wheelset *wheelset_new(wheelset_log *log, void *owner, bool exchange)
{
    wheelset *self = calloc(1, sizeof *self);
    if (!self)
        return NULL;
    self->log = log;
    self->owner = owner;
    self->core.exchange = exchange;
    self->workspace = calloc(MODEL_WORK, sizeof(double));
    self->derivative_room = calloc((size_t)wrcontact_derivative_room(), sizeof(double));
    if (!self->workspace || !self->derivative_room)
    {
        wheelset_free(self);
        return NULL;
    }
    wheelset_reset(self);
    return self;
}

void wheelset_free(wheelset *self)
{
    while (self->states)
    {
        wheelset_state *next = self->states->next;
        free(self->states);
        self->states = next;
    }
    wheelset_free_tables(self);
    free(self->workspace);
    free(self->derivative_room);
    free(self);
}

void wheelset_reset(wheelset *self)
{
    const int32_t exchange = self->core.exchange;
    memset(&self->core, 0, sizeof self->core);
    self->core.exchange = exchange;
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    for (int i = 0; i < MODEL_STATUS; i += 1)
    {
        self->core.values[i] = model_variables[i].start;
        if (model_variables[i].slot >= 0)
            snprintf(self->core.text[model_variables[i].slot], MODEL_TEXT, "%s", model_variables[i].text);
    }
    self->core.stations = MODEL_STATIONS;
    self->remarked = false;
    self->core.phase = PHASE_INSTANTIATED;
    self->core.stale = 1;
    self->core.stop = INFINITY;
}

int wheelset_experiment(wheelset *self, double start, bool stops, double stop)
{
    char first[40], last[40];
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, REFUSE_STARTED);
    if (!isfinite(start) || (stops && !(stop >= start)))
        return wheelset_refuse(self, REFUSE_TIMES, sentence_shortest(start, first, sizeof first),
                               sentence_shortest(stops ? stop : INFINITY, last, sizeof last));
    self->core.time = start;
    self->core.stop = stops ? stop : INFINITY;
    return 0;
}

int wheelset_configure(wheelset *self)
{
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, "configuration mode can be entered only after instantiation or a reset");
    self->core.phase = PHASE_CONFIGURING;
    return 0;
}

int wheelset_configured(wheelset *self)
{
    if (self->core.phase != PHASE_CONFIGURING)
        return wheelset_refuse(self, "configuration mode can be left only after it was entered");
    self->core.phase = PHASE_INSTANTIATED;
    return 0;
}

int wheelset_enter(wheelset *self)
{
    if (self->core.phase == PHASE_CONFIGURING)
        return wheelset_refuse(self, "configuration mode must be left before initialisation mode is entered");
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, REFUSE_ENTERED);
    if (initialise(self))
        return 1;
    self->core.phase = PHASE_INITIALISING;
    return 0;
}

int wheelset_exit(wheelset *self)
{
    if (self->core.phase != PHASE_INITIALISING)
        return wheelset_refuse(self, REFUSE_NOT_ENTERED);
    if (initialise(self))
        return 1;
    self->core.locked = 1;
    wheelset_refresh(self);
    self->core.logged = 0;
    self->core.phase = self->core.exchange ? PHASE_EVENT : PHASE_RUNNING;
    wheelset_accept(self);
    return 0;
}

int wheelset_terminate(wheelset *self)
{
    if (self->core.phase != PHASE_RUNNING && self->core.phase != PHASE_EVENT && self->core.phase != PHASE_CONTINUOUS)
        return wheelset_refuse(self, REFUSE_NOT_RUNNING);
    self->core.phase = PHASE_TERMINATED;
    return 0;
}

/* --- values ----------------------------------------------------------------------------------------- */

void wheelset_set_real(wheelset *self, uint32_t reference, double value)
{
    if (self->core.values[reference] == value)
        return;
    self->core.values[reference] = value;
    self->core.stale = 1;
}

void wheelset_set_string(wheelset *self, uint32_t reference, const char *value)
{
    char *held = self->core.text[model_variables[reference].slot];
    if (strcmp(held, value) == 0)
        return;
    memset(held, 0, MODEL_TEXT);
    memcpy(held, value, strlen(value));
    self->core.stale = 1;
}

int wheelset_set_stations(wheelset *self, uint64_t stations)
{
    const unsigned long long wanted = stations;
    if (stations == self->core.stations && self->core.phase != PHASE_TERMINATED)
        return 0;
    if (self->core.phase != PHASE_CONFIGURING)
        return wheelset_refuse(self, "stations is fixed at %d outside configuration mode and cannot become %llu",
                               (int)self->core.stations, wanted);
    if (stations < (uint64_t)layout__STATION_LEAST || stations > (uint64_t)layout__STATION_LIMIT)
        return wheelset_refuse(self, "stations is %llu; permitted is %d ... %d", wanted, (int)layout__STATION_LEAST,
                               (int)layout__STATION_LIMIT);
    self->core.stations = stations;
    return 0;
}

int32_t wheelset_integer(const wheelset *self, uint32_t reference)
{
    return (int32_t)(reference == MODEL_STATUS ? self->core.status : self->core.values[reference]);
}

int wheelset_refresh(wheelset *self)
{
    if (!self->core.stale || !(self->core.built || self->core.phase == PHASE_INITIALISING))
        return 0;
    if (!self->core.locked && initialise(self))
        return 1;
    wheelset_evaluate(self);
    return 0;
}

int wheelset_step(wheelset *self, double time, double size)
{
    char first[40], second[40], third[40];
    if (self->core.exchange)
        return wheelset_refuse(self, "steps are permitted in co-simulation only; this instance is for model exchange");
    if (self->core.phase != PHASE_RUNNING)
        return self->core.phase == PHASE_TERMINATED ? wheelset_refuse(self, REFUSE_NO_STEP_AFTER)
                                                    : wheelset_refuse(self, REFUSE_NO_STEP_BEFORE);
    if (!isfinite(time) || !isfinite(time + size) || size < 0.0)
        return wheelset_refuse(self, REFUSE_STEP,
                               sentence_shortest(size, first, sizeof first), sentence_shortest(time, second, sizeof second));
    if (time + size > self->core.stop + 1e-6 * size + ROUNDING * fabs(self->core.stop))
        return wheelset_refuse(self, REFUSE_PAST_STOP,
                               sentence_shortest(size, first, sizeof first), sentence_shortest(time, second, sizeof second),
                               sentence_shortest(self->core.stop, third, sizeof third));
    wheelset_refresh(self);
    if (self->core.status != 0.0 && !self->core.logged)
        wheelset_log_status(self);
    self->core.logged = 0;
    self->core.time = time + size;
    return 0;
}
