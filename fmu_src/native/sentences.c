#include "sentences.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model.h"

static const char KEPT[] = "; the outputs keep their last valid values";

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

/* A number in six digits, or in as many as it needs to differ from `limit`, as status.distinct in Python. */
static const char *distinct(double value, double limit, char *text, size_t size)
{
    for (int digits = 6; digits < 18 && isfinite(value); digits += 1)
    {
        snprintf(text, size, "%.*g", digits, value);
        if (fabs(strtod(text, NULL)) != fabs(limit) || fabs(value) == fabs(limit))
            return pointed(text);
    }
    return sentence_shortest(value, text, size);
}

/* Whether the test of a sentence holds for its input. */
static bool holds(const model_sentence *said, double value)
{
    switch (said->test)
    {
    case TEST_INFINITE: return !isfinite(value);
    case TEST_BEYOND: return fabs(value) > said->limit;
    case TEST_OUTSIDE: return !(0.0 <= value && value <= said->limit);
    case TEST_BELOW: return value < said->limit;
    case TEST_NONZERO: return value != 0.0;
    default: return true;
    }
}

/* One sentence on a status that is not 0: the first in the table whose test holds. */
void sentence_of_status(int status, const double *inputs, bool compliant, char *text, size_t size)
{
    const model_sentence *said = model_sentences;
    while (said < model_sentences + MODEL_SENTENCES - 1
           && (said->status != status || said->compliant == !compliant || !holds(said, inputs[said->input])))
        said += 1;
    size_t at = 0;
    for (const char *part = said->text; *part && at + 1 < size; part += 1)
    {
        if (*part != '{')
        {
            text[at++] = *part;
            continue;
        }
        char number[40], *end;
        const long input = strtol(part + 1, &end, 10);
        distinct(inputs[input], input == said->input ? said->limit : NAN, number, sizeof number);
        const int length = snprintf(text + at, size - at, "%s%s", number, model_variables[input].unit);
        at = at + (size_t)length < size ? at + (size_t)length : size - 1;
        part = end;
    }
    text[at] = 0;
    if (status >= MODEL_KEPT)
        snprintf(text + at, size - at, "%s", KEPT);
}
