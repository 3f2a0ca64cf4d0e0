"""Two linear equations with two unknowns."""


def solve_pair(first: float, second: float, first_x: float, first_y: float, second_x: float, second_y: float):
    """Determinant of the derivatives of two residuals, ``first`` and ``second``, by x and y, and the moves of
    x and y that let both vanish (Cramer's rule); no moves where the determinant is 0."""
    determinant = first_x * second_y - second_x * first_y
    x = 0.0
    y = 0.0
    if determinant != 0.0:
        x = (second * first_y - first * second_y) / determinant
        y = (first * second_x - second * first_x) / determinant
    return determinant, x, y
