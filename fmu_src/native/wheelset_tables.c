/* From the parameters to the kernel's tables. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sentences.h"
#include "wheelset_parts.h"

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/layout.h"
#include "kernel/generated/prepare_tables.h"

enum { TABLE_ROOM = 100000, MOST_ROOM = 10000000 };

/* The kernel's setup from the parameters. */
static int fill_setup(wheelset *self, double *setup)
{
    char value[2 * MODEL_TEXT], list[MODEL_SENTENCE];
    memcpy(setup, model_setup, sizeof model_setup);
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
    {
        const model_variable *variable = model_variables + i;
        if (variable->choice_count == 0)
            continue;
        const char *chosen = self->core.text[variable->slot];
        bool found = false;
        size_t length = 0;
        for (int k = 0; k < variable->choice_count; k += 1)
        {
            const model_choice *choice = variable->choices + k;
            length += (size_t)snprintf(list + length, sizeof list - length, "%s'%s'", k ? ", " : "", choice->name);
            if (strcmp(chosen, choice->name) == 0)
            {
                setup[variable->setup] = choice->number;
                found = true;
            }
        }
        if (!found)
            return wheelset_refuse(self, "%s is %s; permitted %s %s", variable->name, sentence_quoted(chosen, value, sizeof value),
                                   variable->choice_count > 1 ? "are" : "is", list);
    }
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
    {
        const model_variable *variable = model_variables + i;
        const double number = self->core.values[i];
        if (variable->causality != MODEL_PARAMETER || variable->type != MODEL_REAL)
            continue;
        if (!(variable->low <= number && number <= variable->high))
            return wheelset_refuse(self, "%s is %s; permitted is %s ... %s%s", variable->name,
                                   sentence_shortest(number, value, sizeof value), SIX_DIGITS(variable->low),
                                   SIX_DIGITS(variable->high), variable->unit);
        if (variable->setup >= 0)
            setup[variable->setup] = number;
    }
    setup[layout__SETUP_ABSENT] = NAN;
    return 0;
}

/* Nodes and strips for the tolerance that is asked for. */
static int fill_resolution(wheelset *self, double *setup)
{
    const double tolerance = self->core.values[MODEL_TOLERANCE];
    const char *model = self->core.text[MODEL_NORMAL_MODEL_SLOT];
    for (int i = 0; i < MODEL_LADDERS; i += 1)
    {
        const model_ladder *ladder = model_ladders + i;
        if (strcmp(model, ladder->model) != 0)
            continue;
        if (tolerance < ladder->finest)
            return wheelset_refuse(self, "tolerance is %s; permitted with the normal_model '%s' is %s ... %s",
                                   SIX_DIGITS(tolerance), model, SIX_DIGITS(ladder->finest),
                                   SIX_DIGITS(model_variables[MODEL_TOLERANCE].high));
        int k = 0;
        while (k + 1 < ladder->count && ladder->steps[k].tolerance > tolerance)
            k += 1;
        memcpy(setup + layout__SETUP_RESOLUTION, ladder->steps[k].numbers, sizeof ladder->steps[k].numbers);
        return 0;
    }
    return wheelset_refuse(self, "normal_model is '%s', which has no resolution", model);
}

/* Whether two names differ at most in the case of their letters a to z. */
static bool same_but_case(const char *one, const char *other)
{
    for (; *one && *other; one += 1, other += 1)
    {
        const int a = *one >= 'A' && *one <= 'Z' ? *one - 'A' + 'a' : *one;
        const int b = *other >= 'A' && *other <= 'Z' ? *other - 'A' + 'a' : *other;
        if (a != b)
            return false;
    }
    return *one == *other;
}

/* The profile that a String names; its case matters only between profiles that differ in nothing else. */
static int find_profile(wheelset *self, const char *kind, int slot, array_double_1d *definition)
{
    char value[2 * MODEL_TEXT], list[MODEL_SENTENCE];
    size_t length = 0;
    const char *other = "";
    bool exact = false;
    for (int i = 0; i < MODEL_PROFILES; i += 1)
        exact = exact || strcmp(self->core.text[slot], model_profiles[i].name) == 0;
    for (int i = 0; i < MODEL_PROFILES; i += 1)
    {
        const model_profile *profile = model_profiles + i;
        const bool named = exact ? strcmp(self->core.text[slot], profile->name) == 0
                                 : same_but_case(self->core.text[slot], profile->name);
        if (strcmp(profile->kind, kind) != 0)
        {
            if (named)
                other = " (a profile of the other kind)";
            continue;
        }
        if (named)
        {
            *definition = span_of((double *)profile->definition, profile->size);
            return 0;
        }
        if (length < sizeof list)
            length += (size_t)snprintf(list + length, sizeof list - length, "%s%s", length ? ", " : "", profile->name);
    }
    return wheelset_refuse(self, "%s is %s%s; permitted are %s", kind, sentence_quoted(self->core.text[slot], value, sizeof value), other,
                           list);
}

/* Why the kernel could not prepare its tables. */
static int refuse_preparation(wheelset *self, int outcome, const double *report)
{
    const char *wheel = self->core.text[MODEL_WHEEL_SLOT], *rail = self->core.text[MODEL_RAIL_SLOT];
    if (outcome == prepare_tables__GAUGE_TOO_DEEP)
        return wheelset_refuse(self, "gauge_depth reaches %s m, but the inner side of the rail profile %s ends at %s m; "
                               "permitted are smaller depths", SIX_DIGITS(report[prepare_tables__REPORT_DEPTH]), rail,
                               SIX_DIGITS(report[prepare_tables__REPORT_DEEPEST]));
    if (outcome == prepare_tables__WHEEL_TOO_WIDE)
        return wheelset_refuse(self, "the wheel profile is %s m wide; permitted are at most %s m",
                               FOUR_DIGITS(report[prepare_tables__REPORT_WIDTH]), FOUR_DIGITS(MODEL_WIDEST));
    if (outcome == prepare_tables__WITHOUT_HEAD)
        return wheelset_refuse(self, "the profiles %s and %s are too steep at y = 0 m, the running circle and the rail's highest "
                               "point; permitted are profiles with less slope there", wheel, rail);
    if (outcome == prepare_tables__TABLES_FULL)
        return wheelset_refuse(self, "the profiles %s and %s have too many points for the kernel's tables; permitted are profiles "
                               "with fewer points", wheel, rail);
    return wheelset_refuse(self, "there is no memory for the kernel's tables");
}

/* One attempt with room for `room` numbers; the outcome, -1 for no memory. */
static int prepare_in(wheelset *self, wrcontact_preparation *preparation, int64_t room)
{
    preparation->tables = span_of(calloc((size_t)room, sizeof(double)), room);
    const int64_t needed = wrcontact_prepare_room(preparation);
    preparation->work = span_of(calloc((size_t)needed, sizeof(double)), needed);
    int outcome = -1;
    if (preparation->tables.data && preparation->work.data)
        outcome = wrcontact_prepare(preparation);
    double *fitting = NULL;
    if (outcome == prepare_tables__PREPARED)
    {
        self->table_size = (int64_t)preparation->report.data[prepare_tables__REPORT_SIZE];
        fitting = realloc(preparation->tables.data, (size_t)self->table_size * sizeof(double));
        free(self->tables);
        self->tables = fitting ? fitting : preparation->tables.data;
    }
    else
        free(preparation->tables.data);
    free(preparation->work.data);
    return outcome;
}

/* Whether the tables are those of the present parameters. */
bool wheelset_is_built(const wheelset *self)
{
    if (!self->tables || memcmp(self->built_text, self->core.text, sizeof self->built_text) != 0)
        return false;
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
        if (model_variables[i].causality == MODEL_PARAMETER && self->built_values[i] != self->core.values[i])
            return false;
    return true;
}

/* New tables for the present parameters. */
static int prepare(wheelset *self)
{
    double setup[MODEL_SETUP], report[MODEL_REPORT] = {0.0};
    wrcontact_preparation preparation = {0};
    if (fill_setup(self, setup) || fill_resolution(self, setup)
        || find_profile(self, "wheel", MODEL_WHEEL_SLOT, &preparation.wheel)
        || find_profile(self, "rail", MODEL_RAIL_SLOT, &preparation.rail))
        return 1;
    preparation.setup = span_of(setup, MODEL_SETUP);
    preparation.report = span_of(report, MODEL_REPORT);
    preparation.hertz = span_of((double *)model_hertz, MODEL_HERTZ_SIZE);
    preparation.influence = span_of((double *)model_influence, MODEL_INFLUENCE_SIZE);
    int outcome = prepare_tables__TABLES_FULL;
    for (int64_t room = TABLE_ROOM; outcome == prepare_tables__TABLES_FULL && room <= MOST_ROOM; room *= 4)
        outcome = prepare_in(self, &preparation, room);
    if (outcome != prepare_tables__PREPARED)
        return refuse_preparation(self, outcome, report);
    memcpy(self->built_values, self->core.values, sizeof self->built_values);
    memcpy(self->built_text, self->core.text, sizeof self->built_text);
    return 0;
}

/* The tables for the present parameters and stations. */
int wheelset_build(wheelset *self)
{
    if (!wheelset_is_built(self) && prepare(self))
        return 1;
    self->tables[layout__SET_STATIONS] = (double)self->core.stations;
    self->tables[layout__SET_PARAMETERS + layout__PARAMETERS_STATIONS] = (double)self->core.stations;
    return 0;
}
