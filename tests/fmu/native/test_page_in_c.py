"""The C of docs/guides/fmu_hosts.md: the command compiles the sources, the lines set the stations."""

import re
import subprocess
import zipfile

import numpy as np

from tests.helpers.fmi_host import HEADERS
from tests.helpers.fmus import needs_glibc, unpacked_library
from tests.helpers.paths import ROOT
from wrcontact import ContactSystem

PAGE = (ROOT / "docs" / "guides" / "fmu_hosts.md").read_text(encoding="utf-8")
PROGRAM = r"""
#include <stdio.h>
#include "fmi3Functions.h"
static void say(fmi3InstanceEnvironment who, fmi3Status status, fmi3String category, fmi3String message) {
    (void)who; fprintf(stderr, "%%d %%s %%s\n", status, category, message);
}
int main(void) {
    fmi3Instance instance = fmi3InstantiateCoSimulation("page", "%s", 0, false, false, false, false, 0, 0,
                                                        0, say, 0);
%s
    for (int i = 0; i < 61; i++) printf("%%.17g\n", values[i]);
    fmi3FreeInstance(instance);
    return 0;
}
"""
pytestmark = needs_glibc


def compiled(command, folder):
    done = subprocess.run(command, cwd=folder, shell=isinstance(command, str), capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


def test_the_command_compiles_the_sources(fmus, tmp_path):
    """All files are there, and no mathematical library is needed. Hardly optimised, which saves a minute."""
    (command,) = re.findall(r"^cc .*$", PAGE, re.MULTILINE)
    with zipfile.ZipFile(fmus[2]) as archive:
        archive.extractall(tmp_path)
    compiled(command.replace("-O3", "-Og"), tmp_path / "sources")
    symbols = subprocess.run(
        ["nm", "-D", "WheelsetContact.so"],
        cwd=tmp_path / "sources",
        text=True,
        capture_output=True,
        check=True,
    ).stdout
    assert " T fmi2DoStep" in symbols and not re.search(r" U (sin|cos|exp|log|pow|sqrt)\b", symbols)


def test_the_lines_of_the_page_set_the_number_of_stations(fmus, tmp_path):
    """Pressures of 61 stations, as Python has them."""
    (lines,) = re.findall(r"```c\n(.*?)```", PAGE, re.DOTALL)
    with zipfile.ZipFile(fmus[3]) as archive:
        token = re.search(r'instantiationToken="(.*?)"', archive.read("modelDescription.xml").decode())[1]
    library = unpacked_library(fmus[3], 3, tmp_path)
    (tmp_path / "page.c").write_text(PROGRAM % (token, lines))
    compiled(["cc", "-std=c11", f"-I{HEADERS}", "page.c", str(library), "-o", "page"], tmp_path)
    said = subprocess.run([tmp_path / "page"], text=True, capture_output=True)
    assert said.returncode == 0 and not said.stderr, said.stderr
    wanted = ContactSystem(stations=61).evaluate().left.outline.pressure
    found = np.array(said.stdout.split(), float)
    assert found.shape == wanted.shape and wanted.max() > 1e8
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1.0)
