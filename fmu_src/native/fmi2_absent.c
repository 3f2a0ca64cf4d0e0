/* FMI 2.0: functions for what this FMU does not have; each is refused with the reason. */
#include "fmi2_instance.h"

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                       const fmi2Integer orders[], const fmi2Real values[])
{
    (void)references, (void)count, (void)orders, (void)values;
    return fmi2_refuse(component, "fmi2SetRealInputDerivatives", "inputs are not interpolated");
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference references[], size_t count,
                                        const fmi2Integer orders[], fmi2Real values[])
{
    (void)references, (void)count, (void)orders, (void)values;
    return fmi2_refuse(component, "fmi2GetRealOutputDerivatives", "there are no output derivatives");
}

fmi2Status fmi2CancelStep(fmi2Component component)
{
    return fmi2_refuse(component, "fmi2CancelStep", "a step is over when fmi2DoStep returns");
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value)
{
    (void)kind, (void)value;
    return fmi2_refuse(component, "fmi2GetStatus", "a step is over when fmi2DoStep returns");
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value)
{
    const instance *self = component;
    if (!self || !value || kind != fmi2LastSuccessfulTime || self->wheelset->core.exchange)
        return fmi2_refuse(self, "fmi2GetRealStatus", "permitted is fmi2LastSuccessfulTime, in co-simulation");
    *value = self->wheelset->core.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value)
{
    (void)kind, (void)value;
    return fmi2_refuse(component, "fmi2GetIntegerStatus", "there is no Integer status");
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value)
{
    const instance *self = component;
    if (!self || !value || kind != fmi2Terminated || self->wheelset->core.exchange)
        return fmi2_refuse(self, "fmi2GetBooleanStatus", "permitted is fmi2Terminated, in co-simulation");
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind, fmi2String *value)
{
    (void)kind, (void)value;
    return fmi2_refuse(component, "fmi2GetStringStatus", "a step is over when fmi2DoStep returns");
}
