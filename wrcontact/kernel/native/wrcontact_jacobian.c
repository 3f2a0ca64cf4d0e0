/* The fourth translation unit: the differentiated kernel along many directions. */
#define WRCONTACT_DIRECTIONS 10
#include "derivative_passes.h"
#include "wrcontact_jacobian.h"

int64_t wrcontact_jacobian_room(void)
{
    return derivative_room();
}

int wrcontact_jacobian(const wrcontact_handle *handle, int64_t count, const double *seeds, double *rates, double *room)
{
    return derivatives(handle, count, seeds, rates, room);
}
