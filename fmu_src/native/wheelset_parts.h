/* What the parts of a wheelset need of each other.  A part calls only those above it, sentences.c above all:
 *
 *     wheelset_checks         which calls are refused
 *     wheelset_tables         from the parameters to the kernel's tables
 *     wheelset_evaluation     one evaluation, the equilibrium
 *     wheelset                the life cycle
 *     wheelset_exchange, wheelset_derivatives, wheelset_states
 */
#ifndef WHEELSET_PARTS_H
#define WHEELSET_PARTS_H

#include "wheelset.h"

/* wheelset_tables.c */
bool wheelset_is_built(const wheelset *self);   /* whether the tables are those of the present parameters */
void wheelset_free_tables(wheelset *self);
int wheelset_build(wheelset *self);             /* the tables for the present parameters and stations */

/* wheelset_evaluation.c */
bool wheelset_is_compliant(const wheelset *self);
wrcontact_handle wheelset_handle(wheelset *self);           /* the kernel's arrays */
void wheelset_set_mode(wheelset *self, double mode);        /* let the tables be those of a contact mode */
void wheelset_evaluate(wheelset *self);                     /* one step of the kernel, and its status */
void wheelset_accept(wheelset *self);           /* let the present inputs be those to hold to, if their outputs are valid */
void wheelset_log_status(wheelset *self);

#endif
