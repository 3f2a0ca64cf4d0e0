/* What the kernel makes of a wheelset: one evaluation, its status in a sentence, and the equilibrium. */
#include "wheelset_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sentences.h"

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/constants.h"

bool wheelset_is_compliant(const wheelset *self)
{
    return strcmp(self->core.text[MODEL_MODE_SLOT], "compliant") == 0;
}

void wheelset_log_status(wheelset *self)
{
    char sentence[MODEL_SENTENCE];
    sentence_of_status((int)self->core.status, self->core.values, wheelset_is_compliant(self), sentence, sizeof sentence);
    self->log(self->owner, sentence);
    self->core.logged = 1;
}

wrcontact_handle wheelset_handle(wheelset *self)
{
    wheelset_core *core = &self->core;
    const wrcontact_handle handle = {
        self->tables, span_of(core->memory, MODEL_MEMORY), span_of(self->workspace, MODEL_WORK),
        span_of(core->values, MODEL_INPUTS), span_of(core->values + MODEL_FIRST_OUTPUT, ROW)};
    return handle;
}

void wheelset_set_mode(wheelset *self, double mode)
{
    self->tables.data[layout__TABLES_MODE] = mode;
}

/* The elastic wheelset that carries the load of the inputs, in the room of a derivative: its status, with the outputs at
 * `outputs`. */
static int balance(wheelset *self, const double **outputs)
{
    double *state = self->derivative_room + MODEL_WORK, *row = state + MODEL_MEMORY;
    const double mode = self->tables.data[layout__TABLES_MODE];
    const wrcontact_handle handle = {
        self->tables, span_of(state, MODEL_MEMORY), span_of(self->derivative_room, MODEL_WORK),
        span_of(self->core.values, MODEL_INPUTS), span_of(row, ROW)};
    memset(self->derivative_room, 0, (MODEL_WORK + MODEL_MEMORY) * sizeof(double));
    wheelset_set_mode(self, layout__MODE_ELASTIC);
    const int status = wrcontact_step(&handle);
    wheelset_set_mode(self, mode);
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
    else if (core->status <= layout__UNLOADED)      /* otherwise the step has logged why */
    {
        char sentence[MODEL_SENTENCE] = "equilibrium: ";
        const size_t begun = strlen(sentence);
        sentence_of_status(status, core->values, false, sentence + begun, sizeof sentence - begun);
        self->log(self->owner, sentence);
    }
    core->balanced = 1;
}

/* Tell once of a load that is permitted but not usual, as after an error in its unit. */
static void remark_load(wheelset *self)
{
    const double load = self->core.values[MODEL_LOAD];
    char sentence[MODEL_SENTENCE];
    if (self->remarked || !(load > 0.0) || !isfinite(load) || (MODEL_LOAD_LEAST <= load && load <= MODEL_LOAD_MOST)
        || wheelset_is_compliant(self))
        return;
    snprintf(sentence, sizeof sentence, "%s is %s%s; usual is %s ... %s%s. It is used as it is.",
             model_variables[MODEL_LOAD].name, SIX_DIGITS(load), model_variables[MODEL_LOAD].unit, SIX_DIGITS(MODEL_LOAD_LEAST),
             SIX_DIGITS(MODEL_LOAD_MOST), model_variables[MODEL_LOAD].unit);
    self->remarked = true;
    self->log(self->owner, sentence);
}

/* In model exchange a solver tries points, so that the last valid outputs are those of a point that it may have left.  Where
 * there are no valid ones, let the outputs be those of the last accepted point. */
static void hold(wheelset *self)
{
    wrcontact_handle handle = wheelset_handle(self);
    handle.inputs = span_of(self->core.accepted, MODEL_INPUTS);
    if (self->core.accepts)
        wrcontact_step(&handle);
}

void wheelset_accept(wheelset *self)
{
    wheelset_core *core = &self->core;
    if (!core->exchange || core->status > layout__UNLOADED)
        return;
    memcpy(core->accepted, core->values, sizeof core->accepted);
    core->accepts = 1;
}

/* One step of the kernel, and its status. */
void wheelset_evaluate(wheelset *self)
{
    wheelset_core *core = &self->core;
    const wrcontact_handle handle = wheelset_handle(self);
    const int status = wrcontact_step(&handle);
    core->status = status;
    core->stale = core->balanced = 0;
    if (status > layout__UNLOADED)
        hold(self);
    remark_load(self);
    if (!wheelset_is_compliant(self))
        wheelset_find_equilibrium(self);        /* which costs nothing */
    if (status && core->phase != PHASE_EVENT && core->phase != PHASE_CONTINUOUS)
        wheelset_log_status(self);
}
