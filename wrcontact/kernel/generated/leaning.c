/* Generated from wheelset/leaning.py by tools/transpile_kernel.py; change that one.
 *
 * Rails that are rolled: the place of a wheelset over them holds for one vertical shift (surface/rails.py),
 * which is found together with the contact.
 *
 * The residual, how much lower the contact is found than the reference, falls at a rate of nearly one as the
 * reference rises. So the secant finds its root in three or four contacts.
 *
 * Where a wheel is about to pass from one place to another, as from the flange root to the flange, the contact
 * falls faster than the reference rises, or jumps, and the secant wanders. Then the root is enclosed about the
 * first contact and halved, so that rounding does not decide which of several is found. If it is a jump, no
 * height is its own reference, and the end with the smaller residual is the answer: its wheels touch as if the
 * wheelset were shifted by the residual times the sine of the rail's roll.
 */

#include "leaning.h"

/* Let ``height`` [m] be the reference of both sides when they are next placed. */
static inline int64_t leaning__set_reference(array_double_1d work, double height)
{
    (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height;
    (*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_REFERENCE)) = height;
    return INT64_C(0);
}

/* 1 if a rail below the placed wheelset is rolled, else 0. */
static inline int64_t leaning__is_leaning(array_double_1d work)
{
    int64_t leaning;
    leaning = INT64_C(0);
    if ((*cspan_at(&work, layout__WORK_SIDES + layout__SIDE_SEARCH_SIZE * INT64_C(1) + layout__SIDE_SEARCH_PLACE + layout__PLACE_LEANING)) == 1.0)
    {
        leaning = INT64_C(1);
    }
    return leaning;
}

/* Begin with the reference ``height`` [m], for which the contact was ``found``. */
static inline int64_t leaning__open_reference(array_double_1d work, double height, double found)
{
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_RESIDUAL)) = found - height;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_SLOPE)) = -1.0;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) = 1.0;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_LOW)) = found - leaning__FARTHEST;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_LOW)) = leaning__UNKNOWN;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_HIGH)) = found + leaning__FARTHEST;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_HIGH)) = -leaning__UNKNOWN;
    return INT64_C(0);
}

/* Where the residual vanishes by its last value and slope [m]; after many contacts the middle of what
 * encloses it, and at last the better end.
 */
static inline double leaning__next_reference(array_double_1d work, double met)
{
    double height;
    height = (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_HEIGHT)) - (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_RESIDUAL)) / (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_SLOPE));
    if ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) > leaning__SECANTS)
    {
        height = 0.5 * ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_LOW)) + (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_HIGH)));
        if ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_HIGH)) - (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_LOW)) < met)
        {
            height = (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_LOW)) - leaning__BESIDE;
            if (fabs((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_HIGH))) < fabs((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_LOW))))
            {
                height = (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_HIGH)) + leaning__BESIDE;
            }
        }
    }
    return height;
}

/* Note that for the reference ``height`` the contact was ``found`` [m]; 1 if that is the same to ``met``,
 * or the better end of a jump, else 0.
 */
static inline int64_t leaning__note_reference(array_double_1d work, double height, double found, double met)
{
    double residual;
    double slope;
    int64_t near;
    residual = found - height;
    near = INT64_C(0);
    if (fabs(residual) < met)
    {
        near = INT64_C(1);
    }
    else if (((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) > leaning__SECANTS) && ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_HIGH)) - (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_LOW)) < met))
    {
        if (((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_LOW)) < leaning__UNKNOWN) && ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN + layout__BRACKET_AT_HIGH)) > -leaning__UNKNOWN))
        {
            near = INT64_C(1);
        }
    }
    else if (height != (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_HEIGHT)))
    {
        slope = (residual - (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_RESIDUAL))) / (height - (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_HEIGHT)));
        (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_SLOPE)) = -1.0;
        if ((slope > leaning__STEEPEST_FALL) && (slope < leaning__FLATTEST_FALL))
        {
            (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_SLOPE)) = slope;
        }
    }
    if ((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) > leaning__SECANTS)
    {
        brackets__narrow_bracket(work, layout__WORK_REFERENCE + layout__REFERENCE_WITHIN, height, residual);
    }
    else if (fabs(residual) > leaning__NEARER * fabs((*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_RESIDUAL))))
    {
        (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) = leaning__SECANTS;
    }
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_HEIGHT)) = height;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_RESIDUAL)) = residual;
    (*cspan_at(&work, layout__WORK_REFERENCE + layout__REFERENCE_CONTACTS)) += 1.0;
    return near;
}
