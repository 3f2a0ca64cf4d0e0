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
#include "kernel/generated/prepare.h"

enum { TABLE_ROOM = 100000, MOST_ROOM = 10000000 };

/* What a user calls the profiles of a side, and where their names are. */
typedef struct {
    const char *wheel, *rail;
    int wheel_slot, rail_slot;
} side_choice;

/* The kernel's setup of the right side from the parameters. */
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

/* The setup of the left side, with what differs there, and the height of the wheelset's centre in both. */
static int fill_left_setup(wheelset *self, double *left, double *right)
{
    static const int differing[2][2] = {{MODEL_LEFT_NOMINAL_RADIUS, MODEL_NOMINAL_RADIUS},
                                        {MODEL_LEFT_RAIL_INCLINATION, MODEL_RAIL_INCLINATION}};
    char value[2 * MODEL_TEXT];
    memcpy(left, right, MODEL_SETUP * sizeof *left);
    for (int i = 0; i < 2; i += 1)
    {
        const model_variable *own = model_variables + differing[i][0], *other = model_variables + differing[i][1];
        const double number = self->core.values[differing[i][0]];
        if (number == 0.0)
            continue;
        if (number < other->low)
            return wheelset_refuse(self, "%s is %s; permitted is %s ... %s%s", own->name,
                                   sentence_shortest(number, value, sizeof value), SIX_DIGITS(other->low), SIX_DIGITS(other->high),
                                   own->unit);
        left[other->setup] = number;
    }
    const int radius = model_variables[MODEL_NOMINAL_RADIUS].setup;
    left[layout__SETUP_HEIGHT] = right[layout__SETUP_HEIGHT] = 0.5 * (right[radius] + left[radius]);
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

/* The profile that a String names, which a user calls `argument`; its case matters only between profiles that differ in nothing else. */
static int find_profile(wheelset *self, const char *argument, const char *kind, int slot, array_double_1d *definition)
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
    return wheelset_refuse(self, "%s is %s%s; permitted are %s", argument, sentence_quoted(self->core.text[slot], value, sizeof value),
                           other, list);
}

/* Why the kernel could not prepare the tables of a side. */
static int refuse_preparation(wheelset *self, const side_choice *side, int outcome, const double *report)
{
    const char *wheel = self->core.text[side->wheel_slot], *rail = self->core.text[side->rail_slot];
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
static int prepare_in(wrcontact_preparation *preparation, int64_t room)
{
    preparation->tables = span_of(calloc((size_t)room, sizeof(double)), room);
    const int64_t needed = wrcontact_prepare_room(preparation);
    preparation->work = span_of(calloc((size_t)needed, sizeof(double)), needed);
    int outcome = -1;
    if (preparation->tables.data && preparation->work.data)
        outcome = wrcontact_prepare(preparation);
    free(preparation->work.data);
    if (outcome == prepare_tables__PREPARED)
    {
        const int64_t size = (int64_t)preparation->report.data[prepare_tables__REPORT_SIZE];
        double *fitting = realloc(preparation->tables.data, (size_t)size * sizeof(double));
        preparation->tables = span_of(fitting ? fitting : preparation->tables.data, size);
    }
    else
        free(preparation->tables.data);
    return outcome;
}

/* Whether the tables are those of the present parameters. */
bool wheelset_is_built(const wheelset *self)
{
    if (!self->right_tables.data || memcmp(self->built_text, self->core.text, sizeof self->built_text) != 0)
        return false;
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
        if (model_variables[i].causality == MODEL_PARAMETER && self->built_values[i] != self->core.values[i])
            return false;
    return true;
}

/* The tables of a side, without starts and methods, in preparation->tables. */
static int prepare_side(wheelset *self, const side_choice *side, wrcontact_preparation *preparation)
{
    int outcome = prepare_tables__TABLES_FULL;
    for (int64_t room = TABLE_ROOM; outcome == prepare_tables__TABLES_FULL && room <= MOST_ROOM; room *= 4)
        outcome = prepare_in(preparation, room);
    return outcome == prepare_tables__PREPARED ? 0 : refuse_preparation(self, side, outcome, preparation->report.data);
}

/* What a preparation starts from: the setup of a side and its profiles. */
static int begin_side(wheelset *self, const side_choice *side, double *setup, double *report, wrcontact_preparation *preparation)
{
    if (find_profile(self, side->wheel, "wheel", side->wheel_slot, &preparation->wheel)
        || find_profile(self, side->rail, "rail", side->rail_slot, &preparation->rail))
        return 1;
    preparation->setup = span_of(setup, MODEL_SETUP);
    preparation->report = span_of(report, MODEL_REPORT);
    preparation->fixed = span_of((double *)model_fixed, MODEL_FIXED_SIZE);
    return 0;
}

static bool same_numbers(array_double_1d one, array_double_1d other)
{
    return one.shape[0] == other.shape[0] && memcmp(one.data, other.data, (size_t)one.shape[0] * sizeof(double)) == 0;
}

/* Starts and methods into the tables of both sides, which then are the wheelset's. */
static int complete(wheelset *self, const wrcontact_preparation *left, const wrcontact_preparation *right)
{
    const int64_t needed = wrcontact_prepare_room(right);
    double *work = calloc((size_t)needed, sizeof(double));
    if (!work)
    {
        if (left->tables.data != right->tables.data)
            free(left->tables.data);
        free(right->tables.data);
        return wheelset_refuse(self, "there is no memory for the kernel's tables");
    }
    wrcontact_complete(right->setup, left->tables, right->tables, work);
    free(work);
    wheelset_free_tables(self);
    self->left_tables = left->tables;
    self->right_tables = right->tables;
    return 0;
}

void wheelset_free_tables(wheelset *self)
{
    if (self->left_tables.data != self->right_tables.data)
        free(self->left_tables.data);
    free(self->right_tables.data);
    self->left_tables = self->right_tables = span_of(NULL, 0);
}

/* New tables for the present parameters. */
static int prepare(wheelset *self)
{
    double right_setup[MODEL_SETUP], left_setup[MODEL_SETUP], report[MODEL_REPORT] = {0.0};
    wrcontact_preparation left = {0}, right = {0};
    const side_choice right_side = {"wheel", "rail", MODEL_WHEEL_SLOT, MODEL_RAIL_SLOT};
    const side_choice left_side = {
        *self->core.text[MODEL_LEFT_WHEEL_SLOT] ? "left_wheel" : "wheel", *self->core.text[MODEL_LEFT_RAIL_SLOT] ? "left_rail" : "rail",
        *self->core.text[MODEL_LEFT_WHEEL_SLOT] ? MODEL_LEFT_WHEEL_SLOT : MODEL_WHEEL_SLOT,
        *self->core.text[MODEL_LEFT_RAIL_SLOT] ? MODEL_LEFT_RAIL_SLOT : MODEL_RAIL_SLOT};
    if (fill_setup(self, right_setup) || fill_resolution(self, right_setup) || fill_left_setup(self, left_setup, right_setup)
        || begin_side(self, &right_side, right_setup, report, &right) || begin_side(self, &left_side, left_setup, report, &left)
        || prepare_side(self, &right_side, &right))
        return 1;
    if (memcmp(left_setup, right_setup, sizeof left_setup) == 0 && same_numbers(left.wheel, right.wheel)
        && same_numbers(left.rail, right.rail))
        left.tables = right.tables;
    else if (prepare_side(self, &left_side, &left))
    {
        free(right.tables.data);
        return 1;
    }
    if (complete(self, &left, &right))
        return 1;
    memcpy(self->built_values, self->core.values, sizeof self->built_values);
    memcpy(self->built_text, self->core.text, sizeof self->built_text);
    return 0;
}

/* The tables for the present parameters and stations. */
int wheelset_build(wheelset *self)
{
    if (!wheelset_is_built(self) && prepare(self))
        return 1;
    double *const sides[2] = {self->left_tables.data, self->right_tables.data};
    for (int side = 0; side < 2; side += 1)
    {
        sides[side][layout__SET_STATIONS] = (double)self->core.stations;
        sides[side][layout__SET_PARAMETERS + layout__PARAMETERS_STATIONS] = (double)self->core.stations;
    }
    return 0;
}
