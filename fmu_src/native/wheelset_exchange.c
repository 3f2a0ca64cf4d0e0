/* Model exchange: the modes, the time, and the points that a solver accepts. */
#include "wheelset_parts.h"

#include <math.h>

#include "sentences.h"

enum { IN_EVENT = 1 << PHASE_EVENT, IN_CONTINUOUS = 1 << PHASE_CONTINUOUS };

/* Whether something can be done in the present mode; `where` says in which ones. */
static int check_mode(wheelset *self, const char *what, int modes, const char *where)
{
    if (!self->core.exchange)
        return wheelset_refuse(self, "%s only in model exchange; this instance is for co-simulation", what);
    if (!(modes >> self->core.phase & 1))
        return wheelset_refuse(self, "%s only in %s", what, where);
    return 0;
}

int wheelset_enter_event_mode(wheelset *self)
{
    if (check_mode(self, "event mode can be entered", IN_CONTINUOUS | IN_EVENT, "continuous-time mode"))
        return 1;
    self->core.phase = PHASE_EVENT;
    return 0;
}

int wheelset_update_discrete(wheelset *self)
{
    if (check_mode(self, "discrete states can be updated", IN_EVENT, "event mode"))
        return 1;
    wheelset_refresh(self);
    wheelset_accept(self);
    return 0;
}

int wheelset_enter_continuous_mode(wheelset *self)
{
    if (check_mode(self, "continuous-time mode can be entered", IN_EVENT, "event mode"))
        return 1;
    self->core.phase = PHASE_CONTINUOUS;
    return 0;
}

int wheelset_set_time(wheelset *self, double time)
{
    char number[40];
    if (check_mode(self, "the time can be set", IN_EVENT | IN_CONTINUOUS, "event mode and in continuous-time mode"))
        return 1;
    if (!isfinite(time))
        return wheelset_refuse(self, "the time is %s s; permitted are finite times", sentence_shortest(time, number, sizeof number));
    self->core.time = time;
    return 0;
}

int wheelset_complete_step(wheelset *self)
{
    if (check_mode(self, "a step of the solver can be completed", IN_CONTINUOUS, "continuous-time mode"))
        return 1;
    wheelset_refresh(self);
    wheelset_accept(self);
    if (self->core.status != 0.0)
        wheelset_log_status(self);
    return 0;
}

int wheelset_check_empty(wheelset *self, const char *what, size_t count)
{
    if (!self->core.exchange)
        return wheelset_refuse(self, "there are %s only in model exchange; this instance is for co-simulation", what);
    if (count > 0)
        return wheelset_refuse(self, "a call asks for %lu %s; this model has none", (unsigned long)count, what);
    return 0;
}
