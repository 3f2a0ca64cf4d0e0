/* Saved states of a wheelset. */
#include <stdlib.h>
#include <string.h>

#include "wheelset_parts.h"

static const char FORMAT[16] = "wrcontact 4";

/* Fowler, Noll and Vo's hash, 64 bits. */
static uint64_t checksum(const void *bytes, size_t size)
{
    const unsigned char *byte = bytes;
    uint64_t hash = UINT64_C(14695981039346656037);
    for (size_t i = 0; i < size; i += 1)
        hash = (hash ^ byte[i]) * UINT64_C(1099511628211);
    return hash;
}

static void save(const wheelset *self, wheelset_saved *saved)
{
    memset(saved, 0, sizeof *saved);
    memcpy(saved->format, FORMAT, sizeof FORMAT);
    memcpy(saved->token, model_token, sizeof model_token);
    saved->size = sizeof *saved;
    saved->core = self->core;
    memcpy(saved->core.known, self->workspace, sizeof saved->core.known);
    saved->checksum = checksum(&saved->core, sizeof saved->core);
}

/* Whether these bytes are a saved state of this FMU. */
static int check_saved(wheelset *self, const wheelset_saved *saved, size_t size)
{
    if (size < sizeof saved->format || memcmp(saved->format, FORMAT, sizeof FORMAT) != 0)
        return wheelset_refuse(self, REFUSE_OTHER_STATE);
    if (size != sizeof *saved)
        return wheelset_refuse(self, "the saved state holds %lu bytes, expected are %lu; the present state is kept",
                               (unsigned long)size, (unsigned long)sizeof *saved);
    if (saved->size != sizeof *saved || saved->checksum != checksum(&saved->core, sizeof saved->core))
        return wheelset_refuse(self, REFUSE_DAMAGED_STATE);
    if (memcmp(saved->token, model_token, sizeof model_token) != 0)
        return wheelset_refuse(self, "the saved state comes from another FMU; the present state is kept");
    return 0;
}

static int restore(wheelset *self, const wheelset_saved *saved)
{
    wheelset_core before = self->core;
    if (saved->core.exchange != before.exchange)
        return wheelset_refuse(self, "the saved state is one of %s, and this instance is for %s; the present state is kept",
                               saved->core.exchange ? "model exchange" : "co-simulation",
                               before.exchange ? "model exchange" : "co-simulation");
    self->core = saved->core;
    if (self->core.built && wheelset_build(self))
    {
        if (self->core.locked)
        {
            self->core = before;
            return 1;
        }
        self->core.built = 0;       /* parameters that were set and not yet tried */
    }
    memset(self->workspace, 0, MODEL_WORK * sizeof(double));
    memcpy(self->workspace, saved->core.known, sizeof saved->core.known);
    memcpy(self->workspace + MODEL_KNOWN, saved->core.values + MODEL_FIRST_OUTPUT, ROW * sizeof(double));
    return 0;
}

/* The link to a state in the list, or to the list's end. */
static wheelset_state **find_state(wheelset *self, const void *state)
{
    wheelset_state **link = &self->states;
    while (*link && *link != state)
        link = &(*link)->next;
    return link;
}

static int check_state(wheelset *self, const void *state)
{
    if (!state)
        return wheelset_refuse(self, "the saved state is a NULL pointer; permitted are states of this instance");
    if (!*find_state(self, state))
        return wheelset_refuse(self, "the saved state is not one of this instance; it has been freed, or is another's");
    return 0;
}

/* A place in the list. */
static int new_state(wheelset *self, void **state)
{
    wheelset_state *made = calloc(1, sizeof *made);
    if (!made)
        return wheelset_refuse(self, "there is no memory for a saved state");
    made->next = self->states;
    self->states = *state = made;
    return 0;
}

int wheelset_save_state(wheelset *self, void **state)
{
    if (!state)
        return wheelset_refuse(self, "the place for the saved state is a NULL pointer");
    if (*state ? check_state(self, *state) : new_state(self, state))
        return 1;
    save(self, &((wheelset_state *)*state)->saved);
    return 0;
}

int wheelset_restore_state(wheelset *self, const void *state)
{
    return check_state(self, state) || restore(self, &((const wheelset_state *)state)->saved);
}

int wheelset_free_state(wheelset *self, void **state)
{
    if (!state || !*state)
        return 0;
    if (check_state(self, *state))
        return 1;
    wheelset_state **link = find_state(self, *state), *found = *link;
    *link = found->next;
    free(found);
    *state = NULL;
    return 0;
}

int wheelset_state_size(wheelset *self, const void *state, size_t *size)
{
    if (check_state(self, state))
        return 1;
    if (!size)
        return wheelset_refuse(self, "the place for the saved state's size is a NULL pointer");
    *size = sizeof(wheelset_saved);
    return 0;
}

int wheelset_write_state(wheelset *self, const void *state, void *bytes, size_t size)
{
    if (check_state(self, state))
        return 1;
    if (!bytes)
        return wheelset_refuse(self, "the place for the saved state's bytes is a NULL pointer");
    if (size < sizeof(wheelset_saved))
        return wheelset_refuse(self, "the saved state has %lu bytes, its place %lu; permitted are places that hold it",
                               (unsigned long)sizeof(wheelset_saved), (unsigned long)size);
    memcpy(bytes, &((const wheelset_state *)state)->saved, sizeof(wheelset_saved));
    return 0;
}

int wheelset_read_state(wheelset *self, const void *bytes, size_t size, void **state)
{
    void *made = NULL;
    if (!state || !bytes)
        return wheelset_refuse(self, "the saved state's %s a NULL pointer", bytes ? "place is" : "bytes are");
    if (new_state(self, &made))
        return 1;
    wheelset_saved *saved = &((wheelset_state *)made)->saved;
    memcpy(saved, bytes, size < sizeof *saved ? size : sizeof *saved);
    if (check_saved(self, saved, size))
        return wheelset_free_state(self, &made), 1;
    if (*state && *find_state(self, *state))
    {
        ((wheelset_state *)*state)->saved = *saved;
        return wheelset_free_state(self, &made);
    }
    *state = made;
    return 0;
}
