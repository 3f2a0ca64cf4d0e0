/* Rates along several directions at once: a pass of the differentiated kernel carries WRCONTACT_LANES rates beside every value.
 *
 * The values are computed once for all directions, and the rates two by two, where the compiler has vectors of two numbers.
 */
#ifndef WRCONTACT_LANES_H
#define WRCONTACT_LANES_H

#include "spans.h"

#if WRCONTACT_LANES == 1
typedef double lanes, lane;
#define EACH_LANE
#define each(rates) (rates)
#else
#if defined(__GNUC__) || defined(__clang__)
typedef double lane __attribute__((vector_size(16), aligned(8)));
#define LANE_WIDTH 2
#else
typedef double lane;
#define LANE_WIDTH 1
#endif
typedef struct {
    lane part[WRCONTACT_LANES / LANE_WIDTH];
} lanes;
/* Before a statement on rates, in which each(...) stands around every one of them. */
#if defined(__GNUC__) && !defined(__clang__)
#define UNROLLED _Pragma("GCC unroll 8")                /* at -O2, too */
#else
#define UNROLLED
#endif
#define EACH_LANE UNROLLED for (int lane_ = 0; lane_ < WRCONTACT_LANES / LANE_WIDTH; lane_ += 1)
#define each(rates) ((rates).part[lane_])
#endif

/* Rates of an array. */
typedef struct {
    lanes *data;
    int64_t shape[1];
} array_lanes_1d;

#ifdef WRCONTACT_CHECK_BOUNDS
static inline lanes *lanes_checked_at(const array_lanes_1d *span, int64_t index, const char *function)
{
    span_check(0 <= index && index < span->shape[0], index, span->shape[0], function);
    return span->data + index;
}
#define RATE_AT(span, index) (*lanes_checked_at(&(span), (index), __func__))
#else
#define RATE_AT(span, index) ((span).data[index])
#endif

/* The rate along direction `k`. */
static ALWAYS_INLINE double *lane_at(lanes *rates, int64_t k)
{
    return (double *)rates + k;
}

/* The same rate along all directions. */
static ALWAYS_INLINE lanes all_lanes(double rate)
{
    lanes rates;
    for (int k = 0; k < WRCONTACT_LANES; k += 1)
        *lane_at(&rates, k) = rate;
    return rates;
}

/* Rate of a square root whose argument changes by `rate`; 0 where the root is 0. */
static ALWAYS_INLINE lane derivative_rates__root_rate(double root, lane rate)
{
    return root != 0.0 ? 0.5 * rate / root : (lane){0.0};
}

/* Rate of the size of a value. */
static ALWAYS_INLINE lane derivative_rates__size_rate(double value, lane rate)
{
    return value < 0.0 ? -rate : rate;
}

/* Whether anything moves along a direction. */
static ALWAYS_INLINE bool derivative_rates__nonzero(lanes rates)
{
    bool found = false;
    for (int k = 0; k < WRCONTACT_LANES; k += 1)
        found = found || *lane_at(&rates, k) != 0.0;
    return found;
}

/* A rate that is the same along all directions. */
static ALWAYS_INLINE double derivative_rates__common_rate(lanes rates)
{
    return *lane_at(&rates, 0);
}

#endif
