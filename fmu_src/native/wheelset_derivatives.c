/* Directional derivatives of a wheelset's outputs. */
#include "wheelset_parts.h"

#include <math.h>
#include <string.h>

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/constants.h"

int wheelset_check_known(wheelset *self, uint32_t reference)
{
    if (wheelset_check(self, reference, MODEL_REAL))
        return 1;
    if (model_variables[reference].causality != MODEL_INPUT)
        return wheelset_refuse(self, "%s is not an input; derivatives are with respect to inputs", model_variables[reference].name);
    return 0;
}

int wheelset_check_unknown(wheelset *self, uint32_t reference)
{
    if (wheelset_check(self, reference, MODEL_REAL))
        return 1;
    if (model_variables[reference].causality != MODEL_OUTPUT)
        return wheelset_refuse(self, "%s is not an output; derivatives are those of outputs", model_variables[reference].name);
    return 0;
}

size_t wheelset_rate_of(uint32_t reference)
{
    return wheelset_is_equilibrium(reference) ? ROW + reference - MODEL_EQUILIBRIUM : reference - MODEL_FIRST_OUTPUT;
}

/* Rates of the equilibrium, from those of an elastic wheelset in the row; the row itself is left to its own. */
static void differentiate_equilibrium(wheelset *self, const double seed[MODEL_INPUTS], double rates[RATES])
{
    const wrcontact_handle handle = wheelset_handle(self);
    const double mode = self->tables.data[layout__TABLES_MODE];
    if (wheelset_is_compliant(self))
        wheelset_set_mode(self, layout__MODE_ELASTIC);
    wrcontact_derivative(&handle, seed, rates, self->derivative_room);
    wheelset_set_mode(self, mode);
    rates[ROW] = rates[layout__OUT_VERTICAL_SHIFT];
    rates[ROW + 1] = rates[layout__OUT_ROLL];
}

int wheelset_differentiate(wheelset *self, const double seed[MODEL_INPUTS], bool equilibrium, double rates[RATES])
{
    if (self->core.phase == PHASE_INSTANTIATED || self->core.phase == PHASE_CONFIGURING)
        return wheelset_refuse(self, "there are no derivatives before the initialisation");
    if (!self->core.locked && wheelset_refresh(self))
        return 1;
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        if (!isfinite(seed[i]))
            return wheelset_refuse(self, "the seed of %s is not finite; permitted are finite numbers", model_variables[i].name);
    const wrcontact_handle handle = wheelset_handle(self);
    memset(rates, 0, RATES * sizeof(double));
    if (equilibrium)
        differentiate_equilibrium(self, seed, rates);
    wrcontact_derivative(&handle, seed, rates, self->derivative_room);
    return 0;
}
