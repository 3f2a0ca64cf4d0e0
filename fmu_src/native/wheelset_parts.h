/* What the parts of the wheelset's life cycle need of each other. */
#ifndef WHEELSET_PARTS_H
#define WHEELSET_PARTS_H

#include "wheelset.h"

/* wheelset.c */
bool wheelset_is_compliant(const wheelset *self);
wrcontact_handle wheelset_handle(wheelset *self);       /* the kernel's arrays */

/* wheelset_tables.c */
bool wheelset_is_built(const wheelset *self);   /* whether the tables are those of the present parameters */
void wheelset_free_tables(wheelset *self);
int wheelset_build(wheelset *self);             /* the tables for the present parameters and stations */

#endif
