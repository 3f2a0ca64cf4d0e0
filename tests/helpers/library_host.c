/* Loads a library for the machine it runs on, a native FMU's or the kernel's, and prints what it computes, bit for bit.
 *
 *     library_host fmi2 <library> <token> <plan> [<value reference>=<text>] ...
 *     library_host fmi3 <library> <token> <plan> [<value reference>=<text>] ...
 *     library_host kernel <library> <plan>
 *
 * Numbers in the plan and in the answer are hexadecimal, float64 by their bits; a list is its length and its members.
 * The plan of an FMU: inputs and outputs by value reference, how many values the outputs have, the status's reference, how
 * many rows, and the rows of inputs.  That of the kernel: tables, the sizes of state and workspace, the counts of inputs and
 * outputs, how many rows, and the rows.  The answer: a line for each row, the outputs and the status; of the kernel also,
 * in the first line, its fingerprint.  An FMU is an instance for co-simulation and one for model exchange, whose values without a
 * step must be the same.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2FunctionTypes.h"
#include "fmi3FunctionTypes.h"
#include "wrcontact_kernel.h"

#ifdef _WIN32
#include <windows.h>
static void *opened(const char *path) { return (void *)LoadLibraryA(path); }
static void *found(void *library, const char *name) { return (void *)GetProcAddress((HMODULE)library, name); }
#else
#include <dlfcn.h>
static void *opened(const char *path) { return dlopen(path, RTLD_NOW | RTLD_LOCAL); }
static void *found(void *library, const char *name) { return dlsym(library, name); }
#endif

static void fail(const char *what, const char *which)
{
    fprintf(stderr, "%s %s\n", what, which);
    exit(1);
}

/* --- the plan and the answer -------------------------------------------------------------------------------- */

static FILE *plan;

static unsigned long long number(void)
{
    unsigned long long value;
    if (fscanf(plan, "%llx", &value) != 1)
        fail("the plan", "ends too early");
    return value;
}

static void *room(size_t count, size_t size)
{
    void *memory = calloc(count + 1, size);
    if (!memory)
        fail("no", "memory");
    return memory;
}

static void read_reals(double *values, size_t count)
{
    for (size_t i = 0; i < count; i += 1)
    {
        const unsigned long long bits = number();
        memcpy(values + i, &bits, sizeof bits);
    }
}

static size_t read_references(unsigned **references)
{
    const size_t count = number();
    *references = room(count, sizeof **references);
    for (size_t i = 0; i < count; i += 1)
        (*references)[i] = (unsigned)number();
    return count;
}

static void print_row(const double *values, size_t count, int status)
{
    for (size_t i = 0; i < count; i += 1)
    {
        unsigned long long bits;
        memcpy(&bits, values + i, sizeof bits);
        printf("%llx ", bits);
    }
    printf("%x\n", (unsigned)status);
}

/* --- FMUs ----------------------------------------------------------------------------------------------------- */

static void *library;

#define FUNCTION(name) ((name##TYPE *)function(#name))
static void *function(const char *name)
{
    void *address = found(library, name);
    if (!address)
        fail("no function", name);
    return address;
}

static void check(int status, const char *call)
{
    if (status)
        fail("an error from", call);
}

static void note2(fmi2ComponentEnvironment e, fmi2String name, fmi2Status status, fmi2String category, fmi2String message,
                  ...)
{
    (void)e, (void)name, (void)status, (void)category;
    fprintf(stderr, "%s\n", message);
}

static void note3(fmi3InstanceEnvironment e, fmi3Status status, fmi3String category, fmi3String message)
{
    (void)e, (void)status, (void)category;
    fprintf(stderr, "%s\n", message);
}

static void *started(int version, const char *token, char **settings, int count, bool exchange)
{
    static const fmi2CallbackFunctions callbacks = {note2, calloc, free, NULL, NULL};
    void *c = version == 2 ? FUNCTION(fmi2Instantiate)("host", exchange ? fmi2ModelExchange : fmi2CoSimulation, token, "",
                                                       &callbacks, fmi2False, fmi2True)
            : exchange ? FUNCTION(fmi3InstantiateModelExchange)("host", token, "", false, true, NULL, note3)
                       : FUNCTION(fmi3InstantiateCoSimulation)("host", token, "", false, true, false, false, NULL, 0, NULL,
                                                               note3, NULL);
    if (!c)
        fail("no", "instance");
    for (int i = 0; i < count; i += 1)
    {
        char *text;
        const unsigned reference = (unsigned)strtoul(settings[i], &text, 10);
        const char *value = text + 1;
        check(version == 2 ? (int)FUNCTION(fmi2SetString)(c, &reference, 1, &value)
                           : (int)FUNCTION(fmi3SetString)(c, &reference, 1, &value, 1), settings[i]);
    }
    if (version == 2)
    {
        check(FUNCTION(fmi2SetupExperiment)(c, fmi2False, 0.0, 0.0, fmi2False, 0.0), "fmi2SetupExperiment");
        check(FUNCTION(fmi2EnterInitializationMode)(c), "fmi2EnterInitializationMode");
        check(FUNCTION(fmi2ExitInitializationMode)(c), "fmi2ExitInitializationMode");
    }
    else
    {
        check(FUNCTION(fmi3EnterInitializationMode)(c, false, 0.0, 0.0, false, 0.0), "fmi3EnterInitializationMode");
        check(FUNCTION(fmi3ExitInitializationMode)(c), "fmi3ExitInitializationMode");
    }
    if (exchange)
        check(version == 2 ? (int)FUNCTION(fmi2EnterContinuousTimeMode)(c) : (int)FUNCTION(fmi3EnterContinuousTimeMode)(c),
              "EnterContinuousTimeMode");
    return c;
}

static void run_fmu(int version, const char *token, char **settings, int setting_count)
{
    unsigned *inputs, *outputs;
    const size_t input_count = read_references(&inputs), output_count = read_references(&outputs), value_count = number();
    const unsigned status_reference = (unsigned)number();
    const size_t row_count = number();
    double *row = room(input_count, sizeof *row), *values = room(value_count, sizeof *values);
    double *others = room(value_count, sizeof *others);
    void *c = started(version, token, settings, setting_count, false);
    void *exchange = started(version, token, settings, setting_count, true);
    for (size_t k = 0; k < row_count; k += 1)
    {
        const double time = 1e-3 * (double)k;
        int status = -1;
        read_reals(row, input_count);
        if (version == 2)
        {
            check(FUNCTION(fmi2SetReal)(c, inputs, input_count, row), "fmi2SetReal");
            check(FUNCTION(fmi2DoStep)(c, time, 1e-3, fmi2True), "fmi2DoStep");
            check(FUNCTION(fmi2GetReal)(c, outputs, output_count, values), "fmi2GetReal");
            check(FUNCTION(fmi2SetReal)(exchange, inputs, input_count, row), "fmi2SetReal");
            check(FUNCTION(fmi2GetReal)(exchange, outputs, output_count, others), "fmi2GetReal");
            check(FUNCTION(fmi2GetInteger)(c, &status_reference, 1, &status), "fmi2GetInteger");
        }
        else
        {
            bool event, end, early;
            double last;
            check(FUNCTION(fmi3SetFloat64)(c, inputs, input_count, row, input_count), "fmi3SetFloat64");
            check(FUNCTION(fmi3DoStep)(c, time, 1e-3, true, &event, &end, &early, &last), "fmi3DoStep");
            check(FUNCTION(fmi3GetFloat64)(c, outputs, output_count, values, value_count), "fmi3GetFloat64");
            check(FUNCTION(fmi3SetFloat64)(exchange, inputs, input_count, row, input_count), "fmi3SetFloat64");
            check(FUNCTION(fmi3GetFloat64)(exchange, outputs, output_count, others, value_count), "fmi3GetFloat64");
            check(FUNCTION(fmi3GetInt32)(c, &status_reference, 1, &status, 1), "fmi3GetInt32");
        }
        if (status < 2 && memcmp(values, others, value_count * sizeof *values) != 0)
            fail("model exchange has", "other values");
        print_row(values, value_count, status);
    }
    if (version == 2)
        FUNCTION(fmi2FreeInstance)(c), FUNCTION(fmi2FreeInstance)(exchange);
    else
        FUNCTION(fmi3FreeInstance)(c), FUNCTION(fmi3FreeInstance)(exchange);
}

/* --- the kernel ------------------------------------------------------------------------------------------------- */

static array_double_1d zeros(size_t count)
{
    return span_of(room(count, sizeof(double)), (int64_t)count);
}

static void run_kernel(void)
{
    int64_t (*abi)(void) = function("wrcontact_abi");
    int (*step)(const wrcontact_handle *) = function("wrcontact_step");
    wrcontact_handle handle;
    handle.tables = zeros(number());
    read_reals(handle.tables.data, (size_t)handle.tables.shape[0]);
    handle.state = zeros(number());
    handle.workspace = zeros(number());
    const size_t input_count = number(), output_count = number(), row_count = number();
    handle.inputs = zeros(input_count);
    handle.outputs = zeros(output_count);
    printf("%llx\n", (unsigned long long)abi());
    for (size_t k = 0; k < row_count; k += 1)
    {
        read_reals(handle.inputs.data, input_count);
        const int status = step(&handle);
        print_row(handle.outputs.data, output_count, status);
    }
}

int main(int count, char **arguments)
{
    const bool kernel = count == 4 && strcmp(arguments[1], "kernel") == 0;
    if (!kernel && (count < 5 || strncmp(arguments[1], "fmi", 3)))
        fail("usage: library_host", "fmi2|fmi3 <library> <token> <plan> [<reference>=<text>] ... | kernel <library> <plan>");
    library = opened(arguments[2]);
    if (!library)
        fail("cannot load", arguments[2]);
    plan = fopen(arguments[kernel ? 3 : 4], "r");
    if (!plan)
        fail("cannot read", arguments[kernel ? 3 : 4]);
    if (kernel)
        run_kernel();
    else
        run_fmu(arguments[1][3] - '0', arguments[3], arguments + 5, count - 5);
    fclose(plan);
    return 0;
}
