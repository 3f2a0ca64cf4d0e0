/* Generated from tangential/polach.py by tools/transpile_kernel.py; change that one.
 *
 * Polach's formula for one ellipse.
 *
 * O. Polach, A fast wheel-rail forces calculation computer code, Vehicle System Dynamics Supplement 33 (1999)
 * 728-739, without his reduction factors for wet rails.  With the semi-axes a along and b across, Kalker's
 * coefficients C_ij and
 *
 *     eta_c = eta + phi a where that is larger than eta, else eta;   s_c = sqrt(xi^2 + eta_c^2)
 *     C = sqrt((C11 xi)^2 + (C22 eta)^2) / sqrt(xi^2 + eta^2)
 *     e = pi a b G C s_c / (4 mu N)                                                              (P1)
 *     F = (2 mu N / pi) (e / (1 + e^2) + arctan e)                                               (P2)
 *
 * the force is F (xi, eta) / s_c against the slip, and the lateral force of spin
 *
 *     B = 1 + 6.3 (1 - exp(-a/b)),   e_s = (8/3) G b sqrt(ab) C23 s_c / (mu N B)                 (P3)
 *     K = e_s (d^3/3 - d^2/2 + 1/6) - (1 - d^2)^1.5 / 3,   d = (e_s^2 - 1) / (e_s^2 + 1)         (P4)
 *     F_s = (9/16) a mu N K B phi / s_c                                                          (P5)
 *
 * comes to it; K is negative.  Their sum is cut to mu N.  The formula knows neither a moment of spin nor a stick
 * zone.  For small creepages it is Kalker's linear theory: K = -(2/3) e_s.
 */

#include "polach.h"

/* Force and largest traction of a patch. */
static inline int64_t polach__solve_polach(array_double_1d work, array_double_1d tables, int64_t rolling)
{
    double a;
    double slip;
    double across;
    double whole;
    double first;
    double second;
    double third;
    double push;
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    slip = sqrt((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)));
    across = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) * a;
    if (fabs(across) < fabs((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y))))
    {
        across = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
    }
    whole = sqrt((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) + across * across);
    if (whole > polach__SMALLEST)
    {
        shapes__kalker_coefficients(&first, &second, &third, tables, (int64_t)((*cspan_at(&tables, layout__TABLES_ROLLING))), a / (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)));
        if (slip > polach__SMALLEST)
        {
            push = polach__creep_force(work, (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)), rolling, polach__mean_coefficient(work, rolling, first, second, slip), whole) / whole;
            (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) = (-push) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X));
            (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) = (-push) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y));
        }
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) += polach__spin_force(work, (*cspan_at(&tables, layout__TABLES_SHEAR_MODULUS)), rolling, third, whole);
        polach__cut_force(work, rolling);
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_MAX_SHEAR)) = polach__largest_shear(work, rolling);
    }
    return INT64_C(0);
}

/* Kalker's coefficient in the direction of the slip. */
static inline double polach__mean_coefficient(array_double_1d work, int64_t rolling, double first, double second, double slip)
{
    double along;
    double across;
    along = first * ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_X)) / slip);
    across = second * ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_CREEPAGE_Y)) / slip);
    return sqrt(along * along + across * across);
}

/* Magnitude of the force [N] of a slip ``whole``; eqs. (P1), (P2). */
static inline double polach__creep_force(array_double_1d work, double shear_modulus, int64_t rolling, double coefficient, double whole)
{
    double bound;
    double e;
    double share;
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    e = 0.25 * M_PI * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)) * shear_modulus * coefficient * whole / bound;
    share = atan(e);
    if (e < 1.0)
    {
        share += e / (1.0 + e * e);
    }
    else
    {
        share += 1.0 / (e + 1.0 / e);
    }
    return 2.0 / M_PI * bound * share;
}

/* Lateral force [N] of spin; eqs. (P3) to (P5). */
static inline double polach__spin_force(array_double_1d work, double shear_modulus, int64_t rolling, double coefficient, double whole)
{
    double a;
    double b;
    double bound;
    double wide;
    double e;
    double result;
    a = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH));
    b = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH));
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    wide = 1.0 + 6.3 * (1.0 - exp((-a) / b));
    e = 8.0 / 3.0 * shear_modulus * b * sqrt(a * b) * coefficient * whole / (bound * wide);
    result = 9.0 / 16.0 * a * bound * wide * polach__spin_share(e) * ((*cspan_at(&work, rolling + layout__ROLLING_PATCH_SPIN)) / whole);
    return result;
}

/* K of eq. (P4), written in c = 1 - d so that nothing cancels where e is large. */
static inline double polach__spin_share(double e)
{
    double c;
    double root;
    c = 2.0 / (1.0 + e * e);
    root = e * c;
    /* d^3/3 - d^2/2 + 1/6 = c^2/2 - c^3/3 */
    return 0.5 * e * c * c * (1.0 - 2.0 / 3.0 * c) - root * root * root / 3.0;
}

/* Let the force not exceed that of full slip. */
static inline int64_t polach__cut_force(array_double_1d work, int64_t rolling)
{
    double bound;
    double force;
    bound = (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FRICTION)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_LOAD));
    force = sqrt((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)));
    if (force > bound)
    {
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) *= bound / force;
        (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) *= bound / force;
    }
    return INT64_C(0);
}

/* The largest traction [Pa] where tractions are spread like the pressure of the ellipse. */
static inline double polach__largest_shear(array_double_1d work, int64_t rolling)
{
    double force;
    double result;
    force = sqrt((*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_X)) + (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_FORCE_Y)));
    result = 1.5 * force / (M_PI * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_LENGTH)) * (*cspan_at(&work, rolling + layout__ROLLING_PATCH_HALF_WIDTH)));
    return result;
}
