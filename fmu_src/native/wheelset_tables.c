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
#include "kernel/generated/constants.h"

enum { TABLE_ROOM = 100000, MOST_ROOM = 10000000 };
enum { NO_MEMORY = -100 };      /* beside the reasons of the kernel's preparation */
enum { DIFFERING = 6 };         /* numbers that may differ on the left side */

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
        if (variable->causality != MODEL_PARAMETER || variable->type == MODEL_STRING)
            continue;
        if (variable->type == MODEL_REAL && !(variable->low <= number && number <= variable->high))
            return wheelset_refuse(self, "%s is %s; permitted is %s ... %s%s", variable->name,
                                   sentence_shortest(number, value, sizeof value), SIX_DIGITS(variable->low),
                                   SIX_DIGITS(variable->high), variable->unit);
        if (variable->setup >= 0)
            setup[variable->setup] = number;
    }
    setup[layout__SETUP_ABSENT] = NAN;
    return 0;
}

/* What differs on the left side; 0 means as on the right. */
static int fill_left(wheelset *self, double *setup)
{
    static const int differing[DIFFERING][3] = {
        {MODEL_LEFT_NOMINAL_RADIUS, MODEL_NOMINAL_RADIUS, layout__SETUP_LEFT_RADIUS},
        {MODEL_LEFT_RAIL_INCLINATION, MODEL_RAIL_INCLINATION, layout__SETUP_LEFT_INCLINATION},
        {MODEL_LEFT_RAIL_LATERAL_STIFFNESS, MODEL_RAIL_LATERAL_STIFFNESS, layout__SETUP_LEFT_SPRING},
        {MODEL_LEFT_RAIL_VERTICAL_STIFFNESS, MODEL_RAIL_VERTICAL_STIFFNESS, layout__SETUP_LEFT_SPRING + 1},
        {MODEL_LEFT_RAIL_LATERAL_DAMPING, MODEL_RAIL_LATERAL_DAMPING, layout__SETUP_LEFT_SPRING + 2},
        {MODEL_LEFT_RAIL_VERTICAL_DAMPING, MODEL_RAIL_VERTICAL_DAMPING, layout__SETUP_LEFT_SPRING + 3}};
    char value[2 * MODEL_TEXT];
    for (int i = 0; i < DIFFERING; i += 1)
    {
        const model_variable *own = model_variables + differing[i][0], *other = model_variables + differing[i][1];
        const double number = self->core.values[differing[i][0]];
        setup[differing[i][2]] = number == 0.0 ? setup[other->setup] : number;
        if (number != 0.0 && number < other->low)
            return wheelset_refuse(self, "%s is %s; permitted is %s ... %s%s", own->name,
                                   sentence_shortest(number, value, sizeof value), SIX_DIGITS(other->low), SIX_DIGITS(other->high),
                                   own->unit);
    }
    return 0;
}

/* Rails on springs need the compliant mode, and dampers need springs and a step in time. */
static int check_springs(wheelset *self, const double *setup)
{
    static const int springs[4][3] = {
        {MODEL_RAIL_LATERAL_STIFFNESS, MODEL_LEFT_RAIL_LATERAL_STIFFNESS, 0},
        {MODEL_RAIL_VERTICAL_STIFFNESS, MODEL_LEFT_RAIL_VERTICAL_STIFFNESS, 1},
        {MODEL_RAIL_LATERAL_DAMPING, MODEL_LEFT_RAIL_LATERAL_DAMPING, 0},
        {MODEL_RAIL_VERTICAL_DAMPING, MODEL_LEFT_RAIL_VERTICAL_DAMPING, 1}};
    char value[2 * MODEL_TEXT];
    for (int i = 0; i < 8; i += 1)
    {
        const int *row = springs[i % 4];
        const model_variable *variable = model_variables + row[i / 4], *stiffness = model_variables + springs[row[2]][i / 4];
        const double number = self->core.values[row[i / 4]];
        const double beside = i < 4 ? setup[stiffness->setup] : setup[layout__SETUP_LEFT_SPRING + row[2]];
        if (number == 0.0)
            continue;
        if (!wheelset_is_compliant(self))
            return wheelset_refuse(self, "%s is %s%s; permitted with the contact_mode '%s' is 0: rails stand on springs with the "
                                   "contact_mode 'compliant'", variable->name, sentence_shortest(number, value, sizeof value),
                                   variable->unit, self->core.text[MODEL_MODE_SLOT]);
        if (self->core.exchange && i % 4 >= 2)
            return wheelset_refuse(self, "%s is %s%s; permitted in model exchange is 0: a damper needs the steps of co-simulation",
                                   variable->name, sentence_shortest(number, value, sizeof value), variable->unit);
        if (beside == 0.0)
            return wheelset_refuse(self, "%s is %s%s without %s; permitted is 0, or a stiffness beside it", variable->name,
                                   sentence_shortest(number, value, sizeof value), variable->unit, stiffness->name);
    }
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

/* The profile that the String `parameter` names; its case matters only between profiles that differ in nothing else. */
static int find_profile(wheelset *self, const char *parameter, const char *kind, int slot, array_double_1d *definition)
{
    char value[2 * MODEL_TEXT], list[MODEL_SENTENCE];
    size_t length = 0;
    const char *other = "";
    bool exact = false;
    for (int i = 0; i < model_profile_count; i += 1)
        exact = exact || strcmp(self->core.text[slot], model_profiles[i].name) == 0;
    for (int i = 0; i < model_profile_count; i += 1)
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
    return wheelset_refuse(self, "%s is %s%s; permitted are %s", parameter, sentence_quoted(self->core.text[slot], value, sizeof value),
                           other, list);
}

/* Why the kernel could not prepare the tables; `slots` are where the names of a side's wheel and rail are. */
static int refuse_preparation(wheelset *self, const int *slots, int reason, const double *setup)
{
    const char *wheel = self->core.text[slots[0]], *rail = self->core.text[slots[1]];
    if (reason == prepare_tables__GAUGE_TOO_DEEP)
        return wheelset_refuse(self, "gauge_depth reaches %s m, but the inner side of the rail profile %s ends at %s m; "
                               "permitted are smaller depths", SIX_DIGITS(setup[layout__SETUP_DEPTH]), rail,
                               SIX_DIGITS(setup[layout__SETUP_REACHED]));
    if (reason == prepare_scan__TOO_WIDE)
        return wheelset_refuse(self, "the wheel profile is %s m wide; permitted are at most %s m",
                               FOUR_DIGITS(setup[layout__SETUP_WIDTH]), FOUR_DIGITS(MODEL_WIDEST));
    if (reason == prepare_tables__WITHOUT_HEAD)
        return wheelset_refuse(self, "the profiles %s and %s are too steep at y = 0 m, the running circle and the rail's highest "
                               "point; permitted are profiles with less slope there", wheel, rail);
    if (reason == prepare_pieces__FULL)
        return wheelset_refuse(self, "the profiles %s and %s have too many points for the kernel's tables; permitted are profiles "
                               "with fewer points", wheel, rail);
    return wheelset_refuse(self, "there is no memory for the kernel's tables");
}

/* One attempt with room for `room` numbers; how many are used, or a negative reason. */
static int prepare_in(wrcontact_preparation *preparation, int64_t room)
{
    int used = NO_MEMORY;
    preparation->tables = span_of(calloc((size_t)room, sizeof(double)), room);
    const int64_t needed = wrcontact_prepare_room(preparation);
    preparation->work = span_of(calloc((size_t)needed, sizeof(double)), needed);
    if (preparation->tables.data && preparation->work.data)
        used = wrcontact_prepare(preparation);
    free(preparation->work.data);
    if (used >= 0)
    {
        double *fitting = realloc(preparation->tables.data, (size_t)used * sizeof(double));
        preparation->tables = span_of(fitting ? fitting : preparation->tables.data, used);
    }
    else
        free(preparation->tables.data);
    return used;
}

/* Whether the tables are those of the present parameters. */
bool wheelset_is_built(const wheelset *self)
{
    if (!self->tables.data || memcmp(self->built_text, self->core.text, sizeof self->built_text) != 0)
        return false;
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
        if (model_variables[i].causality == MODEL_PARAMETER && self->built_values[i] != self->core.values[i])
            return false;
    return true;
}

/* The definitions of all profiles; a left profile without a name is that of the right side.  `slots` are where the names are. */
static int find_profiles(wheelset *self, wrcontact_preparation *preparation, int slots[4])
{
    const int own[4] = {MODEL_WHEEL_SLOT, MODEL_RAIL_SLOT, MODEL_LEFT_WHEEL_SLOT, MODEL_LEFT_RAIL_SLOT};
    static const char *const names[4] = {"wheel_profile", "rail_profile", "left_wheel_profile", "left_rail_profile"};
    static const char *const kinds[2] = {"wheel", "rail"};
    array_double_1d *const definitions[4] = {&preparation->wheel, &preparation->rail, &preparation->left_wheel, &preparation->left_rail};
    for (int i = 0; i < 4; i += 1)
    {
        const int named = i >= 2 && !*self->core.text[own[i]] ? i - 2 : i;
        slots[i] = own[named];
        if (find_profile(self, names[named], kinds[i % 2], slots[i], definitions[i]))
            return 1;
    }
    return 0;
}

void wheelset_free_tables(wheelset *self)
{
    free(self->tables.data);
    self->tables = span_of(NULL, 0);
}

/* New tables for the present parameters. */
static int prepare(wheelset *self)
{
    double setup[MODEL_SETUP];
    int slots[4];
    wrcontact_preparation preparation = {0};
    preparation.setup = span_of(setup, MODEL_SETUP);
    preparation.fixed = span_of((double *)model_fixed, MODEL_FIXED_SIZE);
    if (fill_setup(self, setup) || fill_resolution(self, setup) || fill_left(self, setup) || check_springs(self, setup)
        || find_profiles(self, &preparation, slots))
        return 1;
    int used = prepare_pieces__FULL;
    for (int64_t room = TABLE_ROOM; used == prepare_pieces__FULL && room <= MOST_ROOM; room *= 4)
        used = prepare_in(&preparation, room);
    if (used < 0)
        return refuse_preparation(self, setup[layout__SETUP_SIDE] == 1.0 ? slots : slots + 2, used, setup);
    wheelset_free_tables(self);
    self->tables = preparation.tables;
    memcpy(self->built_values, self->core.values, sizeof self->built_values);
    memcpy(self->built_text, self->core.text, sizeof self->built_text);
    return 0;
}

/* The tables for the present parameters and stations. */
int wheelset_build(wheelset *self)
{
    if (!wheelset_is_built(self) && prepare(self))
        return 1;
    self->tables.data[layout__TABLES_STATIONS] = (double)self->core.stations;
    self->tables.data[layout__TABLES_PARAMETERS + layout__PARAMETERS_STATIONS] = (double)self->core.stations;
    self->tables.data[layout__TABLES_SIDES] = MODEL_SIDES;
    self->tables.data[layout__TABLES_ALONE] = MODEL_SIDES != layout__SIDES_BOTH;
    return 0;
}
