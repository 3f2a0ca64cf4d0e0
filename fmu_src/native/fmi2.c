/* FMI 2.0: an instance, its life and its saved states; values and derivatives are in fmi2_values.c, what belongs to model
 * exchange in fmi2_exchange.c. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2_instance.h"
#include "sentences.h"

/* One line to the host's log. */
static void log_message(const fmi2CallbackFunctions *callbacks, const char *name, fmi2Status status, const char *category,
                        const char *sentence)
{
    char message[2 * MODEL_SENTENCE];
    if (callbacks->logger)
        callbacks->logger(callbacks->componentEnvironment, name, status, category,
                          sentence_doubled(sentence, "%#", message, sizeof message));
}

static void log_warning(void *owner, const char *sentence)
{
    const instance *self = owner;
    if (self->warnings)
        log_message(&self->callbacks, self->name, fmi2Warning, "logStatusWarning", sentence);
}

/* What an action's outcome is to the host. */
fmi2Status fmi2_answer(const instance *self, int refused)
{
    if (!refused)
        return fmi2OK;
    if (self->errors)
        log_message(&self->callbacks, self->name, fmi2Error, "logStatusError", self->wheelset->sentence);
    return fmi2Error;
}

fmi2Status fmi2_refuse(const instance *self, const char *function, const char *reason)
{
    return self ? fmi2_answer(self, wheelset_refuse(self->wheelset, "%s: %s", function, reason)) : fmi2Error;
}

/* --- creation --------------------------------------------------------------------------------------- */

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

static fmi2Component refuse_instance(const fmi2CallbackFunctions *callbacks, const char *name, const char *sentence)
{
    log_message(callbacks, name ? name : "", fmi2Error, "logStatusError", sentence);
    return NULL;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    (void)resources, (void)visible;         /* everything is in this library */
    if (!callbacks)
        return NULL;
    if (!name || !*name)
        return refuse_instance(callbacks, name, "fmi2Instantiate: the instance name is empty; permitted are names");
    if (type != fmi2CoSimulation && type != fmi2ModelExchange)
        return refuse_instance(callbacks, name, "fmi2Instantiate: permitted are co-simulation and model exchange");
    if (!guid || strcmp(guid, MODEL_TOKEN) != 0)
    {
        char sentence[200];
        snprintf(sentence, sizeof sentence, "fmi2Instantiate: the GUID is not the one of this library, %s", MODEL_TOKEN);
        return refuse_instance(callbacks, name, sentence);
    }
    instance *self = calloc(1, sizeof *self);
    if (!self)
        return refuse_instance(callbacks, name, "fmi2Instantiate: not enough memory");
    self->callbacks = *callbacks;
    self->name = malloc(strlen(name) + 1);
    self->wheelset = wheelset_new(log_warning, self, type == fmi2ModelExchange);
    if (!self->name || !self->wheelset)
    {
        fmi2FreeInstance(self);
        return refuse_instance(callbacks, name, "fmi2Instantiate: not enough memory");
    }
    memcpy(self->name, name, strlen(name) + 1);
    self->warnings = logging != fmi2False;
    self->errors = true;            /* why a call failed is no debug message */
    return self;
}

void fmi2FreeInstance(fmi2Component component)
{
    instance *self = component;
    if (!self)
        return;
    if (self->wheelset)
        wheelset_free(self->wheelset);
    free(self->name);
    free(self);
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t count, const fmi2String categories[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    if (count > 0 && !categories)
        return fmi2_refuse(self, "fmi2SetDebugLogging", "categories is a NULL pointer");
    for (size_t i = 0; i < count; i += 1)
        if (!categories[i] || (strcmp(categories[i], "logStatusWarning") != 0 && strcmp(categories[i], "logStatusError") != 0))
            return fmi2_refuse(self, "fmi2SetDebugLogging", "permitted categories are logStatusWarning, logStatusError");
    if (count == 0)
    {
        self->warnings = on != fmi2False;
        self->errors = true;        /* only its own name switches it off */
    }
    for (size_t i = 0; i < count; i += 1)
        *(strcmp(categories[i], "logStatusWarning") == 0 ? &self->warnings : &self->errors) = on != fmi2False;
    return fmi2OK;
}

/* --- life ------------------------------------------------------------------------------------------- */

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean stop_defined, fmi2Real stop)
{
    instance *self = component;
    (void)tolerance_defined, (void)tolerance;       /* an algebraic model */
    if (!self)
        return fmi2Error;
    return fmi2_answer(self, wheelset_experiment(self->wheelset, start, stop_defined != fmi2False, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_enter(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_exit(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2Terminate(fmi2Component component)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_terminate(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2Reset(fmi2Component component)
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    wheelset_reset(self->wheelset);
    return fmi2OK;
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real time, fmi2Real size, fmi2Boolean never_back)
{
    instance *self = component;
    (void)never_back;
    return self ? fmi2_answer(self, wheelset_step(self->wheelset, time, size)) : fmi2Error;
}

/* --- saved states ----------------------------------------------------------------------------------- */

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_save_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_restore_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_free_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_state_size(self->wheelset, state, size)) : fmi2Error;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_write_state(self->wheelset, state, bytes, size)) : fmi2Error;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_read_state(self->wheelset, bytes, size, state)) : fmi2Error;
}
