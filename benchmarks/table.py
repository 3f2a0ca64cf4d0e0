"""Markdown tables and the figures in them."""


def markdown(title, header, rows):
    """A titled table as text; the first column is words, the others are figures."""
    lines = [f"### {title}", "", line(header), line(["---"] + ["---:"] * (len(header) - 1))]
    return "\n".join(lines + [line(row) for row in rows]) + "\n"


def line(cells):
    return f"| {' | '.join(str(cell) for cell in cells)} |"


def figure(value):
    """Two or three digits, no powers of ten."""
    return f"{value:,.0f}" if abs(value) >= 99.5 else f"{value:.1f}"


def percent(shares):
    """Shares as "1.2 / 3.4 / 5.6" [%]."""
    return " / ".join(figure(100 * share) for share in shares)
