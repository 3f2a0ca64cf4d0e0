/* FMI 3.0: what belongs to model exchange.  There are no states and no event indicators, so that lists of them are empty. */
#include "fmi3_instance.h"

fmi3Status fmi3EnterEventMode(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_enter_event_mode(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_update_discrete(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance component, fmi3Boolean *again, fmi3Boolean *terminate, fmi3Boolean *nominals,
                                    fmi3Boolean *states, fmi3Boolean *event, fmi3Float64 *time)
{
    instance *self = component;
    if (!self || !again || !terminate || !nominals || !states || !event || !time)
        return fmi3_refuse(self, "fmi3UpdateDiscreteStates", "the place for an answer is a NULL pointer");
    if (wheelset_update_discrete(self->wheelset))
        return fmi3_answer(self, 1);
    *again = *terminate = *nominals = *states = *event = fmi3False;
    return fmi3OK;
}

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance component)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_enter_continuous_mode(self->wheelset)) : fmi3Error;
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance component, fmi3Boolean never_back, fmi3Boolean *event, fmi3Boolean *terminate)
{
    instance *self = component;
    (void)never_back;
    if (!self || !event || !terminate)
        return fmi3_refuse(self, "fmi3CompletedIntegratorStep", "the place for an answer is a NULL pointer");
    if (wheelset_complete_step(self->wheelset))
        return fmi3_answer(self, 1);
    *event = *terminate = fmi3False;
    return fmi3OK;
}

fmi3Status fmi3SetTime(fmi3Instance component, fmi3Float64 time)
{
    instance *self = component;
    return self ? fmi3_answer(self, wheelset_set_time(self->wheelset, time)) : fmi3Error;
}

/* A function for a list of `n` values, of which the model has none. */
#define EMPTY(NAME, TYPE, WHAT)                                                                         \
    fmi3Status NAME(fmi3Instance component, TYPE values[], size_t n)                                    \
    {                                                                                                   \
        instance *self = component;                                                                     \
        (void)values;                                                                                   \
        return self ? fmi3_answer(self, wheelset_check_empty(self->wheelset, WHAT, n)) : fmi3Error;     \
    }

EMPTY(fmi3SetContinuousStates, const fmi3Float64, "continuous states")
EMPTY(fmi3GetContinuousStates, fmi3Float64, "continuous states")
EMPTY(fmi3GetContinuousStateDerivatives, fmi3Float64, "derivatives of continuous states")
EMPTY(fmi3GetNominalsOfContinuousStates, fmi3Float64, "nominal values of continuous states")
EMPTY(fmi3GetEventIndicators, fmi3Float64, "event indicators")

/* And the length of such a list. */
#define NUMBER(NAME, WHAT)                                                              \
    fmi3Status NAME(fmi3Instance component, size_t *n)                                  \
    {                                                                                   \
        instance *self = component;                                                     \
        if (!self || !n)                                                                \
            return fmi3_refuse(self, #NAME, "the place for the number is a NULL pointer"); \
        if (wheelset_check_empty(self->wheelset, WHAT, 0))                              \
            return fmi3_answer(self, 1);                                                \
        *n = 0;                                                                         \
        return fmi3OK;                                                                  \
    }

NUMBER(fmi3GetNumberOfContinuousStates, "continuous states")
NUMBER(fmi3GetNumberOfEventIndicators, "event indicators")
