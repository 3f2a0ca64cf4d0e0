"""The FMU's documentation/index.html: use, conventions, and tables of all variables.  Equations and tables of messages
are on the pages of the project (docs/theory, docs/reference)."""

from html import escape
from xml.etree.ElementTree import fromstring

from ..conventions import SIDES
from ..interface.variables import folded
from ..methods import CHOICES
from .archive import SOURCES
from .variants import WHEELSET

ICON = SOURCES / "icon.svg"

STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 76em; margin: 2em auto; padding: 0 1em; color: #222; }
p { max-width: 60em; }
table { border-collapse: collapse; font-size: 90%; }
th, td { text-align: left; vertical-align: top; padding: .2em .6em; border-bottom: 1px solid #ddd; }
code, td span { white-space: nowrap; }
h1 svg { width: 1.6em; height: 1.6em; vertical-align: middle; margin-right: .4em; }
"""

ONE_WHEEL = """
<p>This FMU is one side of a compliant wheelset by itself. Its pose, velocities and moment are those of the point on the wheel's
axis that lies half the <code>running_circle_distance</code> inside of the running circle, in the nominal position the centre
of a wheelset; <code>wheel_rate</code> is the wheel's own rotation. Names have no <code>left.</code> and <code>right.</code>;
statements on both wheels, on a prescribed load and on other contact modes do not apply.</p>
"""

USE = """
<h2>How to use it</h2>
<p>Set the inputs, step, read the outputs. The model has no dynamics of its own: outputs follow the inputs immediately, any
step size is correct, and outputs are valid before the first step. A step with unchanged inputs costs nothing.
<code>status</code> is the outcome of a step. If it is not 0, one line in the log names the variable, its value and the
limit. The step itself still succeeds, and the next valid input gives a valid result.</p>
<p>With <code>contact_mode</code> rigid (default) height and roll are those at which the undeformed wheels touch; elastic: those
at which each wheel carries its load. Compliant: height and roll are the inputs <code>vertical_shift_input</code> and
<code>roll_input</code>, the loads follow, and a wheelset with mass can be driven by the outputs <code>force</code> and
<code>moment</code>; <code>normal_force</code> and <code>load_transfer</code> are used for the equilibrium only. Inputs that a mode
does not use may have any permitted value.</p>
"""

CONVENTIONS = """
<h2>Conventions</h2>
<p>All values are in SI units (m, N, Pa, rad); display units are mm, deg, kN, MPa, mm&sup2;. Track frame: x forward, y
to the right, z down, origin on the track centre line at top of rail. Yaw &psi; is positive clockwise seen from above,
roll &theta; positive with the right wheel down; the attitude of the wheelset is R = R<sub>z</sub>(&psi;)
R<sub>x</sub>(&theta;). Wheel and rail profile frames have y to the field side and z down, on both sides (the left side
is the mirror image of the right one): the flange is at negative y, and <code>y_wheel</code>, <code>y_rail</code>,
stations and centroids of both wheels can be compared directly. Only <code>y_track</code> is not mirrored. The contact angle is
positive towards the flange.</p>
<p><code>force</code> and <code>moment</code> are the resultant of the contact forces of both rails on the wheelset, in
the axes of the track frame; the moment is about the wheelset's centre, which is at (0, <code>lateral_shift</code>,
<code>vertical_shift</code> &minus; <code>nominal_radius</code>). They include the creep forces of
friction where a <code>tangential_model</code> is chosen; <code>normal.force</code> and <code>normal.moment</code> are the parts of
the pressures alone.</p>

<p><code>creepage.x</code>, <code>creepage.y</code> and <code>creepage.spin</code> of a patch are the velocity of the wheel
against the rail forward and to the left in the plane of the patch, and its rotation about the normal from the rail to the
wheel, over the mean of the speed and the speed of the wheel's circumference. Velocities are inputs; in rigid and elastic
contact the vertical velocity and the roll rate follow from contact with both rails. Without any velocity there are no
creepages.</p>

<p><code>tangential.x</code> is the creep force on the wheel forward, <code>tangential.y</code> that in the plane of the patch to the
field side, on both sides; <code>tangential.moment</code> is the moment on the wheel about the normal from the rail to the
wheel. The force is opposite to the creepages: a driven wheel has creepage.x &lt; 0 and tangential.x &gt; 0.
<code>driving_torque</code> is the torque of the creep forces about the axle, positive where they turn the wheels forward.</p>

<p>The pages of wrcontact have the equations and the papers (docs/theory), all messages by status
(docs/reference/statuses.md) and what was validated (docs/evidence).</p>
"""


def documentation_page(version, description, about):
    """The page as text.

    Parameters
    ----------
    version : of wrcontact.
    description : the FMU's modelDescription.xml, whose variables are listed.
    about : HTML on this kind of FMU only, from ``about_python`` or ``about_native``.
    """
    root = fromstring(description)
    model, subject = root.get("modelName"), escape(root.get("description", "").partition(":")[0])
    versions = f"FMI {escape(root.get('fmiVersion'))}, wrcontact {escape(version)}"
    tables = "".join(_table(title, causality, root) for causality, title in TABLES.items())
    return (
        f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>{model}</title>\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>{ICON.read_text(encoding='utf-8')}{model}</h1>\n"
        f"<p>{subject}; {versions}.</p>\n{'' if model == WHEELSET.model else ONE_WHEEL}"
        f"{USE}{about}{CONVENTIONS}{_abilities(root)}{tables}"
        '<p>Licences: <a href="licenses/">licenses</a>.</p>\n</body>\n</html>\n'
    )


# --- what holds for one kind of FMU ------------------------------------------------------------------


def about_python():
    """HTML on the FMU that runs in Python."""
    return """
<h2>This FMU</h2>
<p>It contains its program as Python source and runs it inside the host, which needs Python 3.10 or newer with numpy. A host that
is a Python uses itself. On Linux another host needs Python's library, <code>libpython3.*.so.1.0</code>: the FMU takes the one in the process, else the
file that the environment variable <code>WRCONTACT_LIBPYTHON</code> names, else that of the first <code>python3</code> in <code>PATH</code>,
else any that the system finds. On Windows <code>python3.dll</code> must be in <code>PATH</code>. The native FMU needs nothing of this. On a
platform without a compiled kernel in this FMU, the kernel also runs as Python, about 100 times slower, with the same
results. <code>wheel_profile</code> and <code>rail_profile</code> are a name of the catalogue (such as S1002, LMA, UIC60, R65) or the name
of a file in the FMU's <code>resources</code>.</p>
<p>A wrong call (an unknown value reference, a wrong type, a parameter that is not permitted, a call out of order) changes
nothing and gives one sentence in the log and on the console. PythonFMU, which calls the program, knows no error: the call
returns fmi2OK, and values that cannot be read are nan. A step that is refused returns fmi2Discard with the wish to end the
simulation; so does every step after a refused initialisation, where <code>status</code> is 4.</p>
<p>A saved state holds inputs, parameters, outputs, the time, stopTime and the start values of the search.</p>
"""


def about_native(version, platforms, profiles):
    """HTML on a native FMU: ``version`` of FMI (2 or 3), names of its ``platforms``, and its ``profiles`` by
    name."""
    names = {
        kind: ", ".join(escape(name) for name, profile in profiles.items() if profile.kind == kind)
        for kind in ("wheel", "rail")
    }
    return f"""
<h2>This FMU</h2>
<p>It is compiled and needs no Python, no file and no other program. It contains libraries for {", ".join(platforms)}. For
other machines, compile its <code>sources</code> with any C11 compiler; {LISTS[version]} lists the files. The sources tell gcc
and clang not to fuse a multiplication with an addition; another compiler, or another mathematical library, may change
results by rounding.</p>
<p>{OUTLINES[version]}</p>
<p>Profiles are packed: <code>wheel_profile</code> is one of {names["wheel"]}, <code>rail_profile</code> one of
{names["rail"]}. These and all other parameters are fixed when initialisation mode is left.</p>
<p>A wrong call (an unknown value reference, a wrong type, a parameter set after initialisation, a call out of order) returns
an error with one sentence in the log, without debug logging too, and the instance continues. An input that is not a number, or a contact off the
profile, is not an error but a <code>status</code>.</p>
<p>It is for co-simulation and for model exchange, with the same variables and values. In model exchange it has no states, no event
indicators and no events of its own: outputs follow the inputs at every point that a solver tries. Where these have no valid result,
outputs hold those of the last accepted point that had one.</p>
<p>It has directional derivatives of all continuous outputs with respect to all inputs{ADJOINT[version]}. At a jump they are
those of the side on which the pose lies. With status 1 the derivatives of the unloaded wheel's patch are zero; with status 2
and higher, where outputs are held, all are zero.</p>
<p>A step with new inputs takes about 0.02 ms, all outputs read. Memory is allocated when an instance is created and
initialised, and for saved states, never in a step. Instances share constant data only, so each may run in a thread of its
own; one instance is for one thread at a time.</p>
<p>A saved state holds inputs, parameters, outputs, the time, stopTime and the start values of the search. A simulation that continues
from it gives the same bits as one that was not interrupted. Its bytes can be read by any instance of the same FMU (same
{TOKENS[version]}) on the same kind of machine; other instances refuse them.</p>
"""


OUTLINES = {
    2: "The outline of a wheel's patch is 31 scalars each of <code>station</code>, <code>half_length</code>, "
    "<code>pressure</code>, <code>shear</code> and <code>slip</code>, and if <code>wear_outputs</code> is true "
    "also <code>wheel_place</code>, <code>rail_place</code>, <code>power</code> and <code>patch_of</code>, "
    "otherwise zero; the FMU of FMI 3.0 has arrays instead.",
    3: "The outline of a wheel's patch is in the arrays <code>station</code>, <code>half_length</code>, "
    "<code>pressure</code>, <code>shear</code> and <code>slip</code>, and if <code>wear_outputs</code> is true "
    "also in <code>wheel_place</code>, <code>rail_place</code>, <code>power</code> and <code>patch_of</code>, "
    "otherwise zero, evenly spaced from the first loaded place to the last. Their length is the "
    "structural parameter <code>stations</code>, 3 &hellip; 201: set it with fmi3SetUInt64 between "
    "fmi3EnterConfigurationMode and fmi3ExitConfigurationMode, before the initialisation; no other output "
    "depends on it. An array has one value reference, and a call needs room for all its values. Value "
    "references start at 1 and differ from those of the FMU of FMI 2.0.",
}
LISTS = {
    2: "<code>SourceFiles</code> in the model description",
    3: "<code>sources/buildDescription.xml</code>",
}
ADJOINT = {2: "", 3: ", and adjoint ones"}
TOKENS = {2: "guid", 3: "instantiation token"}


# --- from the model description ----------------------------------------------------------------------


TABLES = {
    "input": "Inputs",
    "structuralParameter": "Structural parameters (sizes of arrays)",
    "parameter": "Parameters (fixed after initialisation)",
    "output": "Outputs (side: left or right, patches k = 1 &hellip; 3; outlines at stations j, 31 by "
    "default)",
    "independent": "Time",
}


KINDS = {"ModelExchange": "model exchange", "CoSimulation": "co-simulation"}


def _abilities(root):
    """Capabilities and log categories, as the model description declares them."""
    rows = "".join(
        f"<tr><td>{words}</td><td><code>{name}</code></td><td>{value}</td></tr>\n"
        for kind, words in KINDS.items()
        for element in root.iter(kind)
        for name, value in element.attrib.items()
        if name != "modelIdentifier"
    )
    logs = "".join(
        f"<tr><td><code>{category.get('name')}</code></td><td>{escape(category.get('description'))}</td></tr>\n"
        for category in root.iter("Category")
    )
    return (
        f"<h2>Capabilities</h2>\n<table>\n<tr><th>for</th><th>capability</th><th>declared</th></tr>\n{rows}</table>\n"
        f"<h2>Log categories</h2>\n<table>\n<tr><th>category</th><th>lines</th></tr>\n{logs}</table>\n"
    )


def _table(title, causality, root):
    """A table of all variables of one causality, without empty columns; left and right, patches and stations
    share a row."""
    groups = {}
    for variable in root.find("ModelVariables"):
        if variable.get("causality") == causality:
            groups.setdefault(folded(variable.get("name")), []).append(variable)
    if not groups:
        return ""
    table = [HEADINGS, *(_row(name, members, root) for name, members in groups.items())]
    kept = [k for k in range(len(HEADINGS)) if any(row[k] for row in table[1:])]
    rows = [
        "".join(f"<{tag}>{row[k]}</{tag}>" for k in kept)
        for row, tag in zip(table, ["th"] + ["td"] * (len(table) - 1))
    ]
    return f"<h2>{title}</h2>\n<table>\n" + "".join(f"<tr>{row}</tr>\n" for row in rows) + "</table>\n"


HEADINGS = ("name", "reference", "unit", "shown in", "start", "permitted", "meaning")


def _row(name, members, root):
    """The cells of one row; ``members`` are variables that differ only by side, patch or station."""
    first = members[0]
    # nested in FMI 2
    attributes = {**first.attrib, **(first[0].attrib if first.tag == "ScalarVariable" else {})}
    start = attributes.get("start") or next((element.get("value") for element in first.iter("Start")), "")
    meaning = attributes["description"]
    return (
        f"<code>{escape(name + _size(first, root))}</code>",
        _references(members),
        escape(attributes.get("unit", "")),
        escape(attributes.get("displayUnit", "")),
        escape(_short(start)),
        ", ".join(CHOICES.get(name, ())) or _limits(attributes.get("min"), attributes.get("max")),
        escape(meaning.split(": ", 1)[1] if name.startswith("side.") else meaning),
    )


def _size(variable, root):
    """The size of an array: a number, or the name of the variable that defines it; "" for a scalar."""
    sizes = []
    for dimension in variable.iter("Dimension"):
        reference = dimension.get("valueReference")
        named = [v.get("name") for v in root.find("ModelVariables") if v.get("valueReference") == reference]
        sizes.append(dimension.get("start") or named[0])
    return f"[{', '.join(sizes)}]" if sizes else ""


def _limits(low, high):
    """A range, open where a limit is None."""
    if low and high:
        return f"<span>{float(low):g} &hellip; {float(high):g}</span>"
    return f"&ge; {float(low):g}" if low else f"&le; {float(high):g}" if high else ""


def _short(number):
    """A number with as few digits as possible; other text unchanged."""
    try:
        return f"{float(number):.10g}"
    except ValueError:
        return number


def _references(members):
    """Value references of variables, by side where there are two: "left 28 &hellip; 58; right 162 &hellip;
    192"."""
    sides = {}
    for variable in members:
        side = variable.get("name").split(".")[0]
        sides.setdefault(side if side in SIDES else "", []).append(int(variable.get("valueReference")))
    return "; ".join(f"{side} {_runs(references)}".strip() for side, references in sides.items())


def _runs(numbers):
    """Rising numbers as text, with consecutive ones joined: "1, 5 &hellip; 9"."""
    runs = []
    for number in numbers:
        if runs and number == runs[-1][1] + 1:
            runs[-1][1] = number
        else:
            runs.append([number, number])
    return ", ".join(f"{first}" if first == last else f"{first} &hellip; {last}" for first, last in runs)
