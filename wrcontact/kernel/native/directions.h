/* Rates along several directions at once: a pass of the differentiated kernel carries WRCONTACT_DIRECTIONS rates beside every value.
 *
 * The values are computed once for all directions, and the rates two by two, where the compiler has vectors of two numbers.
 */
#ifndef WRCONTACT_DIRECTIONS_H
#define WRCONTACT_DIRECTIONS_H

#include "spans.h"

#if WRCONTACT_DIRECTIONS == 1
typedef double directional_rate, rate_vector;
#define EACH_DIRECTION
#define each(rates) (rates)
#else
/* A rate_vector is what one arithmetic instruction takes: the rates along VECTOR_WIDTH directions. */
#if defined(__GNUC__) || defined(__clang__)
typedef double rate_vector __attribute__((vector_size(16), aligned(8)));
#define VECTOR_WIDTH 2
#else
typedef double rate_vector;
#define VECTOR_WIDTH 1
#endif
typedef struct {
    rate_vector part[WRCONTACT_DIRECTIONS / VECTOR_WIDTH];
} directional_rate;
/* Before a statement on rates, in which each(...) stands around every one of them. */
#if defined(__GNUC__) && !defined(__clang__)
#define UNROLLED _Pragma("GCC unroll 8")                /* at -O2, too */
#else
#define UNROLLED
#endif
#define EACH_DIRECTION UNROLLED for (int vector_ = 0; vector_ < WRCONTACT_DIRECTIONS / VECTOR_WIDTH; vector_ += 1)
#define each(rates) ((rates).part[vector_])
#endif

/* Rates of an array. */
typedef struct {
    directional_rate *data;
    int64_t shape[1];
} array_directional_rate_1d;

#ifdef WRCONTACT_CHECK_BOUNDS
static inline directional_rate *rate_checked_at(const array_directional_rate_1d *span, int64_t index, const char *function)
{
    span_check(0 <= index && index < span->shape[0], index, span->shape[0], function);
    return span->data + index;
}
#define RATE_AT(span, index) (*rate_checked_at(&(span), (index), __func__))
#else
#define RATE_AT(span, index) ((span).data[index])
#endif

/* The rate along direction `k`. */
static ALWAYS_INLINE double *rate_along(directional_rate *rates, int64_t k)
{
    return (double *)rates + k;
}

/* The same rate along all directions. */
static ALWAYS_INLINE directional_rate along_all(double rate)
{
    directional_rate rates;
    for (int k = 0; k < WRCONTACT_DIRECTIONS; k += 1)
        *rate_along(&rates, k) = rate;
    return rates;
}

/* Rate of a square root whose argument changes by `rate`; 0 where the root is 0. */
static ALWAYS_INLINE rate_vector derivative_rates__root_rate(double root, rate_vector rate)
{
    return root != 0.0 ? 0.5 * rate / root : (rate_vector){0.0};
}

/* Rate of the size of a value. */
static ALWAYS_INLINE rate_vector derivative_rates__size_rate(double value, rate_vector rate)
{
    return value < 0.0 ? -rate : rate;
}

/* Whether anything moves along a direction. */
static ALWAYS_INLINE bool derivative_rates__nonzero(directional_rate rates)
{
    bool found = false;
    for (int k = 0; k < WRCONTACT_DIRECTIONS; k += 1)
        found = found || *rate_along(&rates, k) != 0.0;
    return found;
}

/* A rate that is the same along all directions. */
static ALWAYS_INLINE double derivative_rates__common_rate(directional_rate rates)
{
    return *rate_along(&rates, 0);
}

#endif
