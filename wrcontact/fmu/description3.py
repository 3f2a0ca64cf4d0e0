"""The modelDescription.xml of FMI 3.0, from the one table of variables; outlines are arrays there."""

import re
from typing import NamedTuple
from xml.etree.ElementTree import Element, SubElement

from ..interface.outputs import SIDE, WEAR
from ..interface.references import STORED, numbered
from ..interface.rows import Run
from ..interface.variables import BOOLEAN, INPUT, INTEGER, OUTPUT, PARAMETER, REAL, STRING, VARIABLES
from ..kernel.layout import STATION_COUNT, STATION_LEAST, STATION_LIMIT
from .description import attributes_of, describe_common, xml_file
from .variants import WHEELSET

#: Of co-simulation and of model exchange.
CAPABILITIES = {
    "needsExecutionTool": "false",
    "canBeInstantiatedOnlyOncePerProcess": "false",
    "canGetAndSetFMUState": "true",
    "canSerializeFMUState": "true",
    "providesDirectionalDerivatives": "true",
    "providesAdjointDerivatives": "true",
}
#: And those of each kind.
KINDS = {
    "ModelExchange": {**CAPABILITIES, "needsCompletedIntegratorStep": "true"},
    "CoSimulation": {**CAPABILITIES, "canHandleVariableCommunicationStepSize": "true"},
}

TYPES = {REAL: "Float64", INTEGER: "Int32", BOOLEAN: "Boolean", STRING: "String"}
RUNS = "|".join(row.name for row in (*SIDE, *WEAR) if isinstance(row, Run))
FIRST_STATION = re.compile(rf"(.*\.(?:{RUNS}))\[1\]")
STATIONS_REFERENCE = STORED[3]["stations"]  # by which arrays say their size
TIME, STATIONS, RETIRED = -1, -2, -3  # places of the two that are not in the table, and of no variable
SINGLE = -1  # run of a variable that is no array


class Block(NamedTuple):
    """An FMI 3 variable: where its values begin in the table, which array it is, or SINGLE, and its value
    reference."""

    name: str
    first: int
    run: int
    reference: int


def variable_blocks(variant=WHEELSET):
    """The :class:`Block` of every FMI 3 variable, in the order of the table.

    Arrays have as many values as there are stations; one of STATION_COUNT lies in the table.
    """
    found, place, run = [("time", TIME, SINGLE), ("stations", STATIONS, SINGLE)], 0, 0
    while place < len(VARIABLES):
        name = VARIABLES[place].name
        array = FIRST_STATION.fullmatch(name)
        found.append((array[1], place, run) if array else (name, place, SINGLE))
        place, run = (place + STATION_COUNT, run + 1) if array else (place + 1, run)
    references = numbered([name for name, *_ in found], 3)
    return [Block(own, *block, references[name]) for name, *block in found if (own := variant.name(name))]


def model_description(token, tool, version, starts, units=(), variant=WHEELSET):
    """The whole file as bytes; ``starts`` holds start values that differ from the table's; ``units`` stand in
    the build description here."""
    root = Element(
        "fmiModelDescription",
        fmiVersion="3.0",
        modelName=variant.model,
        instantiationToken=token,
        description=variant.description,
        version=version,
        generationTool=tool,
        variableNamingConvention="structured",
    )
    for kind, abilities in KINDS.items():
        SubElement(root, kind, {"modelIdentifier": variant.model, **abilities})
    describe_common(root)
    blocks = variable_blocks(variant)
    variables, starts = SubElement(root, "ModelVariables"), variant.named(starts)
    for block in blocks:
        _variable(variables, block, starts, variant)
    _structure(SubElement(root, "ModelStructure"), blocks, variant)
    return xml_file(root)


def build_description(units, variant=WHEELSET):
    """The file sources/buildDescription.xml as bytes: which C files are compiled, by which compiler, and how.

    The options are those of gcc, which is named with them; clang takes the same ones.
    """
    root = Element("fmiBuildDescription", fmiVersion="3.0")
    configuration = SubElement(root, "BuildConfiguration", modelIdentifier=variant.model)
    files = SubElement(
        configuration,
        "SourceFileSet",
        language="C11",
        compiler="gcc",
        compilerOptions="-O3 -ffp-contract=off -fno-math-errno",
    )
    for name in units:
        SubElement(files, "SourceFile", name=name)
    SubElement(configuration, "Library", name="m", external="true", description="mathematical functions of C")
    return xml_file(root)


def _variable(parent, block, starts, variant):
    """One variable, or one array of them."""
    name, first, run, reference = block
    if first == TIME:
        SubElement(
            parent,
            "Float64",
            name=name,
            valueReference=str(reference),
            causality="independent",
            variability="continuous",
            description="Simulation time",
        )
        return
    if first == STATIONS:
        SubElement(
            parent,
            "UInt64",
            name=name,
            valueReference=str(reference),
            causality="structuralParameter",
            variability="fixed",
            description="Number of stations of an outline, evenly spaced over the loaded width",
            start=str(STATION_COUNT),
            min=str(STATION_LEAST),
            max=str(STATION_LIMIT),
        )
        return
    variable = variant.variable(VARIABLES[first])
    element = SubElement(
        parent,
        TYPES[variable.type],
        name=name,
        valueReference=str(reference),
        description=variable.description if run == SINGLE else _of_all(variable),
        causality=variable.causality,
        variability=variable.variability,
    )
    if variable.causality != INPUT:
        element.set("initial", "exact" if variable.causality == PARAMETER else "calculated")
    attributes = attributes_of(variable, starts)
    start = attributes.pop("start", None)
    for key, value in attributes.items():
        element.set(key, value)
    if variable.type == STRING:
        SubElement(element, "Start", value=start)
    elif start is not None:
        element.set("start", start)
    if run != SINGLE:
        SubElement(element, "Dimension", valueReference=str(STATIONS_REFERENCE))


def _of_all(variable):
    """What an array means: its first value's meaning without the place of that."""
    return f"{variable.place.split(',')[0]}: {variable.meaning}"


def _structure(parent, blocks, variant):
    """Which inputs each output follows, and what is computed in initialisation from which inputs and
    parameters."""
    known = {block.name: block.reference for block in blocks}
    parameters = [known[v.name] for _, v in variant.variables() if v.causality == PARAMETER]
    for section, extra in (("Output", []), ("InitialUnknown", parameters)):
        for _, first, run, reference in blocks:
            if first < 0 or VARIABLES[first].causality != OUTPUT:
                continue
            size = [STATIONS_REFERENCE] if extra and run != SINGLE else []
            inputs = [known[name] for name in variant.variable(VARIABLES[first]).depends_on]
            follows = sorted(inputs + extra + size)
            SubElement(
                parent,
                section,
                valueReference=str(reference),
                dependencies=" ".join(map(str, follows)),
                dependenciesKind=" ".join("dependent" for _ in follows),
            )
