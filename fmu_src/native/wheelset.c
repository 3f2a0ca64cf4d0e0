#include "wheelset.h"

#include <float.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/layout.h"
#include "kernel/generated/prepare_tables.h"

static const char FORMAT[16] = "wrcontact 2", TOKEN[48] = MODEL_TOKEN;
static const char KEPT[] = "the outputs keep their last valid values";
static const double ROUNDING = 1e-9;     /* of a time that a host has added up over many steps, relative */
enum { TABLE_ROOM = 100000, MOST_ROOM = 10000000 };

/* --- sentences ------------------------------------------------------------------------------------ */

int wheelset_refuse(wheelset *self, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(self->sentence, sizeof self->sentence, format, arguments);
    va_end(arguments);
    return 1;
}

/* The number in `text`, as printf has written it, with a point where the host's locale has something else. */
static const char *pointed(char *text)
{
    const size_t whole = strspn(text, "+-0123456789");
    const size_t mark = strcspn(text + whole, "0123456789aefinxAEFINX");
    if (mark > 0 && text[whole] != 0)
    {
        text[whole] = '.';
        memmove(text + whole + 1, text + whole + mark, strlen(text + whole + mark) + 1);
    }
    return text;
}

/* A number in as many digits. */
static const char *rounded(double value, int digits, char *text, size_t size)
{
    snprintf(text, size, "%.*g", digits, value);
    return pointed(text);
}

/* The same in a place of its own, for one sentence. */
#define FOUR_DIGITS(value) rounded((value), 4, (char[32]){0}, 32)
#define SIX_DIGITS(value) rounded((value), 6, (char[32]){0}, 32)

/* A number in the fewest digits that give it back, as Python writes it. */
static const char *shortest(double value, char *text, size_t size)
{
    if (!isfinite(value))
    {
        snprintf(text, size, "%s", isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
        return text;
    }
    int digits = 0;
    do
        snprintf(text, size, "%.*e", digits, value);
    while (strtod(text, NULL) != value && ++digits < 17);
    const char *power = strchr(text, 'e');
    const int exponent = power ? atoi(power + 1) : 0;
    if (-4 <= exponent && exponent < 16)
        snprintf(text, size, "%.*f", digits - exponent > 1 ? digits - exponent : 1, value);
    return pointed(text);
}

/* `text` in quotes, as Python writes it, with a mark in place of control characters. */
static const char *quoted(const char *text, char *result, size_t size)
{
    const char quote = strchr(text, '\'') && !strchr(text, '"') ? '"' : '\'';
    size_t at = 0;
    result[at++] = quote;
    for (; *text && at + 2 < size; text += 1)
        result[at++] = (unsigned char)*text < 32 ? '?' : *text;
    result[at++] = quote;
    result[at] = 0;
    return result;
}

/* The first input that is not permitted, in a clause. */
static void invalid_input(const double *inputs, char *text, size_t size)
{
    char number[40];
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        if (!isfinite(inputs[i]))
        {
            snprintf(text, size, "%s is %s %s; permitted are finite numbers", model_variables[i].name,
                     shortest(inputs[i], number, sizeof number), model_variables[i].unit);
            return;
        }
    if (inputs[layout__IN_NORMAL_FORCE] < 0.0)
        snprintf(text, size, "normal_force is %s N; permitted is normal_force >= 0 N",
                 SIX_DIGITS(inputs[layout__IN_NORMAL_FORCE]));
    else
        snprintf(text, size, "load_transfer is %s; permitted is -1 <= load_transfer <= 1",
                 SIX_DIGITS(inputs[layout__IN_LOAD_TRANSFER]));
}

/* One sentence on a status that is not 0, as wrcontact/status.py words it. */
static void explain(int status, const double *inputs, bool compliant, char *text, size_t size)
{
    const char *shift = SIX_DIGITS(inputs[layout__IN_LATERAL_SHIFT]), *yaw = SIX_DIGITS(inputs[layout__IN_YAW]);
    const char *force = SIX_DIGITS(inputs[layout__IN_NORMAL_FORCE]);
    const char *transfer = SIX_DIGITS(inputs[layout__IN_LOAD_TRANSFER]);
    const char *height = SIX_DIGITS(inputs[layout__IN_VERTICAL_SHIFT]), *roll = SIX_DIGITS(inputs[layout__IN_ROLL]);
    const bool far = fabs(inputs[layout__IN_LATERAL_SHIFT]) > MODEL_LATERAL_LIMIT;
    char clause[200];
    if (status == layout__INVALID_INPUT)
    {
        invalid_input(inputs, clause, sizeof clause);
        snprintf(text, size, "%s; %s", clause, KEPT);
    }
    else if (status == layout__UNLOADED && compliant)
        snprintf(text, size, "vertical_shift_input is %s m at roll_input %s rad, so a wheel is lifted and carries no load; its "
                 "patch is empty (a larger vertical_shift_input lowers the wheelset)", height, roll);
    else if (status == layout__UNLOADED && inputs[layout__IN_NORMAL_FORCE] == 0.0)
        snprintf(text, size, "normal_force is %s N, so a wheel carries no load; its patch is empty (a load needs normal_force > "
                 "0 N and |load_transfer| < 1)", force);
    else if (status == layout__UNLOADED)
        snprintf(text, size, "load_transfer is %s, so a wheel carries no load; its patch is empty (a load needs normal_force > "
                 "0 N and |load_transfer| < 1)", transfer);
    else if (status != layout__OFF_PROFILE)
        snprintf(text, size, "no solution at lateral_shift %s m, yaw %s rad, normal_force %s N, load_transfer %s within the "
                 "iteration limit; %s", shift, yaw, force, transfer, KEPT);
    else if (!far && fabs(inputs[layout__IN_YAW]) > MODEL_YAW_LIMIT)
        snprintf(text, size, "yaw is %s rad, beyond the profiles; permitted is |yaw| <= %s rad; %s", yaw,
                 SIX_DIGITS(MODEL_YAW_LIMIT), KEPT);
    else if (far)
        snprintf(text, size, "lateral_shift is %s m, beyond the profiles; permitted is |lateral_shift| <= %s m; %s", shift,
                 SIX_DIGITS(MODEL_LATERAL_LIMIT), KEPT);
    else if (compliant && fabs(inputs[layout__IN_ROLL]) > MODEL_ROLL_LIMIT)
        snprintf(text, size, "roll_input is %s rad; permitted is |roll_input| <= %s rad; %s", roll,
                 SIX_DIGITS(MODEL_ROLL_LIMIT), KEPT);
    else if (compliant)
        snprintf(text, size, "vertical_shift_input is %s m and roll_input %s rad at lateral_shift %s m: the contact leaves a "
                 "profile, or a wheel is deeper in its rail than %s m; %s", height, roll, shift, SIX_DIGITS(MODEL_DEEPEST), KEPT);
    else
        snprintf(text, size, "lateral_shift is %s m at yaw %s rad: the smallest gap lies at the end of a profile, so there is no "
                 "contact; or, in elastic contact, normal_force %s N with load_transfer %s presses a wheel deeper into its rail than "
                 "%s m; permitted are poses with the contact inside both profiles; %s", shift, yaw, force, transfer,
                 SIX_DIGITS(MODEL_DEEPEST), KEPT);
}

static void tell_status(wheelset *self)
{
    char sentence[MODEL_SENTENCE];
    const bool compliant = strcmp(self->core.text[MODEL_MODE_SLOT], "compliant") == 0;
    explain((int)self->core.status, self->core.values, compliant, sentence, sizeof sentence);
    self->tell(self->owner, sentence);
    self->core.told = 1;
}

/* --- from parameters to tables -------------------------------------------------------------------- */

/* The kernel's setup from the parameters. */
static int fill_setup(wheelset *self, double *setup)
{
    char value[2 * MODEL_TEXT], list[MODEL_SENTENCE];
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
            return wheelset_refuse(self, "%s is %s; permitted %s %s", variable->name, quoted(chosen, value, sizeof value),
                                   variable->choice_count > 1 ? "are" : "is", list);
    }
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
    {
        const model_variable *variable = model_variables + i;
        const double number = self->core.values[i];
        if (variable->causality != MODEL_PARAMETER || variable->type != MODEL_REAL)
            continue;
        if (!(variable->low <= number && number <= variable->high))
            return wheelset_refuse(self, "%s is %s; permitted is %s ... %s %s", variable->name,
                                   shortest(number, value, sizeof value), SIX_DIGITS(variable->low),
                                   SIX_DIGITS(variable->high), variable->unit);
        if (variable->setup >= 0)
            setup[variable->setup] = number;
    }
    setup[prepare_tables__SETUP_NAN] = NAN;
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
            return wheelset_refuse(self, "tolerance is %s; permitted with the normal_model '%s' is %s ... 0.1 1",
                                   SIX_DIGITS(tolerance), model, SIX_DIGITS(ladder->finest));
        int k = 0;
        while (k + 1 < ladder->count && ladder->steps[k].tolerance > tolerance)
            k += 1;
        memcpy(setup + prepare_tables__SETUP_NODES, ladder->steps[k].numbers, sizeof ladder->steps[k].numbers);
        return 0;
    }
    return wheelset_refuse(self, "normal_model is '%s', which has no resolution", model);
}

/* The profile that a String names. */
static int find_profile(wheelset *self, const char *kind, int slot, array_double_1d *definition)
{
    char value[2 * MODEL_TEXT], list[MODEL_SENTENCE];
    size_t length = 0;
    const char *other = "";
    for (int i = 0; i < MODEL_PROFILES; i += 1)
    {
        const model_profile *profile = model_profiles + i;
        const bool named = strcmp(self->core.text[slot], profile->name) == 0;
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
    return wheelset_refuse(self, "%s is %s%s; permitted are %s", kind, quoted(self->core.text[slot], value, sizeof value), other,
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
static bool is_built(const wheelset *self)
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
    double setup[MODEL_SETUP] = {0.0}, report[MODEL_REPORT] = {0.0};
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
static int build(wheelset *self)
{
    if (!is_built(self) && prepare(self))
        return 1;
    self->tables[layout__SET_STATIONS] = (double)self->core.stations;
    return 0;
}

/* Build the tables where the parameters have changed, and begin with an empty memory. */
static int initialise(wheelset *self)
{
    if (self->core.built && is_built(self))
        return 0;
    if (build(self))
        return 1;
    memset(self->core.memory, 0, sizeof self->core.memory);
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    memset(self->core.values + MODEL_FIRST_OUTPUT, 0, ROW * sizeof(double));
    self->core.built = self->core.stale = 1;
    return 0;
}

/* --- life ------------------------------------------------------------------------------------------- */

wheelset *wheelset_new(wheelset_tell *tell, void *owner)
{
    wheelset *self = calloc(1, sizeof *self);
    if (!self)
        return NULL;
    self->tell = tell;
    self->owner = owner;
    self->workspace = calloc(MODEL_WORK, sizeof(double));
    self->tangent_room = calloc((size_t)wrcontact_tangent_room(), sizeof(double));
    if (!self->workspace || !self->tangent_room)
    {
        wheelset_free(self);
        return NULL;
    }
    wheelset_reset(self);
    return self;
}

void wheelset_free(wheelset *self)
{
    while (self->states)
    {
        wheelset_state *next = self->states->next;
        free(self->states);
        self->states = next;
    }
    free(self->tables);
    free(self->workspace);
    free(self->tangent_room);
    free(self);
}

void wheelset_reset(wheelset *self)
{
    memset(&self->core, 0, sizeof self->core);
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    for (int i = 0; i < MODEL_STATUS; i += 1)
    {
        self->core.values[i] = model_variables[i].start;
        if (model_variables[i].slot >= 0)
            snprintf(self->core.text[model_variables[i].slot], MODEL_TEXT, "%s", model_variables[i].text);
    }
    self->core.stations = MODEL_STATIONS;
    self->core.phase = PHASE_INSTANTIATED;
    self->core.stale = 1;
    self->core.stop = INFINITY;
}

int wheelset_experiment(wheelset *self, double start, bool stops, double stop)
{
    char first[40], last[40];
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, "initialisation is permitted once, with startTime and stopTime, after instantiation or a "
                               "reset");
    if (!isfinite(start) || (stops && !(stop >= start)))
        return wheelset_refuse(self, "startTime is %s s and stopTime %s s; permitted are a finite startTime and a stopTime "
                               "not before it", shortest(start, first, sizeof first),
                               shortest(stops ? stop : INFINITY, last, sizeof last));
    self->core.time = start;
    self->core.stop = stops ? stop : INFINITY;
    return 0;
}

int wheelset_configure(wheelset *self)
{
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, "configuration mode can be entered only after instantiation or a reset");
    self->core.phase = PHASE_CONFIGURING;
    return 0;
}

int wheelset_configured(wheelset *self)
{
    if (self->core.phase != PHASE_CONFIGURING)
        return wheelset_refuse(self, "configuration mode can be left only after it was entered");
    self->core.phase = PHASE_INSTANTIATED;
    return 0;
}

int wheelset_enter(wheelset *self)
{
    if (self->core.phase == PHASE_CONFIGURING)
        return wheelset_refuse(self, "configuration mode must be left before initialisation mode is entered");
    if (self->core.phase != PHASE_INSTANTIATED)
        return wheelset_refuse(self, "initialisation mode can be entered once, after instantiation or a reset");
    if (initialise(self))
        return 1;
    self->core.phase = PHASE_INITIALISING;
    return 0;
}

int wheelset_exit(wheelset *self)
{
    if (self->core.phase != PHASE_INITIALISING)
        return wheelset_refuse(self, "initialisation mode can be left only after it was entered");
    if (initialise(self))
        return 1;
    self->core.locked = 1;
    self->core.phase = PHASE_RUNNING;
    wheelset_refresh(self);
    self->core.told = 0;
    return 0;
}

int wheelset_terminate(wheelset *self)
{
    if (self->core.phase != PHASE_RUNNING)
        return wheelset_refuse(self, "only a running simulation can be terminated");
    self->core.phase = PHASE_TERMINATED;
    return 0;
}

/* --- values ----------------------------------------------------------------------------------------- */

int wheelset_check(wheelset *self, uint32_t reference, model_type type)
{
    static const char *const NAMES[] = {"Real", "Integer", "String", "UInt64"};
    if (reference >= MODEL_VARIABLES)
        return wheelset_refuse(self, "value reference %lu does not exist; they run from 0 to %d", (unsigned long)reference,
                               MODEL_VARIABLES - 1);
    const model_variable *variable = model_variables + reference;
    if (variable->type != type)
        return wheelset_refuse(self, "%s is of type %s, not %s", variable->name, NAMES[variable->type], NAMES[type]);
    return 0;
}

int wheelset_may_get(wheelset *self, uint32_t reference, model_type type)
{
    if (wheelset_check(self, reference, type))
        return 1;
    if (model_variables[reference].causality == MODEL_OUTPUT && self->core.phase == PHASE_INSTANTIATED)
        return wheelset_refuse(self, "%s is an output and cannot be read before the initialisation",
                               model_variables[reference].name);
    return 0;
}

/* Whether a variable can be set at all. */
static int check_settable(wheelset *self, const model_variable *variable)
{
    if (self->core.phase == PHASE_TERMINATED)
        return wheelset_refuse(self, "%s cannot be set: the simulation has been terminated", variable->name);
    if (variable->causality == MODEL_OUTPUT)
        return wheelset_refuse(self, "%s is an output and cannot be set", variable->name);
    return 0;
}

int wheelset_may_set_real(wheelset *self, uint32_t reference, double value)
{
    char present[40], wanted[40];
    if (wheelset_check(self, reference, MODEL_REAL) || check_settable(self, model_variables + reference))
        return 1;
    if (model_variables[reference].causality == MODEL_PARAMETER && self->core.locked
        && self->core.values[reference] != value)
        return wheelset_refuse(self, "%s is fixed at %s after initialisation and cannot become %s",
                               model_variables[reference].name,
                               shortest(self->core.values[reference], present, sizeof present),
                               shortest(value, wanted, sizeof wanted));
    return 0;
}

int wheelset_may_set_string(wheelset *self, uint32_t reference, const char *value)
{
    char present[2 * MODEL_TEXT], wanted[2 * MODEL_TEXT];
    if (wheelset_check(self, reference, MODEL_STRING) || check_settable(self, model_variables + reference))
        return 1;
    const model_variable *variable = model_variables + reference;
    if (!value)
        return wheelset_refuse(self, "%s is a NULL pointer; permitted are texts", variable->name);
    if (strlen(value) >= MODEL_TEXT)
        return wheelset_refuse(self, "%s has %lu bytes; permitted are at most %d", variable->name, (unsigned long)strlen(value),
                               MODEL_TEXT - 1);
    const char *held = self->core.text[variable->slot];
    if (self->core.locked && strcmp(held, value) != 0)
        return wheelset_refuse(self, "%s is fixed at %s after initialisation and cannot become %s", variable->name,
                               quoted(held, present, sizeof present), quoted(value, wanted, sizeof wanted));
    return 0;
}

void wheelset_set_real(wheelset *self, uint32_t reference, double value)
{
    if (self->core.values[reference] == value)
        return;
    self->core.values[reference] = value;
    self->core.stale = 1;
}

void wheelset_set_string(wheelset *self, uint32_t reference, const char *value)
{
    char *held = self->core.text[model_variables[reference].slot];
    if (strcmp(held, value) == 0)
        return;
    memset(held, 0, MODEL_TEXT);
    memcpy(held, value, strlen(value));
    self->core.stale = 1;
}

int wheelset_may_set_integer(wheelset *self, uint32_t reference)
{
    return wheelset_check(self, reference, MODEL_INTEGER) || check_settable(self, model_variables + reference);
}

int wheelset_set_stations(wheelset *self, uint64_t stations)
{
    const unsigned long long wanted = stations;
    if (stations == self->core.stations && self->core.phase != PHASE_TERMINATED)
        return 0;
    if (self->core.phase != PHASE_CONFIGURING)
        return wheelset_refuse(self, "stations is fixed at %d outside configuration mode and cannot become %llu",
                               (int)self->core.stations, wanted);
    if (stations < (uint64_t)layout__STATION_LEAST || stations > (uint64_t)layout__STATION_LIMIT)
        return wheelset_refuse(self, "stations is %llu; permitted is %d ... %d", wanted, (int)layout__STATION_LEAST,
                               (int)layout__STATION_LIMIT);
    self->core.stations = stations;
    return 0;
}

int32_t wheelset_integer(const wheelset *self, uint32_t reference)
{
    return (int32_t)(reference == MODEL_STATUS ? self->core.status : self->core.values[reference]);
}

/* The kernel's arrays. */
static wrcontact_handle handle_of(wheelset *self)
{
    wheelset_core *core = &self->core;
    const wrcontact_handle handle = {
        span_of(self->tables, self->table_size), span_of(core->memory, MODEL_MEMORY), span_of(self->workspace, MODEL_WORK),
        span_of(core->values, MODEL_INPUTS), span_of(core->values + MODEL_FIRST_OUTPUT, ROW)};
    return handle;
}

/* One step of the kernel, and its outcome. */
static void evaluate(wheelset *self)
{
    wheelset_core *core = &self->core;
    const wrcontact_handle handle = handle_of(self);
    const int status = wrcontact_step(&handle);
    core->status = status;
    core->stale = 0;
    if (status)
        tell_status(self);
}

int wheelset_refresh(wheelset *self)
{
    if (!self->core.stale || !(self->core.built || self->core.phase == PHASE_INITIALISING))
        return 0;
    if (!self->core.locked && initialise(self))
        return 1;
    evaluate(self);
    return 0;
}

int wheelset_step(wheelset *self, double time, double size)
{
    char first[40], second[40], third[40];
    if (self->core.phase != PHASE_RUNNING)
        return wheelset_refuse(self, "the wheelset cannot step: it %s", self->core.phase == PHASE_TERMINATED
                               ? "has been terminated" : "has not been initialised");
    if (!isfinite(time) || !isfinite(time + size) || size < 0.0)
        return wheelset_refuse(self, "a step of %s s at %s s is not possible; permitted are finite times and sizes of 0 s or more",
                               shortest(size, first, sizeof first), shortest(time, second, sizeof second));
    if (time + size > self->core.stop + 1e-6 * size + ROUNDING * fabs(self->core.stop))
        return wheelset_refuse(self, "a step of %s s at %s s ends after the stopTime %s s; permitted are steps up to it",
                               shortest(size, first, sizeof first), shortest(time, second, sizeof second),
                               shortest(self->core.stop, third, sizeof third));
    wheelset_refresh(self);
    if (self->core.status != 0.0 && !self->core.told)
        tell_status(self);
    self->core.told = 0;
    self->core.time = time + size;
    return 0;
}

/* --- directional derivatives ------------------------------------------------------------------------- */

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

int wheelset_differentiate(wheelset *self, const double seed[MODEL_INPUTS], double rates[ROW])
{
    if (self->core.phase == PHASE_INSTANTIATED || self->core.phase == PHASE_CONFIGURING)
        return wheelset_refuse(self, "there are no derivatives before the initialisation");
    if (!self->core.locked && wheelset_refresh(self))
        return 1;
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        if (!isfinite(seed[i]))
            return wheelset_refuse(self, "the seed of %s is not finite; permitted are finite numbers", model_variables[i].name);
    const wrcontact_handle handle = handle_of(self);
    memset(rates, 0, ROW * sizeof(double));
    wrcontact_tangent(&handle, seed, rates, self->tangent_room);
    return 0;
}

/* --- saved states ------------------------------------------------------------------------------------ */

/* Fowler, Noll and Vo's hash, 64 bits. */
static uint64_t checksum(const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < size; i += 1)
        hash = (hash ^ byte[i]) * UINT64_C(1099511628211);
    return hash;
}

static void save(const wheelset *self, wheelset_saved *saved)
{
    memset(saved, 0, sizeof *saved);
    memcpy(saved->format, FORMAT, sizeof FORMAT);
    memcpy(saved->token, TOKEN, sizeof TOKEN);
    saved->size = sizeof *saved;
    saved->core = self->core;
    memcpy(saved->core.known, self->workspace, sizeof saved->core.known);
    saved->checksum = checksum(&saved->core, sizeof saved->core);
}

/* Whether these bytes are a saved state of this FMU. */
static int check_saved(wheelset *self, const wheelset_saved *saved, size_t size)
{
    if (size < sizeof saved->format || memcmp(saved->format, FORMAT, sizeof FORMAT) != 0)
        return wheelset_refuse(self, "the saved state is not one of this version; the present state is kept");
    if (size != sizeof *saved)
        return wheelset_refuse(self, "the saved state holds %lu bytes, expected are %lu; the present state is kept",
                               (unsigned long)size, (unsigned long)sizeof *saved);
    if (saved->size != sizeof *saved || saved->checksum != checksum(&saved->core, sizeof saved->core))
        return wheelset_refuse(self, "the saved state is damaged (its checksum differs); the present state is kept");
    if (memcmp(saved->token, TOKEN, sizeof TOKEN) != 0)
        return wheelset_refuse(self, "the saved state comes from another FMU; the present state is kept");
    return 0;
}

static int restore(wheelset *self, const wheelset_saved *saved)
{
    wheelset_core before = self->core;
    self->core = saved->core;
    if (self->core.built && build(self))
    {
        if (self->core.locked)
        {
            self->core = before;
            return 1;
        }
        self->core.built = 0;       /* parameters that were set and not yet tried */
    }
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    memcpy(self->workspace, saved->core.known, sizeof saved->core.known);
    memcpy(self->workspace + MODEL_KNOWN, saved->core.values + MODEL_FIRST_OUTPUT, ROW * sizeof(double));
    return 0;
}

/* The link to a state in the list, or to the list's end. */
static wheelset_state **find_state(wheelset *self, const void *state)
{
    wheelset_state **link = &self->states;
    while (*link && *link != state)
        link = &(*link)->next;
    return link;
}

static int check_state(wheelset *self, const void *state)
{
    if (!state)
        return wheelset_refuse(self, "the saved state is a NULL pointer; permitted are states of this instance");
    if (!*find_state(self, state))
        return wheelset_refuse(self, "the saved state is not one of this instance; it has been freed, or is another's");
    return 0;
}

/* A place in the list. */
static int new_state(wheelset *self, void **state)
{
    wheelset_state *made = calloc(1, sizeof *made);
    if (!made)
        return wheelset_refuse(self, "there is no memory for a saved state");
    made->next = self->states;
    self->states = *state = made;
    return 0;
}

int wheelset_save_state(wheelset *self, void **state)
{
    if (!state)
        return wheelset_refuse(self, "the place for the saved state is a NULL pointer");
    if (*state ? check_state(self, *state) : new_state(self, state))
        return 1;
    save(self, &((wheelset_state *)*state)->saved);
    return 0;
}

int wheelset_restore_state(wheelset *self, const void *state)
{
    return check_state(self, state) || restore(self, &((const wheelset_state *)state)->saved);
}

int wheelset_free_state(wheelset *self, void **state)
{
    if (!state || !*state)
        return 0;
    if (check_state(self, *state))
        return 1;
    wheelset_state **link = find_state(self, *state), *found = *link;
    *link = found->next;
    free(found);
    *state = NULL;
    return 0;
}

int wheelset_state_size(wheelset *self, const void *state, size_t *size)
{
    if (check_state(self, state))
        return 1;
    if (!size)
        return wheelset_refuse(self, "the place for the saved state's size is a NULL pointer");
    *size = sizeof(wheelset_saved);
    return 0;
}

int wheelset_write_state(wheelset *self, const void *state, void *bytes, size_t size)
{
    if (check_state(self, state))
        return 1;
    if (!bytes)
        return wheelset_refuse(self, "the place for the saved state's bytes is a NULL pointer");
    if (size < sizeof(wheelset_saved))
        return wheelset_refuse(self, "the saved state has %lu bytes, its place %lu; permitted are places that hold it",
                               (unsigned long)sizeof(wheelset_saved), (unsigned long)size);
    memcpy(bytes, &((const wheelset_state *)state)->saved, sizeof(wheelset_saved));
    return 0;
}

int wheelset_read_state(wheelset *self, const void *bytes, size_t size, void **state)
{
    void *made = NULL;
    if (!state || !bytes)
        return wheelset_refuse(self, "the saved state's %s a NULL pointer", bytes ? "place is" : "bytes are");
    if (new_state(self, &made))
        return 1;
    wheelset_saved *saved = &((wheelset_state *)made)->saved;
    memcpy(saved, bytes, size < sizeof *saved ? size : sizeof *saved);
    if (check_saved(self, saved, size))
        return wheelset_free_state(self, &made), 1;
    if (*state && *find_state(self, *state))
    {
        ((wheelset_state *)*state)->saved = *saved;
        return wheelset_free_state(self, &made);
    }
    *state = made;
    return 0;
}
