"""Markdown tables and the figures in them."""


def markdown(title, header, rows):
    """A table with a title."""
    return f"### {title}\n\n{grid(header, rows)}\n"


def grid(header, rows, words=1):
    """A table; the first columns hold ``words``, the others numbers."""
    return "\n".join([line(header), line(["---"] * words + ["---:"] * (len(header) - words)),
                      *map(line, rows)])


def line(cells):
    """One line of a table."""
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def figure(value):
    """A number with at most one decimal, without powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 99.5 else f"{value:.1f}"


def percent(shares):
    """Shares as "1.2 / 3.4 / 5.6" [%]."""
    return three(100 * share for share in shares)


def three(values):
    """Numbers as "1.2 / 3.4 / 5.6"."""
    return " / ".join(map(figure, values))
