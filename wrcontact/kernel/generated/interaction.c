/* Generated from normal/interaction.py by tools/transpile_kernel.py; change that one.
 *
 * How the regions of one side press on each other: one half-space, planes of their own (docs/method.md,
 * (8.4)).
 */

#include "interaction.h"

/* Displacement of region ``one`` under one newton on region ``other`` [m/N].
 *
 * Boussinesq's 1 / (pi E* distance).  The distance includes the lengths of the patches along the track and
 * the lead of one region over the other.  The displacement counts by the cosine of the angle between the
 * planes.
 */
static inline double interaction__region_influence(array_double_1d work, array_double_1d tables, int64_t one, int64_t other)
{
    double distance;
    double lead;
    double squares;
    double apart;
    double result;
    distance = (*cspan_at(&work, one + layout__REGION_OFFSET)) + (*cspan_at(&work, one + layout__REGION_MIDDLE)) - (*cspan_at(&work, other + layout__REGION_OFFSET)) - (*cspan_at(&work, other + layout__REGION_MIDDLE));
    lead = interaction__region_lead(work, one, other);
    squares = (*cspan_at(&work, one + layout__REGION_SQUARE)) + (*cspan_at(&work, other + layout__REGION_SQUARE));
    apart = sqrt(distance * distance + lead * lead + interaction__ELONGATED * squares);
    result = 1.0 / (M_PI * (*cspan_at(&tables, layout__TABLES_CONTACT_MODULUS)) * apart);
    result *= interaction__planes_cosine(work, one, other);
    return result;
}

/* How far region ``one`` of a yawed wheel lies ahead of region ``other`` along the track [m]; 0 if their
 * planes form an angle of less than 15 degrees.
 *
 * A flange is 17 ... 31 mm ahead of the flange root and 7 mm beside it.  Between tread and flange root, 1
 * ... 3 mm in 10, the lead is left out: the upright patches (docs/method.md, section 9) do without it, and
 * the half-space agrees better.
 */
static inline double interaction__region_lead(array_double_1d work, int64_t one, int64_t other)
{
    double lead;
    lead = 0.0;
    if (interaction__planes_cosine(work, one, other) < interaction__INCLINED)
    {
        lead = (*cspan_at(&work, one + layout__REGION_X_TRACK)) - (*cspan_at(&work, other + layout__REGION_X_TRACK));
    }
    return lead;
}

/* Cosine of the angle between the planes of two regions [-]; 1 in one plane, not below 0. */
static inline double interaction__planes_cosine(array_double_1d work, int64_t one, int64_t other)
{
    double cosine;
    cosine = 1.0;
    if (((*cspan_at(&work, one + layout__REGION_OWN)) == 1.0) || ((*cspan_at(&work, other + layout__REGION_OWN)) == 1.0))
    {
        cosine = (*cspan_at(&work, one + layout__REGION_COS)) * (*cspan_at(&work, other + layout__REGION_COS)) + (*cspan_at(&work, one + layout__REGION_SIN)) * (*cspan_at(&work, other + layout__REGION_SIN));
        if (cosine < 0.0)
        {
            cosine = 0.0;
        }
    }
    return cosine;
}
