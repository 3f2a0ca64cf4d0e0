"""What docs/reference/compatibility.md promises and tests elsewhere do not see."""

import pickle
import re

import pytest

import wrcontact
from wrcontact.fmu import native
from wrcontact.results import saved
from wrcontact.system import _rebuilt


def kept():
    """What a user may pickle, by its name in the sentence."""
    system = wrcontact.ContactSystem()
    state = system.evaluate(1e-3)
    wheel = wrcontact.WheelContact().evaluate(vertical_shift_input=1e-4)
    return {
        "stepper": system.stepper(),
        "WheelsetState": state,
        "Patch": state.right.patches[0],
        "WheelState": wheel,
    }


def test_what_is_pickled_is_read_by_the_same_version():
    for name, value in kept().items():
        again = pickle.loads(pickle.dumps(value))
        assert type(again) is type(value), name
        if name == "WheelsetState":
            assert again.to_dict() == value.to_dict()


@pytest.mark.parametrize(
    "other, told",
    [
        (("0.1.0", "records"), r"was saved by wrcontact 0\.1\.0, this is "),
        ((wrcontact.__version__, "records"), "with other records; permitted is the same version"),
    ],
)
def test_what_another_version_has_pickled_is_refused(monkeypatch, other, told):
    with monkeypatch.context() as patch:
        for module in ("wrcontact.stepper", "wrcontact.results.views"):
            patch.setattr(f"{module}.version_mark", lambda: other)
        files = {name: pickle.dumps(value) for name, value in kept().items()}
    assert saved.version_mark()[0] == wrcontact.__version__
    for name, file in files.items():
        with pytest.raises(ValueError, match=told) as refused:  # a wheel's state holds a wheelset's
            pickle.loads(file)
        assert str(refused.value).startswith(f"the {name.replace('WheelState', 'WheelsetState')} "), name


def test_a_system_of_an_earlier_version_is_read():
    """It has no value of a parameter that came later, which then has its default."""
    kind, (_, parameters, profiles) = wrcontact.ContactSystem(gauge=1.44).__reduce__()
    assert kind is _rebuilt
    later = "wear_outputs"
    old = {name: value for name, value in parameters.items() if name != later}
    system = _rebuilt(wrcontact.ContactSystem, old, profiles)
    assert system.parameters == parameters


@pytest.mark.full
@pytest.mark.parametrize("version", [2, 3])
def test_states_of_fmus_of_another_version_have_another_token(monkeypatch, version):
    """A state with another token is refused (tests/fmu/native/test_misuse.py)."""
    starts, profiles = native.packed_profiles()

    def token():
        code = native.uncompiled(version, starts, profiles, ["x86_64-linux"])["sources/model.c"].decode()
        return re.search(r'model_token\[48\] = "(\{\w{32}\})"', code)[1]

    here = token()
    assert token() == here
    monkeypatch.setattr(native, "__version__", "0.1.0")
    assert token() != here
