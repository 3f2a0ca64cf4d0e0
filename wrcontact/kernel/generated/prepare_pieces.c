/* Generated from prepare/pieces.py by tools/transpile_kernel.py; change that one.
 *
 * From a definition to the table of quintic pieces, the record Profile.
 *
 * Each piece has the height, slope and second derivative of the exact definition at both ends. Joints of zones
 * are ends of pieces, so a jump of the curvature stays where the standard has it. Where the printed coefficients
 * leave a step in height (S1002: 3.7e-5 mm at y = -26 mm and 1.2e-4 mm at y = -35 mm), both sides are led to
 * their mean over REPAIR_WIDTH. Otherwise the contact would stay at an edge that no real wheel has.
 */

#include "prepare_pieces.h"

/* The quintic with given height, slope and second derivative at both ends, into
 * the piece at ``at`` [mm].
 *
 * Many arguments because the values at both ends come from one zone or are the mean of two.
 */
static inline int64_t prepare_pieces__write_quintic(array_double_1d tables, int64_t at, double low, double high, double z_low, double slope_low, double bend_low, double z_high, double slope_high, double bend_high)
{
    double h;
    double c2;
    double rest;
    double slope;
    double bend;
    double cube;
    h = high - low;
    c2 = 0.5 * bend_low;
    rest = z_high - (z_low + h * (slope_low + h * c2));
    slope = (slope_high - (slope_low + 2.0 * h * c2)) * h;
    bend = (bend_high - 2.0 * c2) * h * h;
    cube = h * h * h;
    (*cspan_at(&tables, at)) = low;
    (*cspan_at(&tables, at + INT64_C(1))) = z_low;
    (*cspan_at(&tables, at + INT64_C(2))) = slope_low;
    (*cspan_at(&tables, at + INT64_C(3))) = c2;
    (*cspan_at(&tables, at + INT64_C(4))) = (10.0 * rest - 4.0 * slope + 0.5 * bend) / cube;
    (*cspan_at(&tables, at + INT64_C(5))) = ((-15.0) * rest + 7.0 * slope - bend) / (cube * h);
    (*cspan_at(&tables, at + INT64_C(6))) = (6.0 * rest - 3.0 * slope + 0.5 * bend) / (cube * h * h);
    return INT64_C(0);
}

/* 1 if the piece at ``at`` follows the zone closely enough between ``low`` and ``high`` [mm], else 0. */
static inline int64_t prepare_pieces__follows_zone(array_double_1d tables, int64_t at, array_double_1d zones, int64_t row, double low, double high)
{
    double c0;
    double c1;
    double c2;
    double c3;
    double c4;
    double c5;
    double part;
    int64_t i;
    double y;
    double u;
    double z;
    double slope;
    double bend;
    double height;
    double own_bend;
    int64_t good;
    c0 = (*cspan_at(&tables, at + INT64_C(1)));
    c1 = (*cspan_at(&tables, at + INT64_C(2)));
    c2 = (*cspan_at(&tables, at + INT64_C(3)));
    c3 = (*cspan_at(&tables, at + INT64_C(4)));
    c4 = (*cspan_at(&tables, at + INT64_C(5)));
    c5 = (*cspan_at(&tables, at + INT64_C(6)));
    part = (high - low) / (double)(prepare_pieces__PARTS);
    good = INT64_C(1);
    for (i = INT64_C(1); i < prepare_pieces__PARTS; i += INT64_C(1))
    {
        y = (double)(i) * part + low;
        u = y - low;
        prepare_zones__zone_jet(&z, &slope, &bend, zones, row, y);
        height = ((((c5 * u + c4) * u + c3) * u + c2) * u + c1) * u + c0;
        own_bend = ((c5 * 20.0 * u + c4 * 12.0) * u + c3 * 6.0) * u + c2 * 2.0;
        if (!(fabs(height - z) <= prepare_pieces__PIECE_ERROR))
        {
            good = INT64_C(0);
        }
        if (!(fabs(own_bend - bend) / (1.0 + fabs(bend)) <= prepare_pieces__PIECE_BEND_ERROR))
        {
            good = INT64_C(0);
        }
    }
    return good;
}

/* Pieces between ``start`` and ``stop`` [mm], halved until they follow the zone; the
 * offset after them, or FULL.
 */
static inline int64_t prepare_pieces__write_refined(array_double_1d tables, int64_t at, array_double_1d zones, int64_t row, double start, double stop, array_double_1d work, int64_t scratch)
{
    double low;
    int64_t waiting;
    double high;
    double z_low;
    double slope_low;
    double bend_low;
    double z_high;
    double slope_high;
    double bend_high;
    low = start;
    waiting = INT64_C(1);
    (*cspan_at(&work, scratch)) = stop;
    while(waiting > INT64_C(0))
    {
        high = (*cspan_at(&work, scratch + waiting - INT64_C(1)));
        if (at + INT64_C(2) * layout__PIECE_SIZE > (int64_t)tables.shape[INT64_C(0)])
        {
            return prepare_pieces__FULL;
        }
        prepare_zones__zone_jet(&z_low, &slope_low, &bend_low, zones, row, low);
        prepare_zones__zone_jet(&z_high, &slope_high, &bend_high, zones, row, high);
        prepare_pieces__write_quintic(tables, at, low, high, z_low, slope_low, bend_low, z_high, slope_high, bend_high);
        if ((high - low < 2.0 * prepare_pieces__SHORTEST_PIECE) || (waiting == prepare_pieces__HALVINGS) || (prepare_pieces__follows_zone(tables, at, zones, row, low, high) == INT64_C(1)))
        {
            at += layout__PIECE_SIZE;
            low = high;
            waiting -= INT64_C(1);
        }
        else
        {
            (*cspan_at(&work, scratch + waiting)) = 0.5 * (low + high);
            waiting += INT64_C(1);
        }
    }
    return at;
}

/* 1 if the heights of two zones differ where the second starts, else 0. */
static inline int64_t prepare_pieces__steps(array_double_1d zones, int64_t before, int64_t after)
{
    double y;
    double z_before;
    double slope;
    double bend;
    double z_after;
    int64_t different;
    y = (*cspan_at(&zones, after + prepare_zones__ZONE_START));
    prepare_zones__zone_jet(&z_before, &slope, &bend, zones, before, y);
    prepare_zones__zone_jet(&z_after, &slope, &bend, zones, after, y);
    different = INT64_C(0);
    if (fabs(z_before - z_after) > prepare_pieces__REPAIRED_STEP)
    {
        different = INT64_C(1);
    }
    return different;
}

/* A piece that leads from the mean of two zones into the second, or from the first into the mean; the
 * offset after it, or FULL.
 */
static inline int64_t prepare_pieces__write_repair(array_double_1d tables, int64_t at, array_double_1d zones, int64_t before, int64_t after, double low, double high)
{
    double z_0;
    double slope_0;
    double bend_0;
    double z_1;
    double slope_1;
    double bend_1;
    double z_2;
    double slope_2;
    double bend_2;
    double z_3;
    double slope_3;
    double bend_3;
    if (at + INT64_C(2) * layout__PIECE_SIZE > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    prepare_zones__zone_jet(&z_0, &slope_0, &bend_0, zones, before, low);
    prepare_zones__zone_jet(&z_1, &slope_1, &bend_1, zones, before, high);
    prepare_zones__zone_jet(&z_2, &slope_2, &bend_2, zones, after, low);
    prepare_zones__zone_jet(&z_3, &slope_3, &bend_3, zones, after, high);
    if (low == (*cspan_at(&zones, after + prepare_zones__ZONE_START)))
    {
        prepare_pieces__write_quintic(tables, at, low, high, 0.5 * (z_0 + z_2), 0.5 * (slope_0 + slope_2), 0.5 * (bend_0 + bend_2), z_3, slope_3, bend_3);
    }
    else
    {
        prepare_pieces__write_quintic(tables, at, low, high, z_0, slope_0, bend_0, 0.5 * (z_1 + z_3), 0.5 * (slope_1 + slope_3), 0.5 * (bend_1 + bend_3));
    }
    return at + layout__PIECE_SIZE;
}

/* Pieces of zone ``index``; the offset after them, or FULL. */
static inline int64_t prepare_pieces__write_zone(array_double_1d tables, int64_t at, array_double_1d zones, int64_t base, int64_t index, array_double_1d work, int64_t scratch)
{
    int64_t size;
    int64_t row;
    double zone_start;
    double start;
    double stop;
    double inner;
    double last;
    int64_t repaired;
    int64_t count;
    double length;
    int64_t i;
    double high;
    size = (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_ROW)));
    row = base + prepare_zones__DEFINITION_ZONES + index * size;
    zone_start = (*cspan_at(&zones, row + prepare_zones__ZONE_START));
    start = zone_start;
    stop = (*cspan_at(&zones, row + prepare_zones__ZONE_STOP));
    if ((index > INT64_C(0)) && (prepare_pieces__steps(zones, row - size, row) == INT64_C(1)))
    {
        inner = double_min(2, start + prepare_pieces__REPAIR_WIDTH, 0.5 * (start + stop));
        at = prepare_pieces__write_repair(tables, at, zones, row - size, row, start, inner);
        start = inner;
    }
    last = stop;
    repaired = INT64_C(0);
    if ((index + INT64_C(1) < (int64_t)((*cspan_at(&zones, base + prepare_zones__DEFINITION_COUNT)))) && (prepare_pieces__steps(zones, row, row + size) == INT64_C(1)))
    {
        repaired = INT64_C(1);
        last = double_max(2, stop - prepare_pieces__REPAIR_WIDTH, 0.5 * (zone_start + stop));
    }
    if ((last > start) && (at != prepare_pieces__FULL))
    {
        count = (int64_t)((int64_t)ceil((last - start) / prepare_pieces__LONGEST_PIECE));
        length = (last - start) / (double)(count);
        for (i = INT64_C(0); i < count; i += INT64_C(1))
        {
            high = (double)(i + INT64_C(1)) * length + start;
            if (i + INT64_C(1) == count)
            {
                high = last;
            }
            if (at != prepare_pieces__FULL)
            {
                at = prepare_pieces__write_refined(tables, at, zones, row, (double)(i) * length + start, high, work, scratch);
            }
        }
    }
    if ((repaired == INT64_C(1)) && (at != prepare_pieces__FULL))
    {
        at = prepare_pieces__write_repair(tables, at, zones, row, row + size, last, stop);
    }
    return at;
}

/* The table of a definition at ``base``; the offset after it, or FULL.  ``nowhere`` is not a number. */
static inline int64_t prepare_pieces__write_profile(array_double_1d tables, int64_t base, array_double_1d zones, int64_t definition, double nowhere, array_double_1d work, int64_t scratch)
{
    int64_t count;
    double start;
    double stop;
    int64_t bins;
    int64_t profile;
    int64_t first;
    int64_t at;
    int64_t index;
    int64_t piece;
    int64_t i;
    double left;
    int64_t k;
    count = (int64_t)((*cspan_at(&zones, definition + prepare_zones__DEFINITION_COUNT)));
    start = (*cspan_at(&zones, definition + prepare_zones__DEFINITION_ZONES + prepare_zones__ZONE_START));
    stop = (*cspan_at(&zones, definition + prepare_zones__DEFINITION_ZONES + (count - INT64_C(1)) * (int64_t)((*cspan_at(&zones, definition + prepare_zones__DEFINITION_ROW))) + prepare_zones__ZONE_STOP));
    bins = (int64_t)((int64_t)ceil((stop - start) / prepare_pieces__BIN_WIDTH));
    profile = base;
    first = profile + layout__PROFILE_BINS + bins;
    at = first;
    if (first + layout__PIECE_SIZE > (int64_t)tables.shape[INT64_C(0)])
    {
        return prepare_pieces__FULL;
    }
    for (index = INT64_C(0); index < count; index += INT64_C(1))
    {
        if (at != prepare_pieces__FULL)
        {
            at = prepare_pieces__write_zone(tables, at, zones, definition, index, work, scratch);
        }
    }
    if (at == prepare_pieces__FULL)
    {
        return prepare_pieces__FULL;
    }
    (*cspan_at(&tables, profile + layout__PROFILE_START)) = start * prepare_pieces__MM;
    (*cspan_at(&tables, profile + layout__PROFILE_STOP)) = stop * prepare_pieces__MM;
    (*cspan_at(&tables, profile + layout__PROFILE_BINS_PER_METRE)) = prepare_pieces__BINS_EACH_METRE;
    (*cspan_at(&tables, profile + layout__PROFILE_BIN_COUNT)) = (double)(bins);
    (*cspan_at(&tables, profile + layout__PROFILE_PIECES)) = (double)(first - base);
    piece = first;
    for (i = INT64_C(0); i < bins; i += INT64_C(1))
    {
        left = start + prepare_pieces__BIN_WIDTH * (double)(i);
        while((piece + layout__PIECE_SIZE < at) && ((*cspan_at(&tables, piece + layout__PIECE_SIZE)) <= left))
        {
            piece += layout__PIECE_SIZE;
        }
        (*cspan_at(&tables, profile + layout__PROFILE_BINS + i)) = (double)(piece - base);
    }
    prepare_pieces__to_metres(tables, first, at);
    for (k = INT64_C(0); k < layout__PIECE_SIZE; k += INT64_C(1))
    {
        (*cspan_at(&tables, at + k)) = nowhere;
    }
    return at + layout__PIECE_SIZE;
}

/* Pieces from millimetres to metres. */
static inline int64_t prepare_pieces__to_metres(array_double_1d tables, int64_t first, int64_t end)
{
    int64_t at;
    at = first;
    while(at < end)
    {
        (*cspan_at(&tables, at)) = (*cspan_at(&tables, at)) * prepare_pieces__MM;
        (*cspan_at(&tables, at + INT64_C(1))) = (*cspan_at(&tables, at + INT64_C(1))) * prepare_pieces__MM;
        (*cspan_at(&tables, at + INT64_C(3))) = (*cspan_at(&tables, at + INT64_C(3))) * prepare_pieces__SCALE_2;
        (*cspan_at(&tables, at + INT64_C(4))) = (*cspan_at(&tables, at + INT64_C(4))) * prepare_pieces__SCALE_3;
        (*cspan_at(&tables, at + INT64_C(5))) = (*cspan_at(&tables, at + INT64_C(5))) * prepare_pieces__SCALE_4;
        (*cspan_at(&tables, at + INT64_C(6))) = (*cspan_at(&tables, at + INT64_C(6))) * prepare_pieces__SCALE_5;
        at += layout__PIECE_SIZE;
    }
    return INT64_C(0);
}
