/* The kernel's elementary functions, for pairs of arguments: rows of two numbers in, rows of WIDTH results out. */
#include "kernel/generated/elementary.c"

void elementary(const double *pairs, double *results, int64_t count)
{
    for (int64_t i = 0; i < count; i += 1)
    {
        const double x = pairs[2 * i], y = pairs[2 * i + 1];
        double *row = results + 7 * i;
        circle__sine_cosine(row, row + 1, x);
        row[2] = circle__atan(x);
        row[3] = circle__atan2(x, y);
        row[4] = powers__exp(x);
        row[5] = powers__log(x);
        row[6] = powers__cube_root(x);
    }
}
