/* A translation unit of its own, as wrcontact_prepare.c: a step does not enter it. */
#include "wrcontact_sections.h"

/* Its headers declare functions of the kernel that it does not call. */
#if defined(__GNUC__) || defined(__clang__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "../generated/sections_unit.c"

int wrcontact_search_sections(array_double_1d tables, array_double_1d workspace, int64_t index, array_double_1d pose)
{
    return section_pose__search_at(workspace, tables, index, pose);
}
