/* FMI 3.0: values of variables, and their directional derivatives.
 *
 * A variable of FMI 3 is a block of neighbouring values of the wheelset: one value, or an outline's array.
 */
#include <string.h>

#include "fmi3_instance.h"

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
    return core->values + MODEL_BEHIND + (size_t)block->run * core->stations;
}

/* Whether a variable is computed only when it is read. */
static bool is_equilibrium(const model_block *block)
{
    return block->first >= 0 && wheelset_is_equilibrium((uint32_t)block->first);
}

/* Where the rates of an output begin: in the kernel's row, or behind it. */
static size_t place_in_row(const instance *self, const model_block *block)
{
    if (is_equilibrium(block))
        return wheelset_rate_of((uint32_t)block->first);
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
    if (reference > MODEL_BLOCKS || model_blocks[reference].first == BLOCK_RETIRED)
        return wheelset_refuse(self->wheelset, REFUSE_UNKNOWN, (unsigned long)reference, 1, MODEL_BLOCKS);
    return 0;
}

/* Whether there are as many values as the variables have. */
static int check_count(instance *self, const char *function, size_t needed, size_t value_count)
{
    if (needed != value_count)
        return wheelset_refuse(self->wheelset, "%s: there are %lu values; these variables have %lu", function,
                               (unsigned long)value_count, (unsigned long)needed);
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
    return check_count(self, function, needed, value_count);
}

fmi3Status fmi3GetFloat64(fmi3Instance component, const fmi3ValueReference references[], size_t count, fmi3Float64 values[],
                          size_t value_count)
{
    instance *self = component;
    if (!self)
        return fmi3Error;
    if (check_list(self, "fmi3GetFloat64", references, count, values, value_count, MODEL_REAL, true)
        || wheelset_refresh(self->wheelset))
        return fmi3_answer(self, 1);
    for (size_t i = 0; i < count; i += 1)
    {
        const model_block *block = model_blocks + references[i];
        if (is_equilibrium(block))
            wheelset_find_equilibrium(self->wheelset);
        const double *from = block_values(self, block);
        for (size_t k = block_size(self, block); k > 0; k -= 1)
            *values++ = *from++;
    }
    return fmi3OK;
}

/* Where the values of variable `i` of a list begin. */
#define FIRST model_blocks[references[i]].first

/* A function that reads variables of one type with one value each; `REFUSED` brings them up to date, `VALUE` is that of
 * variable `i`. */
#define GET(NAME, C_TYPE, TYPE, REFUSED, VALUE)                                                                         \
    fmi3Status NAME(fmi3Instance component, const fmi3ValueReference references[], size_t count, C_TYPE values[],       \
                    size_t value_count)                                                                                 \
    {                                                                                                                   \
        instance *self = component;                                                                                     \
        if (!self)                                                                                                      \
            return fmi3Error;                                                                                           \
        if (check_list(self, #NAME, references, count, values, value_count, TYPE, true) || REFUSED)                     \
            return fmi3_answer(self, 1);                                                                                \
        for (size_t i = 0; i < count; i += 1)                                                                           \
            values[i] = VALUE;                                                                                          \
        return fmi3OK;                                                                                                  \
    }

GET(fmi3GetInt32, fmi3Int32, MODEL_INTEGER, wheelset_refresh(self->wheelset), wheelset_integer(self->wheelset, (uint32_t)FIRST))
GET(fmi3GetBoolean, fmi3Boolean, MODEL_BOOLEAN, 0, self->wheelset->core.values[FIRST] != 0.0)
GET(fmi3GetUInt64, fmi3UInt64, MODEL_UNSIGNED, 0, self->wheelset->core.stations)
GET(fmi3GetString, fmi3String, MODEL_STRING, 0, self->wheelset->core.text[model_variables[FIRST].slot])

/* Whether a Float64 can be set; arrays are outputs, which the first of their values shows. */
static int may_set_float(instance *self, int first, double value)
{
    if (first == BLOCK_TIME)
        return wheelset_refuse(self->wheelset, "time is the independent variable and cannot be set");
    return wheelset_may_set_real(self->wheelset, (uint32_t)first, value);
}

/* A function that sets variables of one type, all of them or none: `REFUSED` is whether variable `i` cannot be
 * set, `APPLY` sets it. */
#define SET(NAME, C_TYPE, TYPE, REFUSED, APPLY)                                                                         \
    fmi3Status NAME(fmi3Instance component, const fmi3ValueReference references[], size_t count, const C_TYPE values[], \
                    size_t value_count)                                                                                 \
    {                                                                                                                   \
        instance *self = component;                                                                                     \
        if (!self)                                                                                                      \
            return fmi3Error;                                                                                           \
        int refused = check_list(self, #NAME, references, count, values, value_count, TYPE, false);                     \
        for (size_t i = 0; i < count && !refused; i += 1)                                                               \
            refused = REFUSED;                                                                                          \
        for (size_t i = 0; i < count && !refused; i += 1)                                                               \
            APPLY;                                                                                                      \
        return fmi3_answer(self, refused);                                                                              \
    }

SET(fmi3SetFloat64, fmi3Float64, MODEL_REAL, may_set_float(self, FIRST, values[i]),
    wheelset_set_real(self->wheelset, (uint32_t)FIRST, values[i]))
SET(fmi3SetInt32, fmi3Int32, MODEL_INTEGER, wheelset_may_set_integer(self->wheelset, (uint32_t)FIRST), (void)0)
SET(fmi3SetBoolean, fmi3Boolean, MODEL_BOOLEAN, wheelset_may_set_boolean(self->wheelset, (uint32_t)FIRST, values[i]),
    wheelset_set_real(self->wheelset, (uint32_t)FIRST, values[i] ? 1.0 : 0.0))
SET(fmi3SetUInt64, fmi3UInt64, MODEL_UNSIGNED, wheelset_set_stations(self->wheelset, values[i]), (void)0)
SET(fmi3SetString, fmi3String, MODEL_STRING, wheelset_may_set_string(self->wheelset, (uint32_t)FIRST, values[i]),
    wheelset_set_string(self->wheelset, (uint32_t)FIRST, values[i]))

/* --- directional derivatives ------------------------------------------------------------------------ */

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
    return check_count(self, function, needed, value_count);
}

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance component, reference_list unknowns, size_t unknown_count,
                                        reference_list knowns, size_t known_count, const fmi3Float64 seed[], size_t seed_count,
                                        fmi3Float64 sensitivity[], size_t sensitivity_count)
{
    static const char NAME[] = "fmi3GetDirectionalDerivative";
    instance *self = component;
    double along[MODEL_INPUTS] = {0.0}, rates[RATES];
    bool equilibrium = false;
    if (!self)
        return fmi3Error;
    if (check_derivative(self, NAME, unknowns, unknown_count, sensitivity, sensitivity_count, wheelset_check_unknown)
        || check_derivative(self, NAME, knowns, known_count, seed, seed_count, wheelset_check_known))
        return fmi3_answer(self, 1);
    for (size_t i = 0; i < known_count; i += 1)
        along[model_blocks[knowns[i]].first] += seed[i];
    for (size_t i = 0; i < unknown_count; i += 1)
        equilibrium = equilibrium || is_equilibrium(model_blocks + unknowns[i]);
    if (wheelset_differentiate(self->wheelset, along, equilibrium, rates))
        return fmi3_answer(self, 1);
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
    double weights[RATES] = {0.0}, rates[RATES], sums[MODEL_INPUTS] = {0.0};
    bool equilibrium = false;
    if (!self)
        return fmi3Error;
    if (check_derivative(self, NAME, unknowns, unknown_count, seed, seed_count, wheelset_check_unknown)
        || check_derivative(self, NAME, knowns, known_count, sensitivity, sensitivity_count, wheelset_check_known))
        return fmi3_answer(self, 1);
    for (size_t i = 0; i < unknown_count; i += 1)
    {
        const model_block *block = model_blocks + unknowns[i];
        double *weight = weights + place_in_row(self, block);
        equilibrium = equilibrium || is_equilibrium(block);
        for (size_t k = 0; k < block_size(self, block); k += 1)
            weight[k] += *seed++;
    }
    for (size_t i = 0; i < known_count; i += 1)
    {
        double along[MODEL_INPUTS] = {0.0}, *sum = sums + model_blocks[knowns[i]].first;
        along[model_blocks[knowns[i]].first] = 1.0;
        if (wheelset_differentiate(self->wheelset, along, equilibrium, rates))
            return fmi3_answer(self, 1);
        *sum = 0.0;
        for (int k = 0; k < RATES; k += 1)
            *sum += weights[k] * rates[k];
    }
    for (size_t i = 0; i < known_count; i += 1)
        sensitivity[i] = sums[model_blocks[knowns[i]].first];
    return fmi3OK;
}
