"""The FMU's modelDescription.xml, from the one table of variables."""

from xml.etree.ElementTree import Element, SubElement, indent, tostring

from ..interface.variables import INPUT, OUTPUT, PARAMETER, REFERENCE, UNITS, VARIABLES
from .variants import WHEELSET

MODEL = WHEELSET.model

#: Of co-simulation and of model exchange.
COMMON = {
    "needsExecutionTool": "false",
    "canBeInstantiatedOnlyOncePerProcess": "false",
    "canNotUseMemoryManagementFunctions": "true",
    "canGetAndSetFMUstate": "true",
    "canSerializeFMUstate": "true",
}
STEPS = {"canHandleVariableCommunicationStepSize": "true", "canInterpolateInputs": "false"}
#: The native FMU has directional derivatives and model exchange, the Python FMU has neither.
PYTHON = {"CoSimulation": {**COMMON, **STEPS, "providesDirectionalDerivative": "false"}}
NATIVE = {
    "ModelExchange": {
        **COMMON,
        "completedIntegratorStepNotNeeded": "false",
        "providesDirectionalDerivative": "true",
    },
    "CoSimulation": {**COMMON, **STEPS, "providesDirectionalDerivative": "true"},
}

LOG_CATEGORIES = {
    "logStatusWarning": "One line for every step whose status is not 0: the variable, its value and the "
    "limit",
    "logStatusError": "Why a call failed: a parameter, a saved state or a value that was refused",
}


def model_description(guid, tool, version, starts, units=(), variant=WHEELSET):
    """The whole file as bytes; ``starts`` holds start values that differ from the table's, ``units`` the C
    files to compile of a native FMU, which has its sources with it; ``variant`` is a wheelset or one
    wheel."""
    root = Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=variant.model,
        guid=guid,
        description=variant.description,
        version=version,
        generationTool=tool,
        variableNamingConvention="structured",
    )
    if units:
        root.set("numberOfEventIndicators", "0")
    for kind, abilities in (NATIVE if units else PYTHON).items():
        element = SubElement(root, kind, {"modelIdentifier": variant.model, **abilities})
        if units:
            files = SubElement(element, "SourceFiles")
            for name in units:
                SubElement(files, "File", name=name)
    describe_common(root)
    _variables(SubElement(root, "ModelVariables"), starts, variant)
    _structure(SubElement(root, "ModelStructure"), variant)
    return xml_file(root)


def xml_file(root):
    """The bytes of an XML file."""
    indent(root)
    return tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"


def describe_common(root):
    """What stands between capabilities and variables in each version of FMI: units by their SI exponents,
    each with the unit to show, log categories, and a default experiment."""
    parent = SubElement(root, "UnitDefinitions")
    for unit in UNITS.values():
        element = SubElement(parent, "Unit", name=unit.name)
        SubElement(element, "BaseUnit", {base: str(exponent) for base, exponent in unit.base.items()})
        if unit.display:
            SubElement(element, "DisplayUnit", name=unit.display, factor=number_text(unit.display_factor))
    categories = SubElement(root, "LogCategories")
    for name, meaning in LOG_CATEGORIES.items():
        SubElement(categories, "Category", name=name, description=meaning)
    SubElement(root, "DefaultExperiment", startTime="0", stopTime="1", stepSize="0.001")


def _variables(parent, starts, variant):
    """Every variable, in the order of the table."""
    starts = variant.named(starts)
    for place, variable in variant.variables():
        element = SubElement(
            parent,
            "ScalarVariable",
            name=variable.name,
            valueReference=str(REFERENCE[VARIABLES[place].name]),
            description=variable.description,
            causality=variable.causality,
            variability=variable.variability,
        )
        if variable.causality != INPUT:
            element.set("initial", "exact" if variable.causality == PARAMETER else "calculated")
        SubElement(element, variable.type, attributes_of(variable, starts))


def attributes_of(variable, starts):
    """Start, unit and limits of one variable, as text."""
    unit = UNITS.get(variable.unit)
    attributes = {
        "start": starts.get(variable.name, variable.start),
        "quantity": unit.quantity if unit else None,
        "unit": variable.unit,
        "displayUnit": unit.display if unit else None,
        "min": variable.minimum,
        "max": variable.maximum,
        "nominal": variable.nominal,
    }
    return {
        name: number_text(value)
        for name, value in attributes.items()
        if value is not None and (value != "" or name == "start")
    }


def number_text(value):
    """A number so that it is read back exactly; a Boolean as XML has it; text as it is."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, float) else str(value)


def _structure(parent, variant):
    """Which inputs each output follows, and what is computed in initialisation from which inputs and
    parameters."""
    variables = [variable for _, variable in variant.variables()]
    places = {variable.name: place for place, variable in enumerate(variables)}
    known = [places[variable.name] for variable in variables if variable.causality == PARAMETER]
    for section, extra in (("Outputs", []), ("InitialUnknowns", known)):
        unknowns = SubElement(parent, section)
        for variable in variables:
            if variable.causality == OUTPUT:
                inputs = [places[name] for name in variable.depends_on]
                _unknown(unknowns, places[variable.name], inputs + extra)


def _unknown(parent, place, follows):
    """One dependency entry; FMI 2 counts variables from 1 there, in the order of the file."""
    SubElement(
        parent,
        "Unknown",
        index=str(place + 1),
        dependencies=" ".join(str(known + 1) for known in sorted(follows)),
        dependenciesKind=" ".join("dependent" for _ in follows),
    )
