/* Calls an FMI 2 or FMI 3 native FMU: in random order with legal and illegal arguments, from several threads, and counting
 * the allocations of the usual steps.
 *
 * With the FMU's sources in this program:
 *
 *     cc -DFMI=2 host.c fmi2*.c wheelset*.c sentences.c model.c kernel/native/wrcontact_*.c -lm
 *
 * or with its library, where every allocation of the process is counted (glibc):
 *
 *     cc -DFMI=2 -DINTERPOSE host.c model.c WheelsetContact.so -lm
 *
 *     host fuzz <seed> <calls>             one line of JSON, and an exit code other than 0 where something is wrong; a call
 *                                          that ends the program is told by its seed and number
 *     host threads <count> <file>          steps over the rows of inputs in the file, in threads and one after the other
 *     host allocations <variant> <file>    how many there are between the initialisation and the end; odd variants
 *                                          have two different sides, and rails that lean and move
 *     host walk <seed> <steps> <variant>       a random walk over tread, flange root and flange, both wheels loaded;
 *                                              odd variants roll, with friction, on rails that move
 *     host resumed <seed> <steps> <variant>    the same walk, going on from saved states at random times
 *     host walks <seed> <steps> <threads>      walks from seeds that follow each other, each in its thread
 */
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "model.h"

/* --- an allocation hook: the FMU's calloc, malloc and realloc are these -------------------------------- */

static long allocations;
static long failing = -1;       /* this allocation fails; none if it is negative */

static int fails(void)
{
    const long number = __atomic_add_fetch(&allocations, 1, __ATOMIC_RELAXED);
    return failing >= 0 && number == failing;
}

#ifdef INTERPOSE
void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *malloc(size_t size) { return fails() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return fails() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return fails() ? NULL : __libc_realloc(old, size); }
#else
void *hooked_malloc(size_t size) { return fails() ? NULL : malloc(size); }
void *hooked_calloc(size_t count, size_t size) { return fails() ? NULL : calloc(count, size); }
void *hooked_realloc(void *old, size_t size) { return fails() ? NULL : realloc(old, size); }
#endif

/* --- calls, counted by function -------------------------------------------------------------------------- */

enum { FUNCTIONS = 120 };
static struct {
    const char *name;
    long calls;
} functions[FUNCTIONS];

static long *counter(const char *name)
{
    int i = 0;
    while (functions[i].name && strcmp(functions[i].name, name) != 0)
        i += 1;
    functions[i].name = name;
    return &functions[i].calls;
}

/* The function of this name in the standard's version; not from several threads. */
#define CALL(name)                          \
    (*({                                    \
        static long *calls;                 \
        if (!calls)                         \
            calls = counter(#name);         \
        *calls += 1;                        \
        &FUNCTION(name);                    \
    }))

/* --- numbers ---------------------------------------------------------------------------------------------- */

static unsigned long long seed;

static unsigned pick(unsigned count)
{
    seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
    return (unsigned)((seed >> 33) % count);
}

static double some_number(void)
{
    static const double ODD[] = {0.0, -0.0, 1.0, -1.0, 1e300, -1e300, 1e-300, 0.015, 0.12, 1e-9, 5e-324, 0.46, 210e9};
    switch (pick(8))
    {
    case 0: return NAN;
    case 1: return pick(2) ? INFINITY : -INFINITY;
    case 2: return ODD[pick(sizeof ODD / sizeof *ODD)];
    case 3: return (pick(2001) - 1000.0) * 1e-1;
    default: return (pick(2001) - 1000.0) * 1e-5;
    }
}

static const char *some_text(void)
{
    static const char *const ODD[] = {"", "S1002", "UIC60", "54E1", "hertz", "elastic", "compliant", "rigid", "vertical", "analyn_strip",
                                      "rough", "smooth", "%s%n%d", "'\"", "\xe8\xbd\xae\xe8\xbd\xa8", "S1003"};
    static char text[4000];
    if (pick(10) == 0)
    {
        memset(text, 'x', sizeof text - 1);
        return text;
    }
    return pick(12) ? ODD[pick(sizeof ODD / sizeof *ODD)] : NULL;
}

static long lines, long_lines;

static void count_line(const char *message)
{
    __atomic_add_fetch(&lines, 1, __ATOMIC_RELAXED);
    if (!message || strlen(message) < 10 || strlen(message) > 2 * MODEL_SENTENCE)
        __atomic_add_fetch(&long_lines, 1, __ATOMIC_RELAXED);
}

enum { OK, LIST = 40, STATES = 4, INSTANCES = 3 };
static double numbers[(201 + 1) * LIST];      /* room for arrays of as many stations as there can be */

/* A pointer, or now and then NULL. */
#define MAYBE(pointer) (pick(30) ? (pointer) : NULL)

/* --- both versions of the standard behind the same names --------------------------------------------------- */

#if FMI == 2
#include "fmi2Functions.h"
#define FUNCTION(name) fmi2##name
typedef fmi2Component component;
typedef fmi2FMUstate saved_state;
typedef fmi2ValueReference value_reference;
typedef fmi2Byte byte;
enum { REFERENCES = MODEL_VARIABLES, FIRST_REFERENCE = 0, FIRST_INPUT = 0 };
static void note(fmi2ComponentEnvironment e, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...)
{
    char text[4 * MODEL_SENTENCE];
    va_list rest;
    (void)e, (void)name, (void)status, (void)category;
    va_start(rest, message);
    vsnprintf(text, sizeof text, message, rest);
    va_end(rest);
    count_line(text);
}
static component create(const char *name, const char *token, bool exchange)
{
    static const fmi2CallbackFunctions callbacks = {note, NULL, NULL, NULL, NULL}, silent = {NULL, NULL, NULL, NULL, NULL};
    const char *const resources[] = {NULL, "", "file:///nowhere", "%s%n"};
    return CALL(Instantiate)(name, pick(60) ? exchange ? fmi2ModelExchange : fmi2CoSimulation : 7, token, resources[pick(4)],
                             pick(50) ? &callbacks : pick(2) ? &silent : NULL, fmi2False, fmi2True);
}
static int get_state(component c, saved_state *s) { return CALL(GetFMUstate)(c, s); }
static int set_state(component c, saved_state s) { return CALL(SetFMUstate)(c, s); }
static int free_state(component c, saved_state *s) { return CALL(FreeFMUstate)(c, s); }
static int state_size(component c, saved_state s, size_t *n) { return CALL(SerializedFMUstateSize)(c, s, n); }
static int write_state(component c, saved_state s, byte *b, size_t n) { return CALL(SerializeFMUstate)(c, s, b, n); }
static int read_state(component c, const byte *b, size_t n, saved_state *s) { return CALL(DeSerializeFMUstate)(c, b, n, s); }
static int get_reals(component c, const value_reference *r, size_t n, double *v, size_t m)
{
    (void)m;
    return CALL(GetReal)(c, r, n, v);
}
static int set_reals(component c, const value_reference *r, size_t n, const double *v, size_t m)
{
    (void)m;
    return CALL(SetReal)(c, r, n, v);
}
static int enter(component c)
{
    return CALL(SetupExperiment)(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), CALL(EnterInitializationMode)(c);
}
static int step(component c, double time, double size) { return CALL(DoStep)(c, time, size, fmi2True); }
static int complete(component c)
{
    int event = -1, end = -1;
    CALL(EnterContinuousTimeMode)(c);
    return (int)CALL(CompletedIntegratorStep)(c, fmi2True, &event, &end) | event | end;
}
static int texts(component c, const value_reference *r, size_t n, const char **v, int set)
{
    return set ? CALL(SetString)(c, r, n, v) : CALL(GetString)(c, r, n, v);
}
static int integers(component c, const value_reference *r, size_t n, int *v, int set)
{
    return set ? CALL(SetInteger)(c, r, n, v) : CALL(GetInteger)(c, r, n, v);
}
static int differentiate(component c, const value_reference *r, size_t n, const value_reference *known, double *rates, size_t m)
{
    const double one = 1.0;
    (void)m;
    return CALL(GetDirectionalDerivative)(c, r, n, known, 1, &one, rates);
}
static int odd_call(component c, const value_reference *r, size_t n)
{
    int integer[64 * LIST] = {0};
    double *v = MAYBE(numbers);
    const char *text;
    fmi2Status status;
    fmi2EventInfo events;
    switch (pick(24))
    {
    case 0: return CALL(GetBoolean)(c, r, n, integer);
    case 1: return CALL(SetBoolean)(c, r, n, integer);
    case 2:
    case 3: return CALL(GetDirectionalDerivative)(c, r, n / 2, MAYBE(r + n / 2), n - n / 2, v, MAYBE(numbers + LIST));
    case 4: return CALL(SetRealInputDerivatives)(c, r, n, integer, v);
    case 5: return CALL(GetRealOutputDerivatives)(c, r, n, integer, v);
    case 6: return CALL(CancelStep)(c);
    case 7: return CALL(GetStatus)(c, (fmi2StatusKind)pick(5), MAYBE(&status));
    case 8: return CALL(GetRealStatus)(c, (fmi2StatusKind)pick(5), v);
    case 9: return CALL(GetBooleanStatus)(c, (fmi2StatusKind)pick(5), MAYBE(integer));
    case 10: return CALL(GetIntegerStatus)(c, (fmi2StatusKind)pick(5), MAYBE(integer));
    case 11: return CALL(GetStringStatus)(c, (fmi2StatusKind)pick(5), MAYBE(&text));
    case 12: return CALL(EnterEventMode)(c);
    case 13: return CALL(NewDiscreteStates)(c, MAYBE(&events));
    case 14: return CALL(EnterContinuousTimeMode)(c);
    case 15: return CALL(CompletedIntegratorStep)(c, fmi2True, MAYBE(integer), integer);
    case 16: return CALL(SetTime)(c, some_number());
    case 17: return CALL(SetContinuousStates)(c, v, n);
    case 18: return CALL(GetDerivatives)(c, v, n);
    case 19: return CALL(GetEventIndicators)(c, v, n);
    case 20: return CALL(GetContinuousStates)(c, v, n);
    case 21: return CALL(GetNominalsOfContinuousStates)(c, v, n);
    case 22: return strcmp(CALL(GetVersion)(), "2.0") || strcmp(CALL(GetTypesPlatform)(), "default");
    default: return CALL(SetupExperiment)(c, fmi2True, some_number(), some_number(), fmi2True, some_number());
    }
}
static size_t stations_of(component c) { return (void)c, MODEL_STATIONS; }
static int configure(component c, unsigned long long stations) { return (void)c, (void)stations, OK; }
static size_t values_of(component c, value_reference reference) { return (void)c, (void)reference, 1; }
#else
#include "fmi3Functions.h"
#define FUNCTION(name) fmi3##name
typedef fmi3Instance component;
typedef fmi3FMUState saved_state;
typedef fmi3ValueReference value_reference;
typedef fmi3Byte byte;
enum { REFERENCES = MODEL_BLOCKS + 1, FIRST_REFERENCE = 1, FIRST_INPUT = 3 };
static void note(fmi3InstanceEnvironment e, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)e, (void)status, (void)category;
    count_line(message);
}
static component create(const char *name, const char *token, bool exchange)
{
    const char *const resources[] = {NULL, "", "/nowhere/", "%s%n"};
    if (exchange)
        return CALL(InstantiateModelExchange)(name, token, resources[pick(4)], false, true, NULL, pick(50) ? note : NULL);
    return CALL(InstantiateCoSimulation)(name, token, resources[pick(4)], false, true, pick(60) == 0, false, NULL,
                                         pick(60) == 0, NULL, pick(50) ? note : NULL, NULL);
}
static int get_state(component c, saved_state *s) { return CALL(GetFMUState)(c, s); }
static int set_state(component c, saved_state s) { return CALL(SetFMUState)(c, s); }
static int free_state(component c, saved_state *s) { return CALL(FreeFMUState)(c, s); }
static int state_size(component c, saved_state s, size_t *n) { return CALL(SerializedFMUStateSize)(c, s, n); }
static int write_state(component c, saved_state s, byte *b, size_t n) { return CALL(SerializeFMUState)(c, s, b, n); }
static int read_state(component c, const byte *b, size_t n, saved_state *s) { return CALL(DeserializeFMUState)(c, b, n, s); }
static int get_reals(component c, const value_reference *r, size_t n, double *v, size_t m)
{
    return CALL(GetFloat64)(c, r, n, v, m);
}
static int set_reals(component c, const value_reference *r, size_t n, const double *v, size_t m)
{
    return CALL(SetFloat64)(c, r, n, v, m);
}
static int enter(component c) { return CALL(EnterInitializationMode)(c, false, 0.0, 0.0, false, 0.0); }
static int step(component c, double time, double size)
{
    bool a, b, d;
    double last;
    return CALL(DoStep)(c, time, size, true, &a, &b, pick(60) ? &d : NULL, &last);
}
static int complete(component c)
{
    bool event = true, end = true;
    CALL(EnterContinuousTimeMode)(c);
    return (int)CALL(CompletedIntegratorStep)(c, true, &event, &end) | event | end;
}
static int texts(component c, const value_reference *r, size_t n, const char **v, int set)
{
    return set ? CALL(SetString)(c, r, n, v, n) : CALL(GetString)(c, r, n, v, n);
}
static int integers(component c, const value_reference *r, size_t n, int *v, int set)
{
    return set ? CALL(SetInt32)(c, r, n, v, n) : CALL(GetInt32)(c, r, n, v, n);
}
static size_t stations_of(component c)
{
    const value_reference reference = 2;
    fmi3UInt64 stations = 0;
    return CALL(GetUInt64)(c, &reference, 1, &stations, 1) == fmi3OK ? (size_t)stations : 0;
}
static int set_stations(component c, unsigned long long stations)
{
    const value_reference reference = 2;
    const fmi3UInt64 value = stations;
    return CALL(SetUInt64)(c, &reference, 1, &value, 1);
}
static int configure(component c, unsigned long long stations)
{
    if (CALL(EnterConfigurationMode)(c) != fmi3OK)
        return OK + 1;
    set_stations(c, stations);
    return CALL(ExitConfigurationMode)(c);
}
static unsigned long long some_stations(void)
{
    static const unsigned long long ODD[] = {0, 1, 2, 3, 4, 30, 31, 32, 201, 202, 4294967327ULL, 18446744073709551615ULL};
    return pick(2) ? ODD[pick(sizeof ODD / sizeof *ODD)] : pick(250);
}

/* Types that no variable has: a case of odd_call each for reading and writing. */
#define OTHER_TYPE(number, name)                                                        \
    case 2 * number: return CALL(Get##name)(c, r, n, (void *)numbers, n);               \
    case 2 * number + 1: return CALL(Set##name)(c, r, n, (void *)numbers, n);


static int differentiate(component c, const value_reference *r, size_t n, const value_reference *known, double *rates, size_t m)
{
    const double one = 1.0;
    if (pick(3) == 0)
        return CALL(GetAdjointDerivative)(c, r, n, known, 1, rates, m, numbers, 1);
    return CALL(GetDirectionalDerivative)(c, r, n, known, 1, &one, 1, rates, m);
}

static int odd_call(component c, const value_reference *r, size_t n)
{
    bool flags[64 * LIST] = {false};
    size_t count[64 * LIST] = {0};
    int orders[64 * LIST] = {0};
    value_reference v[LIST];
    fmi3DependencyKind kind;
    fmi3IntervalQualifier qualifier[LIST];
    fmi3Binary binary[LIST] = {NULL};
    uint64_t ticks[LIST] = {0};
    double *d = MAYBE(numbers);
    switch (pick(66))
    {
    OTHER_TYPE(0, Float32)
    OTHER_TYPE(1, Int8)
    OTHER_TYPE(2, UInt8)
    OTHER_TYPE(3, Int16)
    OTHER_TYPE(4, UInt16)
    OTHER_TYPE(5, UInt32)
    OTHER_TYPE(6, Int64)
    OTHER_TYPE(7, UInt64)
    case 16: return CALL(GetBoolean)(c, r, n, flags, n);
    case 17: return CALL(SetBoolean)(c, r, n, flags, n);
    case 18: return CALL(GetBinary)(c, r, n, count, binary, n);
    case 19: return CALL(SetBinary)(c, r, n, count, binary, n);
    case 20: return CALL(GetClock)(c, r, n, flags);
    case 21: return CALL(SetClock)(c, r, n, flags);
    case 22: return CALL(GetNumberOfVariableDependencies)(c, r ? *r : 0, MAYBE(count));
    case 23: return CALL(GetVariableDependencies)(c, r ? *r : 0, count, v, count, &kind, 0);
    case 24:
    case 25:
        return CALL(GetDirectionalDerivative)(c, r, n / 2, MAYBE(r + n / 2), n - n / 2, d, n - n / 2, MAYBE(numbers + LIST),
                                              n / 2);
    case 26:
        return CALL(GetAdjointDerivative)(c, r, n / 2, r + n / 2, n - n / 2, d, n / 2, MAYBE(numbers + LIST), n - n / 2);
    case 27: return CALL(EnterConfigurationMode)(c);
    case 28: return CALL(ExitConfigurationMode)(c);
    case 29: return CALL(GetIntervalDecimal)(c, r, n, d, qualifier);
    case 30: return CALL(GetIntervalFraction)(c, r, n, ticks, ticks, qualifier);
    case 31: return CALL(GetShiftDecimal)(c, r, n, d);
    case 32: return CALL(GetShiftFraction)(c, r, n, ticks, ticks);
    case 33: return CALL(SetIntervalDecimal)(c, r, n, d);
    case 34: return CALL(SetIntervalFraction)(c, r, n, ticks, ticks);
    case 35: return CALL(SetShiftDecimal)(c, r, n, d);
    case 36: return CALL(SetShiftFraction)(c, r, n, ticks, ticks);
    case 37: return CALL(EvaluateDiscreteStates)(c);
    case 38: return CALL(UpdateDiscreteStates)(c, flags, flags, flags, flags, flags, d);
    case 39: return CALL(EnterContinuousTimeMode)(c);
    case 40: return CALL(CompletedIntegratorStep)(c, true, MAYBE(flags), flags);
    case 41: return CALL(SetTime)(c, some_number());
    case 42: return CALL(SetContinuousStates)(c, d, n);
    case 43: return CALL(GetContinuousStateDerivatives)(c, d, n);
    case 44: return CALL(GetEventIndicators)(c, d, n);
    case 45: return CALL(GetContinuousStates)(c, d, n);
    case 46: return CALL(GetNominalsOfContinuousStates)(c, d, n);
    case 47: return CALL(GetNumberOfEventIndicators)(c, MAYBE(count));
    case 48: return CALL(GetNumberOfContinuousStates)(c, MAYBE(count));
    case 49: return CALL(EnterStepMode)(c);
    case 50: return CALL(EnterEventMode)(c);
    case 51: return CALL(GetOutputDerivatives)(c, r, n, orders, d, n);
    case 52: return CALL(ActivateModelPartition)(c, r ? *r : 0, some_number());
    case 53: return strcmp(CALL(GetVersion)(), "3.0") != 0;
    case 54:
    case 55:
        return CALL(InstantiateScheduledExecution)("name", MODEL_TOKEN, NULL, false, true, NULL, note, NULL, NULL, NULL)
            == NULL;
    case 56:
    case 57: return set_stations(c, some_stations());
    default: return CALL(EnterInitializationMode)(c, true, some_number(), some_number(), pick(2), some_number());
    }
}
static size_t values_of(component c, value_reference reference)
{
    return reference < 1 || reference > MODEL_BLOCKS || model_blocks[reference].run < 0 ? 1 : stations_of(c);
}
#endif

/* --- the fuzzer --------------------------------------------------------------------------------------------- */

static component instances[INSTANCES];
static saved_state states[STATES];      /* also of other instances, and of those that are gone */
static byte stored[STATES][200000];
static size_t stored_size[STATES];
static const model_variable *variable_named(const char *name);

/* The value reference of the variable at a place in model_variables; the first of its run. */
static value_reference reference_of(int place)
{
    value_reference r = FIRST_REFERENCE;
    while (r < REFERENCES && model_blocks[r].first != place)
        r += 1;
    return r;
}

static int accepted_damage;

static long usual_steps, valid_steps, other_outlines;
static long started[8][8];      /* instances that were initialised, by contact mode and normal model */

/* What a simulation does: all inputs possible, velocities too, a step or a completed one of a solver, the status read. */
static int usual_step(component c)
{
    const value_reference status = reference_of((int)(variable_named("status") - model_variables));
    const double yaw = pick(3) ? 0.0 : 1e-5 * (pick(2401) - 1200.0);
    double inputs[MODEL_INPUTS] = {1e-5 * (pick(3001) - 1500.0), yaw, pick(5) ? 0.0 : 1e-5 * pick(1000), 10.0 * pick(20000),
                                         pick(3) ? 0.0 : 1e-2 * (pick(201) - 100.0), 1e-6 * pick(3000), 1e-5 * (pick(201) - 100.0)};
    value_reference references[MODEL_INPUTS];
    int outcome = -1;
    size_t count = 0;
    for (int i = 0; i < MODEL_INPUTS; i += 1)
    {
        const double given = inputs[i];
        if (model_variables[i].type != MODEL_REAL)
            continue;
        inputs[count] = i < 7 || pick(3) == 0 ? given : 1e-3 * model_variables[i].high * (pick(201) - 100.0);
        references[count] = reference_of(i);
        count += 1;
    }
    usual_steps += 1;
    if (set_reals(c, references, count, inputs, count) != OK || (step(c, 0.0, 1e-3) != OK && complete(c) != OK)
        || integers(c, &status, 1, &outcome, 0) != OK)
        return OK + 1;
    valid_steps += outcome == 0 || outcome == 1;
    other_outlines += stations_of(c) != MODEL_STATIONS;
    return OK;
}

static const model_variable *variable_named(const char *name)
{
    const model_variable *variable = model_variables;
    while (strcmp(variable->name, name) != 0)
        variable += 1;
    return variable;
}

/* The place of the method that an instance has among those that can be chosen. */
static int chosen(component c, const char *name)
{
    const model_variable *variable = variable_named(name);
    const value_reference reference = reference_of((int)(variable - model_variables));
    const char *word = "";
    int k = 0;
    texts(c, &reference, 1, &word, 0);
    while (k < variable->choice_count && strcmp(variable->choices[k].name, word) != 0)
        k += 1;
    return k;
}

/* An instance with methods and profiles of its own choice, ready to step. */
static int usual_start(component c)
{
    CALL(Reset)(c);
    if (pick(2))
        configure(c, pick(250));
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
    {
        const model_variable *variable = model_variables + i;
        value_reference reference = reference_of(i);
        if (variable->choice_count > 0 && pick(2))
        {
            const char *word = variable->choices[pick((unsigned)variable->choice_count)].name;
            texts(c, &reference, 1, &word, 1);
        }
        if (variable->causality == MODEL_PARAMETER && variable->type == MODEL_REAL && pick(6) == 0)
        {
            const double number = variable->start * (1.0 + 1e-3 * (pick(201) - 100.0));
            set_reals(c, &reference, 1, &number, 1);
        }
    }
    if (enter(c) != OK || (int)CALL(ExitInitializationMode)(c) != OK)
        return OK + 1;
    started[chosen(c, "contact_mode")][chosen(c, "normal_model")] += 1;
    return OK;
}

/* Serialise a state, sometimes into too little room. */
static int store(component c, unsigned k)
{
    size_t size = 0;
    if (state_size(c, states[k], pick(30) ? &size : NULL) != OK)
        return OK + 1;
    const bool short_of_room = pick(10) == 0;
    if (write_state(c, states[k], MAYBE(stored[k]), size - short_of_room) != OK)
        return OK + 1;
    accepted_damage |= short_of_room;
    stored_size[k] = size;
    return OK;
}

/* A state from its bytes, sometimes damaged. */
static int take_back(component c, unsigned k)
{
    const size_t size = stored_size[k];
    const unsigned damage = size ? pick(8) : 8, place = size ? pick((unsigned)size) : 0;
    if (damage == 0)
        stored[k][place] ^= (byte)(1u << pick(8));
    if (read_state(c, MAYBE(stored[k]), damage == 1 ? place : damage == 2 ? size + 1 : size, MAYBE(states + k)) == OK)
        return accepted_damage |= damage < 3, OK;
    if (damage == 0)
        stored_size[k] = 0;
    return OK + 1;
}

/* Derivatives of some outputs along an input, now and then along what is none. */
static int some_derivative(component c)
{
    const value_reference first = reference_of(MODEL_FIRST_OUTPUT);
    const value_reference known = FIRST_INPUT + pick(MODEL_INPUTS + (pick(9) == 0));
    value_reference references[LIST];
    const size_t count = pick(LIST);
    size_t values = 0;
    for (size_t i = 0; i < count; i += 1)
    {
        references[i] = first + pick(pick(9) ? 8 : REFERENCES - first);
        values += values_of(c, references[i]);
    }
    for (size_t i = 0; i < values; i += 1)
        numbers[i] = 1.0;
    return differentiate(c, references, count, &known, numbers, values);
}

static int some_call(void)
{
    component *slot = instances + pick(INSTANCES), c = *slot;
    const unsigned k = pick(STATES);
    value_reference references[LIST];
    const char *words[LIST];
    int integer[LIST] = {0};
    size_t count = pick(4) ? pick(4) : pick(LIST), values = 0;
    if (!c)
    {
        CALL(FreeInstance)(NULL);
        *slot = create(pick(20) ? "instance" : pick(2) ? "" : NULL, pick(20) ? MODEL_TOKEN : pick(2) ? "{0}" : NULL,
                       pick(3) == 0);
        return *slot ? OK : OK + 1;
    }
    const unsigned kind = pick(5);      /* mostly inputs, and sometimes anything */
    for (size_t i = 0; i < count; i += 1)
    {
        references[i] = kind < 3 ? FIRST_INPUT + pick(MODEL_INPUTS + 4) : pick(REFERENCES + 3);
        words[i] = some_text();
        numbers[i] = some_number();
        values += values_of(c, references[i]);
    }
    for (size_t i = count; i < values; i += 1)
        numbers[i] = some_number();
    if (pick(40) == 0)
        values += 1;
    if (pick(8) == 0)
        return usual_step(c);
    if (pick(200) == 0)
        return usual_start(c);
    if (pick(80) == 0)
        c = NULL;
    const value_reference *maybe = MAYBE(references);
    switch (pick(26))
    {
    case 0: return pick(40) ? (CALL(FreeInstance)(NULL), OK) : (CALL(FreeInstance)(*slot), *slot = NULL, OK);
    case 1: return enter(c);
    case 2: return (int)CALL(ExitInitializationMode)(c);
    case 3: return pick(20) ? OK : (int)CALL(Reset)(c);
    case 4: return pick(60) ? OK : (int)CALL(Terminate)(c);
    case 5: return texts(c, maybe, count, MAYBE(words), 1);
    case 6: return texts(c, maybe, count, MAYBE(words), 0);
    case 7: return pick(2) ? some_derivative(c) : integers(c, maybe, count, MAYBE(integer), pick(4) == 0);
    case 8:
    case 9:
    case 10: return odd_call(c, maybe, maybe ? count : 0);
    case 11: return (int)CALL(SetDebugLogging)(c, pick(8) > 0, count, MAYBE(words));
    case 12: return get_state(c, MAYBE(states + k));
    case 13: return set_state(c, MAYBE(states[k]));
    case 14:
        if (pick(8) == 0)
            states[k] = NULL;       /* the instance frees what it has made */
        return pick(3) ? OK : free_state(c, states + k);
    case 15: return store(c, k);
    case 16: return take_back(c, k);
    case 17:
    case 18: return get_reals(c, maybe, count, MAYBE(numbers), values);
    case 19:
    case 20:
    case 21: return set_reals(c, maybe, count, MAYBE(numbers), values);
    default: return step(c, pick(20) ? 0.0 : some_number(), pick(20) ? 1e-3 : some_number());
    }
}

/* After everything an instance can be reset, initialised and stepped, and then gives the values of a fresh one. */
static int check_recovery(component c)
{
    const value_reference roll = reference_of(MODEL_FIRST_OUTPUT);
    component fresh = NULL;
    double values[2] = {1.0, 2.0};
    while (!fresh)
        fresh = create("fresh", MODEL_TOKEN, pick(2));
    component both[2] = {c, fresh};
    for (int i = 0; i < 2; i += 1)
    {
        CALL(Reset)(both[i]);
        if (enter(both[i]) != OK || (int)CALL(ExitInitializationMode)(both[i]) != OK || get_reals(both[i], &roll, 1, values + i, 1) != OK)
            return printf("an instance is not usable after a reset\n"), 1;
    }
    CALL(FreeInstance)(fresh);
    return values[0] != values[1] && printf("a reset instance gives %.17g, a fresh one %.17g\n", values[0], values[1]);
}

static int fuzz(long calls, volatile long *call)
{
    long good = 0;
    int wrong = 0;
    for (*call = 0; *call < calls && !wrong && !accepted_damage && !long_lines; *call += 1)
    {
        failing = pick(500) ? -1 : allocations + 1 + pick(3);
        good += some_call() == OK;
        failing = -1;
        component *slot = instances + pick(INSTANCES);
        if (pick(1000) == 0 && *slot)
            wrong = check_recovery(*slot);
    }
    for (int i = 0; i < INSTANCES; i += 1)
        if (instances[i])
        {
            wrong |= check_recovery(instances[i]);
            CALL(FreeInstance)(instances[i]);
        }
    printf("{\"calls\": %ld, \"ok\": %ld, \"lines\": %ld, \"odd_lines\": %ld, \"usual_steps\": %ld, \"valid_steps\": %ld, "
           "\"damage_accepted\": %d, \"other_outlines\": %ld, \"functions\": {", *call, good, lines, long_lines,
           usual_steps, valid_steps, accepted_damage, other_outlines);
    for (int i = 0; functions[i].name; i += 1)
        printf("%s\"fmi%d%s\": %ld", i ? ", " : "", FMI, functions[i].name, functions[i].calls);
    printf("}, \"started\": {");
    const model_variable *mode = variable_named("contact_mode"), *model = variable_named("normal_model");
    for (int i = 0; i < mode->choice_count * model->choice_count; i += 1)
        printf("%s\"%s %s\": %ld", i ? ", " : "", mode->choices[i / model->choice_count].name,
               model->choices[i % model->choice_count].name, started[i / model->choice_count][i % model->choice_count]);
    printf("}}\n");
    return wrong || accepted_damage || long_lines > 0;
}

/* The fuzzer in a process of its own, so that a call that ends it, or does not end, can be told. */
static int supervised_fuzz(unsigned long long first, long calls)
{
    enum { LONGEST = 1500 };    /* [s] */
    volatile long *call = mmap(NULL, sizeof *call, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    int status = 0;
    const pid_t child = fork();
    if (child == 0)
    {
        alarm(LONGEST);
        seed = first;
        exit(fuzz(calls, call));
    }
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status))
        fprintf(stderr, "host fuzz %llu %ld fails: ended by signal %d\n", first, *call + 1, WTERMSIG(status));
    else if (status)
        fprintf(stderr, "host fuzz %llu %ld fails: exit code %d\n", first, *call + 1, WEXITSTATUS(status));
    return status != 0;
}

/* --- the usual rows --------------------------------------------------------------------------------------------- */

enum { MOST_ROWS = 2000 };
static double rows[MOST_ROWS][5];
static int row_count;
static value_reference five[5], outputs[MODEL_VARIABLES];      /* the inputs of a row; the Real outputs */
static size_t output_count, value_count;

/* Where values are. */
static void find_values(void)
{
    for (int i = 0; i < 5; i += 1)
        five[i] = reference_of(i);
    for (int first = MODEL_FIRST_OUTPUT; first < MODEL_VARIABLES; first += 1)
    {
        const value_reference r = reference_of(first);      /* of an array its first place alone has one */
        if (r < REFERENCES && model_variables[first].type == MODEL_REAL)
        {
            outputs[output_count++] = r;
            value_count += FMI == 3 && model_blocks[r].run >= 0 ? MODEL_STATIONS : 1;
        }
    }
}

/* The rows of inputs in a file, and where values are. */
static int read_rows(const char *path)
{
    FILE *file = fopen(path, "r");
    while (file && row_count < MOST_ROWS
           && fscanf(file, "%lf %lf %lf %lf %lf", rows[row_count], rows[row_count] + 1, rows[row_count] + 2, rows[row_count] + 3,
                     rows[row_count] + 4) == 5)
        row_count += 1;
    if (file)
        fclose(file);
    find_values();
    return row_count ? OK : (printf("no rows in %s\n", path), OK + 1);
}

/* An instance that is ready to step; `variant` chooses among the methods, and odd ones have a left side of their own. */
static component ready(int variant)
{
    static const char *const LEFT[] = {"left_nominal_radius", "left_rail_inclination"};
    static const double OTHER[] = {0.4593, 0.05};
    component c = NULL;
    while (!c)
        c = create("instance", MODEL_TOKEN, false);
    for (int i = 0; variant % 2 && i < 2; i += 1)
    {
        const value_reference reference = reference_of((int)(variable_named(LEFT[i]) - model_variables));
        if (set_reals(c, &reference, 1, &OTHER[i], 1) != OK)
            printf("%s is refused\n", LEFT[i]), exit(1);
    }
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
        if (model_variables[i].choice_count > 0)
        {
            const value_reference reference = reference_of(i);
            const char *word = model_variables[i].choices[variant % model_variables[i].choice_count].name;
            texts(c, &reference, 1, &word, 1);
        }
    if (enter(c) != OK || (int)CALL(ExitInitializationMode)(c) != OK)
        printf("not initialised\n"), exit(1);
    return c;
}

/* Set 5, do step, get all; the functions themselves, as several threads come here. */
static int usual_row(component c, const double *row, double *values)
{
#if FMI == 2
    int status = fmi2SetReal(c, five, 5, row) | fmi2DoStep(c, 0.0, 1e-3, fmi2True);
    return status | fmi2GetReal(c, outputs, output_count, values);
#else
    bool a, b, d;
    double last;
    int status = fmi3SetFloat64(c, five, 5, row, 5) | fmi3DoStep(c, 0.0, 1e-3, true, &a, &b, &d, &last);
    return status | fmi3GetFloat64(c, outputs, output_count, values, value_count);
#endif
}

/* Let the rails be moved, lean and move in row `k`, and the wheelset too: all Real inputs but the usual five. */
static int move_all(component c, long k)
{
    int status = OK;
    for (int i = 5; model_variables[i].causality == MODEL_INPUT; i += 1)
    {
        const value_reference reference = reference_of(i);
        const double value = model_variables[i].start + 0.02 * model_variables[i].high * sin(0.3 * k + i);
        if (model_variables[i].type == MODEL_REAL)
#if FMI == 2
            status |= fmi2SetReal(c, &reference, 1, &value);
#else
            status |= fmi3SetFloat64(c, &reference, 1, &value, 1);
#endif
    }
    return status;
}

/* What a host does between the initialisation and the end, refused calls and log lines too. */
static int count_allocations(int variant)
{
    static double values[64 * LIST];
    const double nowhere[5] = {NAN, 0.0, 0.0, 1e5, 0.0};
    const value_reference status = reference_of((int)(variable_named("status") - model_variables));
    const value_reference profile = reference_of((int)(variable_named("wheel_profile") - model_variables));
    const char *word = NULL;
    component c = ready(variant);
    saved_state state = NULL;
    int outcome = 0, wrong = 0;
    const long before = allocations;
    for (int k = 0; k < row_count; k += 1)
    {
        if (variant % 2)
            wrong |= move_all(c, k);
        wrong |= usual_row(c, rows[k], values) | usual_row(c, rows[k], values);
        wrong |= integers(c, &status, 1, &outcome, 0) | texts(c, &profile, 1, &word, 0);
        if (k % 20 == 0)
            wrong |= usual_row(c, nowhere, values) | (set_reals(c, outputs, 1, values, 1) == OK) | (lines == 0);
    }
    const long steps = allocations - before;
    wrong |= get_state(c, &state);
    const long first = allocations - before - steps;
    for (int k = 0; k < row_count; k += 1)
        wrong |= get_state(c, &state) | set_state(c, state);
    const long again = allocations - before - steps - first;
    wrong |= (int)CALL(Terminate)(c);
    printf("{\"rows\": %d, \"steps\": %ld, \"first_state\": %ld, \"states\": %ld, \"wrong\": %d}\n", row_count, steps, first,
           again, wrong);
    CALL(FreeInstance)(c);
    return 0;
}

/* --- threads -------------------------------------------------------------------------------------------------- */

typedef struct {
    component c;
    int wrong, moving;
    double *seen;       /* all outputs of all rows */
} runner;

static void *run_rows(void *argument)
{
    runner *self = argument;
    for (int k = 0; k < row_count; k += 1)
    {
        if (self->moving)
            self->wrong |= move_all(self->c, k) != OK;
        self->wrong |= usual_row(self->c, rows[k], self->seen + (size_t)k * value_count) != OK;
    }
    return NULL;
}

static runner runner_of(int variant)
{
    runner made = {ready(variant), 0, variant % 2, calloc((size_t)row_count * value_count, sizeof(double))};
    return made;
}

static int run_threads(int count)
{
    runner *alone = calloc((size_t)count, sizeof *alone), *together = calloc((size_t)count, sizeof *together);
    pthread_t *threads = calloc((size_t)count, sizeof *threads);
    int wrong = 0, different = 0, equal = 0;
    for (int i = 0; i < count; i += 1)
    {
        alone[i] = runner_of(i);
        together[i] = runner_of(i);
        run_rows(alone + i);
    }
    for (int i = 0; i < count; i += 1)
        wrong |= pthread_create(threads + i, NULL, run_rows, together + i);
    for (int i = 0; i < count; i += 1)
        pthread_join(threads[i], NULL);
    const size_t size = (size_t)row_count * value_count * sizeof(double);
    for (int i = 0; i < count; i += 1)
    {
        wrong |= alone[i].wrong | together[i].wrong;
        equal += memcmp(alone[i].seen, together[i].seen, size) == 0;
        different += memcmp(alone[i].seen, alone[(i + 1) % count].seen, size) != 0;
    }
    for (int i = 0; i < count; i += 1)
    {
        CALL(FreeInstance)(alone[i].c), CALL(FreeInstance)(together[i].c);
        free(alone[i].seen), free(together[i].seen);
    }
    free(alone), free(together), free(threads);
    printf("{\"equal\": %d, \"variants\": %d, \"wrong\": %d}\n", equal, different, wrong);
    return wrong || equal != count;
}

/* --- long walks ------------------------------------------------------------------------------------------------- */

/* Where a wheelset goes: lateral_shift [m], yaw [rad], roll_guess [rad], normal_force [N], load_transfer. */
static const double LOWEST[5] = {-8e-3, -0.035, -0.02, 1e3, -0.95}, HIGHEST[5] = {8e-3, 0.035, 0.02, 200e3, 0.95};
static const double STRIDE[5] = {2e-3, 0.01, 5e-3, 50e3, 0.3};        /* the longest step */
static const double HOME[5] = {5e-3, 2e-3, 0.0, 78.5e3, 0.1};         /* where it comes back to every RETURN steps */
enum { RETURN = 500, LOOK = 1000, PARTING = 500, SEEN = MODEL_VARIABLES + 6 * 201 };

typedef struct {
    unsigned long long random;
    double at[5];
} walker;

/* The next number from -1 to 1; the same arithmetic is in walker.py. */
static double draw(walker *self)
{
    self->random = self->random * 6364136223846793005ULL + 1442695040888963407ULL;
    return (double)(self->random >> 11) * 0x1p-52 - 1.0;
}

/* A step in every direction, mostly a short one, reflected at the bounds. */
static void move(walker *self)
{
    for (int i = 0; i < 5; i += 1)
    {
        const double r = draw(self);
        double next = self->at[i] + STRIDE[i] * (r * r * r);
        if (next < LOWEST[i])
            next = LOWEST[i] + (LOWEST[i] - next);
        if (next > HIGHEST[i])
            next = HIGHEST[i] - (next - HIGHEST[i]);
        self->at[i] = next;
    }
}

/* A walk, and what was seen on it. */
typedef struct {
    component c;
    walker walker, elsewhere;
    long steps;
    bool resumes, moves;                            /* whether all other inputs change, too */
    long bad, flange, jumps, twins, partings;       /* steps that are not valid, with flange contact, ... */
    double first_bad[5];
    unsigned long long digest;                      /* of all outputs of all steps */
    long before, least, most;                       /* resident memory after a tenth of the walk, and from then on */
    double low[2][SEEN], high[2][SEEN];             /* of the outputs at home, in each half of the walk */
    long homes, same_bits;
    double home[SEEN], values[SEEN];
} walk;

/* Resident memory [kB], counted page by page: /proc/self/statm may be late by 16 pages a processor. */
static long resident(void)
{
    char text[500] = "";
    const int file = open("/proc/self/smaps_rollup", O_RDONLY);
    if (file < 0 || read(file, text, sizeof text - 1) <= 0 || !strstr(text, "Rss:"))
        printf("resident memory is not told\n"), exit(1);
    close(file);
    return atol(strstr(text, "Rss:") + 4);
}

/* The place of an output's value among those of usual_row. */
static size_t value_named(const char *name)
{
    const int wanted = (int)(variable_named(name) - model_variables);
    size_t place = 0;
    for (size_t i = 0; i < output_count; i += 1)
    {
        const int first = model_blocks[outputs[i]].first;
        if (first == wanted)
            return place;
        place += FMI == 3 && model_blocks[outputs[i]].run >= 0 ? MODEL_STATIONS : 1;
    }
    printf("there is no %s\n", name), exit(1);
}

/* Leave the instance as it is and go on from its saved state: after steps elsewhere, after a reset, or in another instance. */
static int part(walk *self)
{
    const unsigned kind = (unsigned)(2.0 + 2.0 * draw(&self->elsewhere));
    static byte bytes[200000];
    const double nowhere[5] = {NAN, 0.0, 0.0, -1.0, 2.0};
    saved_state state = NULL;
    size_t size = 0;
    int wrong = get_state(self->c, &state);
    self->partings += 1;
    if (kind < 2)
    {
        for (int i = 0; i < 4; i += 1)
        {
            move(&self->elsewhere);
            wrong |= usual_row(self->c, i == 2 ? nowhere : self->elsewhere.at, self->values);
        }
        if (kind == 1)
            wrong |= (int)CALL(Reset)(self->c);
        wrong |= set_state(self->c, state);
        return wrong | free_state(self->c, &state);
    }
    wrong |= state_size(self->c, state, &size) | (size > sizeof bytes);
    wrong |= write_state(self->c, state, bytes, size);
    CALL(FreeInstance)(self->c);
    self->c = NULL;
    while (!self->c)
        self->c = create("instance", MODEL_TOKEN, false);
    state = NULL;
    wrong |= read_state(self->c, bytes, size, &state) | set_state(self->c, state);
    return wrong | free_state(self->c, &state);
}

static void note_home(walk *self, bool second_half)
{
    if (self->homes == 0)
        memcpy(self->home, self->values, value_count * sizeof(double));
    self->homes += 1;
    self->same_bits += memcmp(self->home, self->values, value_count * sizeof(double)) == 0;
    double *low = self->low[second_half], *high = self->high[second_half];
    for (size_t i = 0; i < value_count; i += 1)
    {
        low[i] = fmin(low[i], self->values[i]);
        high[i] = fmax(high[i], self->values[i]);
    }
}

static void note_step(walk *self, int status, size_t angle, size_t place, double *last_place, size_t twin)
{
    bool valid = status == OK;
    for (size_t i = 0; i < value_count; i += 1)
    {
        unsigned long long word;
        memcpy(&word, self->values + i, sizeof word);
        self->digest = (self->digest ^ word) * 1099511628211ULL;
        self->digest ^= self->digest >> 32;
        valid = valid && isfinite(self->values[i]);
    }
    if (!valid && self->bad++ == 0)
        memcpy(self->first_bad, self->walker.at, sizeof self->first_bad);
    self->flange += self->values[angle] > 1.0;                              /* [rad] */
    self->jumps += fabs(self->values[place] - *last_place) > 5e-3;          /* [m]; a stride alone moves it by less than that */
    self->twins += self->values[twin] > 0.0;
    *last_place = self->values[place];
}

static void *run_walk(void *argument)
{
    walk *self = argument;
    const size_t angle = value_named("right.contact_angle"), place = value_named("right.contact.y_wheel");
    const size_t twin = value_named("right.patch[2].normal_force");
    const value_reference status = reference_of((int)(variable_named("status") - model_variables));
    double last_place = 0.0;
    for (int half = 0; half < 2; half += 1)
        for (size_t i = 0; i < SEEN; i += 1)
            self->low[half][i] = INFINITY, self->high[half][i] = -INFINITY;
    for (long k = 0; k < self->steps; k += 1)
    {
        int outcome = -1, wrong = 0;
        if (self->resumes && draw(&self->elsewhere) > 1.0 - 2.0 / PARTING)
            wrong |= part(self);
        move(&self->walker);
        if (self->moves)
            wrong |= move_all(self->c, k);
        wrong |= usual_row(self->c, k % RETURN ? self->walker.at : HOME, self->values);
#if FMI == 2
        wrong |= fmi2GetInteger(self->c, &status, 1, &outcome);
#else
        wrong |= fmi3GetInt32(self->c, &status, 1, &outcome, 1);
#endif
        note_step(self, wrong | outcome, angle, place, &last_place, twin);
        if (k % RETURN == 0)
            note_home(self, 2 * k >= self->steps);
        if (k >= self->steps / 10 && k % LOOK == 0)
        {
            const long size = resident();
            if (!self->before)
                self->before = self->least = self->most = size;
            self->least = size < self->least ? size : self->least;
            self->most = size > self->most ? size : self->most;
        }
    }
    return NULL;
}

static void print_numbers(const char *name, const double *some, size_t size)
{
    printf(", \"%s\": [", name);
    for (size_t i = 0; i < size; i += 1)
        printf("%s%.17g", i ? ", " : "", some[i]);
    printf("]");
}

static int run_walks(unsigned long long first, long steps, int variant, int threads, bool resumes)
{
    walk *walks = calloc((size_t)threads, sizeof *walks);
    pthread_t *started_threads = calloc((size_t)threads, sizeof *started_threads);
    int wrong = 0;
    seed = 3;
    for (int i = 0; i < threads; i += 1)
    {
        walks[i].walker.random = first + (unsigned long long)i;
        walks[i].elsewhere.random = ~first;
        walks[i].steps = steps, walks[i].resumes = resumes, walks[i].moves = variant % 2, walks[i].c = ready(variant);
        memcpy(walks[i].walker.at, HOME, sizeof HOME);
        memcpy(walks[i].elsewhere.at, HOME, sizeof HOME);
    }
    for (int i = 1; i < threads; i += 1)
        wrong |= pthread_create(started_threads + i, NULL, run_walk, walks + i);
    run_walk(walks);
    for (int i = 1; i < threads; i += 1)
        pthread_join(started_threads[i], NULL);
    for (int i = 0; i < threads; i += 1)
    {
        const walk *self = walks + i;
        printf("%s{\"steps\": %ld, \"bad\": %ld, \"flange\": %ld, \"jumps\": %ld, \"twins\": %ld, \"partings\": %ld, "
               "\"digest\": \"%016llx\", \"resident\": [%ld, %ld, %ld], \"homes\": %ld, \"same_bits\": %ld",
               i ? ", " : "[", steps, self->bad, self->flange, self->jumps, self->twins, self->partings, self->digest,
               self->before, self->least, self->most, self->homes, self->same_bits);
        print_numbers("first_bad", self->first_bad, self->bad ? 5 : 0);
        print_numbers("last", self->walker.at, 5);
        print_numbers("home", self->home, value_count);
        print_numbers("low", self->low[0], value_count), print_numbers("high", self->high[0], value_count);
        print_numbers("late_low", self->low[1], value_count), print_numbers("late_high", self->high[1], value_count);
        printf("}");
        CALL(FreeInstance)(self->c);
    }
    printf("]\n");
    free(walks), free(started_threads);
    return wrong;
}

int main(int count, char **arguments)
{
    if (count == 4 && strcmp(arguments[1], "fuzz") == 0)
        return supervised_fuzz(strtoull(arguments[2], NULL, 10), atol(arguments[3]));
    if (count == 5 && strstr("walk walks resumed", arguments[1]))
    {
        const bool threads = strcmp(arguments[1], "walks") == 0;
        const int last = atoi(arguments[4]);
        find_values();
        return run_walks(strtoull(arguments[2], NULL, 10), atol(arguments[3]), threads ? 0 : last, threads ? last : 1,
                         strcmp(arguments[1], "resumed") == 0);
    }
    if (count != 4 || read_rows(arguments[3]) != OK)
        return printf("host fuzz <seed> <calls> | threads <count> <file> | allocations <variant> <file> | "
                      "walk <seed> <steps> <variant> | resumed <seed> <steps> <variant> | walks <seed> <steps> <threads>\n"), 2;
    seed = 3;
    const int number = atoi(arguments[2]);
    return strcmp(arguments[1], "threads") == 0 ? run_threads(number) : count_allocations(number);
}
