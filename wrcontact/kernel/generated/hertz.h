/* Generated from normal/hertz.py by tools/transpile_kernel.py; change that one.
 *
 * Hertz's coefficients and closed-form contact, through a table of exact values.
 *
 * With q the ratio of the short to the long semi-axis, K, E the complete elliptic integrals of modulus
 * sqrt(1 - q^2) and L^3 = 2 E / (pi q^2),
 *
 *     A > B (long across):   m = L q,  n = L,    r = 2 K / (pi L)
 *     A < B:                 m = L,    n = L q,  r the same
 *
 * so that the three combinations ANALYN needs are functions of ln(B/A) alone:
 *
 *     1 + alpha = (r / m^2)(1 + B/A),    1 + beta = (r / n^2)(1 + A/B),    n r
 *
 * and 1 + beta at ln(B/A) is 1 + alpha at ln(A/B).  The table holds quintics over uniform cells, exact to 1e-11
 * (kernel/binding/hertz_table.py).
 */

#ifndef WRCONTACT_KERNEL_HERTZ_H
#define WRCONTACT_KERNEL_HERTZ_H

#include "../native/spans.h"
#include "layout.h"
#include "table_cell.h"

static const double hertz__TILTED = 1e-12;
static const double hertz__STEEPEST = 0.3;

static inline double hertz__table_value(array_double_1d tables, int64_t table, int64_t column, double abscissa);
static inline int64_t hertz__hertz_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double A, double B);
static inline int64_t hertz__skewed_coefficients(double* result_0, double* result_1, double* result_2, array_double_1d tables, int64_t table, double A, double B, double slant);
static inline double hertz__middle_slant(array_double_1d tables, int64_t table, double A, double B, double slant);
static inline double hertz__hertz_stiffness(array_double_1d tables, int64_t table, double A, double B, double contact_modulus);

#endif
