/* FMI 2.0 co-simulation: hands values to a wheelset and takes them back. */
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"
#include "wheelset.h"

typedef struct {
    wheelset *wheelset;
    fmi2CallbackFunctions callbacks;
    char *name;
    bool warnings, errors;          /* log categories that are on */
} instance;

/* One line to the host's log; the message is a format there, so a percent sign is doubled. */
static void tell(const fmi2CallbackFunctions *callbacks, const char *name, fmi2Status status, const char *category,
                 const char *sentence)
{
    char message[2 * MODEL_SENTENCE];
    size_t at = 0;
    if (!callbacks->logger)
        return;
    for (; *sentence && at + 2 < sizeof message; sentence += 1)
    {
        if (*sentence == '%')
            message[at++] = '%';
        message[at++] = *sentence;
    }
    message[at] = 0;
    callbacks->logger(callbacks->componentEnvironment, name, status, category, message);
}

static void tell_warning(void *owner, const char *sentence)
{
    const instance *self = owner;
    if (self->warnings)
        tell(&self->callbacks, self->name, fmi2Warning, "logStatusWarning", sentence);
}

/* What an action's outcome is to the host. */
static fmi2Status answer(const instance *self, int refused)
{
    if (!refused)
        return fmi2OK;
    if (self->errors)
        tell(&self->callbacks, self->name, fmi2Error, "logStatusError", self->wheelset->sentence);
    return fmi2Error;
}

static fmi2Status refuse(const instance *self, const char *function, const char *reason)
{
    return self ? answer(self, wheelset_refuse(self->wheelset, "%s: %s", function, reason)) : fmi2Error;
}

/* --- creation ------------------------------------------------------------------------------------------ */

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }
const char *fmi2GetVersion(void) { return fmi2Version; }

static fmi2Component refuse_instance(const fmi2CallbackFunctions *callbacks, const char *name, const char *sentence)
{
    tell(callbacks, name ? name : "", fmi2Error, "logStatusError", sentence);
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
    if (type != fmi2CoSimulation)
        return refuse_instance(callbacks, name, "fmi2Instantiate: permitted is co-simulation only");
    if (!guid || strcmp(guid, MODEL_TOKEN) != 0)
        return refuse_instance(callbacks, name, "fmi2Instantiate: the GUID is not the one of this library, " MODEL_TOKEN);
    instance *self = calloc(1, sizeof *self);
    if (!self)
        return refuse_instance(callbacks, name, "fmi2Instantiate: not enough memory");
    self->callbacks = *callbacks;
    self->name = malloc(strlen(name) + 1);
    self->wheelset = wheelset_new(tell_warning, self);
    if (!self->name || !self->wheelset)
    {
        fmi2FreeInstance(self);
        return refuse_instance(callbacks, name, "fmi2Instantiate: not enough memory");
    }
    memcpy(self->name, name, strlen(name) + 1);
    self->warnings = self->errors = logging != fmi2False;
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
        return refuse(self, "fmi2SetDebugLogging", "categories is a NULL pointer");
    for (size_t i = 0; i < count; i += 1)
        if (!categories[i] || (strcmp(categories[i], "logStatusWarning") != 0 && strcmp(categories[i], "logStatusError") != 0))
            return refuse(self, "fmi2SetDebugLogging", "permitted categories are logStatusWarning, logStatusError");
    if (count == 0)
        self->warnings = self->errors = on != fmi2False;
    for (size_t i = 0; i < count; i += 1)
        *(strcmp(categories[i], "logStatusWarning") == 0 ? &self->warnings : &self->errors) = on != fmi2False;
    return fmi2OK;
}

/* --- life ------------------------------------------------------------------------------------------------ */

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start,
                               fmi2Boolean stop_defined, fmi2Real stop)
{
    instance *self = component;
    (void)tolerance_defined, (void)tolerance;       /* an algebraic model */
    if (!self)
        return fmi2Error;
    return answer(self, wheelset_experiment(self->wheelset, start, stop_defined != fmi2False, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component)
{
    instance *self = component;
    return self ? answer(self, wheelset_enter(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component)
{
    instance *self = component;
    return self ? answer(self, wheelset_exit(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2Terminate(fmi2Component component)
{
    instance *self = component;
    return self ? answer(self, wheelset_terminate(self->wheelset)) : fmi2Error;
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
    return self ? answer(self, wheelset_step(self->wheelset, time, size)) : fmi2Error;
}

/* --- values ---------------------------------------------------------------------------------------------- */

static int check_pointers(instance *self, const char *function, const void *references, size_t count, const void *values)
{
    if (count > 0 && (!references || !values))
        return wheelset_refuse(self->wheelset, "%s: %s is a NULL pointer", function, references ? "value" : "vr");
    return 0;
}

/* Whether all of a list of values can be read. */
static int check_list(instance *self, const char *function, const fmi2ValueReference references[], size_t count,
                      const void *values, model_type type)
{
    int refused = check_pointers(self, function, references, count, values);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_get(self->wheelset, references[i], type);
    return refused;
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2Real values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    if (check_list(self, "fmi2GetReal", references, count, values, MODEL_REAL) || wheelset_refresh(self->wheelset))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = self->wheelset->core.values[references[i]];
    return fmi2OK;
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2Integer values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    if (check_list(self, "fmi2GetInteger", references, count, values, MODEL_INTEGER) || wheelset_refresh(self->wheelset))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = wheelset_integer(self->wheelset, references[i]);
    return fmi2OK;
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2String values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    if (check_list(self, "fmi2GetString", references, count, values, MODEL_STRING))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = self->wheelset->core.text[model_variables[references[i]].slot];
    return fmi2OK;
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2Boolean values[])
{
    (void)references, (void)values;
    return component && count == 0 ? fmi2OK : refuse(component, "fmi2GetBoolean", "there are no Booleans");
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2Real values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    int refused = check_pointers(self, "fmi2SetReal", references, count, values);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_set_real(self->wheelset, references[i], values[i]);
    for (size_t i = 0; i < count && !refused; i += 1)       /* all or none */
        wheelset_set_real(self->wheelset, references[i], values[i]);
    return answer(self, refused);
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Integer values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    int refused = check_pointers(self, "fmi2SetInteger", references, count, values);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_set_integer(self->wheelset, references[i]);
    return answer(self, refused);
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2String values[])
{
    instance *self = component;
    if (!self)
        return fmi2Error;
    int refused = check_pointers(self, "fmi2SetString", references, count, values);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_set_string(self->wheelset, references[i], values[i]);
    for (size_t i = 0; i < count && !refused; i += 1)       /* all or none */
        wheelset_set_string(self->wheelset, references[i], values[i]);
    return answer(self, refused);
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[], size_t count,
                          const fmi2Boolean values[])
{
    (void)references, (void)values;
    return component && count == 0 ? fmi2OK : refuse(component, "fmi2SetBoolean", "there are no Booleans");
}

/* --- directional derivatives ------------------------------------------------------------------------------ */

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[], size_t unknown_count,
                                        const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seed[],
                                        fmi2Real sensitivity[])
{
    instance *self = component;
    double along[MODEL_INPUTS] = {0.0}, rates[ROW];
    if (!self)
        return fmi2Error;
    if ((unknown_count > 0 && (!unknowns || !sensitivity)) || (known_count > 0 && (!knowns || !seed)))
        return refuse(self, "fmi2GetDirectionalDerivative", "a list is a NULL pointer");
    for (size_t i = 0; i < unknown_count; i += 1)
        if (wheelset_check_unknown(self->wheelset, unknowns[i]))
            return answer(self, 1);
    for (size_t i = 0; i < known_count; i += 1)
    {
        if (wheelset_check_known(self->wheelset, knowns[i]))
            return answer(self, 1);
        along[knowns[i]] += seed[i];
    }
    if (wheelset_differentiate(self->wheelset, along, rates))
        return answer(self, 1);
    for (size_t i = 0; i < unknown_count; i += 1)
        sensitivity[i] = rates[unknowns[i] - MODEL_FIRST_OUTPUT];
    return fmi2OK;
}

/* --- saved states ---------------------------------------------------------------------------------------- */

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_save_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state)
{
    instance *self = component;
    return self ? answer(self, wheelset_restore_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_free_state(self->wheelset, state)) : fmi2Error;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size)
{
    instance *self = component;
    return self ? answer(self, wheelset_state_size(self->wheelset, state, size)) : fmi2Error;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    instance *self = component;
    return self ? answer(self, wheelset_write_state(self->wheelset, state, bytes, size)) : fmi2Error;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_read_state(self->wheelset, bytes, size, state)) : fmi2Error;
}

/* --- what there is not ------------------------------------------------------------------------------------- */

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[])
{
    (void)references, (void)count, (void)orders, (void)values;
    return refuse(component, "fmi2SetRealInputDerivatives", "inputs are not interpolated");
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer orders[], fmi2Real values[])
{
    (void)references, (void)count, (void)orders, (void)values;
    return refuse(component, "fmi2GetRealOutputDerivatives", "there are no output derivatives");
}

fmi2Status fmi2CancelStep(fmi2Component component)
{
    return refuse(component, "fmi2CancelStep", "a step is over when fmi2DoStep returns");
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value)
{
    (void)kind, (void)value;
    return refuse(component, "fmi2GetStatus", "a step is over when fmi2DoStep returns");
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value)
{
    const instance *self = component;
    if (!self || !value || kind != fmi2LastSuccessfulTime)
        return refuse(self, "fmi2GetRealStatus", "permitted is fmi2LastSuccessfulTime");
    *value = self->wheelset->core.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value)
{
    (void)kind, (void)value;
    return refuse(component, "fmi2GetIntegerStatus", "there is no Integer status");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value)
{
    if (!component || !value || kind != fmi2Terminated)
        return refuse(component, "fmi2GetBooleanStatus", "permitted is fmi2Terminated");
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind, fmi2String *value)
{
    (void)kind, (void)value;
    return refuse(component, "fmi2GetStringStatus", "a step is over when fmi2DoStep returns");
}

/* A function of model exchange. */
#define NO_EXCHANGE(NAME, ...)                                                  \
    fmi2Status NAME(fmi2Component component, __VA_ARGS__)                       \
    {                                                                           \
        return refuse(component, #NAME, "permitted is co-simulation only");     \
    }

fmi2Status fmi2EnterEventMode(fmi2Component component)
{
    return refuse(component, "fmi2EnterEventMode", "permitted is co-simulation only");
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component)
{
    return refuse(component, "fmi2EnterContinuousTimeMode", "permitted is co-simulation only");
}

NO_EXCHANGE(fmi2NewDiscreteStates, fmi2EventInfo *events)
NO_EXCHANGE(fmi2CompletedIntegratorStep, fmi2Boolean never_back, fmi2Boolean *event, fmi2Boolean *terminate)
NO_EXCHANGE(fmi2SetTime, fmi2Real time)
NO_EXCHANGE(fmi2SetContinuousStates, const fmi2Real states[], size_t n)
NO_EXCHANGE(fmi2GetDerivatives, fmi2Real derivatives[], size_t n)
NO_EXCHANGE(fmi2GetEventIndicators, fmi2Real indicators[], size_t n)
NO_EXCHANGE(fmi2GetContinuousStates, fmi2Real states[], size_t n)
NO_EXCHANGE(fmi2GetNominalsOfContinuousStates, fmi2Real nominals[], size_t n)
