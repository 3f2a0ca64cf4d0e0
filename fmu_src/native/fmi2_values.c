/* FMI 2.0: values of variables, and their directional derivatives. */
#include "fmi2_instance.h"

static int check_pointers(instance *self, const char *function, const void *references, size_t count, const void *values)
{
    if (count > 0 && (!references || !values))
        return wheelset_refuse(self->wheelset, "%s: %s is a NULL pointer", function, references ? "value" : "vr");
    return 0;
}

static int check_reference(instance *self, fmi2ValueReference reference)
{
    if (reference > MODEL_BLOCKS || model_blocks[reference].first == BLOCK_RETIRED)
        return wheelset_refuse(self->wheelset, REFUSE_UNKNOWN, (unsigned long)reference, 0, MODEL_BLOCKS);
    return 0;
}

/* The place in the table of a value reference that exists. */
static uint32_t place_of(fmi2ValueReference reference)
{
    return (uint32_t)model_blocks[reference].first;
}

/* Whether all of a list of values can be read. */
static int check_list(instance *self, const char *function, const fmi2ValueReference references[], size_t count,
                      const void *values, model_type type)
{
    int refused = check_pointers(self, function, references, count, values);
    for (size_t i = 0; i < count && !refused; i += 1)
        refused = check_reference(self, references[i]) || wheelset_may_get(self->wheelset, place_of(references[i]), type);
    return refused;
}

/* Bring the outputs up to date, and the equilibrium if it is in a list. */
static int refresh(instance *self, const fmi2ValueReference references[], size_t count)
{
    const int refused = wheelset_refresh(self->wheelset);
    for (size_t i = 0; i < count && !refused; i += 1)
        if (wheelset_is_equilibrium(place_of(references[i])))
            wheelset_find_equilibrium(self->wheelset);
    return refused;
}

/* A function that reads values of one type; `REFUSED` brings them up to date, `VALUE` is that of `place`. */
#define GET(NAME, C_TYPE, TYPE, REFUSED, VALUE)                                                                    \
    fmi2Status NAME(fmi2Component component, const fmi2ValueReference references[], size_t count, C_TYPE values[]) \
    {                                                                                                              \
        instance *self = component;                                                                                \
        if (!self)                                                                                                 \
            return fmi2Error;                                                                                      \
        if (check_list(self, #NAME, references, count, values, TYPE) || REFUSED)                                   \
            return fmi2_answer(self, 1);                                                                           \
        for (size_t i = 0; i < count; i += 1)                                                                      \
        {                                                                                                          \
            const uint32_t place = place_of(references[i]);                                                        \
            values[i] = VALUE;                                                                                     \
        }                                                                                                          \
        return fmi2OK;                                                                                             \
    }

GET(fmi2GetReal, fmi2Real, MODEL_REAL, refresh(self, references, count), self->wheelset->core.values[place])
GET(fmi2GetInteger, fmi2Integer, MODEL_INTEGER, wheelset_refresh(self->wheelset), wheelset_integer(self->wheelset, place))
GET(fmi2GetString, fmi2String, MODEL_STRING, 0, self->wheelset->core.text[model_variables[place].slot])

GET(fmi2GetBoolean, fmi2Boolean, MODEL_BOOLEAN, 0, self->wheelset->core.values[place] != 0.0)

/* A function that sets values of one type, all of them or none: `REFUSED` is whether value `i`
 * cannot be set, `APPLY` sets it. */
#define SET(NAME, C_TYPE, REFUSED, APPLY)                                                                                \
    fmi2Status NAME(fmi2Component component, const fmi2ValueReference references[], size_t count, const C_TYPE values[]) \
    {                                                                                                                    \
        instance *self = component;                                                                                      \
        if (!self)                                                                                                       \
            return fmi2Error;                                                                                            \
        int refused = check_pointers(self, #NAME, references, count, values);                                            \
        for (size_t i = 0; i < count && !refused; i += 1)                                                                \
            refused = check_reference(self, references[i]) || REFUSED;                                                   \
        for (size_t i = 0; i < count && !refused; i += 1)                                                                \
            APPLY;                                                                                                       \
        return fmi2_answer(self, refused);                                                                               \
    }

SET(fmi2SetReal, fmi2Real, wheelset_may_set_real(self->wheelset, place_of(references[i]), values[i]),
    wheelset_set_real(self->wheelset, place_of(references[i]), values[i]))
SET(fmi2SetInteger, fmi2Integer, wheelset_may_set_integer(self->wheelset, place_of(references[i])), (void)0)
SET(fmi2SetString, fmi2String, wheelset_may_set_string(self->wheelset, place_of(references[i]), values[i]),
    wheelset_set_string(self->wheelset, place_of(references[i]), values[i]))
SET(fmi2SetBoolean, fmi2Boolean, wheelset_may_set_boolean(self->wheelset, place_of(references[i]), values[i] != fmi2False),
    wheelset_set_real(self->wheelset, place_of(references[i]), values[i] ? 1.0 : 0.0))

/* --- directional derivatives ------------------------------------------------------------------------ */

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknowns[], size_t unknown_count,
                                        const fmi2ValueReference knowns[], size_t known_count, const fmi2Real seed[],
                                        fmi2Real sensitivity[])
{
    instance *self = component;
    double along[MODEL_INPUTS] = {0.0}, rates[RATES];
    bool equilibrium = false;
    if (!self)
        return fmi2Error;
    if ((unknown_count > 0 && (!unknowns || !sensitivity)) || (known_count > 0 && (!knowns || !seed)))
        return fmi2_refuse(self, "fmi2GetDirectionalDerivative", "a list is a NULL pointer");
    for (size_t i = 0; i < unknown_count; i += 1)
    {
        if (check_reference(self, unknowns[i]) || wheelset_check_unknown(self->wheelset, place_of(unknowns[i])))
            return fmi2_answer(self, 1);
        equilibrium = equilibrium || wheelset_is_equilibrium(place_of(unknowns[i]));
    }
    for (size_t i = 0; i < known_count; i += 1)
    {
        if (check_reference(self, knowns[i]) || wheelset_check_known(self->wheelset, place_of(knowns[i])))
            return fmi2_answer(self, 1);
        along[place_of(knowns[i])] += seed[i];
    }
    if (wheelset_differentiate(self->wheelset, along, equilibrium, rates))
        return fmi2_answer(self, 1);
    for (size_t i = 0; i < unknown_count; i += 1)
        sensitivity[i] = rates[wheelset_rate_of(place_of(unknowns[i]))];
    return fmi2OK;
}
