/* What a wheelset answers beside its steps: the equilibrium, and directional derivatives.  Both work in the room of a
 * derivative. */
#include "wheelset_parts.h"

#include <math.h>
#include <string.h>

#include "sentences.h"

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/layout.h"

/* Let the tables of both sides be those of a contact mode. */
static void set_mode(wheelset *self, double mode)
{
    self->left_tables.data[layout__SET_MODE] = self->right_tables.data[layout__SET_MODE] = mode;
}

/* The elastic wheelset that carries the load of the inputs, in the room of a derivative: its status, with the outputs at
 * `outputs`. */
static int balance(wheelset *self, const double **outputs)
{
    double *state = self->tangent_room + MODEL_WORK, *row = state + MODEL_MEMORY;
    const double mode = self->right_tables.data[layout__SET_MODE];
    const wrcontact_handle handle = {
        self->left_tables, self->right_tables, span_of(state, MODEL_MEMORY), span_of(self->tangent_room, MODEL_WORK),
        span_of(self->core.values, MODEL_INPUTS), span_of(row, ROW)};
    memset(self->tangent_room, 0, (MODEL_WORK + MODEL_MEMORY) * sizeof(double));
    set_mode(self, layout__MODE_ELASTIC);
    const int status = wrcontact_step(&handle);
    set_mode(self, mode);
    *outputs = row;
    return status;
}

bool wheelset_is_equilibrium(uint32_t reference)
{
    return reference >= MODEL_EQUILIBRIUM && reference < MODEL_FIRST_OUTPUT;
}

void wheelset_find_equilibrium(wheelset *self)
{
    wheelset_core *core = &self->core;
    const double *outputs = core->values + MODEL_FIRST_OUTPUT;
    int status = layout__VALID;
    if (core->balanced || !core->built)
        return;
    if (wheelset_is_compliant(self))
        status = balance(self, &outputs);
    if (status <= layout__UNLOADED)
    {
        core->values[MODEL_EQUILIBRIUM] = outputs[layout__OUT_VERTICAL_SHIFT];
        core->values[MODEL_EQUILIBRIUM + 1] = outputs[layout__OUT_ROLL];
    }
    else if (core->status <= layout__UNLOADED)      /* otherwise the step has told why */
    {
        char sentence[MODEL_SENTENCE] = "equilibrium: ";
        const size_t begun = strlen(sentence);
        sentence_of_status(status, core->values, false, sentence + begun, sizeof sentence - begun);
        self->tell(self->owner, sentence);
    }
    core->balanced = 1;
}

/* --- directional derivatives ------------------------------------------------------------------------ */

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
    const double mode = self->right_tables.data[layout__SET_MODE];
    if (wheelset_is_compliant(self))
        set_mode(self, layout__MODE_ELASTIC);
    wrcontact_tangent(&handle, seed, rates, self->tangent_room);
    set_mode(self, mode);
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
    wrcontact_tangent(&handle, seed, rates, self->tangent_room);
    return 0;
}
