"""Linear equations with two right-hand sides."""

from ..layout import Equations


def eliminate(equations: Equations, size: int):
    """Solve ``size`` equations in place: the two right-hand sides, in the last two columns, become the
    solutions.

    Gauss without exchange of rows: the matrix is that of a positive kernel, largest on the diagonal.
    """
    width = size + 2
    for pair in range(size // 2):
        # two columns at a time, so that every row is read and written once for both
        k = 2 * pair
        first = equations[k]
        second = equations[k + 1]
        inverse = 1.0 / first[k]
        factor = second[k] * inverse
        for j in range(k + 1, width):
            second[j] -= factor * first[j]
        next_inverse = 1.0 / second[k + 1]
        for i in range(k + 2, size):
            row = equations[i]
            factor = row[k] * inverse
            next_factor = (row[k + 1] - factor * first[k + 1]) * next_inverse
            for j in range(k + 2, width):
                row[j] = row[j] - factor * first[j] - next_factor * second[j]
    for back in range(size):
        k = size - 1 - back
        pivot = equations[k]
        one = pivot[size]
        other = pivot[size + 1]
        for j in range(k + 1, size):
            row = equations[j]
            one -= pivot[j] * row[size]
            other -= pivot[j] * row[size + 1]
        pivot[size] = one / pivot[k]
        pivot[size + 1] = other / pivot[k]
