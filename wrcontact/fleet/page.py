"""The report of a fleet in HTML: one file, which needs nothing from elsewhere."""

from html import escape

from ..conditioning.measures import PAIR

#: Columns with a number.
COLUMNS = (
    "conicity_3mm",
    "nonlinearity",
    "nearest_jump",
    "jump_count",
    "wheel_rate",
    "flange_shift",
    "usable_to",
    "conformal_count",
    "conformal_width",
    "conformal_turn",
    "wheel_noise",
    "rail_noise",
    "wheel_roughness",
    "rail_roughness",
)
#: Size of the small curve of the conicity at 1 ... 8 mm [px], and its value at the upper edge.
CURVE, TOP = (88, 22), 1.0

STYLE = """
:root { color-scheme: light dark; --line: #8885; --broken: #d55e0026; }
body { font: 14px/1.45 system-ui, sans-serif; margin: 1.5rem; }
h1 { font-size: 1.4rem; margin: 0 0 .2rem; }
p { max-width: 60rem; margin: .3rem 0 .8rem; }
input { font: inherit; padding: .25rem .5rem; width: 22rem; margin-bottom: .8rem; }
table { border-collapse: collapse; }
th, td { padding: .25rem .55rem; text-align: right; vertical-align: top;
         border-bottom: 1px solid var(--line); }
th { position: sticky; top: 0; background: Canvas; cursor: pointer; font-weight: 600; vertical-align: bottom;
     max-width: 6rem; }
th small, td small { font-weight: 400; opacity: .7; display: block; }
th[aria-sort=ascending] span::after { content: " \\2191"; }
th[aria-sort=descending] span::after { content: " \\2193"; }
td.text, th.text { text-align: left; } td.files { white-space: nowrap; }
tr.broken, tr.useless { background: var(--broken); }
details[open] { width: 34rem; } details ul { margin: .2rem 0; padding-left: 1.2rem; }
summary { cursor: pointer; } svg { display: block; }
polyline { fill: none; stroke: #0072b2; stroke-width: 1.5; }
"""
#: Sorts by the heading that is clicked, empty cells last; and shows the rows with the text that is sought.
SCRIPT = """
const body = document.querySelector("tbody"), heads = [...document.querySelectorAll("th")];
const value = (row, k) => row.cells[k].dataset.v ?? row.cells[k].textContent.trim();
heads.forEach((head, k) => head.addEventListener("click", () => {
  const up = head.getAttribute("aria-sort") !== "ascending", numbers = head.dataset.kind === "number";
  heads.forEach(other => other.removeAttribute("aria-sort"));
  head.setAttribute("aria-sort", up ? "ascending" : "descending");
  const order = (a, b) => numbers ? a - b : a.localeCompare(b, undefined, {numeric: true});
  const rows = [...body.rows].map(row => [value(row, k), row]);
  rows.sort(([a], [b]) => (a === "") - (b === "") || (a === "" ? 0 : up ? order(a, b) : order(b, a)));
  body.append(...rows.map(([, row]) => row));
}));
document.querySelector("input").addEventListener("input", event => {
  const words = event.target.value.toLowerCase();
  for (const row of body.rows) row.hidden = !row.textContent.toLowerCase().includes(words);
});
"""


def page(fleet):
    """The report on a :class:`~wrcontact.fleet.Fleet` as a text of HTML."""
    rows = "\n".join(map(_row, fleet.rows))
    return f"""<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Fleet of wheels and rails</title>
<style>{STYLE}</style></head><body>
<h1>Fleet of wheels and rails</h1>
<p>A click on a heading sorts by it, a second click the other way round.</p>
<p>{escape(summary(fleet))}</p>
{_errors(fleet)}<input type="search" placeholder="show rows with this text" aria-label="text sought">
<table><thead><tr>{_heads()}</tr></thead>
<tbody>
{rows}
</tbody></table>
<script>{SCRIPT}</script>
</body></html>
"""


def _errors(fleet):
    """The sentences of the rows with an error, which stand above the table."""
    lines = "".join(f"<li>{escape(row['error'])}</li>" for row in fleet.broken)
    return f"<ul>{lines}</ul>\n" if lines else ""


def summary(fleet):
    """What a fleet has come to, in sentences."""
    pairs = [row for row in fleet.rows if not row["error"]]
    wheels, rails = (len({row[kind] for row in pairs}) for kind in ("wheel", "rail"))
    near = sum(row["nearest_jump"] is not None and row["nearest_jump"] < 1e-3 for row in pairs)
    words = [
        f"{_counted(len(pairs), 'pair')} of {_counted(wheels, 'wheel')} and {_counted(rails, 'rail')}: "
        f"{sum(row['usable'] for row in pairs)} usable, {near} with a jump within 1 mm of the centred "
        "position."
    ]
    level = sorted(row["conicity_3mm"] for row in pairs if row["conicity_3mm"] is not None)
    if level:
        words.append(
            f"Equivalent conicity at 3 mm: {level[0]:.3f} to {level[-1]:.3f}, median "
            f"{level[len(level) // 2]:.3f}."
        )
    for name, text in (
        ("grave_remarks", "with a remark on what makes all results wrong if it is so"),
        ("rail_file_inclination", "with a rail that its file has inclined, turned upright"),
    ):
        count = sum(bool(row[name]) for row in pairs)
        if count:
            words.append(f"{_counted(count, 'pair')} {text}.")
    if fleet.broken:
        words.append(f"{_counted(len(fleet.broken), 'row')} with an error:")
    return " ".join(words)


def _counted(count, word):
    return f"{count} {word}" if count == 1 else f"{count} {word}s"


def _heads():
    texts = "".join(f'<th class="text"><span>{name}</span></th>' for name in ("wheel", "rail"))
    numbers = [
        ("remarks", "", "remarks"),
        ("conicity at 1 … 8 mm", f"0 … {TOP:g}", "sorted by 3 mm"),
        *((PAIR[name].heading, PAIR[name].shown_unit, PAIR[name].meaning) for name in COLUMNS),
    ]
    return (
        texts
        + "".join(
            f'<th data-kind="number"{" class=text" if heading == "remarks" else ""} title="{escape(meaning)}">'
            f"<span>{escape(heading)}</span><small>{unit}</small></th>"
            for heading, unit, meaning in numbers
        )
        + "<th><span>files</span></th>"
    )


def _row(row):
    kind = ' class="broken"' if row["error"] else "" if row["usable"] else ' class="useless"'
    cells = [
        f'<td class="text" title="{escape(row[f"{name}_file"])}">{escape(row[name])}</td>'
        for name in ("wheel", "rail")
    ]
    cells += [_remarks(row), _curve(row)]
    cells += [_number(row[name], PAIR[name]) for name in COLUMNS]
    links = " ".join(
        f'<a href="{escape(row[name])}">{words}</a>'
        for name, words in (("json", "JSON"), ("picture", "picture"))
        if row[name]
    )
    return f'<tr{kind}>{"".join(cells)}<td class="files">{links}</td></tr>'


def _remarks(row):
    if row["error"]:
        return (
            '<td class="text" data-v="999"><details><summary>error</summary>'
            f"{escape(row['error'])}</details></td>"
        )
    count, grave = len(row["remarks"]), int(row["grave_remarks"] or 0)
    if not count:
        return '<td class="text" data-v="0">none</td>'
    seen = "".join(f"<p><b>{escape(remark)}</b></p>" for remark in row["remarks"][:grave])
    words = "".join(f"<li>{escape(remark)}</li>" for remark in row["remarks"][grave:])
    folded = f"<details><summary>{count - grave}</summary><ul>{words}</ul></details>" if words else ""
    return f'<td class="text" data-v="{count}">{seen}{folded}</td>'


def _number(value, measure):
    if value is None:
        return "<td></td>"
    return f'<td data-v="{value:.9g}">{value * measure.factor:.{measure.digits}f}</td>'


def _curve(row):
    """A small curve of the conicity over the amplitude, interrupted where it has no value."""
    values = [row[f"conicity_{at}mm"] for at in range(1, 9)]
    parts = [[]]
    for k, value in enumerate(values):
        if value is None:
            parts.append([])
        else:
            x = 2 + k * (CURVE[0] - 4) / 7
            y = CURVE[1] - 1 - min(max(value / TOP, 0.0), 1.0) * (CURVE[1] - 2)
            parts[-1].append(f"{x:.1f},{y:.1f}")
    lines = "".join(f'<polyline points="{" ".join(part)}"/>' for part in parts if part)
    place = f'data-v="{values[2]:.9g}"' if values[2] is not None else 'data-v=""'
    return f'<td {place}><svg width="{CURVE[0]}" height="{CURVE[1]}">{lines}</svg></td>'
