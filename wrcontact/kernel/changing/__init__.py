"""A step on rails whose section changes along the track.

At one pose a wheel on such a rail is a wheel on a constant one: that which has, seen along the ruling direction of the
rail where the wheel touches, at every place across the same smallest gap along it.  This rail is found and written to
the stepper's own tables, and the rooms upstream solve the contact with it; what they find is turned back into the track.
"""
