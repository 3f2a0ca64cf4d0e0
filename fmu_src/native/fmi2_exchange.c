/* FMI 2.0: what belongs to model exchange.  There are no states and no event indicators, so that lists of them are empty. */
#include "fmi2_instance.h"

fmi2Status fmi2EnterEventMode(fmi2Component component)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_enter_event_mode(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *events)
{
    instance *self = component;
    if (!self || !events)
        return fmi2_refuse(self, "fmi2NewDiscreteStates", "the place for the answer is a NULL pointer");
    if (wheelset_update_discrete(self->wheelset))
        return fmi2_answer(self, 1);
    *events = (fmi2EventInfo){fmi2False, fmi2False, fmi2False, fmi2False, fmi2False, 0.0};
    return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_enter_continuous_mode(self->wheelset)) : fmi2Error;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean never_back, fmi2Boolean *event, fmi2Boolean *terminate)
{
    instance *self = component;
    (void)never_back;
    if (!self || !event || !terminate)
        return fmi2_refuse(self, "fmi2CompletedIntegratorStep", "the place for the answer is a NULL pointer");
    if (wheelset_complete_step(self->wheelset))
        return fmi2_answer(self, 1);
    *event = *terminate = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time)
{
    instance *self = component;
    return self ? fmi2_answer(self, wheelset_set_time(self->wheelset, time)) : fmi2Error;
}

/* A function for a list of `n` values, of which the model has none. */
#define EMPTY(NAME, TYPE, WHAT)                                                                         \
    fmi2Status NAME(fmi2Component component, TYPE values[], size_t n)                                   \
    {                                                                                                   \
        instance *self = component;                                                                     \
        (void)values;                                                                                   \
        return self ? fmi2_answer(self, wheelset_check_empty(self->wheelset, WHAT, n)) : fmi2Error;     \
    }

EMPTY(fmi2SetContinuousStates, const fmi2Real, "continuous states")
EMPTY(fmi2GetContinuousStates, fmi2Real, "continuous states")
EMPTY(fmi2GetDerivatives, fmi2Real, "derivatives of continuous states")
EMPTY(fmi2GetNominalsOfContinuousStates, fmi2Real, "nominal values of continuous states")
EMPTY(fmi2GetEventIndicators, fmi2Real, "event indicators")
