"""Steps an FMU over rows of inputs in an importer that is not fmpy, in a process of its own, and
prints what it saw as JSON.

    python importer_process.py <importer> <FMU> (on standard input: "rows" of inputs by name,
    "names" of Real outputs)
"""

import json
import os
import sys
import zipfile
from xml.etree import ElementTree

STEP = 0.01  # [s]


def references(fmu):
    """Value references of an FMU of FMI 2 by name."""
    with zipfile.ZipFile(fmu) as archive:
        root = ElementTree.fromstring(archive.read("modelDescription.xml"))
    return {v.get("name"): int(v.get("valueReference")) for v in root.iter("ScalarVariable")}


def libcosimpy(fmu, rows, names):
    """Open Simulation Platform's libcosim."""
    from libcosimpy.CosimExecution import CosimExecution
    from libcosimpy.CosimManipulator import CosimManipulator
    from libcosimpy.CosimObserver import CosimObserver
    from libcosimpy.CosimSlave import CosimLocalSlave

    known = references(fmu)
    execution = CosimExecution.from_step_size(int(STEP * 1e9))
    index = execution.add_local_slave(local_slave=CosimLocalSlave(fmu_path=fmu, instance_name="wheelset"))
    observer, manipulator = CosimObserver.create_last_value(), CosimManipulator.create_override()
    execution.add_observer(observer=observer)
    execution.add_manipulator(manipulator=manipulator)
    for row in rows:
        manipulator.slave_real_values(
            slave_index=index, variable_references=[known[name] for name in row], values=list(row.values())
        )
        execution.step()
        yield observer.last_real_values(
            slave_index=index, variable_references=[known[name] for name in names]
        )


def ecospy(fmu, rows, names):
    """Ecos."""
    from ecospy import EcosSimulation, EcosSimulationStructure

    with EcosSimulationStructure() as structure:
        structure.add_model("wheelset", fmu)
        with EcosSimulation(structure=structure, step_size=STEP) as simulation:
            simulation.init()
            for row in rows:
                for name, value in row.items():
                    simulation.set_real(f"wheelset::{name}", value)
                simulation.step(1)
                yield [simulation.get_real(f"wheelset::{name}") for name in names]


if __name__ == "__main__":
    importer, file = sys.argv[1:]
    answer = json.dumps({"seen": [list(seen) for seen in globals()[importer](file, **json.load(sys.stdin))]})
    print("\n" + answer, flush=True)
    os._exit(0)  # without what the importers do at the end of a process
