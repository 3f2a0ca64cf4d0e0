/* Generated from layout.py by tools/transpile_kernel.py; change that one.
 *
 * Named offsets into the kernel's arrays; the only place where they are numbers.
 *
 * ``inputs``  what moves: the pose and the load of one wheelset.
 * ``outputs`` what comes back: wheelset block, then left block, then right block, in the order of the FMU's variables.
 */

#ifndef WRCONTACT_KERNEL_LAYOUT_H
#define WRCONTACT_KERNEL_LAYOUT_H

#include "../native/spans.h"

static const int64_t layout__IN_LATERAL_SHIFT = INT64_C(0);
static const int64_t layout__IN_YAW = INT64_C(1);
static const int64_t layout__IN_ROLL_GUESS = INT64_C(2);
static const int64_t layout__IN_NORMAL_FORCE = INT64_C(3);
static const int64_t layout__IN_LOAD_TRANSFER = INT64_C(4);
static const int64_t layout__INPUT_COUNT = INT64_C(5);
static const int64_t layout__OUT_ROLL = INT64_C(0);
static const int64_t layout__OUT_VERTICAL_SHIFT = INT64_C(1);
static const int64_t layout__OUT_LEFT = INT64_C(2);
static const int64_t layout__OUT_RIGHT = INT64_C(136);
static const int64_t layout__OUTPUT_COUNT = INT64_C(270);
static const int64_t layout__SIDE_PATCH_COUNT = INT64_C(0);
static const int64_t layout__SIDE_X_WHEEL = INT64_C(1);
static const int64_t layout__SIDE_Y_WHEEL = INT64_C(2);
static const int64_t layout__SIDE_Z_WHEEL = INT64_C(3);
static const int64_t layout__SIDE_Y_RAIL = INT64_C(4);
static const int64_t layout__SIDE_Z_RAIL = INT64_C(5);
static const int64_t layout__SIDE_X_TRACK = INT64_C(6);
static const int64_t layout__SIDE_Y_TRACK = INT64_C(7);
static const int64_t layout__SIDE_Z_TRACK = INT64_C(8);
static const int64_t layout__SIDE_CONTACT_ANGLE = INT64_C(9);
static const int64_t layout__SIDE_ROLLING_RADIUS = INT64_C(10);
static const int64_t layout__SIDE_CURVATURE_X = INT64_C(11);
static const int64_t layout__SIDE_CURVATURE_Y = INT64_C(12);
static const int64_t layout__SIDE_PENETRATION = INT64_C(13);
static const int64_t layout__SIDE_NORMAL_FORCE = INT64_C(14);
static const int64_t layout__SIDE_AREA = INT64_C(15);
static const int64_t layout__SIDE_MAX_PRESSURE = INT64_C(16);
static const int64_t layout__SIDE_PATCH_LENGTH = INT64_C(17);
static const int64_t layout__SIDE_PATCH_WIDTH = INT64_C(18);
static const int64_t layout__SIDE_PATCH_CENTROID = INT64_C(19);
static const int64_t layout__SIDE_PATCH = INT64_C(20);
static const int64_t layout__SIDE_STATION = INT64_C(41);
static const int64_t layout__SIDE_HALF_LENGTH = INT64_C(72);
static const int64_t layout__SIDE_PRESSURE = INT64_C(103);
static const int64_t layout__SIDE_SIZE = INT64_C(134);
static const int64_t layout__PATCH_NORMAL_FORCE = INT64_C(0);
static const int64_t layout__PATCH_AREA = INT64_C(1);
static const int64_t layout__PATCH_MAX_PRESSURE = INT64_C(2);
static const int64_t layout__PATCH_LENGTH = INT64_C(3);
static const int64_t layout__PATCH_WIDTH = INT64_C(4);
static const int64_t layout__PATCH_CENTROID = INT64_C(5);
static const int64_t layout__PATCH_CONTACT_ANGLE = INT64_C(6);
static const int64_t layout__PATCH_SIZE = INT64_C(7);
static const int64_t layout__PATCH_LIMIT = INT64_C(3);
static const int64_t layout__STATION_COUNT = INT64_C(31);
static const int64_t layout__SET_RADIUS = INT64_C(0);
static const int64_t layout__SET_ARM = INT64_C(1);
static const int64_t layout__SET_RAIL_Y = INT64_C(2);
static const int64_t layout__SET_CONTACT_MODULUS = INT64_C(3);
static const int64_t layout__SET_LATERAL_LIMIT = INT64_C(4);
static const int64_t layout__SET_YAW_LIMIT = INT64_C(5);
static const int64_t layout__SET_WHEEL = INT64_C(6);
static const int64_t layout__SET_RAIL = INT64_C(7);
static const int64_t layout__SET_SCAN = INT64_C(8);
static const int64_t layout__SET_HERTZ = INT64_C(9);
static const int64_t layout__SET_NORMAL_MODEL = INT64_C(10);
static const int64_t layout__SET_LONGITUDINAL = INT64_C(11);
static const int64_t layout__SET_PENETRATION_LEFT = INT64_C(12);
static const int64_t layout__SET_PENETRATION_RIGHT = INT64_C(13);
static const int64_t layout__SET_NODES = INT64_C(14);
static const int64_t layout__SET_STRIDE = INT64_C(15);
static const int64_t layout__SET_STRIPS = INT64_C(16);
static const int64_t layout__SET_SWEEPS = INT64_C(17);
static const int64_t layout__SET_INFLUENCE = INT64_C(18);
static const int64_t layout__SET_STARTS = INT64_C(19);
static const int64_t layout__SET_SIDES = INT64_C(20);
static const int64_t layout__SET_DEPTH = INT64_C(21);
static const int64_t layout__SET_ABSENT = INT64_C(22);
static const int64_t layout__SETTING_COUNT = INT64_C(24);
static const int64_t layout__MODEL_HERTZ = INT64_C(0);
static const int64_t layout__MODEL_ANALYN = INT64_C(1);
static const int64_t layout__MODEL_ANALYN_STRIP = INT64_C(2);
static const int64_t layout__SIDES_BOTH = INT64_C(0);
static const int64_t layout__SIDES_LEFT = INT64_C(1);
static const int64_t layout__SIDES_RIGHT = INT64_C(2);
static const int64_t layout__DEPTH_GEOMETRY = INT64_C(0);
static const int64_t layout__DEPTH_PATCHES = INT64_C(1);
static const int64_t layout__DEPTH_ALL = INT64_C(2);
static const int64_t layout__LONGITUDINAL_EFFECTIVE = INT64_C(0);
static const int64_t layout__LONGITUDINAL_BASIC = INT64_C(1);
static const int64_t layout__STATE_ROLL = INT64_C(0);
static const int64_t layout__STATE_WARM = INT64_C(1);
static const int64_t layout__STATE_GAP_COUNT = INT64_C(2);
static const int64_t layout__STATE_SCAN_COUNT = INT64_C(3);
static const int64_t layout__STATE_ROLL_COUNT = INT64_C(4);
static const int64_t layout__STATE_NODE_COUNT = INT64_C(5);
static const int64_t layout__STATE_SOLVE_COUNT = INT64_C(6);
static const int64_t layout__STATE_Y_LEFT = INT64_C(7);
static const int64_t layout__STATE_Y_RIGHT = INT64_C(8);
static const int64_t layout__STATE_SHIFT = INT64_C(9);
static const int64_t layout__STATE_STRIP_COUNT = INT64_C(10);
static const int64_t layout__STATE_SIZE = INT64_C(11);
static const int64_t layout__VALID = INT64_C(0);
static const int64_t layout__UNLOADED = INT64_C(1);
static const int64_t layout__OFF_PROFILE = INT64_C(2);
static const int64_t layout__NOT_CONVERGED = INT64_C(3);
static const int64_t layout__INVALID_INPUT = INT64_C(4);
static const int64_t layout__SCAN_LIMIT = INT64_C(400);
static const int64_t layout__REGION_LIMIT = INT64_C(3);
static const int64_t layout__REGION_BLOCK = INT64_C(32);
static const int64_t layout__NODE_FIELDS = INT64_C(9);
static const int64_t layout__NODE_LIMIT = INT64_C(256);
static const int64_t layout__NODE_MIDDLE = INT64_C(128);
static const int64_t layout__PLACE_BLOCK = INT64_C(16);
static const int64_t layout__SIDE_BLOCK = INT64_C(400);
static const int64_t layout__CONTACT_BLOCK = INT64_C(32);
static const int64_t layout__ISLAND_BLOCK = INT64_C(80);
static const int64_t layout__STRIP_FIELDS = INT64_C(16);
static const int64_t layout__STRIP_LIMIT = INT64_C(104);
static const int64_t layout__WORK_INPUTS = INT64_C(0);
static const int64_t layout__WORK_KNOWN = INT64_C(6);
static const int64_t layout__WORK_STATUS = INT64_C(7);
static const int64_t layout__WORK_OUTPUTS = INT64_C(8);
static const int64_t layout__WORK_PLACE = INT64_C(278);
static const int64_t layout__WORK_SIDE = INT64_C(310);
static const int64_t layout__WORK_CONTACT = INT64_C(1110);
static const int64_t layout__WORK_REGION = INT64_C(1142);
static const int64_t layout__WORK_NODES = INT64_C(1238);
static const int64_t layout__WORK_ISLANDS = INT64_C(8150);
static const int64_t layout__WORK_STRIPS = INT64_C(8230);
static const int64_t layout__WORK_DISTANCE = INT64_C(9894);
static const int64_t layout__WORK_INFLUENCE = INT64_C(20710);
static const int64_t layout__WORK_SYSTEM = INT64_C(31526);
static const int64_t layout__WORK_SIZE = INT64_C(42550);
static const int64_t layout__SIDE_BEST = INT64_C(0);
static const int64_t layout__SIDE_BEST_Y = INT64_C(1);
static const int64_t layout__SIDE_BEST_RAIL = INT64_C(2);
static const int64_t layout__SIDE_FIRST = INT64_C(3);
static const int64_t layout__SIDE_LAST = INT64_C(4);
static const int64_t layout__SIDE_NODE = INT64_C(8);
static const int64_t layout__SIDE_ABSCISSA = INT64_C(48);
static const int64_t layout__SIDE_STACK = INT64_C(88);

#endif
