/* Steps a native FMU over rows of inputs, as a simulation does: set the inputs, step, read all Real outputs.
 *
 *     cc -DFMI=2 native_times.c WheelsetContact.so -o native_times
 *
 *     native_times <token> <file>      microseconds of the processor for a step: the least of ROUNDS rounds
 *
 * The file holds numbers: how many inputs, outputs, values of these outputs, and rows there are; the value references of inputs
 * and outputs; then the rows.
 */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#if FMI == 2
#include "fmi2Functions.h"
typedef fmi2Component component;
typedef fmi2ValueReference value_reference;
#else
#include "fmi3Functions.h"
typedef fmi3Instance component;
typedef fmi3ValueReference value_reference;
#endif

enum { INPUTS, OUTPUTS, VALUES, ROWS, SIZES, ROUNDS = 15 };

static size_t sizes[SIZES];
static value_reference *inputs, *outputs;
static double *rows, *values;

static int read_references(FILE *file, value_reference *references, size_t count)
{
    for (size_t i = 0; i < count; i += 1)
        if (fscanf(file, "%u", references + i) != 1)
            return 0;
    return 1;
}

static int read_file(const char *name)
{
    FILE *file = fopen(name, "r");
    for (int i = 0; i < SIZES; i += 1)
        if (!file || fscanf(file, "%zu", sizes + i) != 1)
            return 0;
    const size_t count = sizes[ROWS] * sizes[INPUTS];
    inputs = malloc(sizes[INPUTS] * sizeof *inputs);
    outputs = malloc(sizes[OUTPUTS] * sizeof *outputs);
    rows = malloc(count * sizeof *rows);
    values = malloc(sizes[VALUES] * sizeof *values);
    if (!inputs || !outputs || !rows || !values || !read_references(file, inputs, sizes[INPUTS])
        || !read_references(file, outputs, sizes[OUTPUTS]))
        return 0;
    for (size_t i = 0; i < count; i += 1)
        if (fscanf(file, "%lf", rows + i) != 1)
            return 0;
    fclose(file);
    return 1;
}

#if FMI == 2
static component start(const char *token)
{
    static const fmi2CallbackFunctions callbacks = {NULL, NULL, NULL, NULL, NULL};
    component c = fmi2Instantiate("times", fmi2CoSimulation, token, NULL, &callbacks, fmi2False, fmi2False);
    if (c && (fmi2SetupExperiment(c, fmi2False, 0.0, 0.0, fmi2False, 0.0) || fmi2EnterInitializationMode(c)
              || fmi2ExitInitializationMode(c)))
        return NULL;
    return c;
}

static int step(component c, const double *row)
{
    return fmi2SetReal(c, inputs, sizes[INPUTS], row) | fmi2DoStep(c, 0.0, 1e-3, fmi2True)
           | fmi2GetReal(c, outputs, sizes[OUTPUTS], values);
}
#else
static component start(const char *token)
{
    component c = fmi3InstantiateCoSimulation("times", token, NULL, false, false, false, false, NULL, 0, NULL, NULL, NULL);
    if (c && (fmi3EnterInitializationMode(c, false, 0.0, 0.0, false, 0.0) || fmi3ExitInitializationMode(c)))
        return NULL;
    return c;
}

static int step(component c, const double *row)
{
    bool event, end, early;
    double last;
    return fmi3SetFloat64(c, inputs, sizes[INPUTS], row, sizes[INPUTS])
           | fmi3DoStep(c, 0.0, 1e-3, true, &event, &end, &early, &last)
           | fmi3GetFloat64(c, outputs, sizes[OUTPUTS], values, sizes[VALUES]);
}
#endif

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);       /* what others on the machine take is not counted */
    return 1e6 * (double)time.tv_sec + 1e-3 * (double)time.tv_nsec;
}

int main(int count, char **arguments)
{
    if (count != 3 || !read_file(arguments[2]))
        return fprintf(stderr, "native_times <token> <file>\n"), 2;
    component c = start(arguments[1]);
    if (!c)
        return fprintf(stderr, "not initialised\n"), 1;
    double least = 1e300;
    for (int round = 0; round < ROUNDS; round += 1)
    {
        const double before = now();
        for (size_t k = 0; k < sizes[ROWS]; k += 1)
            if (step(c, rows + k * sizes[INPUTS]))
                return fprintf(stderr, "a step fails in row %zu\n", k), 1;
        const double passed = (now() - before) / (double)sizes[ROWS];
        least = passed < least ? passed : least;
    }
    printf("%.3f\n", least);
    return 0;
}
