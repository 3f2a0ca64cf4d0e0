/* FMI 3.0: an instance, its life and its saved states; values and derivatives are in fmi3_values.c, what belongs to model
 * exchange in fmi3_exchange.c. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi3_instance.h"
#include "sentences.h"

/* One line to the host's log. */
static void log_message(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, fmi3Status status, const char *category,
                        const char *sentence)
{
    char message[2 * MODEL_SENTENCE];
    if (log)
        log(environment, status, category, sentence_doubled(sentence, "#", message, sizeof message));
}

static void log_warning(void *owner, const char *sentence)
{
    const instance *self = owner;
    if (self->warnings)
        log_message(self->environment, self->log, fmi3Warning, "logStatusWarning", sentence);
}

/* What an action's outcome is to the host. */
fmi3Status fmi3_answer(const instance *self, int refused)
{
    if (!refused)
        return fmi3OK;
    if (self->errors)
        log_message(self->environment, self->log, fmi3Error, "logStatusError", self->wheelset->sentence);
    return fmi3Error;
}

fmi3Status fmi3_refuse(const instance *self, const char *function, const char *reason)
{
    return self ? fmi3_answer(self, wheelset_refuse(self->wheelset, "%s: %s", function, reason)) : fmi3Error;
}

/* --- creation --------------------------------------------------------------------------------------- */

const char *fmi3GetVersion(void) { return fmi3Version; }

static fmi3Instance refuse_instance(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, const char *sentence)
{
    log_message(environment, log, fmi3Error, "logStatusError", sentence);
    return NULL;
}

/* An instance for co-simulation or for model exchange, which `function` makes. */
static fmi3Instance create(const char *function, fmi3String name, fmi3String token, bool exchange, fmi3Boolean logging,
                           fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    char sentence[200];
    instance *self = NULL;
    if (!name || !*name)
        snprintf(sentence, sizeof sentence, "%s: the instance name is empty; permitted are names", function);
    else if (!token || strcmp(token, MODEL_TOKEN) != 0)
        snprintf(sentence, sizeof sentence, "%s: the instantiation token is not the one of this library, %s", function, MODEL_TOKEN);
    else
    {
        snprintf(sentence, sizeof sentence, "%s: not enough memory", function);
        self = calloc(1, sizeof *self);
    }
    if (self)
        self->wheelset = wheelset_new(log_warning, self, exchange);
    if (!self || !self->wheelset)
    {
        free(self);
        return refuse_instance(environment, log, sentence);
    }
    self->environment = environment;
    self->log = log;
    self->warnings = logging;
    self->errors = true;            /* why a call failed is no debug message */
    return self;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean events, fmi3Boolean early_return,
                                         const fmi3ValueReference intermediate[], size_t intermediate_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update)
{
    (void)resources, (void)visible, (void)early_return, (void)intermediate, (void)update;   /* everything is in this library */
    if (events)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: there is no event mode");
    if (intermediate_count > 0)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: there are no intermediate values");
    return create("fmi3InstantiateCoSimulation", name, token, false, logging, environment, log);
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)resources, (void)visible;
    return create("fmi3InstantiateModelExchange", name, token, true, logging, environment, log);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                               fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                               fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
    return refuse_instance(environment, log, "fmi3InstantiateScheduledExecution: permitted are co-simulation and model exchange");
}

void fmi3FreeInstance(fmi3Instance component)
{
    instance *self = component;
    if (!self)
        return;
    wheelset_free(self->wheelset);
    free(self);
}

fmi3Status fmi3SetDebugLogging(fmi3Instance component, fmi3Boolean on, size_t count, const fmi3String categories[])
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (count > 0 && !categories)
        return fmi3_refuse(self, "fmi3SetDebugLogging", "categories is a NULL pointer");
    for (size_t i = 0; i < count; i += 1)
        if (!categories[i] || (strcmp(categories[i], "logStatusWarning") != 0 && strcmp(categories[i], "logStatusError") != 0))
            return fmi3_refuse(self, "fmi3SetDebugLogging", "permitted categories are logStatusWarning, logStatusError");
    if (count == 0)
    {
        self->warnings = on;
        self->errors = true;        /* only its own name switches it off */
    }
    for (size_t i = 0; i < count; i += 1)
        *(strcmp(categories[i], "logStatusWarning") == 0 ? &self->warnings : &self->errors) = on;
    return fmi3OK;
}

/* --- life ------------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterInitializationMode(fmi3Instance component, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop)
{
    instance *self = component;
    (void)tolerance_defined, (void)tolerance;       /* an algebraic model */
    if (!self)
        return fmi3Error;
    return fmi3_answer(self, wheelset_experiment(self->wheelset, start, stop_defined, stop) || wheelset_enter(self->wheelset));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_exit(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3Terminate(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_terminate(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3Reset(fmi3Instance component)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    wheelset_reset(self->wheelset);
    return fmi3OK;
}

fmi3Status fmi3DoStep(fmi3Instance component, fmi3Float64 time, fmi3Float64 size, fmi3Boolean never_back, fmi3Boolean *event,
                      fmi3Boolean *terminate, fmi3Boolean *early_return, fmi3Float64 *last)
{
    instance *self = component;
    (void)never_back;
    if (!self)
        return fmi3Error;
    if (!event || !terminate || !early_return || !last)
        return fmi3_refuse(self, "fmi3DoStep", "a result is a NULL pointer");
    *event = *terminate = *early_return = fmi3False;
    *last = self->wheelset->core.time;
    if (wheelset_step(self->wheelset, time, size))
        return fmi3_answer(self, 1);
    *last = self->wheelset->core.time;
    return fmi3OK;
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_configure(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_configured(self->wheelset)) : fmi3Error;
}

/* --- saved states ----------------------------------------------------------------------------------- */

fmi3Status fmi3GetFMUState(fmi3Instance component, fmi3FMUState *state)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_save_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3SetFMUState(fmi3Instance component, fmi3FMUState state)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_restore_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3FreeFMUState(fmi3Instance component, fmi3FMUState *state)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_free_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance component, fmi3FMUState state, size_t *size)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_state_size(self->wheelset, state, size)) : fmi3Error;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance component, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_write_state(self->wheelset, state, bytes, size)) : fmi3Error;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance component, const fmi3Byte bytes[], size_t size, fmi3FMUState *state)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_read_state(self->wheelset, bytes, size, state)) : fmi3Error;
}
