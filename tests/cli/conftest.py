"""The command line as a function."""

import pytest

from wrcontact.cli import main


@pytest.fixture
def run(capsys):
    """Run the command line in this process: (exit code, standard output, error output)."""

    def run(*words):
        with pytest.raises(SystemExit) as ended:
            main([str(word) for word in words], prog_name="wrcontact")
        seen = capsys.readouterr()
        return ended.value.code or 0, seen.out, seen.err

    return run
