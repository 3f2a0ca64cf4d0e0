"""The closed loop as an SSP archive (System Structure and Parameterization 1.0), and run by libcosim.

    python -m examples.hunting_wheelset.structure [FOLDER]

writes hunting_wheelset.ssp with both FMUs, and runs it, if libcosimpy is installed (``pip install
libcosimpy``), beside fmpy in the order in which libcosim steps.

The parameters of a run stand twice in the archive: as files ``contact.ssv`` and ``wheelset.ssv`` for tools
that read parameter sets, and as start values of the two FMUs, which are built for this run, for those that
do not (``fmpy.ssp.simulation.simulate_ssp``).
"""

import sys
import zipfile
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from wrcontact.fmu.native import build_native_fmus

from .coupling import CONTACT, TO_CONTACT, TO_WHEELSET, Loop, build, build_wheelset
from .wheelset import MOTION

SPACES = {
    "ssd": "http://ssp-standard.org/SSP1/SystemStructureDescription",
    "ssc": "http://ssp-standard.org/SSP1/SystemStructureCommon",
    "ssv": "http://ssp-standard.org/SSP1/SystemStructureParameterValues",
}
CONTACT_NAME, WHEELSET_NAME = "contact", "wheelset"
#: A run that shows hunting: speed [m/s], start [m], springs [N/m] of an axle box.
EXAMPLE = {
    "frame_speed": 20.0,
    "start_lateral_shift": 2e-3,
    "longitudinal_stiffness": 4e5,
    "lateral_stiffness": 2e5,
}
#: libcosim hands the forces on one step late, which takes damping from the springs of the contacts, so that
#: steps [s] are smaller than where the contact comes first.
STEP = 2e-5


def _child(parent, name, /, **attributes):
    space, word = name.split(":")
    return ElementTree.SubElement(parent, f"{{{SPACES[space]}}}{word}", attributes)


def _component(elements, name, archive, ports):
    """A component with its connectors ``(name, kind)``, and its parameters in a file of its name."""
    part = _child(
        elements,
        "ssd:Component",
        name=name,
        source=f"resources/{archive.name}",
        type="application/x-fmu-sharedlibrary",
    )
    connectors = _child(part, "ssd:Connectors")
    for port, kind in ports:
        _child(_child(connectors, "ssd:Connector", name=port, kind=kind), "ssc:Real")
    bindings = _child(part, "ssd:ParameterBindings")
    _child(bindings, "ssd:ParameterBinding", source=f"resources/{name}.ssv")


def _parameters(name, parameters):
    """The bytes of a file of ``parameters`` by their names."""
    root = ElementTree.Element(f"{{{SPACES['ssv']}}}ParameterSet", {"version": "1.0", "name": name})
    table = _child(root, "ssv:Parameters")
    for parameter, value in parameters.items():
        kind = "ssv:String" if isinstance(value, str) else "ssv:Real"
        text = value if isinstance(value, str) else repr(float(value))
        _child(_child(table, "ssv:Parameter", name=parameter), kind, value=text)
    return _bytes(root)


def _bytes(root):
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="UTF-8", xml_declaration=True)


def build_with(folder, contact, wheelset):
    """Archives of contact and wheelset in ``folder`` that start with these values by name."""
    return build_native_fmus(folder, settings=contact)[0], build_wheelset(folder, wheelset)


def write_ssp(path, archives, contact, wheelset):
    """Write the SSP archive ``path`` of both FMUs.

    Parameters
    ----------
    path : of the archive; its folder must exist.
    archives : FMUs of contact and wheelset; :func:`build_with` builds them with the start values below.
    contact, wheelset : values of their parameters and unconnected inputs, by name; SI.

    Returns
    -------
    Path of the archive.
    """
    for prefix, space in SPACES.items():
        ElementTree.register_namespace(prefix, space)
    root = ElementTree.Element(
        f"{{{SPACES['ssd']}}}SystemStructureDescription", {"name": "hunting_wheelset", "version": "1.0"}
    )
    system = _child(
        root,
        "ssd:System",
        name="hunting_wheelset",
        description="A wheelset on its primary suspension and its contacts with the rails",
    )
    elements, connections = _child(system, "ssd:Elements"), _child(system, "ssd:Connections")
    ends = (
        (CONTACT_NAME, TO_CONTACT, TO_WHEELSET, contact),
        (WHEELSET_NAME, TO_WHEELSET, TO_CONTACT, wheelset),
    )
    for archive, (name, into, out_of, _) in zip(archives, ends):
        ports = [(target, "input") for _, target in into] + [(source, "output") for source, _ in out_of]
        _component(elements, name, Path(archive), ports)
    for start, end, pairs in (
        (WHEELSET_NAME, CONTACT_NAME, TO_CONTACT),
        (CONTACT_NAME, WHEELSET_NAME, TO_WHEELSET),
    ):
        for source, target in pairs:
            _child(
                connections,
                "ssd:Connection",
                startElement=start,
                startConnector=source,
                endElement=end,
                endConnector=target,
            )
    _child(root, "ssd:DefaultExperiment", startTime="0.0", stopTime="1.0")
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("SystemStructure.ssd", _bytes(root))
        for fmu, (name, _, _, values) in zip(archives, ends):
            archive.write(fmu, f"resources/{Path(fmu).name}")
            archive.writestr(f"resources/{name}.ssv", _parameters(name, values))
    return Path(path)


def run_libcosim(ssp, count, step):
    """Motion of the wheelset (count, 9) after each of ``count`` steps of ``step`` [s], and the largest status
    of the contact."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimLogging import CosimLogLevel, log_output_level
    from libcosimpy.CosimObserver import CosimObserver

    log_output_level(CosimLogLevel.WARNING)
    execution = CosimExecution.from_ssp_file(ssp_path=str(ssp), step_size=round(step * 1e9))
    observer = CosimObserver.create_last_value()
    execution.add_observer(observer=observer)
    contact, wheelset = (
        execution.slave_index_from_instance_name(name) for name in (CONTACT_NAME, WHEELSET_NAME)
    )

    def references(slave, names):
        known = {variable.name.decode(): variable.reference for variable in execution.slave_variables(slave)}
        return [known[name] for name in names]

    moving, status, rows, worst = references(wheelset, MOTION), references(contact, ["status"]), [], 0
    for _ in range(count):
        execution.step()
        rows.append(list(observer.last_real_values(slave_index=wheelset, variable_references=moving)))
        worst = max(worst, *observer.last_integer_values(slave_index=contact, variable_references=status))
    return np.array(rows), worst


def settings(archives, wheelset, contact=None, friction=0.3):
    """Parameters and start values (contact, wheelset) that a :class:`Loop` gives both FMUs."""
    with Loop(archives, wheelset, contact, friction) as loop:
        stand = dict(zip(("start_vertical_shift", "start_roll"), loop.stand))
        # until the first values are handed on
        begin = dict(zip([target for _, target in TO_CONTACT], loop.motion.read()))
    load = wheelset.get("load", 157e3)
    inputs = {"normal_force": load / 2, "left.friction": friction, "right.friction": friction}
    return CONTACT | (contact or {}) | inputs | begin, stand | wheelset


def compare(folder, archives, count=10000, step=STEP):
    """Motion (count, 9) by libcosim and by fmpy in the same order, the largest status of both, and the
    archive in ``folder``, whose FMUs are built anew with the start values of the run."""
    values = settings(archives, EXAMPLE)
    folder = Path(folder)
    ssp = write_ssp(folder / "hunting_wheelset.ssp", build_with(folder / "ssp", *values), *values)
    with Loop(archives, EXAMPLE) as loop:
        run = loop.run(count * step, step, parallel=True)
        mine = np.vstack([run.motion[1:], loop.motion.read()[: len(MOTION)]])
    theirs, worst = run_libcosim(ssp, count, step)
    return theirs, mine, max(worst, run.worst_status), ssp


if __name__ == "__main__":
    folder = (sys.argv[1:] or ["out"])[0]
    theirs, mine, worst, ssp = compare(folder, build(folder))
    print(f"{ssp}: {len(mine)} steps by libcosim and by fmpy, largest status {worst}")
    for name, column, other in zip(MOTION, theirs.T, mine.T):
        print(f"{name:20s} largest {np.abs(column).max():.6g}, difference {np.abs(column - other).max():.1e}")
