/* What the generated kernel needs of its surroundings: a span of doubles, and min, max, // and % as Python has them.
 *
 * The meaning is that of the Python source.  An index is not checked, except with -DWRCONTACT_CHECK_BOUNDS, where one
 * outside its span ends the program with a line on stderr.
 */
#ifndef WRCONTACT_SPANS_H
#define WRCONTACT_SPANS_H

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Not in strict C11. */
#ifndef M_PI
#define M_PI 3.14159265358979323846
#endif

/* No fused a*b + c, also where the flag -ffp-contract=off is forgotten: the results are those of the Python source. */
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__) && defined(__FP_FAST_FMA)
#pragma GCC optimize("fp-contract=off")
#elif defined(_MSC_VER)
#pragma fp_contract(off)
#endif

/* For functions that a usual step does not call, and for small ones in its innermost loops. */
#if defined(__GNUC__) || defined(__clang__)
#define OUT_OF_LINE __attribute__((noinline))
#define ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define OUT_OF_LINE
#define ALWAYS_INLINE inline
#endif

/* 'float[:]': an array that belongs to somebody else. */
typedef struct {
    double *data;
    int64_t shape[1];
} array_double_1d;

static inline array_double_1d span_of(double *data, int64_t length)
{
    array_double_1d span = {data, {length}};
    return span;
}

#ifdef WRCONTACT_CHECK_BOUNDS

#include <stdio.h>

static inline void span_check(bool inside, int64_t index, int64_t length, const char *function)
{
    if (!inside)
    {
        fprintf(stderr, "%s: index %lld is outside an array of %lld\n", function, (long long)index, (long long)length);
        abort();
    }
}

static inline double *span_checked_at(const array_double_1d *span, int64_t index, const char *function)
{
    span_check(0 <= index && index < span->shape[0], index, span->shape[0], function);
    return span->data + index;
}

#define AT(span, index) (*span_checked_at(&(span), (index), __func__))

#else

#define span_check(inside, index, length, function) ((void)0)
#define AT(span, index) ((span).data[index])

#endif

/* min(a, b) and max(a, b) as Python orders them: the first one unless the second is truly smaller, or larger. */
static inline double double_min(double a, double b) { return b < a ? b : a; }
static inline double double_max(double a, double b) { return b > a ? b : a; }
static inline int64_t int64_min(int64_t a, int64_t b) { return b < a ? b : a; }
static inline int64_t int64_max(int64_t a, int64_t b) { return b > a ? b : a; }

/* Bits of floats, as the Python source has them (elementary/binary.py). */
static ALWAYS_INLINE int64_t binary__exponent(double x)
{
    int64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits >> 52) - 1023;
}

static ALWAYS_INLINE double binary__power_of_two(int64_t k)
{
    const uint64_t bits = (uint64_t)(k + 1023) << 52;
    double power;
    memcpy(&power, &bits, sizeof power);
    return power;
}

static ALWAYS_INLINE int64_t binary__counted(double x)
{
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (int64_t)(uint32_t)bits;
}

/* Runs of numbers, as the Python source has them (elementary/runs.py). */
static ALWAYS_INLINE int64_t runs__copy_run(array_double_1d source, int64_t first, array_double_1d to,
                                            int64_t place, int64_t count)
{
    if (count > 0) {
        (void)AT(source, first + count - 1);
        (void)AT(to, place + count - 1);
        memcpy(&AT(to, place), &AT(source, first), (size_t)count * sizeof(double));
    }
    return count;
}

/* a // b and a % b of integers: rounded down, the remainder with the sign of b. */
static inline int64_t floor_div(int64_t a, int64_t b)
{
    return a / b - (a % b != 0 && (a < 0) != (b < 0));
}

static inline int64_t modulo(int64_t a, int64_t b)
{
    const int64_t rest = a % b;
    return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

#endif
