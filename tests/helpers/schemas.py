"""The XML files of an FMU against the schemas of the FMI standards, as fmpy carries them."""

import zipfile
from pathlib import Path

import fmpy
from lxml import etree

FOLDER = Path(fmpy.__file__).parent / "schema"
#: Schema of every XML file but the model description that an FMU of FMI 3 of ours holds.
SCHEMAS = {
    "terminalsAndIcons/terminalsAndIcons.xml": "fmi3/fmi3TerminalsAndIcons.xsd",
    "sources/buildDescription.xml": "fmi3/fmi3BuildDescription.xsd",
}


def xml_problems(file, version):
    """What the schemas find wrong in the XML files of an archive of FMI ``version``: lines by file name."""
    schemas = {"modelDescription.xml": f"fmi{version}/fmi{version}ModelDescription.xsd", **SCHEMAS}
    with zipfile.ZipFile(file) as archive:
        return {
            name: problems_of(archive.read(name), schemas[name])
            for name in archive.namelist()
            if name.endswith(".xml")
        }


def problems_of(content, schema):
    """Lines on what a schema finds wrong in a file's bytes."""
    schema = etree.XMLSchema(file=str(FOLDER / schema))
    schema.validate(etree.fromstring(content))
    return [str(line) for line in schema.error_log]
