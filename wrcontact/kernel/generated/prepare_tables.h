/* Generated from prepare/tables.py by tools/transpile_kernel.py; change that one.
 *
 * The array that the kernel reads, from definitions of the profiles and the parameters: what ContactSystem
 * and the native FMU do at the start, outside the hot unit.
 *
 * The recipe, for each side: place the rail, cut the wheel, compile both, and lay the tables one after the
 * other (``prepare``); one array serves both sides where they are equal. Then the kernel itself fills the table
 * of starts of the right side (``start_shift`` and ``note_start``), and last come the methods
 * (``write_methods``).
 */

#ifndef WRCONTACT_KERNEL_PREPARE_TABLES_H
#define WRCONTACT_KERNEL_PREPARE_TABLES_H

#include "../native/spans.h"
#include "layout.h"
#include "prepare_arcs.h"
#include "prepare_curvatures.h"
#include "prepare_fixed.h"
#include "prepare_pieces.h"
#include "prepare_placement.h"
#include "prepare_scan.h"
#include "prepare_zones.h"

static const int64_t prepare_tables__PREPARED = INT64_C(0);
static const int64_t prepare_tables__TABLES_FULL = INT64_C(1);
static const int64_t prepare_tables__GAUGE_TOO_DEEP = INT64_C(2);
static const int64_t prepare_tables__WITHOUT_HEAD = INT64_C(3);
static const int64_t prepare_tables__WHEEL_TOO_WIDE = INT64_C(4);
static const int64_t prepare_tables__REPORT_SIZE = INT64_C(0);
static const int64_t prepare_tables__REPORT_DEEPEST = INT64_C(1);
static const int64_t prepare_tables__REPORT_WIDTH = INT64_C(2);
static const int64_t prepare_tables__REPORT_DEPTH = INT64_C(3);
static const int64_t prepare_tables__REPORT_COUNT = INT64_C(4);
static const double prepare_tables__START_STEP = 0.0005;
static const double prepare_tables__STARTS_EACH_METRE = 2000.0;

static inline int64_t prepare_tables__copy_definition(array_double_1d definition, array_double_1d work, int64_t at);
static inline int64_t prepare_tables__place_zones(array_double_1d setup, array_double_1d work, int64_t wheel, int64_t rail, array_double_1d tables, array_double_1d report);
static inline int64_t prepare_tables__write_settings(array_double_1d setup, array_double_1d tables);
static inline int64_t prepare_tables__write_methods(array_double_1d setup, array_double_1d tables);
static inline int64_t prepare_tables__append_starts(array_double_1d tables, int64_t at);
static inline int64_t prepare_tables__prepare(array_double_1d setup, array_double_1d wheel_definition, array_double_1d rail_definition, array_double_1d fixed, array_double_1d tables, array_double_1d work, array_double_1d report);
static inline double prepare_tables__start_shift(array_double_1d tables, int64_t row);
static inline int64_t prepare_tables__note_start(array_double_1d work, array_double_1d tables, int64_t row, int64_t status);
static inline int64_t prepare_tables__mirror_starts(array_double_1d tables);
static inline int64_t prepare_tables__open_starts(array_double_1d tables, int64_t equal);

#endif
