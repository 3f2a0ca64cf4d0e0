/* The third translation unit: the differentiated kernel along one direction.  It stands apart so that the compiler spends nothing
 * on it that it would take from the steps.
 */
#define WRCONTACT_DIRECTIONS 1
#include "derivative_passes.h"

int64_t wrcontact_derivative_room(void)
{
    return derivative_room();
}

int wrcontact_derivative(const wrcontact_handle *handle, const double *seed, double *rates, double *room)
{
    return derivatives(handle, 1, seed, rates, room);
}
