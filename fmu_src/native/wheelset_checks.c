/* Which calls a wheelset refuses, and with which sentence. */
#include "wheelset_parts.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "sentences.h"

int wheelset_refuse(wheelset *self, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(self->sentence, sizeof self->sentence, format, arguments);
    va_end(arguments);
    return 1;
}

int wheelset_check(wheelset *self, uint32_t reference, model_type type)
{
    static const char *const NAMES[] = {"Real", "Integer", "Boolean", "String", "UInt64"};
    const model_variable *variable = model_variables + reference;
    if (variable->type != type)
        return wheelset_refuse(self, REFUSE_TYPE, variable->name, NAMES[variable->type], NAMES[type]);
    return 0;
}

int wheelset_may_get(wheelset *self, uint32_t reference, model_type type)
{
    if (wheelset_check(self, reference, type))
        return 1;
    if (model_variables[reference].causality == MODEL_OUTPUT && self->core.phase == PHASE_INSTANTIATED)
        return wheelset_refuse(self, REFUSE_UNREAD, model_variables[reference].name);
    return 0;
}

/* Whether a variable can be set at all. */
static int check_settable(wheelset *self, const model_variable *variable)
{
    if (self->core.phase == PHASE_TERMINATED)
        return wheelset_refuse(self, REFUSE_TERMINATED, variable->name);
    if (variable->causality == MODEL_OUTPUT)
        return wheelset_refuse(self, REFUSE_OUTPUT, variable->name);
    return 0;
}

int wheelset_may_set_real(wheelset *self, uint32_t reference, double value)
{
    char present[40], wanted[40];
    if (wheelset_check(self, reference, MODEL_REAL) || check_settable(self, model_variables + reference))
        return 1;
    if (model_variables[reference].causality == MODEL_PARAMETER && self->core.locked
        && self->core.values[reference] != value)
        return wheelset_refuse(self, REFUSE_FIXED, model_variables[reference].name,
                               sentence_shortest(self->core.values[reference], present, sizeof present),
                               sentence_shortest(value, wanted, sizeof wanted));
    return 0;
}

int wheelset_may_set_string(wheelset *self, uint32_t reference, const char *value)
{
    char present[2 * MODEL_TEXT], wanted[2 * MODEL_TEXT];
    if (wheelset_check(self, reference, MODEL_STRING) || check_settable(self, model_variables + reference))
        return 1;
    const model_variable *variable = model_variables + reference;
    if (!value)
        return wheelset_refuse(self, REFUSE_NULL, variable->name);
    if (strlen(value) >= MODEL_TEXT)
        return wheelset_refuse(self, "%s has %lu bytes; permitted are at most %d", variable->name, (unsigned long)strlen(value),
                               MODEL_TEXT - 1);
    const char *held = self->core.text[variable->slot];
    if (self->core.locked && strcmp(held, value) != 0)
        return wheelset_refuse(self, REFUSE_FIXED, variable->name,
                               sentence_quoted(held, present, sizeof present), sentence_quoted(value, wanted, sizeof wanted));
    return 0;
}

int wheelset_may_set_integer(wheelset *self, uint32_t reference)
{
    return wheelset_check(self, reference, MODEL_INTEGER) || check_settable(self, model_variables + reference);
}

int wheelset_may_set_boolean(wheelset *self, uint32_t reference, bool value)
{
    if (wheelset_check(self, reference, MODEL_BOOLEAN) || check_settable(self, model_variables + reference))
        return 1;
    const bool changes = (self->core.values[reference] != 0.0) != value;
    if (model_variables[reference].causality == MODEL_PARAMETER && self->core.locked && changes)
        return wheelset_refuse(self, REFUSE_FIXED, model_variables[reference].name, value ? "False" : "True", value ? "True" : "False");
    if (self->core.phase == PHASE_CONTINUOUS && changes)
        return wheelset_refuse(self, "%s is a Boolean and can be changed only in event mode, not in continuous-time mode",
                               model_variables[reference].name);
    return 0;
}
