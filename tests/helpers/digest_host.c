/* Prepares tables and steps through poses, as digests.py asks, and writes all that the kernel has computed.
 *
 *     digest_host <plan> <answer>
 *
 * Both are files of float64 in the machine's order.  The plan is, for each case, the lengths of the arrays of
 * wrcontact_preparation but for the workspace, the count of poses, the numbers of a row of outputs and the count of
 * derivatives; then the arrays but for the tables, and the rows of inputs.  The answer is, for each case, the length of the
 * preparation, the tables, the rows of outputs, the statuses, and the rates of the first poses.
 */
#include <stdio.h>
#include <stdlib.h>

#include "kernel/generated/constants.h"
#include "kernel/native/wrcontact_derivative.h"
#include "kernel/native/wrcontact_prepare.h"

static FILE *plan, *answer;

static array_double_1d zeros(int64_t count)
{
    double *memory = calloc((size_t)count + 1, sizeof *memory);
    if (!memory)
        exit(2);
    return span_of(memory, count);
}

static array_double_1d given(int64_t count)
{
    array_double_1d found = zeros(count);
    if (fread(found.data, sizeof *found.data, (size_t)count, plan) != (size_t)count)
        exit(3);
    return found;
}

static void write(array_double_1d values, int64_t count)
{
    if (fwrite(values.data, sizeof *values.data, (size_t)count, answer) != (size_t)count)
        exit(4);
    free(values.data);
}

static void run_case(const double *sizes)
{
    const int64_t count = (int64_t)sizes[7], row = (int64_t)sizes[8], derivatives = (int64_t)sizes[9];
    wrcontact_preparation p;
    array_double_1d *parts[] = {&p.setup, &p.wheel, &p.rail, &p.left_wheel, &p.left_rail, &p.fixed};
    for (int i = 0; i < 6; i += 1)
        *parts[i] = given((int64_t)sizes[i]);
    p.tables = zeros((int64_t)sizes[6]);
    p.work = zeros(0);
    p.work = zeros(wrcontact_prepare_room(&p));
    array_double_1d inputs = given(count * layout__INPUT_COUNT), outputs = zeros(count * row), statuses = zeros(count);
    array_double_1d length = zeros(1), rates = zeros(derivatives * row), seed = zeros(layout__INPUT_COUNT);
    const int64_t used = wrcontact_prepare(&p);
    length.data[0] = (double)used;
    const wrcontact_handle handle = {p.tables, zeros(layout__STATE_SIZE), zeros(layout__WORK_SIZE),
                                     zeros(layout__INPUT_COUNT), zeros(row)};
    wrcontact_step_many(&handle, count, inputs.data, outputs.data, statuses.data);
    double *room = zeros(wrcontact_derivative_room()).data;
    for (int64_t i = 0; i < layout__INPUT_COUNT; i += 1)
        seed.data[i] = layout__INPUT_NOMINALS[i];
    for (int64_t k = 0; k < derivatives; k += 1)
    {
        for (int64_t i = 0; i < layout__INPUT_COUNT; i += 1)
            handle.inputs.data[i] = inputs.data[k * layout__INPUT_COUNT + i];
        wrcontact_derivative(&handle, seed.data, rates.data + k * row, room);
    }
    write(length, 1);
    write(p.tables, used > 0 ? used : 0);
    write(outputs, count * row);
    write(statuses, count);
    write(rates, derivatives * row);
}

int main(int count, char **words)
{
    double sizes[10];
    plan = count == 3 ? fopen(words[1], "rb") : NULL;
    answer = count == 3 ? fopen(words[2], "wb") : NULL;
    if (!plan || !answer)
        return 1;
    while (fread(sizes, sizeof *sizes, 10, plan) == 10)
        run_case(sizes);
    return fclose(answer) ? 5 : 0;
}
