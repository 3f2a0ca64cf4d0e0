/* Steps wheelsets as a program for real time does: all memory is there before the first step; a step allocates nothing, takes no
 * lock and opens no file.
 *
 *     cc -O2 realtime_host.c <the compiled kernel> -o realtime_host
 *
 *     realtime_host once <file>                           each row by one wheelset, without measuring
 *     realtime_host train <wheelsets> <rounds> <file>     each row is a time step of all wheelsets, each of them some rows behind
 *                                                         the one before it; microseconds of the processor for each time step, the least of all
 *                                                         rounds
 *
 * The file holds doubles: the sizes of tables, state, workspace, inputs and outputs, the number of inputs that are outputs of the
 * step before, and that of rows; then the place of each such input and of its output, the tables, and the rows of inputs.
 */
#define _POSIX_C_SOURCE 200809L
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef struct {
    double *data;
    int64_t size;
} span;

/* As in wrcontact_kernel.h. */
typedef struct {
    span tables, state, workspace, inputs, outputs;
} handle;

int wrcontact_step(const handle *);

enum { TABLES, STATE, WORKSPACE, INPUTS, OUTPUTS, FED, ROWS, SIZES, BEHIND = 125 };

static int64_t sizes[SIZES];
static double *fed, *tables, *rows;

static int read_file(const char *name)
{
    double given[SIZES];
    FILE *file = fopen(name, "rb");
    if (!file || fread(given, sizeof *given, SIZES, file) != SIZES)
        return 0;
    for (int i = 0; i < SIZES; i += 1)
        sizes[i] = (int64_t)given[i];
    const size_t fed_count = (size_t)(2 * sizes[FED]);
    const size_t table_count = (size_t)sizes[TABLES], row_count = (size_t)(sizes[ROWS] * sizes[INPUTS]);
    fed = malloc((fed_count + 1) * sizeof *fed);
    tables = malloc(table_count * sizeof *tables);
    rows = malloc(row_count * sizeof *rows);
    return fed && tables && rows && fread(fed, sizeof *fed, fed_count, file) == fed_count &&
           fread(tables, sizeof *tables, table_count, file) == table_count &&
           fread(rows, sizeof *rows, row_count, file) == row_count;
}

static span zeros(int64_t size)
{
    const span made = {calloc((size_t)size, sizeof(double)), size};
    return made;
}

/* A wheelset with memory of its own, and the tables, which all of them read. */
static handle wheelset(void)
{
    const handle made = {{tables, sizes[TABLES]},
                         zeros(sizes[STATE]),
                         zeros(sizes[WORKSPACE]),
                         zeros(sizes[INPUTS]),
                         zeros(sizes[OUTPUTS])};
    return made;
}

static int step(const handle *one, int64_t row)
{
    memcpy(one->inputs.data, rows + row % sizes[ROWS] * sizes[INPUTS], (size_t)sizes[INPUTS] * sizeof(double));
    for (int64_t i = 0; i < sizes[FED]; i += 1)
        one->inputs.data[(int64_t)fed[2 * i]] = one->outputs.data[(int64_t)fed[2 * i + 1]];
    return wrcontact_step(one);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * (double)time.tv_sec + 1e-3 * (double)time.tv_nsec;
}

static int run_train(int count, int rounds)
{
    handle *train = malloc((size_t)count * sizeof *train);
    double *least = malloc((size_t)sizes[ROWS] * sizeof *least);
    for (int i = 0; i < count; i += 1)
        train[i] = wheelset();
    for (int round = 0; round < rounds; round += 1)
        for (int64_t row = 0; row < sizes[ROWS]; row += 1)
        {
            const double start = now();
            for (int i = 0; i < count; i += 1)
                if (step(&train[i], row + (int64_t)i * BEHIND) > 1)
                    return printf("row %ld fails\n", (long)row), 1;
            const double passed = now() - start;
            if (round == 0 || passed < least[row])
                least[row] = passed;
        }
    for (int64_t row = 0; row < sizes[ROWS]; row += 1)
        printf("%.3f\n", least[row]);
    return 0;
}

int main(int count, char **arguments)
{
    if (count < 3 || !read_file(arguments[count - 1]))
        return fprintf(stderr, "realtime_host once <file> | train <wheelsets> <rounds> <file>\n"), 2;
    if (count == 5 && strcmp(arguments[1], "train") == 0)
        return run_train(atoi(arguments[2]), atoi(arguments[3]));
    const handle one = wheelset();
    for (int64_t row = 0; row < sizes[ROWS]; row += 1)
        step(&one, row);
    return 0;
}
