#include "sentences.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "wheelset.h"

/* These headers are here for their constants; the functions that they declare are not called. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "kernel/generated/layout.h"

static const char KEPT[] = "the outputs keep their last valid values";

/* The number in `text`, as printf has written it, with a point where the host's locale has something else. */
static const char *pointed(char *text)
{
    const size_t whole = strspn(text, "+-0123456789");
    const size_t mark = strcspn(text + whole, "0123456789aefinxAEFINX");
    if (mark > 0 && text[whole] != 0)
    {
        text[whole] = '.';
        memmove(text + whole + 1, text + whole + mark, strlen(text + whole + mark) + 1);
    }
    return text;
}

/* A number in as many digits. */
const char *sentence_rounded(double value, int digits, char *text, size_t size)
{
    snprintf(text, size, "%.*g", digits, value);
    return pointed(text);
}

/* A number in the fewest digits that give it back, as Python writes it. */
const char *sentence_shortest(double value, char *text, size_t size)
{
    if (!isfinite(value))
    {
        snprintf(text, size, "%s", isnan(value) ? "nan" : value > 0.0 ? "inf" : "-inf");
        return text;
    }
    int digits = 0;
    do
        snprintf(text, size, "%.*e", digits, value);
    while (strtod(text, NULL) != value && ++digits < 17);
    const char *power = strchr(text, 'e');
    const int exponent = power ? atoi(power + 1) : 0;
    if (-4 <= exponent && exponent < 16)
        snprintf(text, size, "%.*f", digits - exponent > 1 ? digits - exponent : 1, value);
    return pointed(text);
}

/* `text` in quotes, as Python writes it, with a mark in place of control characters. */
const char *sentence_quoted(const char *text, char *result, size_t size)
{
    const char quote = strchr(text, '\'') && !strchr(text, '"') ? '"' : '\'';
    size_t at = 0;
    result[at++] = quote;
    for (; *text && at + 2 < size; text += 1)
        result[at++] = (unsigned char)*text < 32 ? '?' : *text;
    result[at++] = quote;
    result[at] = 0;
    return result;
}

/* The text with each character of `marks` in it twice, as far as it has room. */
const char *sentence_doubled(const char *text, const char *marks, char *result, size_t size)
{
    size_t at = 0;
    for (; *text && at + 2 < size; text += 1)
    {
        if (strchr(marks, *text))
            result[at++] = *text;
        result[at++] = *text;
    }
    result[at] = 0;
    return result;
}

/* The first input that is not permitted, in a clause. */
static void invalid_input(const double *inputs, char *text, size_t size)
{
    char number[40];
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        if (!isfinite(inputs[i]))
        {
            snprintf(text, size, "%s is %s%s; permitted are finite numbers", model_variables[i].name,
                     sentence_shortest(inputs[i], number, sizeof number), model_variables[i].unit);
            return;
        }
    for (int i = 0; i < MODEL_INPUTS; i += 1)
        if (model_variables[i].high > 0.0 && fabs(inputs[i]) > model_variables[i].high)
        {
            const char *name = model_variables[i].name, *unit = model_variables[i].unit;
            snprintf(text, size, "%s is %s%s; permitted is |%s| <= %s%s", name, SIX_DIGITS(inputs[i]), unit, name,
                     SIX_DIGITS(model_variables[i].high), unit);
            return;
        }
    for (int i = layout__IN_LEFT_FRICTION; i <= layout__IN_RIGHT_FRICTION; i += 1)
        if (!(inputs[i] >= 0.0 && inputs[i] <= layout__FRICTION_LIMIT))
        {
            const char *name = model_variables[i].name;
            snprintf(text, size, "%s is %s; permitted is 0 <= %s <= %s", name, SIX_DIGITS(inputs[i]), name,
                     SIX_DIGITS(layout__FRICTION_LIMIT));
            return;
        }
    if (inputs[layout__IN_NORMAL_FORCE] < 0.0)
        snprintf(text, size, "normal_force is %s N; permitted is normal_force >= 0 N",
                 SIX_DIGITS(inputs[layout__IN_NORMAL_FORCE]));
    else
        snprintf(text, size, "load_transfer is %s; permitted is -1 <= load_transfer <= 1",
                 SIX_DIGITS(inputs[layout__IN_LOAD_TRANSFER]));
}

/* How far an input may move a rail. */
static double rail_limit(int input)
{
    return input == layout__IN_LEFT_RAIL_ROLL || input == layout__IN_RIGHT_RAIL_ROLL ? MODEL_RAIL_ROLL_LIMIT : MODEL_RAIL_LIMIT;
}

/* The first input that moves a rail too far, or -1. */
static int far_rail(const double *inputs)
{
    for (int i = layout__IN_LEFT_RAIL_LATERAL; i <= layout__IN_RIGHT_RAIL_ROLL; i += 1)
        if (fabs(inputs[i]) > rail_limit(i))
            return i;
    return -1;
}

/* One sentence on a status that is not 0, as wrcontact/status.py words it. */
void sentence_of_status(int status, const double *inputs, bool compliant, char *text, size_t size)
{
    const char *shift = SIX_DIGITS(inputs[layout__IN_LATERAL_SHIFT]), *yaw = SIX_DIGITS(inputs[layout__IN_YAW]);
    const char *force = SIX_DIGITS(inputs[layout__IN_NORMAL_FORCE]);
    const char *transfer = SIX_DIGITS(inputs[layout__IN_LOAD_TRANSFER]);
    const char *height = SIX_DIGITS(inputs[layout__IN_VERTICAL_SHIFT]), *roll = SIX_DIGITS(inputs[layout__IN_ROLL]);
    const bool far = fabs(inputs[layout__IN_LATERAL_SHIFT]) > MODEL_LATERAL_LIMIT;
    const int rail = far_rail(inputs);
    char clause[200];
    if (status == layout__INVALID_INPUT)
    {
        invalid_input(inputs, clause, sizeof clause);
        snprintf(text, size, "%s; %s", clause, KEPT);
    }
    else if (status == layout__UNLOADED && compliant)
        snprintf(text, size, "vertical_shift_input is %s m at roll_input %s rad, so a wheel is lifted and carries no load; its "
                 "patch is empty (a larger vertical_shift_input lowers the wheelset)", height, roll);
    else if (status == layout__UNLOADED && inputs[layout__IN_NORMAL_FORCE] == 0.0)
        snprintf(text, size, "normal_force is %s N, so a wheel carries no load; its patch is empty (a load needs normal_force > "
                 "0 N and |load_transfer| < 1)", force);
    else if (status == layout__UNLOADED)
        snprintf(text, size, "load_transfer is %s, so a wheel carries no load; its patch is empty (a load needs normal_force > "
                 "0 N and |load_transfer| < 1)", transfer);
    else if (status != layout__OFF_PROFILE)
        snprintf(text, size, "no solution at lateral_shift %s m, yaw %s rad, normal_force %s N, load_transfer %s within the "
                 "iteration limit; %s", shift, yaw, force, transfer, KEPT);
    else if (!far && fabs(inputs[layout__IN_YAW]) > MODEL_YAW_LIMIT)
        snprintf(text, size, "yaw is %s rad, beyond the profiles; permitted is |yaw| <= %s rad; %s", yaw,
                 SIX_DIGITS(MODEL_YAW_LIMIT), KEPT);
    else if (far)
        snprintf(text, size, "lateral_shift is %s m, beyond the profiles; permitted is |lateral_shift| <= %s m; %s", shift,
                 SIX_DIGITS(MODEL_LATERAL_LIMIT), KEPT);
    else if (rail >= 0)
        snprintf(text, size, "%s is %s%s; permitted is |%s| <= %s%s; %s", model_variables[rail].name, SIX_DIGITS(inputs[rail]),
                 model_variables[rail].unit, model_variables[rail].name, SIX_DIGITS(rail_limit(rail)), model_variables[rail].unit,
                 KEPT);
    else if (compliant && fabs(inputs[layout__IN_ROLL]) > MODEL_ROLL_LIMIT)
        snprintf(text, size, "roll_input is %s rad; permitted is |roll_input| <= %s rad; %s", roll,
                 SIX_DIGITS(MODEL_ROLL_LIMIT), KEPT);
    else if (compliant)
        snprintf(text, size, "vertical_shift_input is %s m and roll_input %s rad at lateral_shift %s m: the contact leaves a "
                 "profile, or a wheel is deeper in its rail than %s m; %s", height, roll, shift, SIX_DIGITS(MODEL_DEEPEST), KEPT);
    else
        snprintf(text, size, "lateral_shift is %s m at yaw %s rad: the smallest gap lies at the end of a profile, so there is no "
                 "contact; or, in elastic contact, normal_force %s N with load_transfer %s presses a wheel deeper into its rail than "
                 "%s m; permitted are poses with the contact inside both profiles; %s", shift, yaw, force, transfer,
                 SIX_DIGITS(MODEL_DEEPEST), KEPT);
}
