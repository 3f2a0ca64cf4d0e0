/* Generated from prepare/pieces.py by tools/transpile_kernel.py; change that one.
 *
 * From a definition to the table of quintic pieces, the record Profile.
 *
 * Each piece has the height, slope and second derivative of the exact definition at both ends. Joints of zones
 * are ends of pieces, so a jump of the curvature stays where the standard has it. Where the printed coefficients
 * leave a step in height (S1002: 3.7e-5 mm at y = -26 mm and 1.2e-4 mm at y = -35 mm), both sides are led to
 * their mean over REPAIR_WIDTH. Otherwise the contact would stay at an edge that no real wheel has.
 */

#ifndef WRCONTACT_KERNEL_PREPARE_PIECES_H
#define WRCONTACT_KERNEL_PREPARE_PIECES_H

#include "../native/spans.h"
#include "layout.h"
#include "prepare_zones.h"

static const double prepare_pieces__PIECE_ERROR = 1e-09;
static const double prepare_pieces__PIECE_BEND_ERROR = 1e-07;
static const double prepare_pieces__LONGEST_PIECE = 1.0;
static const double prepare_pieces__SHORTEST_PIECE = 0.001;
static const double prepare_pieces__REPAIR_WIDTH = 0.5;
static const double prepare_pieces__REPAIRED_STEP = 1e-06;
static const double prepare_pieces__BIN_WIDTH = 0.03125;
static const double prepare_pieces__BINS_EACH_METRE = 32000.0;
static const double prepare_pieces__MM = 0.001;
static const double prepare_pieces__SCALE_2 = 1000.0;
static const double prepare_pieces__SCALE_3 = 1000000.0;
static const double prepare_pieces__SCALE_4 = 999999999.9999999;
static const double prepare_pieces__SCALE_5 = 999999999999.9999;
static const int64_t prepare_pieces__PARTS = INT64_C(10);
static const int64_t prepare_pieces__HALVINGS = INT64_C(24);
static const int64_t prepare_pieces__FULL = INT64_C(-1);

static inline int64_t prepare_pieces__write_quintic(array_double_1d tables, int64_t at, double low, double high, double z_low, double slope_low, double bend_low, double z_high, double slope_high, double bend_high);
static inline int64_t prepare_pieces__follows_zone(array_double_1d tables, int64_t at, array_double_1d zones, int64_t row, double low, double high);
static inline int64_t prepare_pieces__write_refined(array_double_1d tables, int64_t at, array_double_1d zones, int64_t row, double start, double stop, array_double_1d work, int64_t scratch);
static inline int64_t prepare_pieces__steps(array_double_1d zones, int64_t before, int64_t after);
static inline int64_t prepare_pieces__write_repair(array_double_1d tables, int64_t at, array_double_1d zones, int64_t before, int64_t after, double low, double high);
static inline int64_t prepare_pieces__write_zone(array_double_1d tables, int64_t at, array_double_1d zones, int64_t base, int64_t index, array_double_1d work, int64_t scratch);
static inline int64_t prepare_pieces__to_metres(array_double_1d tables, int64_t first, int64_t end);
static inline int64_t prepare_pieces__write_profile(array_double_1d tables, int64_t base, array_double_1d zones, int64_t definition, double nowhere, array_double_1d work, int64_t scratch);

#endif
