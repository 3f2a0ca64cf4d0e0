/* FMI 3.0 co-simulation: hands values to a wheelset and takes them back.
 *
 * A variable of FMI 3 is a block of neighbouring values of the wheelset: one value, or an outline's array.
 */
#include <stdlib.h>
#include <string.h>

#include "fmi3Functions.h"
#include "wheelset.h"

typedef struct {
    wheelset *wheelset;
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    bool warnings, errors;          /* log categories that are on */
} instance;

typedef const fmi3ValueReference *reference_list;

static void tell_warning(void *owner, const char *sentence)
{
    const instance *self = owner;
    if (self->warnings && self->log)
        self->log(self->environment, fmi3Warning, "logStatusWarning", sentence);
}

/* What an action's outcome is to the host. */
static fmi3Status answer(const instance *self, int refused)
{
    if (!refused)
        return fmi3OK;
    if (self->errors && self->log)
        self->log(self->environment, fmi3Error, "logStatusError", self->wheelset->sentence);
    return fmi3Error;
}

static fmi3Status refuse(const instance *self, const char *function, const char *reason)
{
    return self ? answer(self, wheelset_refuse(self->wheelset, "%s: %s", function, reason)) : fmi3Error;
}

/* --- creation ------------------------------------------------------------------------------------------ */

const char *fmi3GetVersion(void) { return fmi3Version; }

static fmi3Instance refuse_instance(fmi3InstanceEnvironment environment, fmi3LogMessageCallback log, const char *sentence)
{
    if (log)
        log(environment, fmi3Error, "logStatusError", sentence);
    return NULL;
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                         fmi3Boolean logging, fmi3Boolean events, fmi3Boolean early_return,
                                         const fmi3ValueReference intermediate[], size_t intermediate_count,
                                         fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
                                         fmi3IntermediateUpdateCallback update)
{
    (void)resources, (void)visible, (void)early_return, (void)intermediate, (void)update;   /* everything is in this library */
    if (!name || !*name)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: the instance name is empty; permitted are names");
    if (!token || strcmp(token, MODEL_TOKEN) != 0)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: the instantiation token is not the one of this "
                               "library, " MODEL_TOKEN);
    if (events)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: there is no event mode");
    if (intermediate_count > 0)
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: there are no intermediate values");
    instance *self = calloc(1, sizeof *self);
    if (self)
        self->wheelset = wheelset_new(tell_warning, self);
    if (!self || !self->wheelset)
    {
        free(self);
        return refuse_instance(environment, log, "fmi3InstantiateCoSimulation: not enough memory");
    }
    self->environment = environment;
    self->log = log;
    self->warnings = self->errors = logging;
    return self;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                          fmi3Boolean logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging;
    return refuse_instance(environment, log, "fmi3InstantiateModelExchange: permitted is co-simulation only");
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources, fmi3Boolean visible,
                                               fmi3Boolean logging, fmi3InstanceEnvironment environment,
                                               fmi3LogMessageCallback log, fmi3ClockUpdateCallback update,
                                               fmi3LockPreemptionCallback lock, fmi3UnlockPreemptionCallback unlock)
{
    (void)name, (void)token, (void)resources, (void)visible, (void)logging, (void)update, (void)lock, (void)unlock;
    return refuse_instance(environment, log, "fmi3InstantiateScheduledExecution: permitted is co-simulation only");
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
        return refuse(self, "fmi3SetDebugLogging", "categories is a NULL pointer");
    for (size_t i = 0; i < count; i += 1)
        if (!categories[i] || (strcmp(categories[i], "logStatusWarning") != 0 && strcmp(categories[i], "logStatusError") != 0))
            return refuse(self, "fmi3SetDebugLogging", "permitted categories are logStatusWarning, logStatusError");
    if (count == 0)
        self->warnings = self->errors = on;
    for (size_t i = 0; i < count; i += 1)
        *(strcmp(categories[i], "logStatusWarning") == 0 ? &self->warnings : &self->errors) = on;
    return fmi3OK;
}

/* --- life ------------------------------------------------------------------------------------------------ */

fmi3Status fmi3EnterInitializationMode(fmi3Instance component, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop)
{
    instance *self = component;
    (void)tolerance_defined, (void)tolerance;       /* an algebraic model */
    if (!self)
        return fmi3Error;
    return answer(self, wheelset_experiment(self->wheelset, start, stop_defined, stop) || wheelset_enter(self->wheelset));
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? answer(self, wheelset_exit(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3Terminate(fmi3Instance component)
{
    instance *self = component;
    return self ? answer(self, wheelset_terminate(self->wheelset)) : fmi3Error;
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
        return refuse(self, "fmi3DoStep", "a result is a NULL pointer");
    *event = *terminate = *early_return = fmi3False;
    *last = self->wheelset->core.time;
    if (wheelset_step(self->wheelset, time, size))
        return answer(self, 1);
    *last = self->wheelset->core.time;
    return fmi3OK;
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? answer(self, wheelset_configure(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance component)
{
    instance *self = component;
    return self ? answer(self, wheelset_configured(self->wheelset)) : fmi3Error;
}

/* --- values ---------------------------------------------------------------------------------------------- */

/* How many values a variable has. */
static size_t block_size(const instance *self, const model_block *block)
{
    return block->run < 0 ? 1 : (size_t)self->wheelset->core.stations;
}

/* The values of a Float64. */
static const double *block_values(const instance *self, const model_block *block)
{
    const wheelset_core *core = &self->wheelset->core;
    if (block->first == BLOCK_TIME)
        return &core->time;
    if (block->run < 0 || core->stations == MODEL_STATIONS)
        return core->values + block->first;
    return core->values + MODEL_STATUS + (size_t)block->run * core->stations;
}

/* Where the values of an output begin in the kernel's row. */
static size_t place_in_row(const instance *self, const model_block *block)
{
    return (size_t)(block_values(self, block) - (self->wheelset->core.values + MODEL_FIRST_OUTPUT));
}

/* Whether a variable is of this type; `reading`: and can be read. */
static int check_type(instance *self, const model_block *block, model_type type, bool reading)
{
    if (block->first >= 0 && reading)
        return wheelset_may_get(self->wheelset, (uint32_t)block->first, type);
    if (block->first >= 0)
        return wheelset_check(self->wheelset, (uint32_t)block->first, type);
    if (type == (block->first == BLOCK_TIME ? MODEL_REAL : MODEL_UNSIGNED))
        return 0;
    return wheelset_refuse(self->wheelset, "%s, not of this function's",
                           block->first == BLOCK_TIME ? "time is of type Real" : "stations is of type UInt64");
}

static int check_reference(instance *self, fmi3ValueReference reference)
{
    if (reference < 1 || reference > MODEL_BLOCKS)
        return wheelset_refuse(self->wheelset, "value reference %lu does not exist; they run from 1 to %d",
                               (unsigned long)reference, MODEL_BLOCKS);
    return 0;
}

/* Whether a list of variables is known and of this type, with as many values as they hold; `reading`: and can be read. */
static int check_list(instance *self, const char *function, reference_list references, size_t count, const void *values,
                      size_t value_count, model_type type, bool reading)
{
    size_t needed = 0;
    if (count > 0 && (!references || !values))
        return wheelset_refuse(self->wheelset, "%s: %s is a NULL pointer", function, references ? "values" : "valueReferences");
    if (count > 0 && self->wheelset->core.phase == PHASE_CONFIGURING && type != MODEL_UNSIGNED)
        return wheelset_refuse(self->wheelset, "%s: permitted in configuration mode is stations", function);
    for (size_t i = 0; i < count; i += 1)
    {
        if (check_reference(self, references[i]))
            return 1;
        const model_block *block = model_blocks + references[i];
        if (check_type(self, block, type, reading))
            return 1;
        needed += block_size(self, block);
    }
    if (needed != value_count)
        return wheelset_refuse(self->wheelset, "%s: there are %lu values; these variables have %lu", function,
                               (unsigned long)value_count, (unsigned long)needed);
    return 0;
}

fmi3Status fmi3GetFloat64(fmi3Instance component, const fmi3ValueReference references[], size_t count, fmi3Float64 values[],
                          size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (check_list(self, "fmi3GetFloat64", references, count, values, value_count, MODEL_REAL, true)
        || wheelset_refresh(self->wheelset))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
    {
        const model_block *block = model_blocks + references[i];
        const double *from = block_values(self, block);
        for (size_t k = block_size(self, block); k > 0; k -= 1)
            *values++ = *from++;
    }
    return fmi3OK;
}

fmi3Status fmi3GetInt32(fmi3Instance component, const fmi3ValueReference references[], size_t count, fmi3Int32 values[],
                        size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (check_list(self, "fmi3GetInt32", references, count, values, value_count, MODEL_INTEGER, true)
        || wheelset_refresh(self->wheelset))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = wheelset_integer(self->wheelset, (uint32_t)model_blocks[references[i]].first);
    return fmi3OK;
}

fmi3Status fmi3GetUInt64(fmi3Instance component, const fmi3ValueReference references[], size_t count, fmi3UInt64 values[],
                         size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (check_list(self, "fmi3GetUInt64", references, count, values, value_count, MODEL_UNSIGNED, true))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = self->wheelset->core.stations;
    return fmi3OK;
}

fmi3Status fmi3GetString(fmi3Instance component, const fmi3ValueReference references[], size_t count, fmi3String values[],
                         size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (check_list(self, "fmi3GetString", references, count, values, value_count, MODEL_STRING, true))
        return answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
        values[i] = self->wheelset->core.text[model_variables[model_blocks[references[i]].first].slot];
    return fmi3OK;
}

fmi3Status fmi3SetFloat64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                          const fmi3Float64 values[], size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    int refused = check_list(self, "fmi3SetFloat64", references, count, values, value_count, MODEL_REAL, false);
    for (size_t i = 0; i < count && !refused; i += 1)       /* arrays are outputs, which the first of their values tells */
    {
        const int first = model_blocks[references[i]].first;
        refused = first == BLOCK_TIME ? wheelset_refuse(self->wheelset, "time is the independent variable and cannot be set")
                                      : wheelset_may_set_real(self->wheelset, (uint32_t)first, values[i]);
    }
    for (size_t i = 0; i < count && !refused; i += 1)       /* all or none */
        wheelset_set_real(self->wheelset, (uint32_t)model_blocks[references[i]].first, values[i]);
    return answer(self, refused);
}

fmi3Status fmi3SetInt32(fmi3Instance component, const fmi3ValueReference references[], size_t count, const fmi3Int32 values[],
                        size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    int refused = check_list(self, "fmi3SetInt32", references, count, values, value_count, MODEL_INTEGER, false);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_set_integer(self->wheelset, (uint32_t)model_blocks[references[i]].first);
    return answer(self, refused);
}

fmi3Status fmi3SetUInt64(fmi3Instance component, const fmi3ValueReference references[], size_t count,
                         const fmi3UInt64 values[], size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    int refused = check_list(self, "fmi3SetUInt64", references, count, values, value_count, MODEL_UNSIGNED, false);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_set_stations(self->wheelset, values[i]);
    return answer(self, refused);
}

fmi3Status fmi3SetString(fmi3Instance component, const fmi3ValueReference references[], size_t count, const fmi3String values[],
                         size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    int refused = check_list(self, "fmi3SetString", references, count, values, value_count, MODEL_STRING, false);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = wheelset_may_set_string(self->wheelset, (uint32_t)model_blocks[references[i]].first, values[i]);
    for (size_t i = 0; i < count && !refused; i += 1)       /* all or none */
        wheelset_set_string(self->wheelset, (uint32_t)model_blocks[references[i]].first, values[i]);
    return answer(self, refused);
}

/* --- directional derivatives ------------------------------------------------------------------------------ */

typedef int check(wheelset *wheelset, uint32_t reference);

/* Whether every variable of a list passes `check`, and together they have `value_count` values. */
static int check_derivative(instance *self, const char *function, reference_list references, size_t count, const void *values,
                            size_t value_count, check *check)
{
    size_t needed = 0;
    if ((count > 0 && !references) || (value_count > 0 && !values))
        return wheelset_refuse(self->wheelset, "%s: a list is a NULL pointer", function);
    for (size_t i = 0; i < count; i += 1)
    {
        if (check_reference(self, references[i]))
            return 1;
        const model_block *block = model_blocks + references[i];
        if (block->first < 0)
            return wheelset_refuse(self->wheelset, "%s: %s is neither an input nor an output", function,
                                   block->first == BLOCK_TIME ? "time" : "stations");
        if (check(self->wheelset, (uint32_t)block->first))
            return 1;
        needed += block_size(self, block);
    }
    if (needed != value_count)
        return wheelset_refuse(self->wheelset, "%s: there are %lu values; these variables have %lu", function,
                               (unsigned long)value_count, (unsigned long)needed);
    return 0;
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance component, reference_list unknowns, size_t unknown_count,
                                        reference_list knowns, size_t known_count, const fmi3Float64 seed[], size_t seed_count,
                                        fmi3Float64 sensitivity[], size_t sensitivity_count)
{
    static const char NAME[] = "fmi3GetDirectionalDerivative";
    instance *self = component;
    double along[MODEL_INPUTS] = {0.0}, rates[ROW];
    if (!self)
        return fmi3Error;
    if (check_derivative(self, NAME, unknowns, unknown_count, sensitivity, sensitivity_count, wheelset_check_unknown)
        || check_derivative(self, NAME, knowns, known_count, seed, seed_count, wheelset_check_known))
        return answer(self, 1);
    for (size_t i = 0; i < known_count; i += 1)
        along[model_blocks[knowns[i]].first] += seed[i];
    if (wheelset_differentiate(self->wheelset, along, rates))
        return answer(self, 1);
    for (size_t i = 0; i < unknown_count; i += 1)
    {
        const model_block *block = model_blocks + unknowns[i];
        memcpy(sensitivity, rates + place_in_row(self, block), block_size(self, block) * sizeof(double));
        sensitivity += block_size(self, block);
    }
    return fmi3OK;
}

/* Seeds of outputs, sensitivities of inputs: one directional derivative along each input that is asked for. */
fmi3Status fmi3GetAdjointDerivative(fmi3Instance component, reference_list unknowns, size_t unknown_count, reference_list knowns,
                                    size_t known_count, const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[],
                                    size_t sensitivity_count)
{
    static const char NAME[] = "fmi3GetAdjointDerivative";
    instance *self = component;
    double weights[ROW] = {0.0}, rates[ROW], sums[MODEL_INPUTS] = {0.0};
    if (!self)
        return fmi3Error;
    if (check_derivative(self, NAME, unknowns, unknown_count, seed, seed_count, wheelset_check_unknown)
        || check_derivative(self, NAME, knowns, known_count, sensitivity, sensitivity_count, wheelset_check_known))
        return answer(self, 1);
    for (size_t i = 0; i < unknown_count; i += 1)
    {
        const model_block *block = model_blocks + unknowns[i];
        double *weight = weights + place_in_row(self, block);
        for (size_t k = 0; k < block_size(self, block); k += 1)
            weight[k] += *seed++;
    }
    for (size_t i = 0; i < known_count; i += 1)
    {
        double along[MODEL_INPUTS] = {0.0}, *sum = sums + model_blocks[knowns[i]].first;
        along[model_blocks[knowns[i]].first] = 1.0;
        if (wheelset_differentiate(self->wheelset, along, rates))
            return answer(self, 1);
        *sum = 0.0;
        for (int k = 0; k < ROW; k += 1)
            *sum += weights[k] * rates[k];
    }
    for (size_t i = 0; i < known_count; i += 1)
        sensitivity[i] = sums[model_blocks[knowns[i]].first];
    return fmi3OK;
}

/* --- saved states ---------------------------------------------------------------------------------------- */

fmi3Status fmi3GetFMUState(fmi3Instance component, fmi3FMUState *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_save_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3SetFMUState(fmi3Instance component, fmi3FMUState state)
{
    instance *self = component;
    return self ? answer(self, wheelset_restore_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3FreeFMUState(fmi3Instance component, fmi3FMUState *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_free_state(self->wheelset, state)) : fmi3Error;
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance component, fmi3FMUState state, size_t *size)
{
    instance *self = component;
    return self ? answer(self, wheelset_state_size(self->wheelset, state, size)) : fmi3Error;
}

fmi3Status fmi3SerializeFMUState(fmi3Instance component, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    instance *self = component;
    return self ? answer(self, wheelset_write_state(self->wheelset, state, bytes, size)) : fmi3Error;
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance component, const fmi3Byte bytes[], size_t size, fmi3FMUState *state)
{
    instance *self = component;
    return self ? answer(self, wheelset_read_state(self->wheelset, bytes, size, state)) : fmi3Error;
}

/* --- what there is not ------------------------------------------------------------------------------------- */

#define NO_VALUES(TYPE, C_TYPE)                                                                                             \
    fmi3Status fmi3Get##TYPE(fmi3Instance self, const fmi3ValueReference references[], size_t count, C_TYPE values[],       \
                             size_t value_count)                                                                            \
    {                                                                                                                       \
        (void)references, (void)values, (void)value_count;                                                                  \
        return self && count == 0 ? fmi3OK : refuse(self, "fmi3Get" #TYPE, "there are no variables of this type");          \
    }                                                                                                                       \
    fmi3Status fmi3Set##TYPE(fmi3Instance self, const fmi3ValueReference references[], size_t count, const C_TYPE values[], \
                             size_t value_count)                                                                            \
    {                                                                                                                       \
        (void)references, (void)values, (void)value_count;                                                                  \
        return self && count == 0 ? fmi3OK : refuse(self, "fmi3Set" #TYPE, "there are no variables of this type");          \
    }

NO_VALUES(Float32, fmi3Float32)
NO_VALUES(Int8, fmi3Int8)
NO_VALUES(UInt8, fmi3UInt8)
NO_VALUES(Int16, fmi3Int16)
NO_VALUES(UInt16, fmi3UInt16)
NO_VALUES(UInt32, fmi3UInt32)
NO_VALUES(Int64, fmi3Int64)
NO_VALUES(Boolean, fmi3Boolean)

/* A function of FMI 3 that this FMU declares no capability for. */
#define NOT_HERE(NAME, REASON, ...)                                 \
    fmi3Status NAME(fmi3Instance self, __VA_ARGS__)                 \
    {                                                               \
        return refuse(self, #NAME, REASON);                         \
    }
/* The same for a list of `n` values, of which there may be none. */
#define NO_LIST(NAME, REASON, ...)                                  \
    fmi3Status NAME(fmi3Instance self, __VA_ARGS__)                 \
    {                                                               \
        return self && n == 0 ? fmi3OK : refuse(self, #NAME, REASON); \
    }
#define NO_MODE(NAME, REASON)                                       \
    fmi3Status NAME(fmi3Instance self)                              \
    {                                                               \
        return refuse(self, #NAME, REASON);                         \
    }

#define TYPELESS "there are no variables of this type"
#define CLOCKLESS "there are no clocks"
#define EVENTLESS "there is no event mode"
#define NO_EXCHANGE "permitted is co-simulation only"

NO_LIST(fmi3GetBinary, TYPELESS, reference_list r, size_t n, size_t sizes[], fmi3Binary values[], size_t m)
NO_LIST(fmi3SetBinary, TYPELESS, reference_list r, size_t n, const size_t sizes[], const fmi3Binary values[], size_t m)
NO_LIST(fmi3GetClock, CLOCKLESS, reference_list r, size_t n, fmi3Clock values[])
NO_LIST(fmi3SetClock, CLOCKLESS, reference_list r, size_t n, const fmi3Clock values[])
NOT_HERE(fmi3GetIntervalDecimal, CLOCKLESS, reference_list r, size_t n, fmi3Float64 i[], fmi3IntervalQualifier q[])
NOT_HERE(fmi3GetIntervalFraction, CLOCKLESS, reference_list r, size_t n, fmi3UInt64 c[], fmi3UInt64 d[],
         fmi3IntervalQualifier q[])
NOT_HERE(fmi3GetShiftDecimal, CLOCKLESS, reference_list r, size_t n, fmi3Float64 s[])
NOT_HERE(fmi3GetShiftFraction, CLOCKLESS, reference_list r, size_t n, fmi3UInt64 c[], fmi3UInt64 d[])
NOT_HERE(fmi3SetIntervalDecimal, CLOCKLESS, reference_list r, size_t n, const fmi3Float64 i[])
NOT_HERE(fmi3SetIntervalFraction, CLOCKLESS, reference_list r, size_t n, const fmi3UInt64 c[], const fmi3UInt64 d[])
NOT_HERE(fmi3SetShiftDecimal, CLOCKLESS, reference_list r, size_t n, const fmi3Float64 s[])
NOT_HERE(fmi3SetShiftFraction, CLOCKLESS, reference_list r, size_t n, const fmi3UInt64 c[], const fmi3UInt64 d[])
NOT_HERE(fmi3ActivateModelPartition, CLOCKLESS, fmi3ValueReference clock, fmi3Float64 time)
NOT_HERE(fmi3GetNumberOfVariableDependencies, "dependencies are in the model description", fmi3ValueReference r, size_t *n)
NOT_HERE(fmi3GetVariableDependencies, "dependencies are in the model description", fmi3ValueReference r, size_t e[],
         fmi3ValueReference i[], size_t f[], fmi3DependencyKind k[], size_t n)
NOT_HERE(fmi3GetOutputDerivatives, "there are no output derivatives", reference_list r, size_t n, const fmi3Int32 orders[],
         fmi3Float64 values[], size_t m)
NO_MODE(fmi3EnterEventMode, EVENTLESS)
NO_MODE(fmi3EnterStepMode, EVENTLESS)
NO_MODE(fmi3EvaluateDiscreteStates, EVENTLESS)
NOT_HERE(fmi3UpdateDiscreteStates, EVENTLESS, fmi3Boolean *a, fmi3Boolean *b, fmi3Boolean *c, fmi3Boolean *d, fmi3Boolean *e,
         fmi3Float64 *time)
NO_MODE(fmi3EnterContinuousTimeMode, NO_EXCHANGE)
NOT_HERE(fmi3CompletedIntegratorStep, NO_EXCHANGE, fmi3Boolean never_back, fmi3Boolean *event, fmi3Boolean *terminate)
NOT_HERE(fmi3SetTime, NO_EXCHANGE, fmi3Float64 time)
NOT_HERE(fmi3SetContinuousStates, NO_EXCHANGE, const fmi3Float64 states[], size_t n)
NOT_HERE(fmi3GetContinuousStateDerivatives, NO_EXCHANGE, fmi3Float64 derivatives[], size_t n)
NOT_HERE(fmi3GetEventIndicators, NO_EXCHANGE, fmi3Float64 indicators[], size_t n)
NOT_HERE(fmi3GetContinuousStates, NO_EXCHANGE, fmi3Float64 states[], size_t n)
NOT_HERE(fmi3GetNominalsOfContinuousStates, NO_EXCHANGE, fmi3Float64 nominals[], size_t n)
NOT_HERE(fmi3GetNumberOfEventIndicators, NO_EXCHANGE, size_t *n)
NOT_HERE(fmi3GetNumberOfContinuousStates, NO_EXCHANGE, size_t *n)
