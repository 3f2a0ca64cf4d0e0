/* Calls an FMI 2 or FMI 3 native FMU, linked into this program, in random order with legal and illegal arguments, and counts
 * allocations and cost of the usual steps.
 *
 *     cc -DFMI=2 native_host.c fmi2.c wheelset.c model.c kernel/native/wrcontact_kernel.c kernel/native/wrcontact_prepare.c -lm
 *     native_host fuzz <seed> <calls>      one line, and an exit code other than 0 where something is wrong
 *     native_host cost <file>              microseconds of set 5, do step, get all over the rows of inputs in the file, and
 *                                          allocations since the initialisation
 */
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "model.h"

/* --- an allocation hook: the FMU's calloc, malloc and realloc are these -------------------------------- */

static long allocations;
static long failing = -1;       /* this allocation fails; none if it is negative */

static int fails(void)
{
    allocations += 1;
    return failing >= 0 && allocations == failing;
}

void *hooked_malloc(size_t size) { return fails() ? NULL : malloc(size); }
void *hooked_calloc(size_t count, size_t size) { return fails() ? NULL : calloc(count, size); }
void *hooked_realloc(void *old, size_t size) { return fails() ? NULL : realloc(old, size); }

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
    lines += 1;
    if (!message || strlen(message) < 10 || strlen(message) > 2 * MODEL_SENTENCE)
        long_lines += 1;
}

enum { OK, LIST = 40, STATES = 4, INSTANCES = 3 };
static double numbers[64 * LIST];

/* --- both versions of the standard behind the same names --------------------------------------------------- */

#if FMI == 2
#include "fmi2Functions.h"
typedef fmi2Component component;
typedef fmi2FMUstate saved_state;
typedef fmi2ValueReference value_reference;
typedef fmi2Byte byte;
enum { REFERENCES = MODEL_VARIABLES, FIRST_REFERENCE = 0 };
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
static component create(const char *name, const char *token)
{
    static const fmi2CallbackFunctions callbacks = {note, NULL, NULL, NULL, NULL};
    return fmi2Instantiate(name, fmi2CoSimulation, token, NULL, pick(50) ? &callbacks : NULL, fmi2False, fmi2True);
}
#define CALL(name) fmi2##name
static int get_state(component c, saved_state *s) { return fmi2GetFMUstate(c, s); }
static int set_state(component c, saved_state s) { return fmi2SetFMUstate(c, s); }
static int free_state(component c, saved_state *s) { return fmi2FreeFMUstate(c, s); }
static int state_size(component c, saved_state s, size_t *n) { return fmi2SerializedFMUstateSize(c, s, n); }
static int write_state(component c, saved_state s, byte *b, size_t n) { return fmi2SerializeFMUstate(c, s, b, n); }
static int read_state(component c, const byte *b, size_t n, saved_state *s) { return fmi2DeSerializeFMUstate(c, b, n, s); }
static int get_reals(component c, const value_reference *r, size_t n, double *v, size_t m) { (void)m; return fmi2GetReal(c, r, n, v); }
static int set_reals(component c, const value_reference *r, size_t n, const double *v, size_t m)
{
    (void)m;
    return fmi2SetReal(c, r, n, v);
}
static int enter(component c) { return fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), fmi2EnterInitializationMode(c); }
static int step(component c, double time, double size) { return fmi2DoStep(c, time, size, fmi2True); }
static int texts(component c, const value_reference *r, size_t n, const char **v, int set)
{
    return set ? fmi2SetString(c, r, n, v) : fmi2GetString(c, r, n, v);
}
static int integers(component c, const value_reference *r, size_t n, int *v, int set)
{
    return set ? fmi2SetInteger(c, r, n, v) : fmi2GetInteger(c, r, n, v);
}
static int differentiate(component c, const value_reference *r, size_t n, const value_reference *known, double *rates, size_t m)
{
    const double one = 1.0;
    (void)m;
    return fmi2GetDirectionalDerivative(c, r, n, known, 1, &one, rates);
}
static int odd_call(component c, const value_reference *r, size_t n)
{
    int integer = 0;
    switch (pick(9))
    {
    case 0: return fmi2GetBoolean(c, r, n, &integer);
    case 1: return fmi2GetDirectionalDerivative(c, r, n, pick(9) ? r : NULL, n, numbers, numbers);
    case 2: return fmi2SetRealInputDerivatives(c, r, n, &integer, numbers);
    case 3: return fmi2GetRealOutputDerivatives(c, r, n, &integer, numbers);
    case 4: return fmi2CancelStep(c);
    case 5: return fmi2GetRealStatus(c, (fmi2StatusKind)pick(5), pick(5) ? numbers : NULL);
    case 6: return fmi2GetBooleanStatus(c, (fmi2StatusKind)pick(5), pick(5) ? &integer : NULL);
    case 7: return fmi2GetIntegerStatus(c, (fmi2StatusKind)pick(5), &integer);
    default: return fmi2SetupExperiment(c, fmi2True, some_number(), some_number(), fmi2True, some_number());
    }
}
static size_t values_of(value_reference reference) { return (void)reference, 1; }
#else
#include "fmi3Functions.h"
typedef fmi3Instance component;
typedef fmi3FMUState saved_state;
typedef fmi3ValueReference value_reference;
typedef fmi3Byte byte;
enum { REFERENCES = MODEL_BLOCKS + 1, FIRST_REFERENCE = 1 };
static void note(fmi3InstanceEnvironment e, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)e, (void)status, (void)category;
    count_line(message);
}
static component create(const char *name, const char *token)
{
    return fmi3InstantiateCoSimulation(name, token, NULL, false, true, pick(60) == 0, false, NULL, pick(60) == 0, NULL,
                                       pick(50) ? note : NULL, NULL);
}
#define CALL(name) fmi3##name
static int get_state(component c, saved_state *s) { return fmi3GetFMUState(c, s); }
static int set_state(component c, saved_state s) { return fmi3SetFMUState(c, s); }
static int free_state(component c, saved_state *s) { return fmi3FreeFMUState(c, s); }
static int state_size(component c, saved_state s, size_t *n) { return fmi3SerializedFMUStateSize(c, s, n); }
static int write_state(component c, saved_state s, byte *b, size_t n) { return fmi3SerializeFMUState(c, s, b, n); }
static int read_state(component c, const byte *b, size_t n, saved_state *s) { return fmi3DeserializeFMUState(c, b, n, s); }
static int get_reals(component c, const value_reference *r, size_t n, double *v, size_t m) { return fmi3GetFloat64(c, r, n, v, m); }
static int set_reals(component c, const value_reference *r, size_t n, const double *v, size_t m)
{
    return fmi3SetFloat64(c, r, n, v, m);
}
static int enter(component c) { return fmi3EnterInitializationMode(c, false, 0.0, 0.0, false, 0.0); }
static int step(component c, double time, double size)
{
    bool a, b, d;
    double last;
    return fmi3DoStep(c, time, size, true, &a, &b, pick(60) ? &d : NULL, &last);
}
static int texts(component c, const value_reference *r, size_t n, const char **v, int set)
{
    return set ? fmi3SetString(c, r, n, v, n) : fmi3GetString(c, r, n, v, n);
}
static int integers(component c, const value_reference *r, size_t n, int *v, int set)
{
    return set ? fmi3SetInt32(c, r, n, v, n) : fmi3GetInt32(c, r, n, v, n);
}
static int differentiate(component c, const value_reference *r, size_t n, const value_reference *known, double *rates, size_t m)
{
    const double one = 1.0;
    if (pick(3) == 0)
        return fmi3GetAdjointDerivative(c, r, n, known, 1, rates, m, numbers, 1);
    return fmi3GetDirectionalDerivative(c, r, n, known, 1, &one, 1, rates, m);
}
static int odd_call(component c, const value_reference *r, size_t n)
{
    bool flag;
    size_t count;
    switch (pick(10))
    {
    case 0: return fmi3GetBoolean(c, r, n, &flag, n);
    case 1: return fmi3GetDirectionalDerivative(c, r, n, pick(9) ? r : NULL, n, numbers, n, numbers, n);
    case 2: return fmi3GetInt64(c, r, n, NULL, n);
    case 3: return fmi3EnterConfigurationMode(c);
    case 4: return fmi3ExitConfigurationMode(c);
    case 5: return fmi3EnterEventMode(c);
    case 6: return fmi3EnterStepMode(c);
    case 7: return fmi3GetNumberOfContinuousStates(c, &count);
    case 8: return fmi3GetClock(c, r, n, &flag);
    default: return fmi3EnterInitializationMode(c, true, some_number(), some_number(), true, some_number());
    }
}
static size_t values_of(value_reference reference)
{
    return reference < 1 || reference > MODEL_BLOCKS ? 1 : (size_t)model_blocks[reference].count;
}
#endif

/* --- the fuzzer --------------------------------------------------------------------------------------------- */

static component instances[INSTANCES];
static saved_state states[STATES];
static byte stored[STATES][200000];
static size_t stored_size[STATES];

static long usual_steps, valid_steps;

/* What a simulation does: all inputs possible, a step, the status read. */
static int usual_step(component c)
{
    const value_reference first = FMI == 2 ? 0 : 2, status = FMI == 2 ? MODEL_STATUS : MODEL_BLOCKS;
    const double yaw = pick(3) ? 0.0 : 1e-5 * (pick(2401) - 1200.0);
    const double inputs[MODEL_INPUTS] = {1e-5 * (pick(3001) - 1500.0), yaw, pick(5) ? 0.0 : 1e-5 * pick(1000), 10.0 * pick(20000),
                                         pick(3) ? 0.0 : 1e-2 * (pick(201) - 100.0), 1e-6 * pick(3000), 1e-5 * (pick(201) - 100.0)};
    value_reference references[MODEL_INPUTS];
    int outcome = -1;
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        references[i] = first + (value_reference)i;
    usual_steps += 1;
    if (set_reals(c, references, MODEL_INPUTS, inputs, MODEL_INPUTS) != OK || step(c, 0.0, 1e-3) != OK
        || integers(c, &status, 1, &outcome, 0) != OK)
        return OK + 1;
    valid_steps += outcome == 0 || outcome == 1;
    return OK;
}

/* An instance with methods and profiles of its own choice, ready to step. */
static int usual_start(component c)
{
    CALL(Reset)(c);
    for (int i = 0; i < MODEL_VARIABLES; i += 1)
    {
        const model_variable *variable = model_variables + i;
        value_reference reference = (value_reference)i + (FMI == 2 ? 0 : 2);    /* no array stands before the parameters' end */
        if (variable->choice_count > 0 && pick(3) == 0)
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
    if (enter(c) != OK)
        return OK + 1;
    return (int)CALL(ExitInitializationMode)(c);
}

/* Derivatives of some outputs along an input, now and then along what is none. */
static int some_derivative(component c)
{
    const value_reference first = FMI == 2 ? MODEL_FIRST_OUTPUT : MODEL_FIRST_OUTPUT + 2;
    const value_reference known = FIRST_REFERENCE + (FMI == 3) + pick(MODEL_INPUTS + (pick(9) == 0));
    value_reference references[LIST];
    const size_t count = pick(LIST);
    size_t values = 0;
    for (size_t i = 0; i < count; i += 1)
    {
        references[i] = first + pick(pick(9) ? 8 : REFERENCES - first);
        values += values_of(references[i]);
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
        *slot = create(pick(20) ? "instance" : pick(2) ? "" : NULL, pick(20) ? MODEL_TOKEN : pick(2) ? "{0}" : NULL);
        return *slot ? OK : OK + 1;
    }
    const unsigned kind = pick(5);      /* mostly inputs, and sometimes anything */
    for (size_t i = 0; i < count; i += 1)
    {
        references[i] = kind < 3 ? FIRST_REFERENCE + (FMI == 3) + pick(MODEL_INPUTS + 4) : pick(REFERENCES + 3);
        words[i] = some_text();
        numbers[i] = some_number();
        values += values_of(references[i]);
    }
    for (size_t i = count; i < values; i += 1)
        numbers[i] = some_number();
    if (pick(40) == 0)
        values += 1;
    if (pick(8) == 0)
        return usual_step(c);
    if (pick(200) == 0)
        return usual_start(c);
    switch (pick(24))
    {
    case 0: return pick(40) ? OK : (CALL(FreeInstance)(c), *slot = NULL, OK);
    case 1: return enter(pick(40) ? c : NULL);
    case 2: return CALL(ExitInitializationMode)(c);
    case 3: return pick(20) ? OK : CALL(Reset)(c);
    case 4: return pick(60) ? OK : CALL(Terminate)(c);
    case 5: return texts(c, references, count, words, 1);
    case 6: return texts(c, references, count, words, 0);
    case 7: return pick(2) ? some_derivative(c) : integers(c, references, count, integer, pick(4) == 0);
    case 8: return odd_call(c, references, count);
    case 9: return CALL(SetDebugLogging)(c, true, count, words);
    case 10: return get_state(c, pick(20) ? states + k : NULL);
    case 11: return set_state(c, pick(20) ? states[k] : NULL);
    case 12: return pick(3) ? OK : free_state(c, states + k);
    case 13:
        if (state_size(c, states[k], &stored_size[k]) != OK)
            return stored_size[k] = 0, OK + 1;
        return write_state(c, states[k], stored[k], stored_size[k] - (pick(10) == 0));
    case 14:
        if (stored_size[k] && pick(2))
            stored[k][pick((unsigned)stored_size[k])] ^= (byte)(1u << pick(8));
        return read_state(c, stored[k], stored_size[k] - (stored_size[k] && pick(10) == 0), states + k);
    case 15: return get_reals(c, pick(30) ? references : NULL, count, pick(30) ? numbers : NULL, values);
    case 16: return get_reals(c, references, count, numbers, values);
    case 17:
    case 18:
    case 19: return set_reals(c, references, count, numbers, values);
    default: return step(c, pick(20) ? 0.0 : some_number(), pick(20) ? 1e-3 : some_number());
    }
}

/* After everything an instance can be reset, initialised and stepped, and then gives the values of a fresh one. */
static int check_recovery(component c)
{
    const value_reference roll = FMI == 2 ? MODEL_FIRST_OUTPUT : MODEL_FIRST_OUTPUT + 2;
    component fresh = NULL;
    double values[2] = {1.0, 2.0};
    while (!fresh)
        fresh = create("fresh", MODEL_TOKEN);
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

static int fuzz(long calls)
{
    long good = 0, made = 0;
    for (long call = 0; call < calls; call += 1)
    {
        failing = pick(500) ? -1 : allocations + 1 + pick(3);
        good += some_call() == OK;
        made += 1;
    }
    failing = -1;
    int wrong = 0;
    for (int i = 0; i < INSTANCES; i += 1)
        if (instances[i])
        {
            wrong |= check_recovery(instances[i]);
            for (int k = 0; k < STATES; k += 1)
                free_state(instances[i], states + k);
            CALL(FreeInstance)(instances[i]);
        }
    for (int k = 0; k < STATES; k += 1)
        if (states[k])
        {
            component c = NULL;
            while (!c)
                c = create("last", MODEL_TOKEN);
            free_state(c, states + k);
            CALL(FreeInstance)(c);
        }
    printf("{\"calls\": %ld, \"ok\": %ld, \"lines\": %ld, \"odd_lines\": %ld, \"usual_steps\": %ld, \"valid_steps\": %ld}\n",
           made, good, lines, long_lines, usual_steps, valid_steps);
    return wrong || long_lines > 0;
}

/* --- cost ----------------------------------------------------------------------------------------------------- */

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return 1e6 * (double)time.tv_sec + 1e-3 * (double)time.tv_nsec;
}

static int cost(const char *path)
{
    static double rows[2000][5];
    static double outputs[MODEL_VARIABLES];
    value_reference inputs[5], references[MODEL_VARIABLES];
    size_t count = 0, values = 0;
    int row_count = 0;
    FILE *file = fopen(path, "r");
    while (file && row_count < 2000
           && fscanf(file, "%lf %lf %lf %lf %lf", rows[row_count], rows[row_count] + 1, rows[row_count] + 2, rows[row_count] + 3,
                     rows[row_count] + 4) == 5)
        row_count += 1;
    if (!row_count)
        return printf("no rows in %s\n", path), 1;
    fclose(file);
    seed = 3;
    component c = NULL;
    while (!c)
        c = create("instance", MODEL_TOKEN);
    for (int i = 0; i < 5; i += 1)
        inputs[i] = FIRST_REFERENCE + (FMI == 3) + i;
    for (value_reference r = FIRST_REFERENCE; r < REFERENCES; r += 1)
    {
        const int first = FMI == 2 ? (int)r : model_blocks[r].first;
        if (first >= MODEL_FIRST_OUTPUT && model_variables[first].type == MODEL_REAL)
        {
            references[count++] = r;
            values += values_of(r);
        }
    }
    if (enter(c) != OK || (int)CALL(ExitInitializationMode)(c) != OK)
        return printf("not initialised\n"), 1;
    const long before = allocations;
    double best = 1e300;
    for (int repeat = 0; repeat < 15; repeat += 1)
    {
        const double start = now();
        for (int k = 0; k < row_count; k += 1)
        {
#if FMI == 2
            int status = set_reals(c, inputs, 5, rows[k], 5) | fmi2DoStep(c, 0.0, 1e-3, fmi2True);
#else
            bool a, b, d;
            double last;
            int status = set_reals(c, inputs, 5, rows[k], 5) | fmi3DoStep(c, 0.0, 1e-3, true, &a, &b, &d, &last);
#endif
            if (status | get_reals(c, references, count, outputs, values))
                return printf("a step fails in row %d\n", k), 1;
        }
        const double passed = (now() - start) / row_count;
        best = passed < best ? passed : best;
    }
    double derivative = 0.0;
    for (int k = 0; k < row_count; k += 1)
    {
        int status = set_reals(c, inputs, 5, rows[k], 5) | get_reals(c, references, count, outputs, values);
        const double start = now();
        status |= differentiate(c, references, count, inputs, outputs, values);
        derivative += (now() - start) / row_count;
        if (status)
            return printf("a derivative fails in row %d\n", k), 1;
    }
    printf("{\"microseconds\": %.3f, \"derivative\": %.3f, \"rows\": %d, \"outputs\": %lu, \"allocations\": %ld}\n", best,
           derivative, row_count, (unsigned long)values, allocations - before);
    CALL(FreeInstance)(c);
    return 0;
}

int main(int count, char **arguments)
{
    if (count == 4 && strcmp(arguments[1], "fuzz") == 0)
    {
        seed = strtoull(arguments[2], NULL, 10);
        return fuzz(atol(arguments[3]));
    }
    if (count == 3 && strcmp(arguments[1], "cost") == 0)
        return cost(arguments[2]);
    printf("usage: native_host fuzz <seed> <calls> | cost <file>\n");
    return 2;
}
