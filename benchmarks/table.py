"""Markdown tables and the figures in them."""


def markdown(title, header, rows):
    """A table with a title; the first column holds words, the others numbers."""
    lines = [f"### {title}", "", line(header), rule(header)]
    return "\n".join(lines + [line(row) for row in rows]) + "\n"


def rule(header):
    """The second line of a table with this header."""
    return line(["---"] + ["---:"] * (len(header) - 1))


def line(cells):
    """One line of a table."""
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def figure(value):
    """A number with at most one decimal, without powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 99.5 else f"{value:.1f}"


def percent(shares):
    """Shares as "1.2 / 3.4 / 5.6" [%]."""
    return " / ".join(figure(100 * share) for share in shares)
