/* Numbers, texts and the status of a step in sentences, as Python words them. */
#ifndef SENTENCES_H
#define SENTENCES_H

#include <stdbool.h>
#include <stddef.h>

const char *sentence_rounded(double value, int digits, char *text, size_t size);    /* a number in as many digits */
const char *sentence_shortest(double value, char *text, size_t size);       /* in the fewest digits that give it back */
const char *sentence_quoted(const char *text, char *result, size_t size);   /* in quotes, without control characters */

/* The text with each character of `marks` in it twice, as far as it has room.  A message of FMI has `##` for `#`, which stands
 * around value references there; in FMI 2 it is a format as well and has `%%` for `%`. */
const char *sentence_doubled(const char *text, const char *marks, char *result, size_t size);

/* The same in a place of its own, for one sentence. */
#define FOUR_DIGITS(value) sentence_rounded((value), 4, (char[32]){0}, 32)
#define SIX_DIGITS(value) sentence_rounded((value), 6, (char[32]){0}, 32)

/* One sentence on a status that is not 0, as wrcontact/status.py words it. */
void sentence_of_status(int status, const double *inputs, bool compliant, char *text, size_t size);

#endif
