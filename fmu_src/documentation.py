"""The FMU's documentation/index.html: the method's equations, conventions, and the table of variables."""

from html import escape

from ..interface.variables import INPUT, OUTPUT, PARAMETER, UNITS, documented

STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; color: #222; }
table { border-collapse: collapse; width: 100%; font-size: 90%; }
th, td { text-align: left; vertical-align: top; padding: .2em .6em; border-bottom: 1px solid #ddd; }
.equation { margin: .6em 2em; font-family: serif; font-size: 110%; }
code { white-space: nowrap; }
"""

METHOD = """
<h2>How to use it</h2>
<p>Set the inputs, step, read the outputs. They follow the inputs at once: the model has no dynamics of its own, any
step size is right, and outputs are valid before the first step. A step with unchanged inputs costs nothing.
<code>status</code> tells the outcome of a step; other than 0 it comes with one line in the log that names the variable,
its value and the limit. The step itself always succeeds, and the next valid input gives a valid result.</p>
<table>
<tr><th>status</th><th>meaning</th><th>outputs</th></tr>
<tr><td>0</td><td>valid</td><td>valid</td></tr>
<tr><td>1</td><td>unloaded: a wheel has no normal force, or is lifted in compliant contact</td><td>valid; the patch of that wheel is empty</td></tr>
<tr><td>2</td><td>off the profile: no contact point within wheel and rail profile, or deeper than 2 mm in it</td><td>last valid values</td></tr>
<tr><td>3</td><td>not converged</td><td>last valid values</td></tr>
<tr><td>4</td><td>invalid input: not a number, infinite, a negative force, a load transfer beyond &plusmn;1</td><td>last valid values</td></tr>
</table>
<p>The native FMU has directional derivatives of all continuous outputs against all inputs, those of FMI 3.0 adjoint ones too. At a
jump it is the derivative of the side on which the pose stands; with status 1 the lifted wheel's patch has none, and with status 2 and
more, where outputs are held, all are zero.</p>

<h2>Conventions</h2>
<p>All values are in SI units (m, N, Pa, rad); display units are mm, deg, kN, MPa, mm&sup2;. Track frame: x forward, y to
the right, z down, origin on the track centre line at top of rail. Yaw &psi; is positive clockwise seen from above, roll
&theta; positive with the right wheel down; the attitude of the wheelset is
R = R<sub>z</sub>(&psi;) R<sub>x</sub>(&theta;). Wheel and rail profile frames have y to the field side and z down, on both
sides (the left side is the mirror image of the right one): the flange is at negative y, and
<code>y_wheel</code>, <code>y_rail</code>, stations and centroids of both wheels compare directly. Only
<code>y_track</code> is not mirrored. The contact angle is positive towards the flange.</p>
<p><code>force</code> and <code>moment</code> are the resultant of the contact forces of both rails on the wheelset, in the
axes of the track frame; the moment is about the wheelset's centre, which is at (0, <code>lateral_shift</code>,
<code>vertical_shift</code> &minus; <code>nominal_radius</code>). There is no friction: each patch pushes along its own normal.</p>

<h2>Contact modes</h2>
<p><code>contact_mode</code> rigid (default): height and roll are those at which the undeformed wheels touch, and each wheel
is pressed along its normal there. Elastic: the wheels sink in until each carries its load, which gives height and roll; under
a small load that is the rigid pose. Compliant: height and roll are the inputs <code>vertical_shift_input</code> and
<code>roll_input</code>, and the loads follow from how deep each wheel stands; <code>normal_force</code> and
<code>load_transfer</code> are not read, and the outputs <code>force</code> and <code>moment</code> close the loop to a
wheelset with mass. Inputs that a mode does not read may have any permitted value. <code>load</code> says what
<code>normal_force</code> prescribes: the total over the patches of a wheel, or the vertical component of their resultant.</p>

<h2>Contact geometry</h2>
<p>The wheel is a surface of revolution with radius r(y), the rail a cylinder along x: at a contact the common normal has
no x component. This fixes the angle around the wheel for every point of the profile, the <em>contact locus</em>:</p>
<p class="equation">&phi;(y) = &minus;arctan t &minus; arcsin w, &nbsp; t = tan &psi; sin &theta;, &nbsp;
w = &plusmn; tan &psi; cos &theta; r&prime;(y) / &radic;(1 + t&sup2;) &nbsp; (+ right wheel, &minus; left wheel)</p>
<p>Along it the vertical gap between wheel and rail is a function of one coordinate,</p>
<p class="equation">g(y) = z<sub>rail</sub>(Y(y)) &minus; Z(y),</p>
<p>with (Y, Z) the outline of the wheel seen along the track. The contact point is where the gap is smallest; every local
minimum close to the smallest one is refined, so that the contact does not depend on where the wheelset was before.</p>
<p>Rigid wheelsets roll until the smallest gaps are equal left and right:</p>
<p class="equation">G(&theta;) = min g<sub>right</sub> &minus; min g<sub>left</sub> = 0.</p>
<p>The derivative of a minimum is the partial derivative at the fixed place of the minimum (envelope theorem),</p>
<p class="equation">d(min g) / d&theta; = z&prime;<sub>rail</sub> &part;Y/&part;&theta; &minus; &part;Z/&part;&theta;,</p>
<p>so that Newton's method inside a bracket finds the roll in a few steps. The vertical shift is the gap that is left.</p>

<h2>Normal contact</h2>
<p>Hertz: with the relative curvatures of the undeformed distance z = A x&sup2; + B s&sup2; (x rolling direction, s in the
contact plane), the normal force N and 1/E* = 2 (1 &minus; &nu;&sup2;) / E,</p>
<p class="equation">c = (3 N / (4 E* (A + B)))<sup>1/3</sup>, &nbsp; a = m c, &nbsp; b = n c, &nbsp;
&delta; = r ((3 N / (4 E*))&sup2; (A + B))<sup>1/3</sup>, &nbsp; p<sub>0</sub> = 3 N / (2 &pi; a b)</p>
<p>where m, n, r follow from the complete elliptic integrals K(e) and E(e) of the ellipse with the ratio q of its
semi-axes and e&sup2; = 1 &minus; q&sup2;: with L = (2 E(e) / (&pi; q&sup2;))<sup>1/3</sup> the longer of m, n is L and the
other q L, r = 2 K(e) / (&pi; L), and the smaller curvature is to the larger as (K(e) &minus; E(e)) to
(E(e) / q&sup2; &minus; K(e)).</p>
<p>ANALYN (Sichani, Enblom and Berg) takes the undeformed distance g(s) and the local curvature B(s) across the patch:</p>
<p class="equation">&alpha; = (r / m&sup2;)(1 + B / A) &minus; 1, &nbsp; &beta; = (r / n&sup2;)(1 + A / B) &minus; 1</p>
<p class="equation">d(s) = &delta;<sub>0</sub> &minus; (1 + &beta;) g(s), &nbsp;
a(s) = &radic;(d / ((1 + &alpha;) A)), &nbsp; p<sub>0</sub>(s) = (2 E* / &pi;) d / (n r a)</p>
<p class="equation">p(x, s) = p<sub>0</sub>(s) &radic;(1 &minus; (x / a(s))&sup2;), &nbsp;
N = &int; (&pi; / 2) a(s) p<sub>0</sub>(s) ds</p>
<p>&delta;<sub>0</sub> is found from the prescribed N. The factor of p<sub>0</sub> is 2 E*/&pi;; with constant A and B the
result is that of Hertz. Separate loaded regions are reported as patches, by falling load.</p>
"""


def documentation_page(version, starts):
    """The page as text; ``starts`` holds start values that differ from the table's."""
    tables = "".join(_table(title, causality, starts) for causality, title in TABLES.items())
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n<title>WheelsetContact</title>\n'
        f"<style>{STYLE}</style>\n</head>\n<body>\n<h1>WheelsetContact</h1>\n"
        f"<p>Wheel-rail contact of one wheelset on track; wrcontact {escape(version)}.</p>\n"
        f"{METHOD}\n{tables}<p>Licences: <a href=\"licenses/\">licenses</a>.</p>\n</body>\n</html>\n"
    )


TABLES = {
    INPUT: "Inputs",
    PARAMETER: "Parameters (fixed after initialisation)",
    OUTPUT: "Outputs (side is left or right, k = 1 &hellip; 3, j = 1 &hellip; 31)",
}


def _table(title, causality, starts):
    """All variables of one causality as a table."""
    rows = "".join(_row(name, variable, starts) for name, variable in documented() if variable.causality == causality)
    head = "<tr><th>name</th><th>unit</th><th>shown in</th><th>start</th><th>limits</th><th>meaning</th></tr>\n"
    return f"<h2>{title}</h2>\n<table>\n{head}{rows}</table>\n"


def _row(name, variable, starts):
    """One variable as a table row."""
    unit = UNITS.get(variable.unit)
    start = starts.get(variable.name, variable.start)
    limits = (("&ge;", variable.minimum), ("&le;", variable.maximum))
    cells = [
        f"<code>{escape(name)}</code>",
        escape(variable.unit),
        unit.display if unit else "",
        "" if start is None else escape(f"{start:.10g}" if isinstance(start, float) else start),
        " or ".join(variable.choices) or ", ".join(f"{sign} {limit:g}" for sign, limit in limits if limit is not None),
        escape(variable.meaning),
    ]
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>\n"
